//! Scenes of kind `tour`.

mod body;
mod kind;
mod read;

pub use body::{FARTHEST, ID, MAX_STOPS, TourScene};
pub use kind::KIND;
