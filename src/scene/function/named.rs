//! The test functions that have names: those of [WCPSO](crate#papers) Table 1, and Rastrigin from [LTQPSO](crate#papers).

use std::f64::consts::{E, TAU};

use serde_json::Value;

use crate::{
    kernel::{
        Error,
        objective::{Evaluation, Objective, Scratch, SearchBox},
    },
    math, message,
};

/// The largest dimension of a function.
pub const MAX_DIMENSION: usize = 100;

/// A test function to minimise. Each has the minimum 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename = "TestFunction", rename_all = "kebab-case"))]
pub enum Function {
    /// f1, D = 2, minimum at 0.
    Matyas,
    /// f2, D = 2, minimum at 0.
    EggCrate,
    /// f3, minimum at 0.
    Sphere,
    /// f4, minimum at (1, …, 1).
    Rosenbrock,
    /// f5, minimum at 0.
    Ackley,
    /// f6, minimum at 0.
    Rastrigin,
}

impl Function {
    /// All functions, in the order of the table.
    pub const ALL: [Self; 6] = [Self::Matyas, Self::EggCrate, Self::Sphere, Self::Rosenbrock, Self::Ackley, Self::Rastrigin];

    /// The name that scene files use.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Matyas => "matyas",
            Self::EggCrate => "egg-crate",
            Self::Sphere => "sphere",
            Self::Rosenbrock => "rosenbrock",
            Self::Ackley => "ackley",
            Self::Rastrigin => "rastrigin",
        }
    }

    /// Half the side of the search box, which is centred on 0.
    pub const fn half_side(self) -> f64 {
        match self {
            Self::Matyas => 10.0,
            Self::EggCrate => TAU,
            Self::Sphere => 100.0,
            Self::Rosenbrock => 4.0,
            Self::Ackley => 32.0,
            Self::Rastrigin => 5.12,
        }
    }

    /// The dimensions it is defined in, both ends included.
    pub const fn dimensions(self) -> (usize, usize) {
        match self {
            Self::Matyas | Self::EggCrate => (2, 2),
            Self::Rosenbrock => (2, MAX_DIMENSION),
            Self::Sphere | Self::Ackley | Self::Rastrigin => (1, MAX_DIMENSION),
        }
    }

    /// The value of every coordinate at the minimum.
    pub const fn minimiser(self) -> f64 {
        if matches!(self, Self::Rosenbrock) { 1.0 } else { 0.0 }
    }

    /// The function's value at `x`, whose length is the dimension.
    #[inline]
    pub fn value(self, x: &[f64]) -> f64 {
        match self {
            Self::Matyas => 0.26 * (x[0] * x[0] + x[1] * x[1]) - 0.48 * x[0] * x[1],
            Self::EggCrate => {
                let (a, b) = (math::sin(x[0]), math::sin(x[1]));
                x[0] * x[0] + x[1] * x[1] + 25.0 * (a * a + b * b)
            }
            Self::Sphere => x.iter().map(|x| x * x).sum(),
            Self::Rosenbrock => x
                .windows(2)
                .map(|w| {
                    let (curve, slope) = (w[1] - w[0] * w[0], 1.0 - w[0]);
                    100.0 * curve * curve + slope * slope
                })
                .sum(),
            Self::Ackley => {
                let n = x.len() as f64;
                let squares: f64 = x.iter().map(|x| x * x).sum();
                let cosines = math::sum_cos_turns(x);
                -20.0 * math::exp(-0.2 * (squares / n).sqrt()) - math::exp(cosines / n) + 20.0 + E
            }
            Self::Rastrigin => x.iter().map(|&x| x * x - 10.0 * math::cos_turns(x) + 10.0).sum(),
        }
    }
}

/// A test function in so many variables, with its origin anywhere.
#[derive(Debug, Clone)]
pub(super) struct Named {
    pub function: Function,
    /// As it was given: the box has no more sides than a function may have.
    dimension: usize,
    /// The position of the function's origin, a number for each variable; empty: at 0.
    pub shift: Vec<f64>,
    search_box: SearchBox,
}

impl Named {
    pub fn new(function: Function, dimension: usize, shift: Vec<f64>) -> Self {
        let side = function.half_side();
        let search_box = SearchBox::of(std::iter::repeat_n([-side, side], dimension.min(MAX_DIMENSION)));
        Self { function, dimension, shift, search_box }
    }

    pub fn check(&self) -> Result<(), Error> {
        let dimension = self.dimension;
        let (low, high) = self.function.dimensions();
        if !(low..=high).contains(&dimension) {
            let function = self.function.name();
            let allowed = if low == high {
                message!("scene-dimension", "{low} for {function}", low, function)
            } else {
                message!("scene-dimensions", "a whole number from {low} to {high} for {function}", low, high, function)
            };
            return Err(Error::refused("dimension", dimension, allowed));
        }
        if ![0, dimension].contains(&self.shift.len()) {
            return Err(Error::refused("shift", self.shift.len(), message!("scene-shift", "a number for each variable")));
        }
        let inside = |shift: &&f64| (self.function.minimiser() + **shift).abs() <= self.function.half_side();
        match self.shift.iter().find(|shift| !inside(shift)) {
            Some(shift) => {
                let allowed = message!("scene-shift-inside", "so small that the minimum stays in the search box");
                Err(Error::refused("shift", *shift, allowed))
            }
            None => Ok(()),
        }
    }

