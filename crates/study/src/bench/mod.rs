//! Suites by which a field compares itself, with planners of ours: `forage bench`.
//!
//! A suite is a list of [jobs](super::runner::Job), whose rows are kept like those of any experiment. Out of the rows the files are
//! written that others' tools read.

pub mod barn;
pub mod bbob;
pub mod centre_bias;
mod minimise;
pub mod movingai;
pub mod peers;
mod recorder;
pub mod suite;
mod targets;
pub mod trees;
pub mod tsplib;

pub use suite::{Contender, Suite};
