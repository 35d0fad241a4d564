//! Suites by which a field compares itself, with planners of ours: `forage bench`.
//!
//! A suite is a list of [jobs](super::runner::Job), whose rows are kept like those of any experiment. Out of the rows the files are
//! written that others' tools read.

pub mod bbob;
pub mod centre_bias;
mod minimise;
pub mod movingai;
pub mod peers;
mod plot;
mod recorder;
pub mod suite;
mod targets;
pub mod tsplib;

use std::sync::Arc;

use forage::{Error, Registry, Run, Setup, Status, params::Domain};

pub use suite::{Contender, Suite};

/// The parameter by which planners say how long they run.
const ITERATIONS: &str = "iterations";

/// After how many iterations a run has spent `budget` evaluations, by its first step that spends some: schedules over the iterations, as
/// of an inertia weight, come to their end there.
///
/// # Errors
/// What the planner refuses.
pub fn iterations_within(registry: &Arc<Registry>, setup: &Setup, budget: u64) -> Result<u64, Error> {
    let mut run = Run::with_keyframes(registry, setup.clone(), 0)?;
    let begun = run.evaluations();
    let mut idle = 0;
    let spent = loop {
        let status = run.step(1);
        let spent = run.evaluations() - begun;
        if spent > 0 || status != Status::Running {
            break spent;
        }
        idle += 1;
    };
    let most = most_iterations(registry, &setup.planner)?;
    Ok((idle + budget.saturating_sub(begun).div_ceil(spent.max(1))).clamp(1, most))
}

/// The most iterations that a planner takes.
fn most_iterations(registry: &Registry, planner: &str) -> Result<u64, Error> {
    Ok(match registry.planner(planner)?.parameter(ITERATIONS).map(|parameter| parameter.domain) {
        Some(Domain::Integer { max, .. }) => max,
        _ => u64::MAX,
    })
}
