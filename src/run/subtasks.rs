//! Runs of planners for planners: one after another, or natively side by side.

use std::sync::Arc;

use crate::{
    describe::{CONVERGED, Registry},
    kernel::{Error, Scene, Status, Stepped, Subtask, SubtaskResult},
};

use super::{answers::SubtaskRunner, setup::Setup, stepping::Run};

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
    /// Takes a step as [`Run::step`] does, unless `stop` becomes true: it is asked again and again. `Partly`: it was stopped, and
    /// [`Run::is_partly`] says whether within the planner's step.
    ///
    /// # Errors
    /// What is refused of the step's subtasks.
    pub fn step_until(&mut self, stop: &(dyn Fn() -> bool + Sync)) -> Result<Stepped, Error> {
        let subtasks = self.subtasks();
        if let Some(registry) = self.registry().filter(|_| !subtasks.is_empty()) {
            match run_subtasks_until(registry, self.scene(), &subtasks, stop)? {
                None => return Ok(Stepped::Partly),
                Some(found) => self.answers.keep(self.at.iteration, found),
            }
        }
        while !stop() {
            let stepped = self.part();
            if stepped != Stepped::Partly {
                return Ok(stepped);
            }
        }
        Ok(Stepped::Partly)
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

/// A part of a step carries out so many steps of a subtask, or fewer once they have evaluated as many candidates: the only measure of their
/// work. One step of a colony is enough, one of a search that settles a cell is not.
const AT_ONCE: u64 = 8;

/// Carries out the subtasks of a run in the same process.
pub(super) struct LocalSubtasks {
    registry: Arc<Registry>,
    scene: Arc<Scene>,
    begun: Option<Begun>,
}

/// The subtasks of a step, some of which are carried out.
struct Begun {
    iteration: u64,
    requests: Vec<Subtask>,
    /// What the first of them found.
    found: Vec<SubtaskResult>,
    /// The one that is under way.
    run: Option<Box<Run>>,
}

impl LocalSubtasks {
    pub(super) fn new(registry: &Arc<Registry>, scene: &Arc<Scene>) -> Self {
        Self { registry: Arc::clone(registry), scene: Arc::clone(scene), begun: None }
    }

    /// Carries out all of an iteration, on all cores.
    #[cfg(feature = "parallel")]
    fn all(&mut self, _: u64, subtasks: &[Subtask]) -> Vec<SubtaskResult> {
        run_subtasks(&self.registry, &self.scene, subtasks).unwrap_or_default()
    }

    /// Carries out all of an iteration, one after another.
    #[cfg(not(feature = "parallel"))]
    fn all(&mut self, iteration: u64, subtasks: &[Subtask]) -> Vec<SubtaskResult> {
        let others = self.begun.take();
        self.begin(iteration, subtasks.to_vec());
        let found = self.complete_rest();
        self.begun = others;
        found
    }

    /// Carries out what is left of those that have begun.
    fn complete_rest(&mut self) -> Vec<SubtaskResult> {
        loop {
            if let Some(found) = self.part() {
                return found;
            }
        }
    }
}

impl SubtaskRunner for LocalSubtasks {
    fn complete(&mut self, iteration: u64, subtasks: &[Subtask]) -> Vec<SubtaskResult> {
        // A replay asks for those of earlier iterations: what has begun is not theirs and stays.
        if self.is_under_way(iteration) {
            return self.complete_rest();
        }
        self.all(iteration, subtasks)
    }

    fn is_under_way(&self, iteration: u64) -> bool {
        self.begun.as_ref().is_some_and(|begun| begun.iteration == iteration)
    }

    fn begin(&mut self, iteration: u64, subtasks: Vec<Subtask>) {
        self.begun = Some(Begun { iteration, requests: subtasks, found: Vec::new(), run: None });
    }

    fn part(&mut self) -> Option<Vec<SubtaskResult>> {
        let Self { registry, scene, begun } = self;
        let Some(Begun { requests, found, run, .. }) = begun else { return Some(Vec::new()) };
        let Some(under_way) = run else {
            match requests.get(found.len()).map(|next| begin(registry, scene, next)) {
                Some(Ok(next)) => {
                    *run = Some(Box::new(next));
                    return None;
                }
                Some(Err(_)) => found.clear(),
                None => {}
            }
            return begun.take().map(|begun| begun.found);
        };
        let enough = under_way.evaluations() + AT_ONCE;
        for _ in 0..AT_ONCE {
            match under_way.part() {
                Stepped::Whole if under_way.evaluations() < enough => {}
                Stepped::Whole | Stepped::Partly => break,
                Stepped::Not => {
                    found.push(result(under_way));
                    *run = None;
                    break;
                }
            }
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

    use super::*;
    use crate::{
        describe::{Entry, Start},
        kernel::{Candidate, Digest, Frame, Planner, Progress, Readings, Started, State, Subtasks},
        shipped,
        swarm::pso,
    };

    /// How often the planner of the subtasks was started, and how often the requests were made.
    static STARTS: AtomicUsize = AtomicUsize::new(0);
    static REQUESTS: AtomicUsize = AtomicUsize::new(0);
    const COUNT: usize = 3;

    static COUNTED: Entry = Entry { name: "counted", start: start_counted, ..pso::ENTRY };
    static ASKING: Entry = Entry { name: "asking", start: |_| Ok(start_asking("counted")), ..pso::ENTRY };
    static UNCOUNTED: Entry = Entry { name: "asking-pso", start: |_| Ok(start_asking("pso")), ..pso::ENTRY };
    static REFUSED: Entry = Entry { name: "refused", start: |_| Ok(start_asking("nobody")), ..pso::ENTRY };

    fn start_counted(start: &Start) -> Result<Started, Error> {
        STARTS.fetch_add(1, Relaxed);
        (pso::ENTRY.start)(start)
    }

    fn start_asking(planner: &'static str) -> Started {
        Started::new(Asking { planner, steps: 0, found: Vec::new() }, 5)
    }

    /// Each step needs a few runs of another planner.
    #[derive(Clone, State)]
    struct Asking {
        #[state(shared)]
        planner: &'static str,
        steps: u64,
        found: Vec<SubtaskResult>,
    }

    impl Planner for Asking {
        fn advance(&mut self) -> Progress {
            self.steps += 1;
            Progress::Continue
        }
        fn evaluations(&self) -> u64 {
            self.steps
        }
        fn best(&self) -> Option<Candidate> {
            None
        }
        fn read(&self, _: &mut Readings) {}
        fn draw(&self, _: &mut Frame) {}
        fn subtasks(&mut self) -> Option<&mut dyn Subtasks> {
            Some(self)
        }
    }

    impl Subtasks for Asking {
        fn requests(&self) -> Vec<Subtask> {
            REQUESTS.fetch_add(usize::from(self.planner == "counted"), Relaxed);
            let params = || [("iterations", 20.0), ("population", 3.0)].map(|(name, value)| (name, value.into())).into_iter().collect();
            let seed = |k| self.steps * COUNT as u64 + k;
            (0..COUNT as u64).map(|k| Subtask { planner: self.planner, params: params(), seed: seed(k), ends: None }).collect()
        }
        fn provide(&mut self, found: Vec<SubtaskResult>) {
            self.found = found;
        }
    }

    fn run(planner: &str) -> Run {
        let registry = crate::Registry::standard().with_all(&[&COUNTED, &ASKING, &UNCOUNTED, &REFUSED]);
        let setup = Setup { planner: planner.into(), scene: shipped("sphere").unwrap(), params: crate::Overrides::default(), seed: 1 };
        Run::new(&Arc::new(registry), setup).unwrap()
    }

    /// Requests are made once for each step, and no subtask is carried out twice: not where a step follows some parts, nor after a replay
    /// between them.
    #[test]
    fn a_step_completes_the_subtasks_that_parts_have_begun() {
        let counts = || (STARTS.load(Relaxed), REQUESTS.load(Relaxed));
        let mut whole = run("asking-pso");
        let mut run = run("asking");
        let mut parts = 1;
        while run.part() == Stepped::Partly {
            assert!(!run.is_partly() && run.iteration() == 0);
            parts += 1;
        }
        assert!(parts > 2 * COUNT, "{parts} parts");
        assert_eq!((run.iteration(), counts()), (1, (COUNT, 1)));
        while counts().0 < COUNT + 2 {
            assert_eq!(run.part(), Stepped::Partly);
        }
        assert_eq!(run.state_at(0).iteration, 0);
        run.step(1);
        assert_eq!(counts().0, 2 * COUNT);
        whole.step(2);
        assert_eq!((run.iteration(), digest(&run)), (2, digest(&whole)));
    }

    /// That of the planner's state: the two runs have different planners' names.
    fn digest(run: &Run) -> String {
        let mut digest = Digest::default();
        run.at.planner.digest(&mut digest);
        digest.hex()
    }

    #[test]
    fn what_is_refused_of_a_subtask_is_an_error_of_the_step() {
        let mut run = run("refused");
        let error = run.step_until(&|| false).unwrap_err();
        assert_eq!((error.field(), error.value(), run.iteration()), ("planner", "nobody", 0));
        assert_eq!(run.step_until(&|| true), Err(error));
        run.step(1);
        assert_eq!(run.iteration(), 1, "a step finds nothing instead");
    }
}
