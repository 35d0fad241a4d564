//! **Forage** is a laboratory for path planners: particles, quantum swarms, ants, bats and trees that look for a way, one
//! iteration at a time, with the same bits natively and in WebAssembly.
//!
//! A [`Scene`] and a planner, with parameters and a seed, make a [`Run`]. A run steps; after each step it can be drawn, read,
//! explained, rewound and judged, the same way for every planner, ours or yours. The command line, Node and the page are
//! thin faces on that.
//!
//! ```
//! use forage::{Run, Setup, shipped, standard};
//!
//! let setup = Setup { planner: "wcpso".into(), scene: shipped("wcpso-discs")?, params: Default::default(), seed: 1 };
//! let mut run = Run::new(standard(), setup)?;
//! run.step(500);
//! let outcome = run.outcome();
//! println!("{} within {:.3} % of the optimum", outcome.length.unwrap(), 100.0 * outcome.gap.unwrap());
//! # assert!(outcome.feasible);
//! # Ok::<(), forage::Error>(())
//! ```
//!
//! # Where to begin
//! - **Run something**: [`Registry`] lists what there is, [`Setup`] says what to run, [`Run`] runs it, [`Outcome`] judges it.
//! - **Bring a planner**: implement [`Planner`](kernel::Planner), describe it in an [`Entry`](describe::Entry), and list it by
//!   [`Registry::with`]. `examples/own-planner` is a crate that does; its `main` is a whole command line.
//! - **Bring a part**: an objective for a swarm ([`swarm::objective`]), a kind of scene ([`describe::SceneKind`]), and what each
//!   family's page says can be exchanged.
//! - **Check it**: `testing` tries what every planner must keep to, ours and yours, and says what is wrong and what helps.
//!
//! Six examples that run, in `examples/`: `own_objective` (a function of one's own under a swarm), `step_and_draw` (a run
//! stepped, read, rewound and drawn), `tour` (stops in TSPLIB's format), `arm` (a path for a six-axis arm, and the arm on it),
//! `seeds` (many seeds, and whether two planners differ), `node.mjs` (a run in Node). The book, in `docs/`, has a glossary.
//!
//! # The map
//! From the ground up: a module knows what stands above it here, and nothing below. No two files import each other at any
//! distance; a test sees to it.
//! - [`math`], [`geometry`]: deterministic functions, shapes.
//! - [`kernel`]: the contracts of planners and scenes, and the data that they speak of: candidates, readings, frames, random
//!   streams, states and their hashes, errors.
//! - [`statistics`]: tests between samples, and what many runs have in common.
//! - [`params`], [`describe`]: parameters; what entries are made of, and the [`Registry`] that lists them.
//! - [`arm`], [`exact`]: six-axis arms, their kinematics and collisions; exact optima.
//! - [`scene`]: the kinds of scenes, a folder each, other programs' files, random scenes.
//! - [`run`]: a run, its subtasks, its way back, its outcome and its link; a trial, one run of many.
//! - [`swarm`], [`ants`], [`search`], [`tour`], [`tree`], [`dynamic`], [`tuning`]: planners, a folder a family and a file a planner.
//! - [`follow`]: a robot or an arm on the path that was found. [`picture`]: what a run looks like.
//! - [`standard`]: all that ships, a line each.
//! - `testing`: the conformance suite, which checks what every planner promises; not in WebAssembly.
//!
//! The JavaScript face, the command line and the study of many runs are crates of their own above this one.
//!
//! # Papers
//! The documentation cites them by these tags, with section, table or equation number. All five are in Chinese; what the
//! copies that we used do not print is marked with "probably" or "not printed".
//! - **WCPSO**: Jia Huiqun (贾会群) et al., *Path Planning Based on Improved Particle Swarm Optimization Algorithm*
//!   (基于改进粒子群算法的路径规划), Transactions of the Chinese Society for Agricultural Machinery, 2018, no. 12.
//! - **LTQPSO**: Liu Jie (刘洁), Zhao Haifang (赵海方), Zhou Delian (周德廉), *Path planning of mobile robots with an improved
//!   quantum-behaved PSO* (一种改进量子行为粒子群优化算法的移动机器人路径规划; our translation), probably Computer Science,
//!   no. 11A; year and volume not printed.
//! - **ANTBAT**: Fang Min (方敏), Jin Shijun (金世俊), *Multi-point path planning based on ant colony and bat algorithms*
//!   (基于蚁群算法和蝙蝠算法的多点路径规划; our translation), probably Electronic Measurement Technology, no. 18; year and
//!   volume not printed.
//! - **ARM-RRT**: Dai Yanhui (代彦辉), Liang Yanyang (梁艳阳), Xie Gang, *The Mechanical Arm of Six-Dof Obstacle Avoidance Path
//!   Planning Based on Rapid-Exploring Random Trees* (基于RRT搜索算法的六自由度机械臂避障路径规划), Techniques of Automation &
//!   Applications, 2012, no. 10, 31–37.
//! - **WOLF-ANT**: *Dynamic path planning of a mobile robot based on an improved ant colony algorithm* (our translation of
//!   基于改进蚁群算法的移动机器人动态路径规划方法, from its abstract); title, authors, journal and year not printed.

// `#[derive(State)]` writes paths as they are from outside.
extern crate self as forage;

pub mod ants;
pub mod arm;
pub mod describe;
pub mod dynamic;
pub mod exact;
pub mod follow;
pub mod geometry;
pub mod kernel;
pub mod math;
pub mod params;
pub mod picture;
pub mod registry;
pub mod run;
pub mod scene;
pub mod search;
mod settled;
pub mod statistics;
pub mod swarm;
#[cfg(not(target_arch = "wasm32"))]
pub mod testing;
pub mod tour;
pub mod tree;
pub mod tuning;
#[cfg(feature = "types")]
pub mod types;

pub use describe::Registry;
pub use kernel::{Error, Frame, Scene, Status};
pub use params::{Overrides, Value};
pub use registry::{shipped, standard};
pub use run::{Link, Outcome, Run, Setup, Trial};
