//! **Forage** is a laboratory for path planners: a *scene* and a *planner* (with parameters and a seed) make a
//! *session*; a session *steps*; after each step it can be drawn, read, explained, rewound and judged, the same way
//! for every planner. The shell, Node and the page are three thin faces on that, and all give the same bits.
//!
//! ```
//! use forage::{Session, Setup, shipped};
//!
//! let setup = Setup { planner: "wcpso".into(), scene: shipped("wcpso-discs")?, params: Default::default(), seed: 1 };
//! let mut session = Session::new(setup)?;
//! session.step(500);
//! let outcome = session.outcome();
//! println!("{} within {:.3} % of the optimum", outcome.length.unwrap(), 100.0 * outcome.gap.unwrap());
//! # assert!(outcome.feasible);
//! # Ok::<(), forage::Error>(())
//! ```
//!
//! # The map of the house
//! From the ground up; a module uses what is above it in this list.
//! - [`math`], [`statistics`], [`geometry`]: deterministic functions, tests between samples, shapes.
//! - [`kernel`]: the contracts that planners and scenes implement, and the data that they speak of: errors, random streams,
//!   solutions, readings, frames, digests.
//! - [`describe`]: what the entries of planners and of scene kinds are made of. [`params`]: parameters, and values for them.
//! - [`exact`]: exact optima. [`scene`]: what is planned in, a folder a kind, and the scene files.
//! - [`arm`]: six-axis arms, their kinematics, what they touch, and how they follow a path.
//! - [`swarm`], [`ants`], [`search`], [`tour`], [`tree`], [`tuning`]: planners. A folder a family; a file a planner or a
//!   part of one.
//! - [`drive`]: a robot that follows what was found, and what its outline touches.
//! - [`catalogue`]: every planner and its parameters; nothing else lists planners.
//! - [`session`]: one run, with rewind, hash and [`link`]. [`picture`]: what it looks like. [`trial`]: one run of many,
//!   summed up in a line.
//!
//! Papers are cited by tag and equation: `[WCPSO]` is Jia Huiqun et al., *Path planning based on improved particle
//! swarm optimization algorithm*, Transactions of the Chinese Society for Agricultural Machinery, 2018 no. 12.

// `#[derive(State)]` writes paths as they are from outside.
extern crate self as forage;

pub mod ants;
pub mod arm;
pub mod catalogue;
pub mod describe;
pub mod drive;
mod dynamic;
pub mod exact;
pub mod geometry;
pub mod kernel;
pub mod link;
pub mod math;
pub mod params;
pub mod picture;
pub mod scene;
pub mod search;
pub mod session;
mod settled;
pub mod statistics;
pub mod swarm;
pub mod tour;
pub mod tree;
pub mod trial;
pub mod tuning;
#[cfg(target_arch = "wasm32")]
pub mod wasm;

pub use catalogue::catalogue;
pub use drive::{Drive, DriveOutcome};
pub use kernel::{Error, Frame, Status};
pub use link::Link;
pub use params::{Overrides, Value};
pub use scene::{Scene, shipped, shipped_names};
pub use session::{Outcome, Session, Setup};
pub use trial::Trial;
