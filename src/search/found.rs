//! What a search hands over once it has settled the goal.

use crate::{geometry, kernel::State, way::Way};

use super::{rules::Relaxation, task::Task};

/// The path and what it costs.
#[derive(State)]
pub(super) struct Found {
    pub(super) iteration: u64,
    pub(super) cost: f64,
    #[state(skip)]
    pub(super) way: Way,
}

impl Found {
    /// Of the cells of a way, each the child of the one before.
    pub(super) fn new(task: &Task, way: &[usize], iteration: u64) -> Self {
        let path = task.course.path(&task.cells, way.iter().copied());
        let cost = match task.rules.relaxation {
            Relaxation::Step => task.course.length(&task.cells, task.cells.steps(way)),
            Relaxation::Sight => geometry::length(&path),
        };
        Self { iteration, cost, way: Way::new(path) }
    }
}
