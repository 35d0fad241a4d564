//! The best way so far, before and after its redundant nodes are removed.

use crate::{
    geometry::{self, shortcut},
    planner::Readings,
};

use super::ground::Ground;

/// A way from start to goal.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Found {
    /// Its directions from the start on.
    pub directions: Vec<u8>,
    /// In the scene's unit.
    pub length: f64,
    /// Through the cells' centres.
    pub path: Vec<[f64; 2]>,
    /// Without redundant nodes.
    pub smooth: Vec<[f64; 2]>,
}

impl Found {
    pub fn new(ground: &Ground, directions: &[u8], length: f64) -> Self {
        let way = ground.way(directions);
        let path = ground.course.path(&ground.cells, way);
        let smooth = shortcut(&path, |a, b| ground.field.is_free(a, b));
        Self { directions: directions.to_vec(), length, path, smooth }
    }

    pub fn bytes(&self) -> usize {
        self.directions.len() + (self.path.len() + self.smooth.len()) * size_of::<[f64; 2]>()
    }
}

/// What is measured of the best way, before and after.
pub(super) fn read(best: Option<&Found>, out: &mut Readings) {
    let none: &[[f64; 2]] = &[];
    let (before, after) = best.map_or((none, none), |best| (&best.path, &best.smooth));
    let length = |path| if best.is_some() { geometry::length(path) } else { f64::INFINITY };
    out.push("length", length(before));
    out.push("turns", geometry::turns(before) as f64);
    out.push("turning", geometry::turning(before));
    out.push("smooth_length", length(after));
    out.push("smooth_turns", geometry::turns(after) as f64);
    out.push("smooth_turning", geometry::turning(after));
}