    /// The position of the minimum.
    pub fn minimiser(&self) -> Vec<f64> {
        (0..self.search_box.dimension()).map(|i| self.function.minimiser() + self.shift.get(i).unwrap_or(&0.0)).collect()
    }

    pub fn write(&self, out: &mut Vec<(&'static str, Value)>) {
        out.extend([("function", Value::from(self.function.name())), ("dimension", Value::from(self.dimension))]);
        if !self.shift.is_empty() {
            out.push(("shift", Value::from(self.shift.as_slice())));
        }
    }

    /// The value at `x`, whose length is the dimension.
    #[inline]
    fn value(&self, x: &[f64]) -> f64 {
        let moved;
        let x = if self.shift.is_empty() {
            x
        } else {
            moved = self.moved(x);
            &moved[..x.len()]
        };
        self.function.value(x)
    }

    /// `x` without the shift.
    #[cold]
    fn moved(&self, x: &[f64]) -> [f64; MAX_DIMENSION] {
        let mut moved = [0.0; MAX_DIMENSION];
        moved.iter_mut().zip(x.iter().zip(&self.shift)).for_each(|(moved, (x, shift))| *moved = x - shift);
        moved
    }
}

impl Objective for Named {
    fn search_box(&self) -> &SearchBox {
        &self.search_box
    }

    fn evaluate(&self, x: &[f64], _scratch: &mut Scratch) -> Evaluation {
        self.value(x).into()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn close(value: f64, expected: f64) {
        assert!((value - expected).abs() <= 1e-12 * expected.abs().max(1.0), "{value} is not {expected}");
    }

    #[test]
    fn values_agree_with_those_computed_by_hand() {
        close(Function::Matyas.value(&[3.0, -2.0]), 0.26 * 13.0 + 0.48 * 6.0); // 6.26
        close(Function::EggCrate.value(&[std::f64::consts::FRAC_PI_2, 0.0]), 25.0 + 2.467_401_100_272_339_7);
        close(Function::Sphere.value(&[1.0, -2.0, 3.0]), 14.0);
        close(Function::Rosenbrock.value(&[2.0, 3.0, -1.0]), 100.0 + 1.0 + 100.0 * 100.0 + 4.0);
        // 20 (1 - e^-0.2) + e - e^1 at (1, 1): the cosines are 1.
        close(Function::Ackley.value(&[1.0, 1.0]), 20.0 * (1.0 - 0.818_730_753_077_981_8));
        close(Function::Ackley.value(&[0.5]), 20.0 * (1.0 - 0.904_837_418_035_959_6) + E - 0.367_879_441_171_442_33);
        close(Function::Rastrigin.value(&[1.0, 0.5]), 1.0 + 0.25 + 20.0);
    }

    #[test]
    fn each_minimum_is_zero_where_it_is_said_to_be() {
        for function in Function::ALL {
            for dimension in [function.dimensions().0, function.dimensions().1.min(10)] {
                let value = function.value(&vec![function.minimiser(); dimension]);
                // Ackley's is one rounding of 20 + e off, as the paper's table prints it.
                let expected = if function == Function::Ackley { 8.881_784_197_001_252e-16 } else { 0.0 };
                assert!(value.abs() <= expected, "{} in {dimension} dimensions: {value:e}", function.name());
            }
        }
    }

    #[test]
    fn dimensions_outside_the_table_are_refused() {
        let refused = |function, dimension| Named::new(function, dimension, Vec::new()).check().is_err();
        assert!(refused(Function::Matyas, 3) && refused(Function::Rosenbrock, 1) && refused(Function::Sphere, 0));
        assert!(refused(Function::Sphere, 2_000_000_000) && refused(Function::Sphere, MAX_DIMENSION + 1) && !refused(Function::Sphere, 1));
    }

    #[test]
    fn a_shift_moves_the_minimum_and_keeps_it_in_the_search_box() {
        let scene = |shift: &[f64]| Named::new(Function::Rosenbrock, 2, shift.to_vec());
        let moved = scene(&[-3.0, 2.5]);
        assert_eq!((moved.check(), moved.minimiser()), (Ok(()), vec![-2.0, 3.5]));
        assert_eq!((moved.value(&[-2.0, 3.5]), moved.value(&[-1.0, 5.5])), (0.0, Function::Rosenbrock.value(&[2.0, 3.0])));
        assert!(scene(&[3.5, 0.0]).check().unwrap_err().to_string().contains("search box"));
        assert!(scene(&[0.0]).check().unwrap_err().to_string().contains("a number for each"));
    }
}
