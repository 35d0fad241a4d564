//! Functions by formula: `sum(x[i]^2 - 10*cos(2*pi*x[i]) + 10)`.
//!
//! `grammar` reads a text into code, an operand before its operator. `compile` carries that code out once, with the number of
//! variables known: sums and products over the other ones are written out, innermost ones become steps over all of their
//! terms, and every name and index is checked. `program` is what is left, and is carried out for each position.
//! `functions` lists what can be called.

mod compile;
mod functions;
mod grammar;
mod program;
mod scene;
#[cfg(test)]
mod tests;

use std::fmt;

use crate::{
    kernel::{Error, limits::check_bytes},
    message,
};

use super::read::EXPRESSION;
pub use functions::{FUNCTIONS, Function as FormulaFunction};
use program::Program;
pub(super) use scene::read;

/// How many bytes a formula may have.
pub const MOST_BYTES: usize = 4096;

/// A function of `n` variables, compiled from a text.
///
/// Variables are `x[1]` to `x[n]`; `x`, `y` and `z` are the first three. `sum(…)` and `prod(…)` go over `i` from 1 to `n`, or over
/// another name and range: `sum(…, k, 1, n - 1)`. Then there are `n`, `pi`, `tau` and `e`; `+ - * / % ^`; comparisons, `&&`, `||` and
/// `!`, which are 1 or 0; `condition ? one : other`; and [`FUNCTIONS`].
///
/// ```
/// use forage::scene::Formula;
///
/// let valley = Formula::new("sum(100*(x[i+1] - x[i]^2)^2 + (1 - x[i])^2, i, 1, n - 1)", 3)?;
/// assert_eq!(valley.value(&[2.0, 3.0, -1.0], &mut Vec::new()), 100.0 + 1.0 + 10_000.0 + 4.0);
/// let error = Formula::new("sum(x[i]^2", 3).unwrap_err();
/// assert!(error.to_string().contains("character 11"));
/// # Ok::<(), forage::Error>(())
/// ```
#[derive(Clone, PartialEq)]
pub struct Formula {
    text: String,
    dimension: usize,
    program: Program,
}

impl Formula {
    /// Compiles a text for `dimension` variables.
    ///
    /// # Errors
    /// [`Error::Malformed`] for `expression`, with the place and with what could stand there; [`Error::Refused`] for a text of
    /// more than [`MOST_BYTES`] bytes, and for a `dimension` of 0.
    pub fn new(text: &str, dimension: usize) -> Result<Self, Error> {
        check_bytes(EXPRESSION, text.len(), MOST_BYTES)?;
        if dimension == 0 {
            return Err(Error::refused("dimension", dimension, message!("scene-positive-whole", "a positive whole number")));
        }
        let code = grammar::read(text).map_err(|fault| fault.of(text))?;
        let program = compile::compile(&code, dimension).map_err(|fault| fault.of(text))?;
        Ok(Self { text: text.to_owned(), dimension, program })
    }

    /// The text that it was compiled from.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The value at `x`, whose length is the number of variables. NaN or infinite where the formula is not defined. `room` is
    /// worked in: the same one again and again costs no allocation.
    ///
    /// # Panics
    /// If `x` has fewer numbers than there are variables.
    pub fn value(&self, x: &[f64], room: &mut Vec<f64>) -> f64 {
        let mut value = f64::NAN;
        self.program.values(&x[..self.dimension], self.dimension, room, |of_x| value = of_x);
        value
    }

    /// The values at many positions, one after the other in `xs`, into `out`: the same bits as one by one, several times as fast.
    pub fn values(&self, xs: &[f64], room: &mut Vec<f64>, out: &mut [f64]) {
        let mut out = out.iter_mut();
        self.each_value(xs, room, |value| {
            if let Some(out) = out.next() {
                *out = value;
            }
        });
    }

    fn each_value(&self, xs: &[f64], room: &mut Vec<f64>, out: impl FnMut(f64)) {
        let whole = xs.len() / self.dimension * self.dimension;
        self.program.values(&xs[..whole], self.dimension, room, out);
    }
}

impl fmt::Debug for Formula {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Formula").field(&self.text).finish()
    }
}
