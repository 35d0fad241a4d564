//! What a search hands over once it has settled the goal.

use crate::{geometry, kernel::State, scene::grid_path::GridPath};

use super::{rules::Relaxation, task::Task};

/// The path and what it costs.
#[derive(State)]
pub(super) struct Found {
    pub(super) iteration: u64,
    pub(super) cost: f64,
    #[state(skip)]
    pub(super) way: GridPath,
}

impl Found {
    /// Of the cells of a way, each the child of the one before.
    pub(super) fn new(task: &Task, way: &[usize], iteration: u64) -> Self {
        let path = task.endpoints.path(&task.cells, way.iter().copied());
        let cost = match task.rules.relaxation {
            Relaxation::Step => task.endpoints.length(&task.cells, task.cells.steps(way)),
            Relaxation::Sight => geometry::length(&path),
        };
        Self { iteration, cost, way: GridPath::new(path) }
    }
}
