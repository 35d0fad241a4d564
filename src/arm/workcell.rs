//! An arm among cuboids, as data.

use crate::geometry::Cuboid;

use super::Arm;

/// An arm among cuboids.
#[derive(Debug, Clone, PartialEq)]
pub struct ArmScene {
    /// Where the tip may be.
    pub workspace: Cuboid,
    /// Where the tip starts.
    pub start: [f64; 3],
    /// Where it must come to.
    pub goal: [f64; 3],
    /// What it must not touch.
    pub cuboids: Vec<Cuboid>,
    /// The arm.
    pub arm: Arm,
}
