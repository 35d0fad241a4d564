//! The fields of a `function` scene with a name.

use crate::{
    kernel::{
        Error,
        fields::{Fields, each, number},
    },
    message,
};

use super::{body::FunctionScene, named::Function};

/// The field that a formula is in.
pub(super) const EXPRESSION: &str = "expression";

/// Reads its fields.
pub(super) fn read(fields: &mut Fields) -> Result<FunctionScene, Error> {
    if fields.has(EXPRESSION) {
        return Err(Error::unknown("tool", "formulas", []));
    }
    let function = fields.one_of("function", Function::ALL, Function::name)?;
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
