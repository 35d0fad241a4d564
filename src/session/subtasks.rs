//! Runs of planners for planners: one after another, or natively side by side.

use std::{collections::BTreeMap, sync::Arc};

use crate::{
    describe::CONVERGED,
    kernel::{Error, Status, Subtask, SubtaskResult},
    scene::Scene,
};

use super::{Session, Setup};

/// What the subtasks of a run found, by the iteration whose step they were for.
pub(super) struct Answers {
    scene: Arc<Scene>,
    found: BTreeMap<u64, Vec<SubtaskResult>>,
    /// They are kept for the way back; otherwise until they are used.
    kept: bool,
}

impl Answers {
    pub(super) fn new(scene: Arc<Scene>, kept: bool) -> Self {
        Self { scene, found: BTreeMap::new(), kept }
    }

    /// Whether the subtasks of an iteration were carried out.
    pub(super) fn knows(&self, iteration: u64) -> bool {
        self.found.contains_key(&iteration)
    }

    /// Takes what was found elsewhere.
    pub(super) fn keep(&mut self, iteration: u64, found: Vec<SubtaskResult>) {
        self.found.insert(iteration, found);
    }

    /// What these subtasks of an iteration find.
    pub(super) fn of(&mut self, iteration: u64, jobs: &[Subtask]) -> Vec<SubtaskResult> {
        let known = if self.kept { self.found.get(&iteration).cloned() } else { self.found.remove(&iteration) };
        known.unwrap_or_else(|| {
            // What starting could refuse was refused for the run itself; a failure now finds nothing.
            let found = run_subtasks(&self.scene, jobs).unwrap_or_default();
            if self.kept {
                self.found.insert(iteration, found.clone());
            }
            found
        })
    }
}

/// Carries a run out to its end.
///
/// # Errors
/// Whatever [`Session::new`] refuses.
pub fn run_to_end(setup: Setup) -> Result<SubtaskResult, Error> {
    let mut session = Session::with_keyframes(setup, 0)?;
    while session.step(u64::MAX) == Status::Running {}
    let converged = session.readings().of(CONVERGED).unwrap_or(session.iteration() as f64);
    // A swarm's best may still touch an obstacle: then nothing was found.
    let best = session.best().filter(|best| session.scene.judge(&best.solution).feasible);
    let cost = best.as_ref().map(|best| best.cost);
    let path = best.and_then(|best| best.solution.path().map(<[_]>::to_vec)).unwrap_or_default();
    Ok(SubtaskResult { cost, converged, path })
}

/// Carries jobs out, with the feature `parallel` on all cores. The findings are in the jobs' order, whoever was first.
///
/// # Errors
/// The first job's that is refused.
pub fn run_subtasks(scene: &Arc<Scene>, jobs: &[Subtask]) -> Result<Vec<SubtaskResult>, Error> {
    let one = |job: &Subtask| {
        let scene = match job.ends {
            Some(ends) => Arc::new(scene.between(ends)?),
            None => Arc::clone(scene),
        };
        run_to_end(Setup { planner: job.planner.to_owned(), scene, params: job.params.clone(), seed: job.seed })
    };
    #[cfg(feature = "parallel")]
    {
        use rayon::prelude::*;
        jobs.par_iter().map(one).collect()
    }
    #[cfg(not(feature = "parallel"))]
    jobs.iter().map(one).collect()
}
