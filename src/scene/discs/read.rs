//! The fields of a `discs` scene.

use serde_json::Value;

use crate::{
    geometry::{Bounds, Disc},
    kernel::{
        Error,
        fields::{Fields, each, object, point},
    },
    message,
};

use super::body::DiscsScene;

/// Its fields, in the order in which they are written.
pub(super) fn write(scene: &DiscsScene, out: &mut Vec<(&'static str, Value)>) {
    let bounds = object(vec![("min", point(scene.bounds.min)), ("max", point(scene.bounds.max))]);
    let disc = |disc: &Disc| object(vec![("center", point(disc.center)), ("radius", Value::from(disc.radius))]);
    let discs = scene.discs.iter().map(disc).collect();
    out.extend([("bounds", bounds), ("start", point(scene.start)), ("goal", point(scene.goal)), ("discs", Value::Array(discs))]);
}

/// Reads its fields.
pub(super) fn read(fields: &mut Fields) -> Result<DiscsScene, Error> {
    Ok(DiscsScene {
        bounds: bounds(fields.take("bounds"))?,
        start: fields.point("start")?,
        goal: fields.point("goal")?,
        discs: each("discs", fields.list("discs")?, disc)?,
    })
}

fn bounds(value: Value) -> Result<Bounds, Error> {
    let mut fields = Fields::of("bounds", value, message!("scene-bounds", "an object with min and max"))?;
    let bounds = Bounds { min: fields.point("min")?, max: fields.point("max")? };
    fields.end()?;
    Ok(bounds)
}

fn disc(at: &str, value: Value) -> Result<Disc, Error> {
    let mut fields = Fields::of(at, value, message!("scene-disc", "an object with center and radius"))?;
    let disc = Disc { center: fields.point("center")?, radius: fields.number("radius")? };
    fields.end()?;
    Ok(disc)
}
