//! Scenes of kind `arm`.

mod body;
mod kind;
mod read;

pub(crate) use body::JOINED;
pub use body::{ID, MAX_CUBOIDS};
pub use kind::KIND;
