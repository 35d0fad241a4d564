//! Which numbers a scene may hold.

use crate::kernel::{Error, digits::Digits};

/// The largest coordinate or size: squares of it keep their digits.
pub(crate) const LARGEST: f64 = 1e6;

/// Refuses numbers that are not finite.
pub(crate) fn finite(field: &str, value: f64) -> Result<(), Error> {
    if value.is_finite() { Ok(()) } else { Err(Error::refused(field, value, "a finite number")) }
}

/// Refuses numbers that are not finite or too large.
pub(super) fn limited(field: &str, value: f64) -> Result<(), Error> {
    finite(field, value)?;
    if value.abs() > LARGEST {
        return Err(Error::refused(field, value, format!("from -{0} to {0}", Digits(LARGEST))));
    }
    Ok(())
}

/// Refuses numbers that are not greater than 0 or too large.
pub(super) fn positive(field: &str, value: f64) -> Result<(), Error> {
    finite(field, value)?;
    if value <= 0.0 || value > LARGEST {
        return Err(Error::refused(field, value, format!("greater than 0, at most {}", Digits(LARGEST))));
    }
    Ok(())
}

/// Refuses a coordinate of a point that is not finite or too large.
pub(super) fn coordinate(field: &str, point: [f64; 2], axis: usize) -> Result<(), Error> {
    limited(&format!("{field}[{axis}]"), point[axis])
}
