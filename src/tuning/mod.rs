//! A particle swarm over the parameters of an ant colony, [WOLF-ANT] §5.2: a planner that runs planners.
//!
//! It knows colonies only as everybody does, by the catalogue and the stepped contract, and never runs one: its runs are
//! [`Subtasks`], which may be carried out side by side; the outcome does not depend on it.

mod entry;
mod explain;
mod parameters;
mod planner;
mod swarm;
#[cfg(test)]
mod tests;

pub use entry::ENTRY;
pub use parameters::SYMBOLS;
