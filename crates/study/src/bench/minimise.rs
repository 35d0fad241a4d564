//! A planner on a function within a budget of evaluations: when its best value fell, and how far above the minimum it was.

use std::sync::{
    Arc,
    atomic::{AtomicBool, Ordering},
};

use forage::{
    Error, Registry, Run, Setup, Status,
    scene::{FunctionScene, Header},
    swarm::objective::Objective,
};

use super::{
    super::within::{RunEnd, run_within_budget},
    recorder::Recorder,
    suite::Contender,
    targets,
};

/// A run that is to be carried out.
pub(super) struct Minimisation<'a> {
    pub registry: &'a Arc<Registry>,
    pub contender: &'a Contender,
    /// What its scene is called.
    pub name: &'a str,
    pub seed: u64,
    /// The most evaluations that count.
    pub budget: u64,
}

/// What came of it.
pub(super) struct Convergence {
    /// How many evaluations there were until it was solved, spent or at its own end.
    pub evaluations: u64,
    /// After how many evaluations the best value fell, and how far above the minimum it was then.
    pub improvements: Vec<(u64, f64)>,
}

impl Convergence {
    /// How far above the minimum the best was in the end.
    pub fn gap(&self) -> f64 {
        self.improvements.last().map_or(f64::INFINITY, |(_, gap)| *gap)
    }
}

impl Minimisation<'_> {
    /// The run's setup on a function.
    pub fn setup(&self, function: FunctionScene) -> Result<Setup, Error> {
        let scene = forage::scene::function::KIND.scene(Header::named(self.name, self.name), function)?;
        let Contender { planner, params } = self.contender.clone();
        Ok(Setup { planner, scene: Arc::new(scene), params, seed: self.seed })
    }

    /// Runs until it is [solved](targets::FINAL), has spent the budget or comes to its own end; `None` if it was stopped.
    pub fn run(&self, known: FunctionScene, stop: &AtomicBool) -> Result<Option<Convergence>, Error> {
        let minimum = known.minimum().map_or(0.0, |minimum| minimum.value);
        let inner = Arc::clone(known.objective());
        run_within_budget(self.registry, self.setup(known)?, self.budget, |setup| self.attempt(setup, minimum, Arc::clone(&inner), stop))
    }

    /// Runs as it is set up, but on a function that records what is evaluated.
    fn attempt(
        &self,
        mut setup: Setup,
        minimum: f64,
        inner: Arc<dyn Objective>,
        stop: &AtomicBool,
    ) -> Result<Option<(Convergence, RunEnd)>, Error> {
        let recorder = Arc::new(Recorder::new(inner, self.budget));
        setup.scene = self.setup(FunctionScene::of(Arc::<Recorder>::clone(&recorder), None, None)?)?.scene;
        recorder.clear();
        let mut run = Run::with_keyframes(self.registry, setup, 0)?;
        loop {
            let over = recorder.read(|log| log.evaluations >= self.budget || log.best() - minimum <= targets::FINAL);
            if over || run.step(1) != Status::Running {
                break;
            }
            if stop.load(Ordering::Relaxed) {
                return Ok(None);
            }
        }
        let convergence = recorder.read(|log| {
            // What was evaluated in the same iteration after it was solved does not count.
            let mut improvements: Vec<_> = log.improvements.iter().map(|(at, value)| (*at, value - minimum)).collect();
            let evaluations = targets::hitting_time(&improvements, targets::FINAL).unwrap_or(log.evaluations);
            improvements.retain(|(at, _)| *at <= evaluations);
            Convergence { evaluations, improvements }
        });
        Ok(Some((convergence, RunEnd::of(&run))))
    }
}
