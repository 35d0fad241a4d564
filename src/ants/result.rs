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
    let Some(Found { path, smooth, .. }) = best else {
        NAMES.into_iter().for_each(|name| out.push(name, f64::NAN));
        return;
    };
    for (names, path) in NAMES.chunks_exact(3).zip([path, smooth]) {
        let measured = [geometry::length(path), geometry::turns(path) as f64, geometry::turning(path)];
        names.iter().zip(measured).for_each(|(name, value)| out.push(name, value));
    }
}

const NAMES: [&str; 6] = ["length", "turns", "turning", "smooth_length", "smooth_turns", "smooth_turning"];
