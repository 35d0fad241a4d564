//! Scenes of kind `grid`.

mod body;
mod kind;
mod read;
pub(crate) mod words;

pub use body::{CONTACT, GridScene, ID, MAX_EXACT_CELLS, MAX_GRID_STOPS, MAX_SIDE, Robot, SMALLEST_CELL};
pub use kind::KIND;
