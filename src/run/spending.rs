//! The evaluations of a run, estimated from its first step: equal budgets are set by it.

use std::sync::Arc;

use crate::{
    describe::Registry,
    kernel::{Error, Status},
    params::Domain,
};

use super::{setup::Setup, stepping::Run};

/// The parameter by which planners say how long they run.
pub const ITERATIONS: &str = "iterations";

/// What a run spends.
///
/// ```
/// use forage::{Setup, run::Spending, shipped, standard};
/// let setup = Setup { planner: "pso".into(), scene: shipped("sphere")?, params: Default::default(), seed: 1 };
/// let spending = Spending::of(standard(), &setup)?;
/// assert_eq!(spending.all(), spending.start + spending.step * spending.limit);
/// assert_eq!(spending.iterations(spending.all()), spending.limit);
/// # Ok::<(), forage::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Spending {
    /// Evaluations before its first step.
    pub start: u64,
    /// Steps that evaluate nothing, before the first that does.
    pub idle: u64,
    /// Evaluations of that one; 0: no step has any.
    pub step: u64,
    /// The most steps that it takes, as it is set up.
    pub limit: u64,
    /// The most that it could be set to.
    pub most: u64,
}

impl Spending {
    /// Starts a run and takes steps until one has spent something.
    ///
    /// # Errors
    /// As [`Run::new`].
    pub fn of(registry: &Arc<Registry>, setup: &Setup) -> Result<Self, Error> {
        let most = match registry.planner(&setup.planner)?.parameter(ITERATIONS).map(|parameter| parameter.domain) {
            Some(Domain::Integer { max, .. }) => max,
            _ => u64::MAX,
        };
        let mut run = Run::with_keyframes(registry, setup.clone(), 0)?;
        let (start, limit) = (run.evaluations(), run.limit());
        let mut idle = 0;
        loop {
            let status = run.step(1);
            let step = run.evaluations() - start;
            if step > 0 || status != Status::Running {
                return Ok(Self { start, idle, step, limit, most });
            }
            idle += 1;
        }
    }

    /// The evaluations of all steps, by the estimate.
    pub fn all(&self) -> u64 {
        self.start.saturating_add(self.step.saturating_mul(self.limit.saturating_sub(self.idle)))
    }

    /// The number of iterations that spends this many evaluations; the last one is finished. Schedules over the iterations, such as an
    /// inertia weight's, then end with the budget.
    pub fn iterations(&self, evaluations: u64) -> u64 {
        (self.idle + evaluations.saturating_sub(self.start).div_ceil(self.step.max(1))).clamp(1, self.most)
    }
}
