//! Scenes of kind `function`.

mod body;
mod kind;
mod read;

pub use body::{Function, FunctionScene, ID, MAX_DIMENSION};
pub use kind::KIND;
