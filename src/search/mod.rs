//! Exact searches over a grid's cells that step like every other planner: `dijkstra`, `a-star` and `theta-star`.
//!
//! One search (`best_first`) composed of two parts (`rules`): a [`Heuristic`], which says how far it still is, and a
//! [`Relaxation`], which says whose child a cell becomes. [`start`] makes a planner of them, with an own heuristic, too:
//!
//! ```
//! use forage::{describe::Entry, search::{self, Heuristic, Relaxation, dijkstra}};
//!
//! /// Goes wherever the goal seems nearest: what it costs to come there hardly counts.
//! const GREEDY: Entry = Entry::new("greedy", "Greedy best-first", "Doran and Michie 1966", "To the goal first.", |start| {
//!     search::start(start, Heuristic::Own(|[columns, rows]| columns + rows), 1e6, Relaxation::Step)
//! })
//! .like(&dijkstra::ENTRY);
//! # assert_eq!(GREEDY.family, "search");
//! ```
//!
//! # The parts
//! - `open`: the cells reached and not settled, in order. `link`: how a cell was reached. `sight`: whether one cell sees another.
//! - `found`: the path, and the path without the nodes that it does not need. `planner`: the stepped contract.
//! - `draw` shows the cells settled and the frontier, `explain` says why a cell has the number it has.
//! - `parameters`: what the entries share. [`dijkstra`], [`a_star`], [`theta_star`]: a file a planner.

pub mod a_star;
mod best_first;
pub mod dijkstra;
mod draw;
mod explain;
mod found;
mod link;
mod open;
mod parameters;
mod planner;
mod rules;
mod sight;
mod task;
#[cfg(test)]
mod tests;
pub mod theta_star;

pub use planner::start;
pub use rules::{Heuristic, Relaxation};

/// What an evaluation of a graph search is.
pub(crate) const EVALUATION: &str = "a cell that is closed";
