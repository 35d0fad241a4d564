//! What a path can cut.

/// Obstacles in which the length of a path is measured.
///
/// It is behind a pointer, so that a build without grids contains nothing of their obstacles.
pub trait ObstacleField: Send + Sync {
    /// How much of the way from one point to another is inside obstacles. `pieces` is room to work in.
    fn length_inside(&self, a: [f64; 2], b: [f64; 2], pieces: &mut Vec<[f64; 2]>) -> f64;

    /// Whether the robot can go straight from one point to another; it may touch.
    fn is_free(&self, a: [f64; 2], b: [f64; 2]) -> bool;
}
