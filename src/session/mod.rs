//! One run: a scene, a planner with parameters and a seed, stepped, rewound, judged and shared.

mod keyframes;
mod outcome;
mod subtasks;
mod trace;

use std::{cell::OnceCell, sync::Arc};

pub use outcome::Outcome;
use subtasks::Answers;
pub use subtasks::{run_subtasks, run_to_end};
pub use trace::{Trace, csv_heading, csv_line, csv_row};

use crate::{
    arm::{self, Motion, MotionOutcome},
    catalogue::{PLANNERS, find},
    describe::{Entry, Start, Suggestion},
    drive::{self, Drive},
    kernel::{
        Candidate, Digest, Error, Event, Exact, Frame, Inspection, Item, Readings, ReferenceOptimum, Solution, Stage, Started, State,
        Status, Stepper, Subtask, SubtaskResult, Timeline, TourEnds, rng::check_seed,
    },
    link::Link,
    params::{Overrides, Parameters},
    scene::Scene,
};

use keyframes::Keyframes;

/// What a run is made of. Two runs of the same setup give the same bits.
#[derive(Debug, Clone)]
pub struct Setup {
    /// The planner's name in the catalogue.
    pub planner: String,
    /// What is planned in.
    pub scene: Arc<Scene>,
    /// Parameters that differ from the defaults.
    pub params: Overrides,
    /// 0 to 2^53 − 1.
    pub seed: u64,
}

impl Setup {
    /// Checks everything that can be refused without running it.
    ///
    /// # Errors
    /// The planner's name, a scene it does not run on, a parameter, the seed.
    pub fn check(&self) -> Result<(&'static Entry, Parameters), Error> {
        let entry = find(&self.planner)?;
        entry.check_scene(&self.scene)?;
        check_seed(self.seed)?;
        Ok((entry, Parameters::new(entry.parameters, self.scene.kind(), &self.params)?))
    }

    /// The sizes that the planner's paper recommends for this setup, if it says anything.
    ///
    /// ```
    /// let scene = forage::shipped("qpso-10m")?;
    /// let setup = forage::Setup { planner: "ltqpso".into(), scene, params: Default::default(), seed: 1 };
    /// let suggested = setup.suggest()?.unwrap();
    /// assert_eq!((suggested.population, suggested.iterations), (16, 29));
    /// # Ok::<(), forage::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`Setup::check`].
    pub fn suggest(&self) -> Result<Option<Suggestion>, Error> {
        let (entry, settings) = self.check()?;
        Ok((entry.suggest)(&settings))
    }
}

/// A run that can go forward and back.
pub struct Session {
    entry: &'static Entry,
    scene: Arc<Scene>,
    settings: Parameters,
    seed: u64,
    /// The planner, and where it stands.
    at: Stepper,
    limit: u64,
    /// The last iteration, as soon as it is known.
    end: Option<u64>,
    reference: ReferenceOptimum,
    round: Option<TourEnds>,
    stages: Vec<Stage>,
    keyframes: Keyframes,
    answers: Answers,
    /// The state before the one that was inspected last: while an item is watched, each step costs one more, not a replay.
    before: Option<Stepper>,
    trace: Trace,
    readings: Readings,
    /// What the setup adds to a hash; made when the first is asked for.
    setup_digest: OnceCell<Digest>,
    /// What the arm followed last with the usual parameters, and how that went: an outcome is asked for more often than a
    /// path changes.
    followed: Option<(Solution, MotionOutcome)>,
}

impl Session {
    /// Memory for keyframes unless told otherwise, in bytes.
    pub const KEYFRAME_BUDGET: usize = 64 << 20;

    /// Starts a run at iteration 0.
    ///
    /// ```
    /// use forage::{Session, Setup, Status, shipped};
    /// let scene = shipped("wcpso-discs")?;
    /// let mut session = Session::new(Setup { planner: "wcpso".into(), scene, params: Default::default(), seed: 1 })?;
    /// while session.step(1) == Status::Running {}
    /// let outcome = session.outcome();
    /// assert!(outcome.feasible && outcome.gap.unwrap() < 0.005);
    /// session.seek(3); // and back again, exactly
    /// assert_eq!(session.iteration(), 3);
    /// # Ok::<(), forage::Error>(())
    /// ```
    ///
    /// # Errors
    /// Whatever can be refused is refused here: the planner's name, a scene it does not run on, a parameter, the seed.
    pub fn new(setup: Setup) -> Result<Self, Error> {
        Self::with_keyframes(setup, Self::KEYFRAME_BUDGET)
    }

