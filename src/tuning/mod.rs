//! A particle swarm over the parameters of an ant colony, [WOLF-ANT](crate#papers) §5.2: a planner that runs planners.
//!
//! It finds colonies in the list of planners that it starts with and never runs one: it asks for runs as subtasks, which may
//! run in parallel without changing the result. `swarm` is its state, `planner` the stepped contract, `explain` what a
//! particle stands for, `parameters` what is searched, `entry` the entry.

mod entry;
mod explain;
mod parameters;
mod planner;
mod swarm;
#[cfg(test)]
mod tests;

pub use entry::ENTRY;

/// What an evaluation is of a planner that tunes another one.
pub(crate) const EVALUATION: &str = "a run of the colony";
