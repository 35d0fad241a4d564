//! What planners find, and which optimum it is measured by.

use serde::Serialize;

use crate::arm::Posture;

/// What planners find.
#[derive(Debug, Clone, PartialEq)]
pub enum Solution {
    /// Corners of a path, in the scene's unit.
    Path(Vec<[f64; 2]>),
    /// A point in a function's box.
    Position(Vec<f64>),
    /// A tour that calls at every stop.
    Tour {
        /// The stops' numbers in the order in which it calls at them, each once.
        order: Vec<usize>,
        /// What its ends are.
        round: TourEnds,
        /// The way through them, back to the first if it is closed, in the scene's unit.
        path: Vec<[f64; 2]>,
    },
    /// A drive among moving obstacles, from start to goal in simulated time.
    Drive(Track),
    /// A way for the tip of an arm.
    Reach {
        /// The corners of the tip's path, in metres.
        path: Vec<[f64; 3]>,
        /// The arm's postures, if they were planned and not only where its tip is: it goes from one to the next with all
        /// joints evenly, and the path is where that takes the tip.
        postures: Vec<Posture>,
    },
}

/// Where a robot was, and when.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Track {
    /// The corners of its way, in the scene's unit; where it stood there is one.
    pub path: Vec<[f64; 2]>,
    /// [t, x, y] wherever its motion changed, by growing time; between them it went straight at an even speed, or stood.
    pub moments: Vec<[f64; 3]>,
    /// The radius of the robot as moving obstacles meet it.
    pub radius: f64,
    /// What the moving obstacles do at the border.
    pub border: Border,
}

/// What a moving obstacle does when it comes to the border of its scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Border {
    /// It goes on and is gone.
    #[default]
    Leave,
    /// It bounces off as soon as it touches.
    Bounce,
}

impl Solution {
    /// How many corners its path has.
    pub fn corners(&self) -> usize {
        match self {
            Self::Reach { path, .. } => path.len(),
            _ => self.path().map_or(0, <[_]>::len),
        }
    }

    /// The corners of a path in the plane or of a tour's way.
    pub fn path(&self) -> Option<&[[f64; 2]]> {
        match self {
            Self::Path(path) | Self::Tour { path, .. } | Self::Drive(Track { path, .. }) => Some(path),
            Self::Position(_) | Self::Reach { .. } => None,
        }
    }
}

/// What the ends of a tour are.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Default, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum TourEnds {
    /// It goes back to where it began.
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
    /// Every one.
    pub const ALL: [Self; 4] = [Self::Closed, Self::Open, Self::FromFirst, Self::FirstToLast];

    /// Whether it goes back to where it began.
    pub fn closes(self) -> bool {
        self == Self::Closed
    }

    /// Whether an order calls at each of `n` stops once and has such ends.
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

/// Which optimum a result is measured by.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum ReferenceOptimum {
    /// The shortest way there is, at any angle.
    #[default]
    AnyAngle,
    /// The shortest way from cell to neighbouring cell of a grid.
    Cells,
    /// The shortest tour by the distances that the scene gives.
    Matrix,
    /// The optimum that the scene's file gives: none could be computed.
    Stored,
    /// None: the scene's file gives an optimum, and this result is better.
    Refuted,
}

/// The best solution so far and what it costs the planner. Whether it is any good, [`crate::Scene::judge`] says.
#[derive(Debug, Clone, PartialEq)]
pub struct Candidate {
    /// What the planner minimises.
    pub cost: f64,
    /// What it found.
    pub solution: Solution,
}
