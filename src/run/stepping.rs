//! A run that can go forward and back.

use std::{cell::OnceCell, sync::Arc};

use crate::{
    describe::{Entry, FollowOutcomes, FollowedPath, Registry, layers},
    kernel::{
        Candidate, Digest, Error, Event, Exact, Frame, Inspection, Item, Readings, ReferenceOptimum, Scene, Solution, Stage, State, Status,
        Stepped, Stepper, Subtask, SubtaskResult, Timeline, TourEnds,
        error::{list_of, one_of},
        rng::Stream,
    },
    params::{Overrides, Parameters},
};

use super::{
    answers::Answers,
    curve::{Curve, Improvement},
    keyframes::Keyframes,
    origin::Origin,
    trace::Trace,
};

/// A run that can go forward and back.
pub struct Run {
    pub(super) origin: Origin,
    pub(super) entry: &'static Entry,
    pub(super) scene: Arc<Scene>,
    pub(super) parameters: Parameters,
    pub(super) seed: u64,
    /// The planner, its iteration and its status.
    pub(super) at: Stepper,
    pub(super) limit: u64,
    /// The last iteration, as soon as it is known.
    pub(super) end: Option<u64>,
    pub(super) reference: ReferenceOptimum,
    pub(super) ends: Option<TourEnds>,
    pub(super) stages: Vec<Stage>,
    pub(super) keyframes: Keyframes,
    pub(super) answers: Answers,
    /// The state before the one that was inspected last: while an item is watched, each step costs one more, not a replay.
    pub(super) before: Option<Stepper>,
    pub(super) trace: Trace,
    /// The best so far, once it is asked for: to judge it takes time.
    pub(super) curve: Option<Curve>,
    pub(super) readings: Readings,
    /// What the setup adds to a hash; made when the first is asked for.
    pub(super) setup_digest: OnceCell<Digest>,
    /// What was followed last with the usual parameters, and how that went: an outcome is asked for more often than a path
    /// changes.
    pub(super) followed: Option<(Solution, FollowOutcomes)>,
}

impl Run {
    /// Memory for keyframes if nothing else is asked for, in bytes.
    pub const KEYFRAME_BUDGET: usize = 64 << 20;

    /// Takes up to `steps` steps, the first of which completes one that has begun, its subtasks included; stops where the planner does.
    pub fn step(&mut self, steps: u64) -> Status {
        for _ in 0..steps {
            if !self.step_whole() {
                break;
            }
            self.remember();
        }
        self.status()
    }

    /// Takes a step, if there is one to take.
    fn step_whole(&mut self) -> bool {
        let Self { at, answers, .. } = self;
        let k = at.iteration;
        at.step(|subtasks| answers.of(k, &subtasks))
    }

    /// Does a part of a step. A caller that repeats it can stop between two parts; the run is the same. Subtasks are carried out one
    /// after another; a part of a subtask's step, or up to eight short ones, are a part of the step.
    ///
    /// A part is a whole step or up to about a tenth of a second of work. What cannot be divided takes longer: the start of a run, and one
    /// member of a search in the largest scenes, e.g. a bat that improves a tour of 2000 stops.
    ///
    /// Between the parts iteration and status are those before the step; what is drawn and read is the planner's state within it.
    pub fn part(&mut self) -> Stepped {
        let Self { at, answers, .. } = self;
        let k = at.iteration;
        let stepped = at.part(&mut |subtasks| answers.part_of(k, subtasks));
        if stepped == Stepped::Whole {
            self.remember();
        }
        stepped
    }

    /// Whether the planner is within a step: that step has begun and is not over. False while the step's subtasks are carried out: until
    /// they are, the planner's state is that of [`Run::iteration`].
    pub fn is_partly(&self) -> bool {
        self.at.is_partly()
    }

    /// Goes to iteration `k`, forward or back, exactly; stops early where the planner does.
    pub fn seek(&mut self, k: u64) -> Status {
        self.rewind(k);
        self.step(k.saturating_sub(self.iteration()))
    }

