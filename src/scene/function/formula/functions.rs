//! What a formula can call.

use crate::math;

/// A function that a formula can call.
#[derive(Debug, Clone, Copy)]
pub struct Function {
    /// Its name.
    pub name: &'static str,
    /// What it is computed by.
    pub(super) of: Call,
}

/// How a function is computed, by the number of its arguments.
#[derive(Debug, Clone, Copy)]
pub(super) enum Call {
    /// From one.
    One(fn(f64) -> f64),
    /// From two.
    Two(fn(f64, f64) -> f64),
    /// From two or more, from left to right.
    Many(fn(f64, f64) -> f64),
    /// Of a condition and two values, the first where the condition is not 0.
    Choice,
    /// Of a body, a name and a range.
    Sum,
    /// The same as a product.
    Product,
}

const fn one(name: &'static str, of: fn(f64) -> f64) -> Function {
    Function { name, of: Call::One(of) }
}

const fn two(name: &'static str, of: fn(f64, f64) -> f64) -> Function {
    Function { name, of: Call::Two(of) }
}

/// All that a formula can call: of one argument, of two, `min` and `max` of two or more, `if(condition, one, other)`, and `sum` and `prod`.
pub const FUNCTIONS: &[Function] = &[
    Function { name: "sum", of: Call::Sum },
    Function { name: "prod", of: Call::Product },
    Function { name: "if", of: Call::Choice },
    Function { name: "min", of: Call::Many(least) },
    Function { name: "max", of: Call::Many(greatest) },
    one("abs", f64::abs),
    one("sqrt", f64::sqrt),
    one("cbrt", libm::cbrt),
    one("exp", math::exp),
    one("ln", math::ln),
    one("log", math::ln),
    one("log2", libm::log2),
    one("log10", math::log10),
    one("sin", math::sin),
    one("cos", math::cos),
    one("tan", libm::tan),
    one("asin", math::asin),
    one("acos", math::acos),
    one("atan", libm::atan),
    one("sinh", libm::sinh),
    one("cosh", libm::cosh),
    one("tanh", libm::tanh),
    one("floor", libm::floor),
    one("ceil", libm::ceil),
    one("round", libm::round),
    one("sign", sign),
    two("atan2", math::atan2),
    two("hypot", libm::hypot),
    two("pow", power),
    two("mod", modulo),
];

/// −1, 0 or 1.
fn sign(a: f64) -> f64 {
    if a > 0.0 {
        1.0
    } else if a < 0.0 {
        -1.0
    } else {
        a
    }
}

/// The lesser of two; NaN if one of them is.
fn least(a: f64, b: f64) -> f64 {
    if a.is_nan() || a < b { a } else { b }
}

/// The greater of two; NaN if one of them is.
fn greatest(a: f64, b: f64) -> f64 {
    if a.is_nan() || a > b { a } else { b }
}

/// `a` to the power of `b`.
pub(super) fn power(a: f64, b: f64) -> f64 {
    math::pow(a, b)
}

/// What is left of `a` when whole multiples of `b` are taken away, with the sign of `b`.
pub(super) fn modulo(a: f64, b: f64) -> f64 {
    a - b * libm::floor(a / b)
}

/// The function of this name.
pub(super) fn find(name: &str) -> Option<&'static Function> {
    FUNCTIONS.iter().find(|function| function.name == name)
}
