//! Distances by fractions of whole numbers of any size.

use num_bigint::BigInt;
use num_rational::Ratio;
use num_traits::{One as _, ToPrimitive as _, Zero as _};

pub type Number = Ratio<BigInt>;

/// A floating-point number is a fraction.
pub fn exact(number: f64) -> Number {
    Number::from_float(number).expect("it is finite")
}

pub fn square(number: &Number) -> Number {
    number * number
}

/// The nearest floating-point number.
pub fn nearest(number: &Number) -> f64 {
    number.to_f64().expect("every fraction has one")
}

/// The square of the distance of two points.
pub fn apart(a: &[Number], b: &[Number]) -> Number {
    a.iter().zip(b).map(|(a, b)| square(&(a - b))).sum()
}

/// The point at a parameter of a segment.
pub fn along(a: &[f64], b: &[f64], t: f64) -> Vec<Number> {
    let t = exact(t);
    a.iter().zip(b).map(|(&a, &b)| exact(a) + &t * (exact(b) - exact(a))).collect()
}

/// The square of the distance of the segment from `a` to `b` from 0.
pub fn between(a: &[Number], b: &[Number]) -> Number {
    let step: Vec<Number> = a.iter().zip(b).map(|(a, b)| b - a).collect();
    let length: Number = step.iter().map(square).sum();
    let along: Number = a.iter().zip(&step).map(|(a, step)| -(a * step)).sum();
    let t = if length.is_zero() { Number::zero() } else { (along / length).max(Number::zero()).min(Number::one()) };
    a.iter().zip(&step).map(|(a, step)| square(&(a + &t * step))).sum()
}

/// The square of the distance of a point from a segment.
pub fn to_point(a: &[f64], b: &[f64], c: &[f64]) -> Number {
    let from = |end: &[f64]| end.iter().zip(c).map(|(&end, &c)| exact(end) - exact(c)).collect::<Vec<_>>();
    between(&from(a), &from(b))
}

/// The square of the distance of a segment from a box with sides along the axes. Between the places where it passes the plane of a side
/// the square is a parabola.
pub fn to_box(a: &[f64], b: &[f64], min: &[f64], max: &[f64]) -> Number {
    let excess = |axis: usize, t: &Number| {
        let x = exact(a[axis]) + t * (exact(b[axis]) - exact(a[axis]));
        let (low, high) = (exact(min[axis]), exact(max[axis]));
        if x < low {
            x - low
        } else if x > high {
            x - high
        } else {
            Number::zero()
        }
    };
    let at = |t: &Number| -> Vec<Number> { (0..a.len()).map(|axis| excess(axis, t)).collect() };
    places(a, b, min, max).windows(2).map(|pair| between(&at(&pair[0]), &at(&pair[1]))).min().expect("there is a piece")
}

/// The greatest distance of a point of a segment from the nearest side of the rectangle that it is in; 0 where it is in none of it. It is
/// where two sides are equally near, or at an end of what is inside.
pub fn depth(a: &[f64], b: &[f64], min: &[f64], max: &[f64]) -> Number {
    let sides = |t: &Number| -> Vec<Number> {
        let x = |axis: usize| exact(a[axis]) + t * (exact(b[axis]) - exact(a[axis]));
        (0..2).flat_map(|axis| [x(axis) - exact(min[axis]), exact(max[axis]) - x(axis)]).collect()
    };
    let (first, last) = (sides(&Number::zero()), sides(&Number::one()));
    let mut all = places(a, b, min, max);
    for i in 0..4 {
        for j in 0..i {
            let slope = (&last[i] - &first[i]) - (&last[j] - &first[j]);
            if !slope.is_zero() {
                all.push((&first[j] - &first[i]) / slope);
            }
        }
    }
    let inside = all.iter().filter(|t| **t >= Number::zero() && **t <= Number::one());
    inside.filter_map(|t| sides(t).into_iter().min()).fold(Number::zero(), Number::max)
}

/// 0, 1 and the parameters between at which a segment passes the plane of a side, in their order.
fn places(a: &[f64], b: &[f64], min: &[f64], max: &[f64]) -> Vec<Number> {
    let mut places = vec![Number::zero(), Number::one()];
    for axis in 0..a.len() {
        let step = exact(b[axis]) - exact(a[axis]);
        if !step.is_zero() {
            places.extend([min, max].map(|side| (exact(side[axis]) - exact(a[axis])) / &step));
        }
    }
    places.retain(|t| *t >= Number::zero() && *t <= Number::one());
    places.sort();
    places
}
