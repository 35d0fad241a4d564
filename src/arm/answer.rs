//! What is said of postures: where the links are in one, and which of them reach a point, [ARM-RRT](crate#papers) §4.1. Points
//! are in metres, in the world.

use nalgebra::{Unit, Vector3};
use serde::Serialize;

use super::{ArmScene, Posture, Skeleton, Unreachable, degrees, touches};

/// Where an arm's links are in a posture.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename = "ArmPose"))]
pub struct Pose {
    /// Base, shoulder, elbow, wrist and tip, in metres.
    pub skeleton: Skeleton,
    /// Where the tool points: a unit vector in the world.
    pub direction: [f64; 3],
    /// No link touches a cuboid or the column.
    pub free: bool,
}

/// A posture that brings the tip to a point.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename = "ArmSolution"))]
pub struct Reaching {
    /// In degrees.
    pub joints: [f64; 6],
    /// Base, shoulder, elbow, wrist and tip, in metres.
    pub skeleton: Skeleton,
    /// No link touches a cuboid or the column.
    pub free: bool,
}

/// The postures that bring the tip to a point with the tool pointing one way.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename = "ArmSolutions"))]
pub struct Answer {
    /// Where the tool points: a unit vector in the world. `None` if none was given and none of those tried has a solution.
    pub direction: Option<[f64; 3]>,
    /// Up to 8 within the limits, nearest to the given one first.
    pub solutions: Vec<Reaching>,
    /// Why there are none. Without a direction `orientation` means: none of those tried, but others could.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "types", ts(optional))]
    pub unreachable: Option<Unreachable>,
}

impl ArmScene {
    /// Where the arm's links are in a posture (radians), within its limits or not.
    pub fn pose(&self, posture: &Posture) -> Pose {
        let skeleton = self.arm.skeleton(posture);
        Pose { skeleton, direction: self.arm.pointing(posture).into(), free: !touches(self, &skeleton, 0.0) }
    }

    /// The postures within the limits that bring the tip to a point (metres) with the tool pointing in a direction, nearest to
    /// `near` (radians) first. Without a direction: of 42 spread over the sphere the one whose posture is nearest.
    pub fn answer(&self, point: [f64; 3], direction: Option<Unit<Vector3<f64>>>, near: &Posture) -> Answer {
        let found = match direction {
            Some(direction) => self.arm.reaching(point, &direction, near).map(|found| (direction, found)),
            None => self.arm.reaching_somehow(point, near),
        };
        let reaching = |posture: &Posture| {
            let skeleton = self.arm.skeleton(posture);
            Reaching { joints: degrees(posture), skeleton, free: !touches(self, &skeleton, 0.0) }
        };
        let (direction, solutions, unreachable) = match found {
            Ok((direction, found)) => (Some(direction), found.iter().map(reaching).collect(), None),
            Err(why) => (direction, Vec::new(), Some(why)),
        };
        Answer { direction: direction.map(|direction| direction.into_inner().into()), solutions, unreachable }
    }
}
