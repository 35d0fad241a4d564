//! The fields of a `function` scene.

use serde_json::Value;

use crate::{
    kernel::{
        Error,
        fields::{Fields, each, number},
    },
    message,
};

use super::body::{Function, FunctionScene};

/// Its fields, in the order in which they are written.
pub(super) fn write(scene: &FunctionScene, out: &mut Vec<(&'static str, Value)>) {
    let FunctionScene { function, dimension, shift } = scene;
    out.extend([("function", Value::from(function.name())), ("dimension", Value::from(*dimension))]);
    if !shift.is_empty() {
        out.push(("shift", Value::from(shift.as_slice())));
    }
}

/// Reads its fields.
pub(super) fn read(fields: &mut Fields) -> Result<FunctionScene, Error> {
    let function = fields.one_of("function", Function::ALL, Function::name)?;
    let dimension = fields.number("dimension")?;
    if dimension.fract() != 0.0 || !(0.0..=f64::from(u32::MAX)).contains(&dimension) {
        return Err(Error::refused("dimension", dimension, message!("scene-positive-whole", "a positive whole number")));
    }
    let mut shift = Vec::new();
    if fields.has("shift") {
        shift = each("shift", fields.list("shift")?, |at, value| number(at.to_owned(), &value))?;
    }
    fields.allow("shift");
    Ok(FunctionScene { function, dimension: dimension as usize, shift })
}
