//! What the papers claim, as questions that runs can answer: upheld, refuted or undecided.
//!
//! A [`Claim`] quotes the paper and has [`Part`]s. A part names scenes, planners with their parameters ([`Arm`]) and a [`Question`]
//! that a test answers with seeds which no parameter was chosen by. The mark follows from the parts' answers by one rule ([`Mark`]).
//! Each paper has a file with its claims, as data, and a [`Study`](super::study::Study) that carries their runs out.

mod antbat;
mod arm_rrt;
mod claim;
mod judge;
mod judged;
mod ltqpso;
mod measure;
mod paper;
mod run;
mod show;
mod studies;
mod task;
mod wcpso;
mod wolf_ant;
mod words;

#[cfg(test)]
mod tests;

pub use claim::{Arm, Claim, Event, On, Part, Question, SEEDS, SEEDS_ON_MAPS, Until};
pub use judged::{Answer, Answered, Judged, Mark};
pub use measure::{EVALUATIONS, GAP, LENGTH, Measure, VALUE};
pub use show::{RULES, counted, json, markdown, text};
pub use studies::STUDIES;
