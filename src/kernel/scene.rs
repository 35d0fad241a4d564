//! What a kind of scene is called, and how it judges a solution.

use serde::Serialize;

/// The kinds of scene. Planners say which they run on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Kind {
    /// A test function to minimise.
    Function,
    /// A plane with circular obstacles.
    Discs,
    /// A grid of free and blocked cells.
    Grid,
    /// Stops to call at, and their distances.
    Tour,
    /// A six-axis arm among cuboids.
    Arm,
}

impl Kind {
    /// Every kind.
    pub const ALL: [Self; 5] = [Self::Function, Self::Discs, Self::Grid, Self::Tour, Self::Arm];

    /// The name that scene files use.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Function => "function",
            Self::Discs => "discs",
            Self::Grid => "grid",
            Self::Tour => "tour",
            Self::Arm => "arm",
        }
    }
}

/// How good a solution really is, whatever cost the planner gave it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Verdict {
    /// The path's length; `None` where there is no path.
    pub length: Option<f64>,
    /// It breaks nothing.
    pub feasible: bool,
    /// The smallest distance to an obstacle, negative inside; `None` without obstacles.
    pub clearance: Option<f64>,
}
