//! One run: a scene, a planner with parameters and a seed, stepped, rewound, judged and shared.
//!
//! `setup` is what a run is made of, `start` begins it, `run` steps, rewinds, draws and reads it, `outcome` judges it. `subtasks` carries
//! out the runs of other planners that a run needs; `answers` remembers what they found. `keyframes` are for the way back,
//! `trace` has the readings of past iterations.

mod answers;
mod keyframes;
mod outcome;
mod run;
mod setup;
mod start;
mod subtasks;
mod trace;

pub use outcome::Outcome;
pub use run::Session;
pub use setup::Setup;
pub use subtasks::{run_subtasks, run_to_end};
pub use trace::{Trace, csv_heading, csv_line, csv_row};
