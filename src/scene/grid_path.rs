//! A path over cells, with and without its redundant nodes, and the readings of both.

use std::sync::OnceLock;

use crate::{
    describe::{Group, Reading},
    geometry::{self, shortcut},
    kernel::{Readings, State},
    params::Param,
};

use super::GridScene;

/// A path from start to goal.
#[derive(Debug, Clone, State)]
pub struct GridPath {
    /// The path through the cells' centres, in the scene's unit.
    pub path: Vec<[f64; 2]>,
    /// Made when it is first asked for.
    #[state(skip)]
    smooth: OnceLock<Vec<[f64; 2]>>,
}

impl GridPath {
    /// A path with these corners.
    pub fn new(path: Vec<[f64; 2]>) -> Self {
        Self { path, smooth: OnceLock::new() }
    }

    /// The path without redundant nodes, [ANTBAT](crate#papers) §1.3.
    pub fn smooth(&self, grid: &GridScene) -> &[[f64; 2]] {
        self.smooth.get_or_init(|| shortcut(&self.path, |a, b| grid.field().is_free(a, b)))
    }
}

/// Pushes [`LENGTH`] to [`SMOOTH_TURNING`]; without a path they are NaN.
pub fn read(way: Option<&GridPath>, grid: &GridScene, out: &mut Readings) {
    let measured = |path: &[[f64; 2]]| [geometry::length(path), geometry::turns(path) as f64, geometry::turning(path)];
    let [before, after] = way.map_or([[f64::NAN; 3]; 2], |way| [measured(&way.path), measured(way.smooth(grid))]);
    let readings = [LENGTH, TURNS, TURNING, SMOOTH_LENGTH, SMOOTH_TURNS, SMOOTH_TURNING];
    readings.iter().zip(before.into_iter().chain(after)).for_each(|(reading, value)| out.push(*reading, value));
}

/// Whether the final path is without redundant nodes.
pub const SMOOTH: Param<bool> = Param::flag(
    "smooth",
    "Smoothing",
    false,
    "Hand over the path without its redundant nodes: a node goes if its neighbours see each other, [ANTBAT] §3.1. It is then measured by the shortest path at any angle. What is searched stays the same.",
);

/// The length of the path over cells.
pub const LENGTH: Reading = Reading::new("length", "L_{\\text{raw}}", "Raw length", Group::Length, "The path’s length before smoothing.");
/// The number of turns.
pub const TURNS: Reading = Reading::new("turns", "n_t", "Turns", Group::Measure, "At how many corners the path turns before smoothing.");
/// The total turning angle.
pub const TURNING: Reading =
    Reading::new("turning", "\\theta", "Turning", Group::Measure, "How much it turns in all before smoothing, in radians.");
/// The length without redundant nodes.
pub const SMOOTH_LENGTH: Reading = Reading::new(
    "smooth_length",
    "L_{\\text{smooth}}",
    "Smoothed length",
    Group::Length,
    "The length of the path without its redundant nodes.",
);
/// The turns without them.
pub const SMOOTH_TURNS: Reading = Reading::new(
    "smooth_turns",
    "n_t'",
    "Turns, smoothed",
    Group::Measure,
    "At how many corners the path without its redundant nodes turns.",
);
/// The total turning angle without them.
pub const SMOOTH_TURNING: Reading =
    Reading::new("smooth_turning", "\\theta'", "Turning, smoothed", Group::Measure, "How much that path turns in all, in radians.");

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_way_is_measured_before_and_after() {
        let scene = crate::shipped("ant-bat-30").unwrap();
        let grid = scene.get::<GridScene>().unwrap();
        let way = GridPath::new(vec![[10.5, 28.5], [11.5, 28.5], [12.5, 29.5], [13.5, 29.5]]);
        let mut out = Readings::default();
        read(Some(&way), grid, &mut out);
        let quarter = std::f64::consts::FRAC_PI_4;
        let expected = [2.0 + 2.0_f64.sqrt(), 2.0, 2.0 * quarter, 10.0_f64.sqrt(), 0.0, 0.0];
        for ((_, value), expected) in out.iter().zip(expected) {
            assert!((value - expected).abs() < 1e-15, "{value} {expected}");
        }
        out.clear();
        read(None, grid, &mut out);
        assert!(out.iter().len() == 6 && out.iter().all(|(_, value)| value.is_nan()));
    }
}