    /// Jumps to the latest state at or before iteration `k` that is at hand, and says which iteration that is.
    /// The rest of the way to `k` is `step`. A step that has begun is given up, unless `k` is ahead and no later state is at hand.
    pub fn rewind(&mut self, k: u64) -> u64 {
        let now = self.iteration();
        let back = k < now || k == now && self.is_partly();
        match self.keyframes.at_or_before(k) {
            Some(state) if back || state.iteration > now => self.at = state.clone(),
            _ if back => self.at = self.start(),
            _ => {}
        }
        self.iteration()
    }

    /// The state at an iteration at or before the present one, without going there: from whatever is at hand nearest to it.
    pub(super) fn state_at(&mut self, k: u64) -> Stepper {
        let kept = self.keyframes.at_or_before(k);
        let mut state = match (self.before.take().filter(|state| state.iteration <= k), kept) {
            (Some(before), kept) if kept.is_none_or(|kept| kept.iteration <= before.iteration) => before,
            (_, Some(state)) => state.clone(),
            (_, None) => self.start(),
        };
        loop {
            let now = state.iteration;
            if now >= k || !state.step(|subtasks| self.answers.of(now, &subtasks)) {
                return state;
            }
        }
    }

    pub(super) fn remember(&mut self) {
        self.keyframes.offer(&self.at);
        if let Some(curve) = &mut self.curve {
            curve.look(&self.scene, &self.at);
        }
        if self.status() != Status::Running {
            self.end = Some(self.at.iteration);
        }
        if self.trace.wants(self.at.iteration) {
            self.read();
            self.trace.push(self.at.iteration, &self.readings);
        }
    }

    pub(super) fn read(&mut self) {
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

    /// Takes steps until so many candidates are evaluated, or up to `steps` of them; stops where the planner does. A step that the
    /// planner is within is completed first.
    pub fn step_to(&mut self, evaluations: u64, steps: u64) -> Status {
        for _ in 0..steps {
            // Within a step a planner may count what it has not evaluated yet.
            if !self.is_partly() && self.evaluations() >= evaluations || self.step(1) != Status::Running {
                break;
            }
        }
        self.status()
    }

    /// The best solution so far and what it costs the planner.
    pub fn best(&self) -> Option<Candidate> {
        self.at.planner.best()
    }

    /// What lists the planner; `None` for one that was started elsewhere.
    pub fn registry(&self) -> Option<&Arc<Registry>> {
        match &self.origin {
            Origin::Registry(registry) => Some(registry),
            Origin::State(_) => None,
        }
    }

    /// The planner's entry.
    pub fn entry(&self) -> &'static Entry {
        self.entry
    }

    /// The scene.
    pub fn scene(&self) -> &Arc<Scene> {
        &self.scene
    }

