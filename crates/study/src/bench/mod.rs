//! Standard benchmark suites: `forage bench`.
//!
//! A suite is a list of [jobs](super::runner::Job), whose rows are kept like those of any experiment. From the rows come a report and the
//! files that the field's tools read.

pub mod barn;
pub mod baselines;
pub mod bbob;
pub mod centre_bias;
mod minimise;
pub mod movingai;
mod recorder;
pub mod suite;
mod targets;
pub mod trees;
pub mod tsplib;

pub use suite::{Contender, Suite};
