//! An arm's six joints as a space: a point is a posture in radians, and what is free is decided by the whole arm.

use std::sync::Arc;

use crate::{
    arm::{self, ArmScene, Posture},
    kernel::{Error, Solution},
    params::{Param, Parameters},
    scene::{JOINED, Scene},
};

use super::{
    postures::free_postures,
    space::{Space, room},
};

pub(super) const GOALS: Param<u64> = Param::integer(
    "goals",
    "n_g",
    "Goal postures",
    [1, 300, 8],
    "In how many postures the arm may end: of those at the goal that touch nothing, the ones nearest to the first.",
)
.slider(1.0, 50.0, false);
pub(super) const RADIUS: Param<f64> = Param::number(
    "radius",
    "r",
    "Radius of the links",
    [0.0, 1.0, 0.0],
    "In metres. The links are their skeleton, grown by this. In the paper 0.",
)
.slider(0.0, 0.1, false);
pub(super) const RESOLUTION: Param<f64> = Param::number(
    "resolution",
    "\\delta",
    "Resolution",
    [1e-4, 0.1, 0.005],
    "How far any point of a link may go between two tests, in metres, where a cuboid is near; and how far the links keep away, so that nothing is touched in between.",
)
.slider(1e-3, 0.05, true);

/// The joints of a scene's arm.
pub(super) struct Joints {
    scene: Arc<ArmScene>,
    min: Posture,
    max: Posture,
    start: Posture,
    goals: Vec<Posture>,
    /// Of the links, and as much more as they may go between two tests: what is free in all tests is free in between.
    radius: f64,
    /// How far a link may go between two tests.
    resolution: f64,
}

impl Joints {
    /// Of an arm's scene, with the settings `radius`, `resolution` and `goals`. It starts in the free posture nearest to
    /// home that has its tip at the start, and may end in any of the free postures at the goal that are nearest to that one.
    ///
    /// # Errors
    /// [`Error::Refused`] for `start` or `goal` without such a posture.
    pub(super) fn new(scene: &Arc<Scene>, settings: &Parameters) -> Result<Self, Error> {
        let body = scene.share::<ArmScene>()?;
        let arm = &body.arm;
        let most = settings[GOALS] as usize;
        // Start and goal are free, however near: half of their room is left.
        let rooms = [body.start, body.goal].into_iter().flat_map(|end| body.obstacles().map(move |obstacle| room(end, obstacle)));
        let resolution = rooms.fold(settings[RESOLUTION], |resolution, room| resolution.min(room / 2.0));
        let radius = settings[RADIUS] + resolution;
        let start = free_postures("start", &body, body.start, &arm.home(), radius)?[0];
        let mut goals = free_postures("goal", &body, body.goal, &start, radius)?;
        goals.truncate(most);
        let limit = |degrees: fn(&arm::Joint) -> f64| arm::radians(&arm.joints.each_ref().map(degrees));
        Ok(Self { min: limit(|joint| joint.min), max: limit(|joint| joint.max), start, goals, radius, resolution, scene: body })
    }
}

impl Space<6> for Joints {
    fn bounds(&self) -> (Posture, Posture) {
        (self.min, self.max)
    }

    fn start(&self) -> Posture {
        self.start
    }

    fn goals(&self) -> &[Posture] {
        &self.goals
    }

    fn is_free(&self, a: &Posture, b: &Posture) -> bool {
        let scene = &*self.scene;
        // A hair beyond the border is rounding, where start or goal lie on it.
        let inside = |tip: &[f64; 3]| (0..3).all(|i| (scene.workspace.min[i] - JOINED..=scene.workspace.max[i] + JOINED).contains(&tip[i]));
        arm::motion_is_free(scene, a, b, self.radius, self.resolution) && arm::tip_path(&scene.arm, &[*a, *b]).iter().all(inside)
    }

    /// Where the tip is.
    fn place(&self, posture: &Posture) -> [f64; 3] {
        self.scene.arm.skeleton(posture)[4]
    }

    fn solution(&self, path: &[Posture]) -> Solution {
        Solution::Reach { path: arm::tip_path(&self.scene.arm, path), postures: path.to_vec() }
    }

    fn curves(&self) -> bool {
        true
    }

    fn has_members(&self) -> bool {
        true
    }
}
