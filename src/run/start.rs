//! How a run begins.

use std::{cell::OnceCell, sync::Arc};

use crate::{
    describe::{Entry, Registry, Start},
    kernel::{Error, Readings, Scene, Started, Stepper},
    message,
    params::Parameters,
};

use super::{answers::Answers, keyframes::Keyframes, origin::Origin, setup::Setup, stepping::Run, subtasks::LocalSubtasks, trace::Trace};

/// What there is to know of a planner that no registry lists.
const UNLISTED: Entry = Entry::new("unlisted", "Unlisted", "", "A planner that no registry lists.", |_| {
    Err(Error::refused("planner", "unlisted", message!("run-unlisted", "a planner that a registry lists")))
});

/// What a run is of.
struct Begun {
    origin: Origin,
    entry: &'static Entry,
    scene: Arc<Scene>,
    parameters: Parameters,
    seed: u64,
}

impl Run {
    /// Starts a run at iteration 0.
    ///
    /// ```
    /// use forage::{Run, Setup, Status, shipped, standard};
    /// let scene = shipped("wcpso-discs")?;
    /// let mut run = Run::new(standard(), Setup { planner: "wcpso".into(), scene, params: Default::default(), seed: 1 })?;
    /// while run.step(1) == Status::Running {}
    /// let outcome = run.outcome();
    /// assert!(outcome.feasible && outcome.gap.unwrap() < 0.005);
    /// run.seek(3); // and back again, exactly
    /// assert_eq!(run.iteration(), 3);
    /// # Ok::<(), forage::Error>(())
    /// ```
    ///
    /// # Errors
    /// Whatever can be refused is refused here: the planner's name, a scene it does not run on, a parameter, the seed.
    pub fn new(registry: &Arc<Registry>, setup: Setup) -> Result<Self, Error> {
        Self::with_keyframes(registry, setup, Self::KEYFRAME_BUDGET)
    }

    /// Starts a run that keeps keyframes up to `budget` bytes, and what its subtasks found up to as many; with 0 every way back is a
    /// replay from the start.
    ///
    /// # Errors
    /// As [`Run::new`].
    pub fn with_keyframes(registry: &Arc<Registry>, setup: Setup, budget: usize) -> Result<Self, Error> {
        let (entry, parameters) = setup.check(registry)?;
        let Setup { scene, seed, .. } = setup;
        let started = (entry.start)(&Start { entry, scene: &scene, parameters: &parameters, seed, entries: &**registry })?;
        let answers = Answers::new(budget, Some(Box::new(LocalSubtasks::new(registry, &scene))));
        let setup = Begun { origin: Origin::Registry(Arc::clone(registry)), entry, scene, parameters, seed };
        Ok(Self::begin(started, setup, answers, budget))
    }

    /// A run of a planner that no registry lists. It steps, rewinds and is read like any other, but has no link: nobody else
    /// could open it.
    ///
    /// [`Run::described_by`] adds what there is to know of it, layers to draw above all; [`Run::on`] the scene that judges its
    /// results. Subtasks of other planners find nothing.
    ///
    /// ```
    /// use forage::{Run, Status, kernel::Started};
    /// # use forage::kernel::{Candidate, Frame, Planner, Progress, Readings, Solution, State};
    /// /// Halves a number.
    /// #[derive(Clone, State)]
    /// struct Halving(f64);
    /// # impl Planner for Halving {
    /// #     fn advance(&mut self) -> Progress { self.0 /= 2.0; Progress::Continue }
    /// #     fn evaluations(&self) -> u64 { 0 }
    /// #     fn best(&self) -> Option<Candidate> { Some(Candidate { cost: self.0, solution: Solution::Position(vec![self.0]) }) }
    /// #     fn read(&self, _: &mut Readings) {}
    /// #     fn draw(&self, _: &mut Frame) {}
    /// # }
    /// let mut run = Run::with(Started::new(Halving(8.0), 3));
    /// assert_eq!(run.step(10), Status::Exhausted);
    /// assert_eq!(run.best().unwrap().cost, 1.0);
    /// run.seek(1);
    /// assert_eq!(run.best().unwrap().cost, 4.0);
    /// ```
    pub fn with(started: Started) -> Self {
        let state = Stepper::new(started.planner.clone_box(), started.limit, started.progress);
        let setup = Begun {
            origin: Origin::State(state),
            entry: &UNLISTED,
            scene: Arc::new(Scene::nowhere()),
            parameters: Parameters::default(),
            seed: 0,
        };
        Self::begin(started, setup, Answers::new(Self::KEYFRAME_BUDGET, None), Self::KEYFRAME_BUDGET)
    }

    /// Described by an entry: its name, its layers, its readings.
    #[must_use]
    pub fn described_by(self, entry: &'static Entry) -> Self {
        Self { entry, ..self }
    }

    /// On a scene, which judges the results and knows their exact optimum.
    #[must_use]
    pub fn on(self, scene: Arc<Scene>) -> Self {
        Self { scene, ..self }
    }

    fn begin(started: Started, begun: Begun, answers: Answers, budget: usize) -> Self {
        let Begun { origin, entry, scene, parameters, seed } = begun;
        let Started { planner, limit, open_ended, progress, reference, ends, stages } = started;
        let mut run = Self {
            entry,
            origin,
            answers,
            scene,
            parameters,
            seed,
            at: Stepper::new(planner, limit, progress),
            limit,
            end: (!open_ended).then_some(limit),
            reference,
            ends,
            stages,
            keyframes: Keyframes::new(budget),
            before: None,
            trace: Trace::default(),
            curve: None,
            readings: Readings::default(),
            setup_digest: OnceCell::new(),
            followed: None,
        };
        run.remember();
        run
    }

    /// A planner at iteration 0. Starting succeeded once with the same scene, parameters and seed, so it does again; if it did
    /// not, staying where we are is the harmless answer.
    pub(super) fn start(&self) -> Stepper {
        match &self.origin {
            Origin::State(state) => state.clone(),
            Origin::Registry(registry) => {
                let start =
                    Start { entry: self.entry, scene: &self.scene, parameters: &self.parameters, seed: self.seed, entries: &**registry };
                (self.entry.start)(&start).map_or_else(|_| self.at.clone(), Stepper::from)
            }
        }
    }
}
