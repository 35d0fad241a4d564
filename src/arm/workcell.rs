//! An arm among cuboids, as data.

use crate::geometry::Cuboid;

use super::Arm;

/// An arm among cuboids.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct ArmScene {
    /// The region in which the tip may be, in metres.
    pub workspace: Cuboid,
    /// The start of the tip's path.
    pub start: [f64; 3],
    /// The goal of the tip's path.
    pub goal: [f64; 3],
    /// The obstacles.
    pub cuboids: Vec<Cuboid>,
    /// The arm.
    pub arm: Arm,
}
