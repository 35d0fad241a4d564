//! Scenes of kind `discs`.

mod body;
mod kind;
mod read;

pub use body::{DiscsScene, ID, MAX_DISCS};
pub use kind::KIND;
