//! Six-axis arms with a spherical wrist, [ARM-RRT](crate#papers) §4.1 of the repaired text: the arm as data, where its links
//! are, which postures bring its tip somewhere, and what they touch. How it follows a path is in [`follow`](crate::follow).
//!
//! Lengths are in metres; a scene's angles are in degrees, as in its file, and a [`Posture`]'s in radians. A [`Posture`] is a
//! configuration of the arm. World coordinates are base + Rz(yaw) (x, y, z).

mod answer;
mod check;
mod cloud;
mod collision;
mod directions;
mod forward;
mod hand;
mod inverse;
mod model;
mod reach;
mod slice;
mod solutions;
mod tips;
mod workcell;
mod wrist;

pub use answer::{Answer, Pose, Reaching};
pub use cloud::{MAX_LATTICE, Reachability, reachability};
pub use collision::{Column, Links, clearance, column, motion_is_free, segment_meets_column, touches};
pub use directions::DIRECTIONS;
pub(crate) use hand::{Hand, Holding, squared};
pub use model::{Arm, Axis, Base, Joint, Posture, Skeleton, Tool, degrees, radians};
pub use slice::{SLICE, slice};
pub use solutions::{MAX_SOLUTIONS, Solutions, Unreachable, distance};
pub use tips::tip_path;
pub use workcell::ArmScene;
pub use wrist::SINGULAR;

#[cfg(test)]
mod tests;
