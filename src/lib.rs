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
//! - [`planner`]: the stepped contract that a planner's author implements.
//! - [`catalogue`]: every planner and its parameters; nothing else lists planners.
//! - [`scene`]: what is planned in, one file a kind, and the scene files. [`exact`]: the oracles for them.
//! - [`swarm`]: particle swarms. [`search`]: exact searches over a grid's cells. A folder a family; a file a planner or a
//!   part of one.
//! - [`tree`]: rapidly-exploring random trees, in the plane, in space and in joints. [`arm`]: six-axis arms, their
//!   kinematics, what they touch, and how they follow a path.
//! - [`drive`]: a robot that follows what was found, and what its outline touches.
//! - [`session`]: one run, with rewind, hash and link. [`frame`] and [`picture`]: what it looks like.
//! - [`trial`]: one run of many, summed up in a line. [`statistics`]: what many of them have in common, and tests between them.
//! - [`geometry`], [`math`], [`rng`], [`digest`], [`error`](mod@error): the ground.
//!
//! Imports point one way: faces → session → catalogue → families → scene, geometry, exact → math, rng, error.
//!
//! Papers are cited by tag and equation: `[WCPSO]` is Jia Huiqun et al., *Path planning based on improved particle
//! swarm optimization algorithm*, Transactions of the Chinese Society for Agricultural Machinery, 2018 no. 12.

pub mod ants;
pub mod any;
pub mod arm;
pub mod catalogue;
pub mod describe;
pub mod digest;
pub mod drive;
mod dynamic;
pub mod error;
pub mod exact;
pub mod frame;
pub mod geometry;
pub mod json;
pub mod link;
pub mod math;
pub mod params;
pub mod picture;
pub mod planner;
pub mod rng;
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
pub mod way;

pub use catalogue::catalogue;
pub use drive::{Drive, DriveOutcome};
pub use error::Error;
pub use frame::Frame;
pub use link::Link;
pub use params::{Given, Value};
pub use planner::Status;
pub use scene::{Scene, shipped, shipped_names};
pub use session::{Outcome, Session, Setup};
pub use trial::Trial;
