//! The arm follows a path: postures along it, the paper's replacements, joint trajectories, and what the whole arm touches.
//!
//! - `course`: the path as points; `follow`: which postures there are for a point, and the paper's choice among them;
//! - `search`, `smoothest`: ours, the choice that is best for the path as a whole;
//! - `trajectory`: when the arm is where, and what it touches on the way.

mod course;
mod follow;
mod outcome;
mod parameters;
mod search;
mod smoothest;
mod trajectory;

#[cfg(test)]
mod tests;

use nalgebra::UnitQuaternion;

use crate::{
    arm::{ArmScene, Holding, Links},
    describe::{FollowedPath, Follower},
    kernel::{Error, Solution, rng::Stream, words},
    params::{Overrides, Parameters},
    scene::{ARM, Scene},
};

pub use outcome::{Motion, MotionOutcome};

use course::stations;
use follow::{Followed, Pointing, Postures, densified};
use parameters::{
    COLUMNS, FORMULAS, NEAREST, ORIENTATION, Orientation, PARAMETERS, RADIUS, REPLACEMENT, RESOLUTION, SEED, SPACING, SPREAD, TRIES,
};
use trajectory::Trajectory;

/// See the module.
pub const ENTRY: Follower = Follower {
    name: "motion",
    title: words("How an arm follows a path"),
    kind: ARM,
    needs: "a scene with an arm",
    applies: |scene| scene.kind() == ARM,
    source: words("[ARM-RRT] §3.2.2, §3.3"),
    summary: words(
        "The arm follows the path with its tip: postures along it by inverse kinematics, joints that turn evenly from one to \
              the next as fast as their limits allow, and the whole arm checked against cuboids and column all the way.",
    ),
    parameters: &[PARAMETERS],
    columns: COLUMNS,
    formulas: FORMULAS,
    follow: |scene, solution, overrides| Ok(along(scene, solution, overrides)?.map(|motion| Box::new(motion) as Box<dyn FollowedPath>)),
};

/// The scene's arm following a solution. `None` unless it is an arm's scene and an arm's solution.
///
/// # Errors
/// As [`Parameters::new`].
pub fn along(scene: &Scene, solution: Option<&Solution>, given: &Overrides) -> Result<Option<Motion>, Error> {
    let parameters = Parameters::new(ENTRY.parameters, ARM, given)?;
    let (Ok(scene), Some(Solution::Reach { path, postures })) = (scene.get::<ArmScene>(), solution) else {
        return Ok(None);
    };
    if path.is_empty() {
        return Ok(None);
    }
    let links = Links::new(scene, parameters[RADIUS]);
    let spacing = parameters[SPACING];
    if postures.is_empty() {
        let stations = stations(path, spacing);
        let mut choice = choice(scene, &parameters, links.clone(), stations.len());
        let followed = if parameters[NEAREST] { choice.nearest(&stations) } else { choice.smoothest(&stations) };
        let trajectory = Trajectory { scene, links: &links, parameters: &parameters, path: None };
        return Ok(Some(trajectory.motion(followed, stations.len())));
    }
    let stops = densified(&scene.arm, postures, spacing);
    let points = stops.len();
    let trajectory = Trajectory { scene, links: &links, parameters: &parameters, path: Some(path) };
    Ok(Some(trajectory.motion(Followed { stops, ..Followed::default() }, points)))
}

fn choice<'a>(scene: &'a ArmScene, parameters: &Parameters, links: Links<'a>, points: usize) -> Postures<'a> {
    let holding = Holding::new(&scene.arm);
    let mut random = Stream::new(parameters[SEED], 0);
    let [.., home] = scene.arm.forward(&scene.arm.home());
    let spread = parameters[SPREAD];
    let pointing = match parameters[ORIENTATION] {
        Orientation::Free => Pointing::Free,
        Orientation::Home => Pointing::PointByPoint(vec![home.rotation; points]),
        Orientation::Random => {
            let mut angle = || random.between(-spread, spread);
            let turns = (0..points).map(|_| UnitQuaternion::from_euler_angles(angle(), angle(), angle()) * home.rotation);
            Pointing::PointByPoint(turns.collect())
        }
    };
    let hands = holding.hands();
    let replaces = parameters[REPLACEMENT];
    let tries = if replaces { parameters[TRIES] } else { 0 };
    Postures { scene, links, holding, hands, pointing, resolution: parameters[RESOLUTION], replaces, tries, random }
}
