//! The arm follows a path: postures along it, the paper's replacements, joint trajectories, and what the whole arm touches.
//!
//! - [`course`]: the path as points; [`follow`]: which postures there are for a point, and the paper's choice among them;
//! - [`hand`], [`search`], [`smoothest`]: ours, the choice that is best for the path as a whole;
//! - [`trajectory`]: when the arm is where, and what it touches on the way.

mod course;
mod follow;
mod hand;
mod parameters;
mod search;
mod smoothest;
mod trajectory;

#[cfg(test)]
mod tests;

use nalgebra::UnitQuaternion;
use serde::Serialize;

use crate::{
    kernel::{Error, Solution, rng::Stream},
    params::{Given, Settings},
    scene::{ArmScene, Kind, Scene},
};

use super::Links;

pub use parameters::MOTION;

use course::stations;
use follow::{Followed, Follower, Pointing, densified};
use hand::Holding;
use trajectory::Trajectory;

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
    /// Where it ends, and why, if it does not arrive; where the tip first leaves the path by more than a centimetre, if it does.
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
    let settings = Settings::new(MOTION.parameters, Kind::Arm, given)?;
    let (Ok(scene), Some(Solution::Reach { path, postures })) = (scene.arm(), solution) else {
        return Ok(None);
    };
    if path.is_empty() {
        return Ok(None);
    }
    let links = Links::new(scene, settings.number("radius"));
    let spacing = settings.number("spacing");
    if postures.is_empty() {
        let stations = stations(path, spacing);
        let mut follower = follower(scene, &settings, links.clone(), stations.len());
        let followed = if settings.choice("postures") == "nearest" { follower.nearest(&stations) } else { follower.smoothest(&stations) };
        let trajectory = Trajectory { scene, links: &links, settings: &settings, path: None };
        return Ok(Some(trajectory.motion(followed, stations.len())));
    }
    let stops = densified(&scene.arm, postures, spacing);
    let points = stops.len();
    let trajectory = Trajectory { scene, links: &links, settings: &settings, path: Some(path) };
    Ok(Some(trajectory.motion(Followed { stops, ..Followed::default() }, points)))
}

fn follower<'a>(scene: &'a ArmScene, settings: &Settings, links: Links<'a>, points: usize) -> Follower<'a> {
    let holding = Holding::new(&scene.arm);
    let mut random = Stream::new(settings.integer("seed"), 0);
    let [.., home] = scene.arm.forward(&scene.arm.home());
    let spread = settings.number("spread");
    let pointing = match settings.choice("orientation") {
        "home" => Pointing::Given(vec![home.rotation; points]),
        "random" => {
            let mut angle = || random.between(-spread, spread);
            let turns = (0..points).map(|_| UnitQuaternion::from_euler_angles(angle(), angle(), angle()) * home.rotation);
            Pointing::Given(turns.collect())
        }
        _ => Pointing::Free,
    };
    let hands = holding.hands();
    let replaces = settings.flag("replacement");
    let tries = if replaces { settings.integer("tries") } else { 0 };
    Follower { scene, links, holding, hands, pointing, resolution: settings.number("resolution"), replaces, tries, random }
}
