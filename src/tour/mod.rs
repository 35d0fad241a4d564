//! Tours through many stops, [ANTBAT](crate#papers) §3.2 and §3.3: a road network first, then an order of the stops.
//!
//! There is one run of two stages. On a grid the first stage has other planners build the road between each
//! two stops; scenes of kind `tour` have their distances already. The second searches the order: what its
//! planners differ in is a [`Search`]. An own one is a planner by [`start`]: it improves [`Tour`]s of a [`Problem`] by [`moves`], a
//! [`LocalSearch`] or whatever it likes.
//!
//! ```
//! use std::sync::Arc;
//! use forage::{
//!     describe::Entry,
//!     kernel::{State, rng::Stream},
//!     tour::{self, Problem, Search, Tour, moves, two_opt},
//! };
//!
//! /// Random tours, each made as short as 2-opt and Or-opt moves can make it.
//! #[derive(Clone, State)]
//! struct Restarts {
//!     #[state(shared)]
//!     problem: Arc<Problem>,
//!     local: tour::LocalSearch,
//!     best: Tour,
//!     rng: Stream,
//! }
//!
//! impl Search for Restarts {
//!     fn step(&mut self) {
//!         let mut tour = moves::random_tour(&self.problem, &mut self.rng);
//!         self.local.polish(&mut tour);
//!         if tour.length < self.best.length {
//!             self.best = tour;
//!         }
//!     }
//!     fn evaluations(&self) -> u64 {
//!         self.local.tried()
//!     }
//!     fn best(&self) -> Option<&Tour> {
//!         Some(&self.best)
//!     }
//! }
//!
//! const ENTRY: Entry = Entry::new("restarts", "Restarts", "Lin 1965", "Random tours, made short by moves.", |start| {
//!     tour::start(start, &[], |problem, _, rng| {
//!         let (problem, local) = (problem.clone(), tour::LocalSearch::new(problem));
//!         Box::new(Restarts { best: Tour::first(&problem), problem, local, rng })
//!     })
//! })
//! .like(&two_opt::ENTRY)
//! .readings(&[tour::BEST, tour::BUILT, tour::FAILED, tour::BY_ROAD, tour::FOUND]);
//! # assert!(ENTRY.stops);
//! ```
//!
//! # The parts
//! - `search`: what planners differ in, a file a planner: [`bat`], [`hybrid_bat`], [`ga`], [`sa`], [`tour_pso`], [`two_opt`],
//!   [`held_karp`].
//! - `problem`: what they search. [`moves`]: the changes that they make; `local`, `kicks`, `swaps`, `nearest`: what several of them use.
//! - `tours`: roads, then a tour, under way; `roads`: the road network. `planner`: the stepped contract.
//! - `draw` and `explain`: what it looks like and why; `parameters`: what the entries share.

pub mod bat;
mod draw;
mod explain;
mod field;
pub mod ga;
pub mod held_karp;
pub mod hybrid_bat;
mod kicks;
mod local;
pub mod moves;
mod nearest;
mod parameters;
mod planner;
mod problem;
mod roads;
pub mod sa;
mod search;
mod swaps;
#[cfg(test)]
mod tests;
pub mod tour_pso;
mod tours;
pub mod two_opt;

pub use crate::settled::SETTLED;
pub use local::LocalSearch;
pub use nearest::nearest_neighbour;
pub use parameters::{BEST, BUILT, BY_ROAD, DIFFERENT, FAILED, FOUND, ITERATIONS, MEAN, TOURS};
pub use planner::start;
pub use problem::{Problem, Stop, Tour};
pub use search::{Begin, CopySearch, Search};

/// What an evaluation of a tour planner is.
pub(crate) const EVALUATION: &str = "a tour, or a change of one, that is measured";
