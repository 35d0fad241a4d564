//! The fields of a `function` scene with a name of its own.

use crate::{
    kernel::{
        Error,
        error::one_of,
        fields::{Fields, each, number},
    },
    message,
};

use super::{body::FunctionScene, named::Function};

/// The field that a formula is in.
pub(super) const EXPRESSION: &str = "expression";

/// The field that a name is in.
pub(super) const FUNCTION: &str = "function";

/// What the names of the suite `bbob` begin with.
pub(super) const SUITE: &str = "bbob-";
/// All of its names, as errors give them.
pub(super) const SUITE_NAMES: &str = "bbob-1 to bbob-24";

/// Whether a scene's function is one of that suite, or means to be.
pub(super) fn is_of_suite(fields: &Fields) -> bool {
    fields.peek(FUNCTION).is_some_and(|name| name.starts_with(SUITE))
}

/// Reads its fields.
pub(super) fn read(fields: &mut Fields) -> Result<FunctionScene, Error> {
    if fields.has(EXPRESSION) || is_of_suite(fields) {
        return Err(Error::unknown("tool", "formulas", []));
    }
    let found = fields.take(FUNCTION);
    let function = Function::ALL.into_iter().find(|function| found == function.name()).ok_or_else(|| {
        let names: Vec<_> = Function::ALL.map(Function::name).into_iter().chain([SUITE_NAMES]).collect();
        fields.refuse(FUNCTION, &found, one_of(&names))
    })?;
    let dimension = dimension(fields)?;
    let mut shift = Vec::new();
    if fields.has("shift") {
        shift = each("shift", fields.list("shift")?, |at, value| number(at.to_owned(), &value))?;
    }
    fields.allow("shift");
    Ok(FunctionScene::named(function, dimension, shift))
}

/// The number of variables.
pub(super) fn dimension(fields: &mut Fields) -> Result<usize, Error> {
    let dimension = fields.number("dimension")?;
    if dimension.fract() != 0.0 || !(0.0..=f64::from(u32::MAX)).contains(&dimension) {
        return Err(Error::refused("dimension", dimension, message!("scene-positive-whole", "a positive whole number")));
    }
    Ok(dimension as usize)
}
