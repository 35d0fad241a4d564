//! What a search hands over once it has settled the goal.

use std::sync::OnceLock;

use crate::geometry::{self, shortcut};

use super::{best_first::Task, rules::Relaxation};

/// The path and what it costs. What is made of it is made when somebody asks.
pub(super) struct Found {
    pub(super) iteration: u64,
    pub(super) cost: f64,
    pub(super) path: Vec<[f64; 2]>,
    smooth: OnceLock<Vec<[f64; 2]>>,
}

/// What is read off a path.
pub(super) type Measures = [f64; 3];

impl Found {
    /// Of the cells of a way, each the child of the one before.
    pub(super) fn new(task: &Task, way: &[usize], iteration: u64) -> Self {
        let path = task.course.path(&task.cells, way.iter().copied());
        let cost = match task.rules.relaxation {
            Relaxation::Step => task.course.length(&task.cells, task.cells.steps(way)),
            Relaxation::Sight => geometry::length(&path),
        };
        Self { iteration, cost, path, smooth: OnceLock::new() }
    }

    /// The path without the nodes that it does not need.
    pub(super) fn smooth(&self, task: &Task) -> &[[f64; 2]] {
        self.smooth.get_or_init(|| shortcut(&self.path, |a, b| task.field.is_free(a, b)))
    }

    /// The memory it takes.
    pub(super) fn bytes(&self) -> usize {
        size_of::<Self>() + size_of::<[f64; 2]>() * (self.path.capacity() + self.smooth.get().map_or(0, Vec::capacity))
    }
}

/// A path's length, at how many corners it turns, and by how much in all.
pub(super) fn measures(path: &[[f64; 2]]) -> Measures {
    [geometry::length(path), geometry::turns(path) as f64, geometry::turning(path)]
}