    /// Every parameter's value.
    pub fn parameters(&self) -> &Parameters {
        &self.parameters
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

    /// The values of the feasible best whenever it changed, up to the furthest iteration. From the first call on it grows with each
    /// step; what was before takes a replay. Within a step it ends with the one before.
    pub fn curve(&mut self) -> &[Improvement] {
        let mut curve = self.curve.take().unwrap_or_default();
        // Mostly it is asked for before the first step: then no planner has to start for it.
        if !self.is_partly() {
            curve.look(&self.scene, &self.at);
        }
        if curve.seen <= self.iteration() {
            let mut state = if curve.seen == 0 { self.start() } else { self.state_at(curve.seen - 1) };
            loop {
                curve.look(&self.scene, &state);
                let now = state.iteration;
                if now >= self.iteration() || !state.step(|subtasks| self.answers.of(now, &subtasks)) {
                    break;
                }
            }
        }
        &self.curve.insert(curve).improvements
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
        if let Some(inspection) = explain.inspect(item) {
            return Some(inspection);
        }
        let created = explain.created_at(item).unwrap_or(self.iteration());
        let before = self.state_at(created.checked_sub(1)?);
        let inspection = before.planner.facets().explain.and_then(|explain| explain.explain_next(item));
        self.before = Some(before);
        inspection
    }

    /// What an item would have done in the step that [`Run::inspect`] explains if one thing had been otherwise; `draw` numbers the
    /// other random numbers. It is carried out on a copy and marked as [`layers::SUPPOSED`].
    ///
    /// # Errors
    /// [`Error::Refused`] for what is not among the explanation's `suppositions`.
    pub fn suppose(&mut self, item: Item, supposition: &str, draw: u64) -> Result<Option<Inspection>, Error> {
        let Some(inspection) = self.inspect(item) else { return Ok(None) };
        let known: Vec<_> = inspection.suppositions.iter().map(|label| label.name).collect();
        if !known.contains(&supposition) {
            return Err(Error::refused("supposition", supposition, one_of(&known)));
        }
        let explain = self.at.planner.facets().explain;
        let mut inspection = explain.and_then(|explain| explain.suppose_now(item, supposition));
        if inspection.is_none() {
            let made = explain.and_then(|explain| explain.created_at(item)).unwrap_or(self.iteration());
            let before = self.state_at(made.saturating_sub(1));
            // From the end, where no planner takes its own.
            let others = Stream::new(self.seed, u64::MAX - draw);
            inspection = before.planner.facets().explain.and_then(|explain| explain.suppose(item, supposition, &others));
            self.before = Some(before);
        }
        if let Some(inspection) = &mut inspection {
            inspection.marks.retain(|mark| [layers::AFTER, layers::VELOCITY, layers::JUMP].iter().any(|layer| layer.key == mark.layer));
            inspection.marks.iter_mut().for_each(|mark| mark.layer = layers::SUPPOSED.key);
        }
        Ok(inspection)
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
        match self.ends {
            Some(ends) => self.scene.exact_tour(self.reference, ends),
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

    /// The runs of other planners, on this scene, that the next step needs; see [`Run::provide`].
    pub fn subtasks(&mut self) -> Vec<Subtask> {
        if self.status() != Status::Running || self.is_partly() || self.answers.knows(self.iteration()) {
            return Vec::new();
        }
        self.at.planner.subtasks().map_or_else(Vec::new, |subtasks| subtasks.requests())
    }

    /// Hands over what the runs of [`Run::subtasks`] found, in their order, so that the next step need not carry them
    /// out itself. What it does with them does not depend on who carried them out.
    ///
    /// # Errors
    /// [`Error::Refused`] for more or fewer than were asked for, for numbers that are not finite and for paths that leave the scene.
    pub fn provide(&mut self, found: Vec<SubtaskResult>) -> Result<(), Error> {
        let wanted = self.subtasks().len();
        if found.len() != wanted {
            return Err(Error::refused("findings", list_of(found.len()), list_of(wanted)));
        }
        let view = self.scene.view();
        found.iter().enumerate().try_for_each(|(i, found)| found.check(&format!("findings[{i}]"), view))?;
        if wanted > 0 {
            self.answers.keep(self.iteration(), found);
        }
        Ok(())
    }

    /// Follows the best path so far as a robot or an arm does: `follower` is the name of one that the registry lists. `None` unless
    /// it applies to the scene and a path was found.
    ///
    /// # Errors
    /// For a follower that is not listed, for a parameter that it does not have, or its value.
    pub fn follow(&self, follower: &str, overrides: &Overrides) -> Result<Option<Box<dyn FollowedPath>>, Error> {
        let follower = self.registry().ok_or_else(|| Error::unknown("follower", follower, []))?.follower(follower)?;
        (follower.follow)(&self.scene, self.best().map(|best| best.solution).as_ref(), overrides)
    }

    /// The hash of setup, iteration, best cost and the whole state, in hexadecimal: two different runs never share one.
    pub fn hash(&self) -> String {
        self.digest().hex()
    }

    pub(crate) fn digest(&self) -> Digest {
        let mut digest = self.setup_digest.get_or_init(|| self.digest_of_setup()).clone();
        self.iteration().digest(&mut digest);
        self.best().map(|best| best.cost).digest(&mut digest);
        self.at.planner.digest(&mut digest);
        digest
    }

    /// Planner, parameters, seed and what is in the scene; its name, title and notes do not matter.
    pub(super) fn digest_of_setup(&self) -> Digest {
        let mut digest = Digest::of(self.entry.name);
        for (name, value) in self.parameters.all() {
            name.digest(&mut digest);
            value.to_string().digest(&mut digest);
        }
        self.seed.digest(&mut digest);
        self.scene.content().digest(&mut digest);
        digest
    }
}

#[cfg(test)]
mod tests;
