//! Cuboids with room around them.

use crate::geometry::Cuboid;

/// A cuboid grown on all sides.
pub(super) fn grow(cuboid: &Cuboid, by: f64) -> Cuboid {
    Cuboid { min: cuboid.min.map(|c| c - by), max: cuboid.max.map(|c| c + by) }
}
