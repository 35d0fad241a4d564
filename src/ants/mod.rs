//! Ants that go from cell to cell of a grid and lay pheromone on their paths, [ANTBAT](crate#papers) §3.1 and
//! [WOLF-ANT](crate#papers) §5.1.
//!
//! There is one [`Colony`]. What the planners differ in is its [`Variant`]: how an ant sees the cells around it, how it chooses among
//! them, and what it lays. [`start`] makes a planner of any variant, with own parts, too:
//!
//! ```
//! use forage::{ants::{self, Heuristic, Update, Variant, aco}, describe::Entry};
//!
//! /// Ants that keep off walls, and of which only those lay pheromone that are better than most.
//! const SHY: Variant = Variant {
//!     heuristic: Heuristic::Own(|cells, next, goal| f64::from(cells.moves(next).count_ones()) / cells.apart(next, goal).max(0.5)),
//!     update: Update::Own(|ant| if ant.length <= ant.iteration[1] { ant.q / ant.length } else { 0.0 }),
//!     greed: [0.0, 0.5],
//!     ..Variant::TRADITIONAL
//! };
//! const ENTRY: Entry =
//!     Entry::new("aco-shy", "Shy ants", "", "Ants that keep off walls.", |start| ants::start(start, SHY)).like(&aco::ENTRY);
//! # assert_eq!(ENTRY.family, "ants");
//! ```
//!
//! # The parts
//! `colony` is the state, `planner` its stepped contract; `draw` shows it, `explain` says why an ant chose a step. An ant sees by
//! `ground`, chooses by `walk` and lays by `update`. `pheromone` keeps τ and the choice weights, which are made once per
//! iteration for each cell that an ant comes to; a step is then a look-up and one random number. `scouts` are ants sent around
//! obstacles of a drive; `colonies` lists the planners for others to choose from.

pub mod aco;
pub mod aco_dijkstra;
pub mod aco_direction;
pub mod aco_wolf;
mod colonies;
mod colony;
mod draw;
mod explain;
mod ground;
mod parameters;
mod pheromone;
mod planner;
mod scouts;
#[cfg(test)]
mod tests;
mod update;
mod walk;

pub(crate) use colonies::COLONIES;
pub use colony::{Colony, Variant};
pub use ground::{Direction, Heuristic};
pub use planner::start;
pub(crate) use scouts::Scouts;
pub use update::{Arrival, Update};

/// What an evaluation of a colony is.
pub(crate) const EVALUATION: &str = "an ant’s path from the start";
