//! The arm follows a path: postures along it, the paper's replacements, joint trajectories, and what the whole arm touches.
//!
//! - [`course`]: the path as points; [`follow`]: which postures there are for a point, and the paper's choice among them;
//! - [`hand`], [`search`], [`smoothest`]: ours, the choice that is best for the path as a whole;
//! - [`trajectory`]: when the arm is where, and what it touches on the way.

mod course;
mod follow;
mod hand;
mod outcome;
mod parameters;
mod search;
mod smoothest;
mod trajectory;

#[cfg(test)]
mod tests;

use nalgebra::UnitQuaternion;

use crate::{
    arm::ArmScene,
    kernel::{Error, Solution, rng::Stream},
    params::{Overrides, Parameters},
    scene::{ARM, Scene},
};

use super::Links;

pub use outcome::{Motion, MotionOutcome};
pub use parameters::MOTION;

use course::stations;
use follow::{Followed, Follower, Pointing, densified};
use hand::Holding;
use parameters::{NEAREST, ORIENTATION, Orientation, RADIUS, REPLACEMENT, RESOLUTION, SEED, SPACING, SPREAD, TRIES};
use trajectory::Trajectory;

/// The scene's arm following a solution. `None` unless it is an arm's scene and an arm's solution.
///
/// # Errors
/// As [`Parameters::new`].
pub fn along(scene: &Scene, solution: Option<&Solution>, given: &Overrides) -> Result<Option<Motion>, Error> {
    let settings = Parameters::new(MOTION.parameters, ARM, given)?;
    let (Ok(scene), Some(Solution::Reach { path, postures })) = (scene.get::<ArmScene>(), solution) else {
        return Ok(None);
    };
    if path.is_empty() {
        return Ok(None);
    }
    let links = Links::new(scene, settings[RADIUS]);
    let spacing = settings[SPACING];
    if postures.is_empty() {
        let stations = stations(path, spacing);
        let mut follower = follower(scene, &settings, links.clone(), stations.len());
        let followed = if settings[NEAREST] { follower.nearest(&stations) } else { follower.smoothest(&stations) };
        let trajectory = Trajectory { scene, links: &links, settings: &settings, path: None };
        return Ok(Some(trajectory.motion(followed, stations.len())));
    }
    let stops = densified(&scene.arm, postures, spacing);
    let points = stops.len();
    let trajectory = Trajectory { scene, links: &links, settings: &settings, path: Some(path) };
    Ok(Some(trajectory.motion(Followed { stops, ..Followed::default() }, points)))
}

fn follower<'a>(scene: &'a ArmScene, settings: &Parameters, links: Links<'a>, points: usize) -> Follower<'a> {
    let holding = Holding::new(&scene.arm);
    let mut random = Stream::new(settings[SEED], 0);
    let [.., home] = scene.arm.forward(&scene.arm.home());
    let spread = settings[SPREAD];
    let pointing = match settings[ORIENTATION] {
        Orientation::Free => Pointing::Free,
        Orientation::Home => Pointing::Overrides(vec![home.rotation; points]),
        Orientation::Random => {
            let mut angle = || random.between(-spread, spread);
            let turns = (0..points).map(|_| UnitQuaternion::from_euler_angles(angle(), angle(), angle()) * home.rotation);
            Pointing::Overrides(turns.collect())
        }
    };
    let hands = holding.hands();
    let replaces = settings[REPLACEMENT];
    let tries = if replaces { settings[TRIES] } else { 0 };
    Follower { scene, links, holding, hands, pointing, resolution: settings[RESOLUTION], replaces, tries, random }
}
