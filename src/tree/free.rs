//! The question that what is made of a path asks of the space.

/// Whether one can go straight from one point to another.
pub(super) type Free<'a, const N: usize> = &'a dyn Fn(&[f64; N], &[f64; N]) -> bool;
