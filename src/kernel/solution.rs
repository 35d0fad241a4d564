//! Solutions, and the optimum that they are measured against.

use serde::Serialize;

use crate::arm::Posture;

/// A solution that a planner finds.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Solution {
    /// A path: its corners, in the scene's unit.
    Path(Vec<[f64; 2]>),
    /// A position in the search box of a test function.
    Position(Vec<f64>),
    /// A tour that visits every stop.
    Tour {
        /// The visiting order: the stops' indices, each once.
        order: Vec<usize>,
        /// Where it begins and ends.
        ends: TourEnds,
        /// The path through the stops, back to the first if the tour is closed, in the scene's unit.
        path: Vec<[f64; 2]>,
    },
    /// A drive among moving obstacles, from start to goal in simulated time.
    Drive(Track),
    /// A path for the tip of an arm.
    Reach {
        /// The corners of the tip's path, in metres.
        path: Vec<[f64; 3]>,
        /// The arm's configurations, if they were planned and not only the tip's path: all joints turn evenly from one to the
        /// next, and `path` is the path of the tip.
        postures: Vec<Posture>,
    },
}

/// A robot's motion over time.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Track {
    /// The corners of its path, in the scene's unit, one of them wherever it stood still.
    pub path: Vec<[f64; 2]>,
    /// `[t, x, y]` at every change of its motion, by growing time in seconds; between two of them it went straight at constant
    /// speed, or stood still.
    pub moments: Vec<[f64; 3]>,
    /// The radius of the robot against moving obstacles, in the scene's unit.
    pub radius: f64,
    /// What moving obstacles do at the border of the scene.
    pub border: Border,
}

/// What a moving obstacle does at the border of its scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Border {
    /// It leaves the scene.
    #[default]
    Leave,
    /// It bounces off as soon as it touches the border.
    Bounce,
}

impl Solution {
    /// The number of corners of its path.
    pub fn corners(&self) -> usize {
        match self {
            Self::Reach { path, .. } => path.len(),
            _ => self.path().map_or(0, <[_]>::len),
        }
    }

    /// The corners of its path, if it has one in the plane.
    pub fn path(&self) -> Option<&[[f64; 2]]> {
        match self {
            Self::Path(path) | Self::Tour { path, .. } | Self::Drive(Track { path, .. }) => Some(path),
            Self::Position(_) | Self::Reach { .. } => None,
        }
    }
}

/// Where a tour begins and ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Default, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum TourEnds {
    /// It returns to its first stop.
    #[default]
    Closed,
    /// It begins at any stop and ends at any other.
    Open,
    /// It begins at the first stop and ends at any other.
    FromFirst,
    /// It begins at the first stop and ends at the last.
    FirstToLast,
}

impl TourEnds {
    /// All variants.
    pub const ALL: [Self; 4] = [Self::Closed, Self::Open, Self::FromFirst, Self::FirstToLast];

    /// Whether it returns to its first stop.
    pub fn closes(self) -> bool {
        self == Self::Closed
    }

    /// Whether an order visits each of `n` stops once and has these ends.
    pub fn allows(self, order: &[usize], n: usize) -> bool {
        let mut called = vec![false; n];
        let once = |&stop: &usize| called.get_mut(stop).is_some_and(|called| !std::mem::replace(called, true));
        let ends = match self {
            Self::Closed | Self::Open => true,
            Self::FromFirst => order.first() == Some(&0),
            Self::FirstToLast => order.first() == Some(&0) && order.last() == Some(&(n - 1)),
        };
        order.len() == n && order.iter().all(once) && ends
    }
}

/// The optimum that a result is measured against.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
#[serde(rename_all = "kebab-case")]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub enum ReferenceOptimum {
    /// The shortest path at any angle.
    #[default]
    AnyAngle,
    /// The shortest path between neighbouring cells of a grid.
    Cells,
    /// The shortest tour by the distances that the scene gives.
    Matrix,
    /// The optimum stated in the scene file; none could be computed.
    Stored,
    /// None: the scene file states an optimum, and this result is better.
    Refuted,
}

/// A solution and its cost to the planner. [`crate::Scene::judge`] tells whether it is feasible.
#[derive(Debug, Clone, PartialEq)]
pub struct Candidate {
    /// The value that the planner minimises.
    pub cost: f64,
    /// The solution.
    pub solution: Solution,
}
