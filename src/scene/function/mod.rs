//! Scenes of kind `function`.

mod bbob;
mod body;
mod code;
mod formula;
mod kind;
mod named;
mod own;
mod read;

pub use bbob::{DIMENSIONS as BBOB_DIMENSIONS, FUNCTIONS as BBOB_FUNCTIONS, INSTANCES as BBOB_INSTANCES};
pub use body::{FunctionScene, ID};
pub use code::{CodeFault, check_repeatable, from_code, refused_cost};
pub use formula::{FUNCTIONS as FORMULA_FUNCTIONS, Formula, FormulaFunction, MOST_BYTES as FORMULA_BYTES};
pub use kind::{KIND, NAMED};
pub use named::{Function, MAX_DIMENSION};
