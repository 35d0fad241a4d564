//! How a run begins.

use std::{cell::OnceCell, sync::Arc};

use crate::{
    catalogue::PLANNERS,
    describe::Start,
    kernel::{Error, Readings, Started, Stepper},
};

use super::{answers::Answers, keyframes::Keyframes, run::Session, setup::Setup, subtasks::run_subtasks, trace::Trace};

impl Session {
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
            answers: Answers::new(Arc::clone(&scene), budget > 0, run_subtasks),
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
}
