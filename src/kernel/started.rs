//! A planner at the start of its run, and in the course of it.

use super::{Planner, Progress, ReferenceOptimum, Stage, Status, Subtask, SubtaskResult, Subtasks, TourEnds};

/// A planner at iteration 0, and what does not change while it runs.
#[non_exhaustive]
pub struct Started {
    /// The planner, before its first step.
    pub planner: Box<dyn Planner>,
    /// The iteration limit.
    pub limit: u64,
    /// Whether the run may end before its limit. Otherwise the limit is its end.
    pub open_ended: bool,
    /// Whether there is a first step to take.
    pub progress: Progress,
    /// The optimum that its results are measured against.
    pub reference: ReferenceOptimum,
    /// Where its tours begin and end, if it finds tours.
    pub ends: Option<TourEnds>,
    /// The stages of the run, in order; empty if all steps are of one kind.
    pub stages: Vec<Stage>,
}

impl Started {
    /// A run with a first step to take, measured against the shortest path at any angle.
    pub fn new(planner: impl Planner, limit: u64) -> Self {
        Self {
            planner: Box::new(planner),
            limit,
            open_ended: false,
            progress: Progress::Continue,
            reference: ReferenceOptimum::default(),
            ends: None,
            stages: Vec::new(),
        }
    }

    /// Declares that the run may end before its limit.
    #[must_use]
    pub fn open_ended(self) -> Self {
        Self { open_ended: true, ..self }
    }

    /// Sets the optimum that results are measured against.
    #[must_use]
    pub fn measured_by(self, reference: ReferenceOptimum) -> Self {
        Self { reference, ..self }
    }

    /// Ends the run before its first step unless there is a solution.
    #[must_use]
    pub fn solvable(self, solvable: bool) -> Self {
        let progress = if solvable { Progress::Continue } else { Progress::Done(Status::Infeasible) };
        Self { progress, ..self }
    }

    /// Sets the stages of the run.
    #[must_use]
    pub fn in_stages(self, stages: Vec<Stage>) -> Self {
        Self { stages, ..self }
    }
}

impl From<Started> for Stepper {
    fn from(started: Started) -> Self {
        Self::new(started.planner, started.limit, started.progress)
    }
}

/// A planner with its iteration and its status. A clone between two steps is a keyframe.
pub struct Stepper {
    /// The planner.
    pub planner: Box<dyn Planner>,
    /// The number of steps taken.
    pub iteration: u64,
    /// Whether there is more to do, or why not.
    pub status: Status,
    limit: u64,
    /// A step has begun and is not over.
    partly: bool,
}

/// What is known of the subtasks that a step needs.
#[derive(Debug, Clone, PartialEq)]
pub enum Answer {
    /// The step needs none.
    Unneeded,
    /// Not all of them are carried out yet.
    Partly,
    /// What they found, in the order of the requests.
    Found(Vec<SubtaskResult>),
}

/// What a part of a step has led to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Stepped {
    /// A step was completed.
    Whole,
    /// There is more to do of this step.
    Partly,
    /// Nothing was done: the run is over.
    Not,
}

impl Stepped {
    /// Takes up to `steps` steps by `part`, which does a part of one; returns after the first part of a step that is long.
    pub fn repeat(steps: u64, mut part: impl FnMut() -> Self) -> Self {
        for _ in 1..steps {
            match part() {
                Self::Whole => {}
                other => return other,
            }
        }
        part()
    }
}

impl Clone for Stepper {
    fn clone(&self) -> Self {
        Self { planner: self.planner.clone_box(), ..*self }
    }
}

impl Stepper {
    /// A planner before its first step.
    pub fn new(planner: Box<dyn Planner>, limit: u64, progress: Progress) -> Self {
        let mut stepper = Self { planner, iteration: 0, status: Status::Running, limit, partly: false };
        stepper.note(progress);
        stepper
    }

    /// The memory of a copy, in bytes.
    pub fn size(&self) -> usize {
        size_of::<Self>() + self.planner.heap_size()
    }

    /// Whether the planner is within a step: that step has begun and is not over. While its subtasks are carried out the planner has not
    /// begun the step.
    pub fn is_partly(&self) -> bool {
        self.partly
    }

    /// Takes a step, or completes the one that has begun; `false` if the run is over. `answer` carries out the subtasks that the step
    /// needs.
    pub fn step(&mut self, answer: impl FnOnce(Vec<Subtask>) -> Vec<SubtaskResult>) -> bool {
        let mut answer = Some(answer);
        loop {
            let answered = self.part(&mut |subtasks| match subtasks.requests() {
                requests if requests.is_empty() => Answer::Unneeded,
                requests => answer.take().map_or(Answer::Unneeded, |answer| Answer::Found(answer(requests))),
            });
            match answered {
                Stepped::Whole => return true,
                Stepped::Partly => {}
                Stepped::Not => return false,
            }
        }
    }

    /// Does a part of a step. `answer` carries out the subtasks that it needs, or a part of them. It asks for the requests itself, so
    /// that they are not made for each part.
    pub fn part(&mut self, answer: &mut dyn FnMut(&dyn Subtasks) -> Answer) -> Stepped {
        if self.status != Status::Running {
            return Stepped::Not;
        }
        if !self.partly
            && let Some(subtasks) = self.planner.subtasks()
        {
            match answer(&*subtasks) {
                Answer::Unneeded => {}
                Answer::Partly => return Stepped::Partly,
                Answer::Found(found) => subtasks.provide(found),
            }
        }
        let progress = self.planner.advance();
        self.partly = progress == Progress::Partly;
        if self.partly {
            return Stepped::Partly;
        }
        self.iteration += 1;
        self.note(progress);
        Stepped::Whole
    }

    fn note(&mut self, progress: Progress) {
        self.status = match progress {
            Progress::Done(status) => status,
            _ if self.iteration >= self.limit => Status::Exhausted,
            _ => Status::Running,
        };
    }
}
