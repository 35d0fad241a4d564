//! What is planned in: a folder a kind, and random scenes ([`generate`]).
//!
//! A [`Scene`] is always valid: its numbers are finite, start and goal are inside and free. A kind's folder holds `body`, the
//! data and the checks of solutions; `read`, its fields in the scene file; `kind`, its entry.

pub mod arm;
mod check;
pub mod discs;
mod endpoints;
pub mod function;
pub mod generate;
pub mod grid;
pub mod grid_path;
mod moving;
pub mod reach;
mod shipped;
#[cfg(test)]
mod tests;
pub mod tour;

pub(crate) use arm::JOINED;
pub use arm::{ID as ARM, MAX_CUBOIDS};
pub use check::LARGEST;
pub use discs::{DiscsScene, ID as DISCS, MAX_DISCS};
pub use function::{Formula, Function, FunctionScene, ID as FUNCTION, MAX_DIMENSION};
pub use grid::{CONTACT, GridScene, ID as GRID, MAX_EXACT_CELLS, MAX_GRID_STOPS, MAX_SIDE, Robot, SMALLEST_CELL};
pub use moving::{Leg, MAX_MOVING, MAX_WAYPOINTS, Motion, Moving};
pub use tour::{FARTHEST, ID as TOUR, MAX_STOPS, TourScene};

pub use crate::kernel::{Header, Scene};
