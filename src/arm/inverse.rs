//! Which postures bring the tip somewhere, [ARM-RRT] §2.1: closed form, up to eight.

use std::f64::consts::PI;

use super::Posture;

/// Why no posture brings the tool into a pose.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Unreachable {
    /// The tip cannot come there, whichever way the tool points.
    Position,
    /// It can, but not with the tool pointing this way.
    Orientation,
    /// It could, if joints turned further than their limits.
    Limits,
}

/// A posture in degrees.
pub fn degrees(posture: &Posture) -> [f64; 6] {
    posture.map(|angle| angle * (180.0 / PI))
}

/// A posture of degrees.
pub fn radians(degrees: &[f64; 6]) -> Posture {
    degrees.map(|angle| angle * (PI / 180.0))
}