    /// Starts a run that keeps keyframes up to `budget` bytes; with 0 every way back is a replay from the start.
    ///
    /// # Errors
    /// As [`Session::new`].
    pub fn with_keyframes(setup: Setup, budget: usize) -> Result<Self, Error> {
        let (entry, settings) = setup.check()?;
        let Setup { scene, seed, .. } = setup;
        let Started { planner, limit, open_ended, progress, reference, round, stages } =
            (entry.start)(&Start { scene: &scene, parameters: &settings, seed, entries: &PLANNERS })?;
        let mut session = Self {
            entry,
            answers: Answers::new(Arc::clone(&scene), budget > 0),
            scene,
            settings,
            seed,
            at: Stepper::new(planner, limit, progress),
            limit,
            end: (!open_ended).then_some(limit),
            reference,
            round,
            stages,
            keyframes: Keyframes::new(budget),
            before: None,
            trace: Trace::default(),
            readings: Readings::default(),
            setup_digest: OnceCell::new(),
            followed: None,
        };
        session.remember();
        Ok(session)
    }

    /// The run that a link describes, at its beginning.
    ///
    /// # Errors
    /// As [`Session::new`], and for a link that cannot be read.
    pub fn from_link(link: &str) -> Result<Self, Error> {
        Self::new(Link::parse(link)?.setup)
    }

    /// Takes up to `steps` steps; stops where the planner does.
    pub fn step(&mut self, steps: u64) -> Status {
        for _ in 0..steps {
            if !self.advance() {
                break;
            }
            self.remember();
        }
        self.status()
    }

    /// Takes a step, if there is one to take.
    fn advance(&mut self) -> bool {
        let Self { at, answers, .. } = self;
        let k = at.iteration;
        at.step(|jobs| answers.of(k, &jobs))
    }

    /// Goes to iteration `k`, forward or back, exactly; stops early where the planner does.
    pub fn seek(&mut self, k: u64) -> Status {
        self.rewind(k);
        self.step(k.saturating_sub(self.iteration()))
    }

    /// Jumps to the latest state at or before iteration `k` that is at hand, and says which iteration that is.
    /// The rest of the way to `k` is `step`.
    pub fn rewind(&mut self, k: u64) -> u64 {
        let now = self.iteration();
        match self.keyframes.at_or_before(k) {
            Some(state) if k < now || state.iteration > now => self.at = state.clone(),
            _ if k < now => self.at = self.start(),
            _ => {}
        }
        self.iteration()
    }

    /// A planner at iteration 0. Starting succeeded once with the same scene, settings and seed, so it does again;
    /// if it did not, staying where we are is the harmless answer.
    fn start(&self) -> Stepper {
        let start = Start { scene: &self.scene, parameters: &self.settings, seed: self.seed, entries: &PLANNERS };
        match (self.entry.start)(&start) {
            Ok(started) => started.into(),
            Err(_) => self.at.clone(),
        }
    }

    /// The state at an iteration at or before the present one, without going there: from whatever is at hand nearest to it.
    fn state_at(&mut self, k: u64) -> Stepper {
        let kept = self.keyframes.at_or_before(k);
        let mut state = match (self.before.take().filter(|state| state.iteration <= k), kept) {
            (Some(before), kept) if kept.is_none_or(|kept| kept.iteration <= before.iteration) => before,
            (_, Some(state)) => state.clone(),
            (_, None) => self.start(),
        };
        loop {
            let now = state.iteration;
            if now >= k || !state.step(|jobs| self.answers.of(now, &jobs)) {
                return state;
            }
        }
    }

    fn remember(&mut self) {
        self.keyframes.offer(&self.at);
        if self.status() != Status::Running {
            self.end = Some(self.at.iteration);
        }
        if self.trace.wants(self.at.iteration) {
            self.read();
            self.trace.push(self.at.iteration, &self.readings);
        }
    }

    fn read(&mut self) {
        self.readings.clear();
        self.at.planner.read(&mut self.readings);
    }

    /// How many iterations were taken to come here.
    pub fn iteration(&self) -> u64 {
        self.at.iteration
    }

    /// The iteration at which the run ends at the latest.
    pub fn limit(&self) -> u64 {
        self.limit
    }

    /// The last iteration, as soon as it is known: of runs that may be over before their limit, once they came to their end.
    pub fn end(&self) -> Option<u64> {
        self.end
    }

