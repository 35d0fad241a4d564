//! Which numbers a scene may hold.

use crate::{
    kernel::{Error, Message, error},
    message,
};

/// The largest coordinate or size of a scene: squares of it keep their digits.
pub const LARGEST: f64 = 1e6;

/// Refuses numbers that are not finite.
pub(crate) fn finite(field: &str, value: f64) -> Result<(), Error> {
    if value.is_finite() { Ok(()) } else { Err(Error::refused(field, value, error::finite())) }
}

/// Refuses numbers that are not finite or too large.
pub(super) fn limited(field: &str, value: f64) -> Result<(), Error> {
    up_to(field, value, LARGEST)
}

/// Refuses numbers that are not finite or larger than `most`.
pub(super) fn up_to(field: &str, value: f64, most: f64) -> Result<(), Error> {
    finite(field, value)?;
    if value.abs() > most {
        return Err(Error::refused(field, value, from_to(-most, most)));
    }
    Ok(())
}

/// Refuses numbers that are not greater than 0 or too large.
pub(super) fn positive(field: &str, value: f64) -> Result<(), Error> {
    finite(field, value)?;
    if value <= 0.0 || value > LARGEST {
        return Err(Error::refused(field, value, message!("scene-positive", "greater than 0, at most {most}", most = LARGEST)));
    }
    Ok(())
}

/// Refuses a coordinate of a point that is not finite or too large.
pub(super) fn coordinate(field: &str, point: [f64; 2], axis: usize) -> Result<(), Error> {
    limited(&format!("{field}[{axis}]"), point[axis])
}

/// What is allowed of a number between two others.
pub(super) fn from_to(least: f64, most: f64) -> Message {
    message!("scene-from-to", "from {least} to {most}", least, most)
}

/// What is allowed of an upper end: more than the lower one, which is named.
pub(super) fn greater_than(name: &str, value: f64) -> Message {
    message!("scene-greater-than", "greater than {name} = {value}", name, value)
}

/// What is said where something is missing.
pub(super) fn nothing() -> Message {
    message!("error-nothing", "nothing")
}

/// What is said of a field that must be left out.
pub(super) fn this_field() -> Message {
    message!("error-this-field", "this field")
}
