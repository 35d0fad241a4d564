//! Scenes of kind `function`.

mod body;
mod formula;
mod kind;
mod read;

pub use body::{Function, FunctionScene, ID, MAX_DIMENSION};
pub use formula::{FUNCTIONS as FORMULA_FUNCTIONS, Formula, FormulaFunction, MOST_BYTES as FORMULA_BYTES};
pub use kind::KIND;
