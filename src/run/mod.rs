//! One run: a scene, a planner with parameters and a seed, stepped, rewound, judged and shared.
//!
//! `setup` is what a run is made of, `start` begins it, `stepping` steps, rewinds, draws and reads it, `outcome` judges it, and [`link`]
//! puts it into an address. `subtasks` carries out the runs of other planners that a run needs; `answers` remembers what they
//! found. `keyframes` and `origin` are for the way back, `trace` has the readings of past iterations, `curve` the best results.
//! `task` judges a run by what it was to reach, `handed_in` reads lists of links to grade. [`trial`] is one run of many, summed up in a line.

mod answers;
mod curve;
#[cfg(not(target_arch = "wasm32"))]
mod handed_in;
mod keyframes;
pub mod link;
mod origin;
mod outcome;
mod setup;
#[cfg(not(target_arch = "wasm32"))]
mod spending;
mod start;
mod stepping;
mod subtasks;
#[cfg(not(target_arch = "wasm32"))]
mod task;
mod trace;
pub mod trial;

pub use curve::Improvement;
#[cfg(not(target_arch = "wasm32"))]
pub use handed_in::{Handed, handed_in};
pub use link::Link;
pub use outcome::Outcome;
pub use setup::Setup;
#[cfg(not(target_arch = "wasm32"))]
pub use spending::{ITERATIONS, Spending};
pub use stepping::Run;
pub use subtasks::{run_subtasks, run_subtasks_until, run_to_end};
#[cfg(not(target_arch = "wasm32"))]
pub use task::{Goal, Judgement, Task};
#[cfg(not(target_arch = "wasm32"))]
pub(crate) use trace::OTHER_READINGS;
pub use trace::{Trace, csv_heading, csv_line, csv_row};
pub use trial::Trial;