    /// Whether there is more to do, or why not.
    pub fn status(&self) -> Status {
        self.at.status
    }

    /// Candidate solutions evaluated so far: what planners are compared by.
    pub fn evaluations(&self) -> u64 {
        self.at.planner.evaluations()
    }

    /// Takes steps until so many candidates are evaluated, or up to `steps` of them; stops where the planner does.
    pub fn step_to(&mut self, evaluations: u64, steps: u64) -> Status {
        for _ in 0..steps {
            if self.evaluations() >= evaluations || self.step(1) != Status::Running {
                break;
            }
        }
        self.status()
    }

    /// The best solution so far and what it costs the planner.
    pub fn best(&self) -> Option<Candidate> {
        self.at.planner.best()
    }

    /// The planner's entry in the catalogue.
    pub fn entry(&self) -> &'static Entry {
        self.entry
    }

    /// The scene.
    pub fn scene(&self) -> &Arc<Scene> {
        &self.scene
    }

    /// Every parameter's value.
    pub fn settings(&self) -> &Parameters {
        &self.settings
    }

    /// The seed.
    pub fn seed(&self) -> u64 {
        self.seed
    }

    /// The numbers of this iteration.
    pub fn readings(&mut self) -> &Readings {
        self.read();
        &self.readings
    }

    /// The readings of past iterations.
    pub fn trace(&self) -> &Trace {
        &self.trace
    }

    /// Draws the present state, at most about `budget` vertices a layer; what is only worth drawing from near, in the
    /// part of the plane that [`Frame::look_at`] said.
    pub fn draw(&self, frame: &mut Frame, budget: usize) {
        frame.clear(budget, self.entry.drawn_and_marked().0.iter().map(|layer| layer.key));
        self.at.planner.draw(frame);
    }

    /// Why an item did what it did in the step that led here, or, of what came about once, in the step that made it.
    pub fn inspect(&mut self, item: Item) -> Option<Inspection> {
        let explain = self.at.planner.facets().explain?;
        if let Some(told) = explain.inspect(item) {
            return Some(told);
        }
        let created = explain.created_at(item).unwrap_or(self.iteration());
        let before = self.state_at(created.checked_sub(1)?);
        let told = before.planner.facets().explain.and_then(|explain| explain.explain_next(item));
        self.before = Some(before);
        told
    }

    /// The nearest thing that can be inspected within `reach` of a point, in the scene's unit.
    pub fn pick(&self, point: [f64; 2], reach: f64) -> Option<Item> {
        let mut frame = Frame::default();
        self.draw(&mut frame, usize::MAX);
        let pickable: Vec<_> = self.entry.layers.iter().filter(|layer| layer.pickable).map(|layer| layer.key).collect();
        crate::picture::nearest(&frame, &pickable, point, reach)
    }

    /// The exact optimum by the rule that the planner keeps to, as a path.
    pub fn exact(&self) -> Option<&Exact> {
        match self.round {
            Some(round) => self.scene.exact_tour(self.reference, round),
            None => self.scene.exact_by(self.reference),
        }
    }

    /// The parts of the run that have their own kind of step, in their order; empty for most. The last one has no end before
    /// the run came to its own.
    pub fn stages(&self) -> Vec<Stage> {
        let mut stages = self.stages.clone();
        if let Some(last) = stages.last_mut() {
            last.end = self.end;
        }
        stages
    }

    /// What happened so far in simulated time, and what was decided and why; empty for most.
    pub fn events(&self) -> &[Event] {
        self.at.planner.facets().timeline.map_or(&[], Timeline::events)
    }

    /// The numbers of those that search side by side, row by row; the columns are the entry's `members`.
    pub fn members(&self, out: &mut Vec<f64>) {
        out.clear();
        if let Some(members) = self.at.planner.facets().members {
            members.members(out);
        }
    }

    /// The runs of other planners, on this scene, that the next step needs; see [`Session::provide`].
    pub fn subtasks(&mut self) -> Vec<Subtask> {
        if self.status() != Status::Running || self.answers.knows(self.iteration()) {
            return Vec::new();
        }
        self.at.planner.subtasks().map_or_else(Vec::new, |subtasks| subtasks.requests())
    }

    /// Hands over what the runs of [`Session::subtasks`] found, in their order, so that the next step need not carry them
    /// out itself. What it does with them does not depend on who carried them out.
    pub fn provide(&mut self, found: Vec<SubtaskResult>) {
        if !found.is_empty() && found.len() == self.subtasks().len() {
            self.answers.keep(self.iteration(), found);
        }
    }

    /// What keeps the run from a result, if something does.
    fn failure(&self) -> Option<String> {
        self.at.planner.facets().failure?.failure(self.status())
    }

    /// Everything there is to say about where the run stands.
    pub fn outcome(&mut self) -> Outcome {
        Outcome::of(self)
    }

    /// The scene's robot driving along the best path so far. `None` unless the scene is a grid with a robot that has
    /// length and width, and a path was found.
    ///
    /// # Errors
    /// For a parameter that is not one of [`drive::PARAMETERS`], or its value.
    pub fn drive(&self, given: &Overrides) -> Result<Option<Drive>, Error> {
        let best = self.best();
        drive::along(&self.scene, best.as_ref().and_then(|best| best.solution.path()), given)
    }

    /// The scene's arm following the best path so far. `None` unless the scene is an arm's, and a path was found.
    ///
    /// # Errors
    /// For a parameter that is not one of [`arm::MOTION`]'s, or its value.
    pub fn motion(&self, given: &Overrides) -> Result<Option<Motion>, Error> {
        arm::along(&self.scene, self.best().map(|best| best.solution).as_ref(), given)
    }

    /// How the arm follows the best path with the usual parameters.
    fn usual_motion(&mut self, best: &Solution) -> Option<MotionOutcome> {
        if self.followed.as_ref().is_none_or(|(solution, _)| solution != best) {
            // The defaults are never refused.
            let motion = arm::along(&self.scene, Some(best), &Overrides::new()).ok().flatten();
            self.followed = motion.map(|motion| (best.clone(), motion.outcome));
        }
        self.followed.as_ref().map(|(_, outcome)| outcome.clone())
    }

    /// The hash of setup, iteration, best and the whole state, in hexadecimal: two different runs never share one.
    pub fn hash(&self) -> String {
        self.digest().hex()
    }

    fn digest(&self) -> Digest {
        let mut digest = self.setup_digest.get_or_init(|| self.digest_of_setup()).clone();
        self.iteration().digest(&mut digest);
        self.best().map(|best| best.cost).digest(&mut digest);
        self.at.planner.digest(&mut digest);
        digest
    }

    /// Planner, parameters, seed and what is in the scene; its name, title and notes do not matter.
    fn digest_of_setup(&self) -> Digest {
        let mut digest = Digest::of(self.entry.name);
        for (name, value) in self.settings.all() {
            name.digest(&mut digest);
            value.to_string().digest(&mut digest);
        }
        self.seed.digest(&mut digest);
        self.scene.content().digest(&mut digest);
        digest
    }

    /// A link that opens this very picture: planner, scene, changed parameters, seed, iteration and hash.
    pub fn link(&self) -> String {
        let setup = Setup {
            planner: self.entry.name.to_owned(),
            scene: Arc::clone(&self.scene),
            params: self.settings.changed().clone(),
            seed: self.seed,
        };
        Link { setup, iteration: self.iteration(), hash: Some(self.hash()) }.to_string()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{describe::layers, shipped};

    /// Whatever way the state before was reached (keyframe, replay, or the one kept from the last inspection), the
    /// explanation is the same, and asking for it changes nothing.
    #[test]
    fn an_explanation_does_not_depend_on_what_was_asked_before() {
        let setup = Setup { planner: "wcpso".into(), scene: shipped("wcpso-discs").unwrap(), params: Overrides::default(), seed: 2 };
        let item = Item { layer: layers::PARTICLES.key, index: 17 };
        let mut watched = Session::with_keyframes(setup.clone(), 200_000).unwrap();
        let mut hashes = Vec::new();
        let told: Vec<_> = (0..40)
            .map(|_| {
                watched.step(1);
                let told = watched.inspect(item).unwrap();
                hashes.push(watched.hash());
                told
            })
            .collect();
        let mut fresh = Session::with_keyframes(setup, 0).unwrap();
        for k in [40, 3, 17, 18, 16, 39_u64] {
            watched.seek(k);
            fresh.seek(k);
            assert_eq!(fresh.hash(), hashes[k as usize - 1]);
            assert_eq!(fresh.inspect(item).as_ref(), Some(&told[k as usize - 1]));
            assert_eq!(watched.inspect(item).as_ref(), Some(&told[k as usize - 1]));
        }
    }
}
