//! Points, segments, discs, boxes and polylines: distances, lengths and collision tests.

mod approach;
mod block;
mod bounds;
mod cells;
mod cuboid;
mod disc;
mod field;
mod obstacles;
mod oriented;
mod polyline;
mod segment;
mod shortcut;
mod smooth;

pub use approach::{closest_approach, first_within};
pub use block::Block;
pub use bounds::Bounds;
pub use cells::{Cells, DIRECTIONS, Endpoints, Plan, Steps, YAxis, angle};
pub use cuboid::Cuboid;
pub use disc::Disc;
pub use field::Field;
pub use obstacles::ObstacleField;
pub use oriented::Oriented;
pub use polyline::{arc_outline, length, length_in_space, turning, turns};
pub use segment::{closest_parameter, distance_squared};
pub use shortcut::shortcut;
pub use smooth::{PIECES, shuman, subdivided};

/// A point or a displacement in the plane, in the scene's unit.
pub type Vector = nalgebra::Vector2<f64>;

/// The vector of a point given as `[x, y]`.
pub fn vector([x, y]: [f64; 2]) -> Vector {
    Vector::new(x, y)
}
