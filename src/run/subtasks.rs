//! Runs of planners for planners: one after another, or natively side by side.

use std::sync::Arc;

use crate::{
    describe::{CONVERGED, Registry},
    kernel::{Error, Scene, Status, Stepped, Subtask, SubtaskResult},
};

use super::{answers::Carrier, setup::Setup, stepping::Run};

/// Carries a run out to its end.
///
/// # Errors
/// Whatever [`Run::new`] refuses.
pub fn run_to_end(registry: &Arc<Registry>, setup: Setup) -> Result<SubtaskResult, Error> {
    let mut run = Run::with_keyframes(registry, setup, 0)?;
    while run.step(u64::MAX) == Status::Running {}
    Ok(result(&mut run))
}

/// Runs subtasks, with the feature `parallel` on all cores. The results are in the order of the subtasks.
///
/// # Errors
/// What is refused of the first subtask that is.
pub fn run_subtasks(registry: &Arc<Registry>, scene: &Arc<Scene>, subtasks: &[Subtask]) -> Result<Vec<SubtaskResult>, Error> {
    run_subtasks_until(registry, scene, subtasks, &|| false).map(Option::unwrap_or_default)
}

/// The same, unless `stop` becomes true: it is asked again and again while they run. `None` if they were stopped.
///
/// # Errors
/// As [`run_subtasks`].
pub fn run_subtasks_until(
    registry: &Arc<Registry>,
    scene: &Arc<Scene>,
    subtasks: &[Subtask],
    stop: &(dyn Fn() -> bool + Sync),
) -> Result<Option<Vec<SubtaskResult>>, Error> {
    let one = |subtask: &Subtask| {
        let mut run = begin(registry, scene, subtask)?;
        while !stop() {
            if run.part() == Stepped::Not {
                return Ok(Some(result(&mut run)));
            }
        }
        Ok(None)
    };
    #[cfg(feature = "parallel")]
    {
        use rayon::prelude::*;
        subtasks.par_iter().map(one).collect()
    }
    #[cfg(not(feature = "parallel"))]
    subtasks.iter().map(one).collect()
}

impl Run {
    /// Takes a step as [`Run::step`] does, unless `stop` becomes true: it is asked again and again. `Partly`: it was stopped.
    pub fn step_until(&mut self, stop: &(dyn Fn() -> bool + Sync)) -> Stepped {
        let subtasks = self.subtasks();
        if let Some(registry) = self.registry().filter(|_| !subtasks.is_empty()) {
            match run_subtasks_until(registry, self.scene(), &subtasks, stop) {
                Ok(None) => return Stepped::Partly,
                found => self.answers.keep(self.at.iteration, found.ok().flatten().unwrap_or_default()),
            }
        }
        while !stop() {
            let stepped = self.part();
            if stepped != Stepped::Partly {
                return stepped;
            }
        }
        Stepped::Partly
    }
}

fn begin(registry: &Arc<Registry>, scene: &Arc<Scene>, subtask: &Subtask) -> Result<Run, Error> {
    let scene = match subtask.ends {
        Some(ends) => Arc::new(scene.between(ends)?),
        None => Arc::clone(scene),
    };
    let setup = Setup { planner: subtask.planner.to_owned(), scene, params: subtask.params.clone(), seed: subtask.seed };
    Run::with_keyframes(registry, setup, 0)
}

/// What a run that is over found.
fn result(run: &mut Run) -> SubtaskResult {
    let converged = run.readings().of(CONVERGED).unwrap_or(run.iteration() as f64);
    // A swarm's best may still touch an obstacle: then nothing was found.
    let best = run.best().filter(|best| run.scene.judge(&best.solution).feasible);
    let cost = best.as_ref().map(|best| best.cost);
    let path = best.and_then(|best| best.solution.path().map(<[_]>::to_vec)).unwrap_or_default();
    SubtaskResult { cost, converged, path }
}

/// So many steps of a subtask, or a part of one, are a part of the step that needs it.
const AT_ONCE: usize = 8;

/// Carries out the subtasks of a run where the run is.
pub(super) struct Here {
    registry: Arc<Registry>,
    scene: Arc<Scene>,
    /// Of which iteration some are carried out already, what they found, and the one that is under way.
    iteration: u64,
    found: Vec<SubtaskResult>,
    run: Option<Box<Run>>,
}

impl Here {
    pub(super) fn new(registry: &Arc<Registry>, scene: &Arc<Scene>) -> Self {
        Self { registry: Arc::clone(registry), scene: Arc::clone(scene), iteration: 0, found: Vec::new(), run: None }
    }
}

impl Carrier for Here {
    fn whole(&self, subtasks: &[Subtask]) -> Vec<SubtaskResult> {
        run_subtasks(&self.registry, &self.scene, subtasks).unwrap_or_default()
    }

    fn part(&mut self, iteration: u64, subtasks: &[Subtask]) -> Option<Vec<SubtaskResult>> {
        if self.iteration != iteration {
            (self.iteration, self.run) = (iteration, None);
            self.found.clear();
        }
        let Some(run) = &mut self.run else {
            let Some(next) = subtasks.get(self.found.len()) else {
                return Some(std::mem::take(&mut self.found));
            };
            return match begin(&self.registry, &self.scene, next) {
                Ok(run) => {
                    self.run = Some(Box::new(run));
                    None
                }
                Err(_) => Some(Vec::new()),
            };
        };
        for _ in 0..AT_ONCE {
            match run.part() {
                Stepped::Whole => {}
                Stepped::Partly => break,
                Stepped::Not => {
                    self.found.push(result(run));
                    self.run = None;
                    break;
                }
            }
        }
        None
    }
}
