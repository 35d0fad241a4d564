//! Particle swarms: `pso`, `wpso`, `cpso` and `wcpso` of [WCPSO](crate#papers), `qpso` and `ltqpso` of [LTQPSO](crate#papers),
//! the continuous bats of [ANTBAT](crate#papers), and what it compares with (`cuckoo-search`, `pso-rrt`), with exchangeable
//! parts.
//!
//! All of them minimise an [`Objective`](objective::Objective). An own one is a search box and a cost; each planner's `on` starts
//! on it. A swarm with a schedule or perturbation of its own is a [`Flight`], and one that moves otherwise keeps its particles in
//! a [`Population`].
//!
//! ```
//! use std::sync::Arc;
//! use forage::{Overrides, kernel::{SceneKindId, Stepper}, swarm::wcpso, swarm::objective::{Evaluation, Objective, Scratch, SearchBox}};
//!
//! /// (x − 1)² + (y − 2)²
//! struct Bowl(SearchBox);
//!
//! impl Objective for Bowl {
//!     fn search_box(&self) -> &SearchBox {
//!         &self.0
//!     }
//!     fn evaluate(&self, x: &[f64], _: &mut Scratch) -> Evaluation {
//!         let [dx, dy] = [x[0] - 1.0, x[1] - 2.0];
//!         (dx * dx + dy * dy).into()
//!     }
//! }
//!
//! let parameters = wcpso::ENTRY.configure(SceneKindId("bowl"), &Overrides::default())?;
//! let bowl = Bowl(SearchBox::cube(2, -10.0, 10.0)?);
//! let mut run = Stepper::from(wcpso::on(Arc::new(bowl), &parameters, 1));
//! while run.step(|_| Vec::new()) {}
//! assert!(run.planner.best().unwrap().cost < 1e-9);
//! # Ok::<(), forage::Error>(())
//! ```
//!
//! In an entry the start is `|start| Ok(wcpso::on(objective, start.parameters, start.seed))`, and
//! [`Entry::like`](crate::describe::Entry::like) takes over what [`wcpso::ENTRY`] describes.
//!
//! # The parts
//! - [`objective`]: what a position means and costs: a function's value, or a path. Two encodings of paths,
//!   [`waypoints`] and [`polar`], over a `terrain` of discs or of blocked cells; `encoding` chooses.
//! - `population`: positions, costs, personal and global bests; whatever moves the particles. `clock`: when it stops.
//! - `flight`: particles with velocities, by a [`schedule`] of ω, c1 and c2 and (for some) a [`perturbation`].
//! - `quantum`: particles that leap. `bat_continuous`: bats. `cuckoo_search`: nests, whose flights `levy` draws.
//! - `explain` says what a step did to one particle, with the tables of `sheet`, `draw` shows it.
//! - `parameters` and `paths`: what the entries share. [`pso`], [`wpso`], [`cpso`], [`wcpso`], [`qpso`], [`ltqpso`]: a file a planner.

pub mod bat_continuous;
mod clock;
pub mod cpso;
pub mod cuckoo_search;
mod draw;
mod encoding;
mod explain;
mod flight;
mod levy;
mod parameters;
mod paths;
pub mod perturbation;
pub mod polar;
mod population;
pub mod pso;
pub mod pso_rrt;
mod quantum;
pub mod schedule;
mod sheet;
mod terrain;
pub mod waypoints;
pub mod wcpso;
pub mod wpso;

pub use crate::kernel::objective;
pub use flight::{Flight, Swarm};
pub use parameters::{FLIGHT, ITERATIONS, POPULATION};
pub use paths::EARLY_STOP;
pub use population::Population;
pub use quantum::{ltqpso, qpso};

/// What an evaluation of a swarm is.
pub(crate) const EVALUATION: &str = "a position";
