//! Scenes of kind `function`.

mod body;
mod formula;
mod kind;
mod named;
mod read;

pub use body::{FunctionScene, ID};
pub use formula::{FUNCTIONS as FORMULA_FUNCTIONS, Formula, FormulaFunction, MOST_BYTES as FORMULA_BYTES};
pub use kind::{KIND, NAMED};
pub use named::{Function, MAX_DIMENSION};
