//! Exact searches over a grid's cells that step like every other planner: `dijkstra`, `a-star` and `theta-star`.
//!
//! One search (`best_first`) composed of two parts (`rules`): a heuristic, which says how far it still is, and a
//! relaxation, which says whose child a cell becomes.
//!
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

use crate::{
    describe::Start,
    kernel::{Error, ReferenceOptimum, Started},
};

use best_first::Search;
use rules::{Heuristic, Relaxation, Rules};

/// Starts a search by its rules.
fn start(start: &Start, heuristic: Heuristic, weight: f64, relaxation: Relaxation) -> Result<Started, Error> {
    let search = Search::new(start, Rules { heuristic, relaxation }, weight)?;
    let (limit, smooth) = (search.task.limit, search.task.smooth);
    let cells = relaxation == Relaxation::Step && !smooth;
    Ok(Started::new(search, limit).open_ended().measured_by(if cells { ReferenceOptimum::Cells } else { ReferenceOptimum::AnyAngle }))
}
