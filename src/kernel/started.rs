//! How a run begins, and its planner under way.

use super::{Planner, Progress, ReferenceOptimum, Stage, Status, Subtask, SubtaskResult, TourEnds};

/// A planner at iteration 0, and what does not change while it runs.
pub struct Started {
    /// Before its first step.
    pub planner: Box<dyn Planner>,
    /// After how many steps it stops at the latest.
    pub limit: u64,
    /// It may well be over before that. Otherwise the limit is its end, and known from the beginning.
    pub open_ended: bool,
    /// Whether there is anything to do.
    pub progress: Progress,
    /// Which optimum its results are measured by.
    pub reference: ReferenceOptimum,
    /// What the ends of its tours are, if it finds tours.
    pub round: Option<TourEnds>,
    /// The parts of a run, in their order; none, for most: all steps are of one kind.
    pub stages: Vec<Stage>,
}

impl Started {
    /// A planner with something to do, measured by the shortest path at any angle.
    pub fn new(planner: impl Planner, limit: u64) -> Self {
        Self {
            planner: Box::new(planner),
            limit,
            open_ended: false,
            progress: Progress::Continue,
            reference: ReferenceOptimum::default(),
            round: None,
            stages: Vec::new(),
        }
    }

    /// A run that may well be over before its limit.
    #[must_use]
    pub fn open_ended(self) -> Self {
        Self { open_ended: true, ..self }
    }

    /// Measured by this optimum.
    #[must_use]
    pub fn measured_by(self, reference: ReferenceOptimum) -> Self {
        Self { reference, ..self }
    }

    /// A run that is over before its first step unless there is a solution.
    #[must_use]
    pub fn solvable(self, solvable: bool) -> Self {
        let progress = if solvable { Progress::Continue } else { Progress::Done(Status::Infeasible) };
        Self { progress, ..self }
    }

    /// Of these parts.
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

/// A planner under way: how many steps it took, and whether it goes on. A clone is a keyframe.
pub struct Stepper {
    /// Its state.
    pub planner: Box<dyn Planner>,
    /// How many steps it took.
    pub iteration: u64,
    /// Whether there is more to do, or why not.
    pub status: Status,
    limit: u64,
}

impl Clone for Stepper {
    fn clone(&self) -> Self {
        Self { planner: self.planner.clone_box(), ..*self }
    }
}

impl Stepper {
    /// A planner before its first step.
    pub fn new(planner: Box<dyn Planner>, limit: u64, progress: Progress) -> Self {
        let mut stepper = Self { planner, iteration: 0, status: Status::Running, limit };
        stepper.note(progress);
        stepper
    }

    /// The memory that a copy takes, in bytes.
    pub fn size(&self) -> usize {
        size_of::<Self>() + self.planner.heap_size()
    }

    /// Takes a step and says whether there was one to take. `answer` carries out the runs that it rests on.
    pub fn step(&mut self, answer: impl FnOnce(Vec<Subtask>) -> Vec<SubtaskResult>) -> bool {
        if self.status != Status::Running {
            return false;
        }
        if let Some(subtasks) = self.planner.subtasks() {
            let requests = subtasks.requests();
            if !requests.is_empty() {
                subtasks.provide(answer(requests));
            }
        }
        let progress = self.planner.advance();
        self.iteration += 1;
        self.note(progress);
        true
    }

    fn note(&mut self, progress: Progress) {
        self.status = match progress {
            Progress::Done(status) => status,
            Progress::Continue if self.iteration >= self.limit => Status::Exhausted,
            Progress::Continue => Status::Running,
        };
    }
}
