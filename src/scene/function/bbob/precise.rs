//! Logarithm and cosine, as good as always correctly rounded: computed with twice the digits. Where columns of a rotation nearly depend on
//! each other, the last bit of what is drawn decides what others call the same function.

use std::f64::consts::{FRAC_PI_2, LN_2, SQRT_2};

/// What the constants of std leave out.
const FRAC_PI_2_REST: f64 = 6.123_233_995_736_766e-17;
const LN_2_REST: f64 = 2.319_046_813_846_3e-17;
/// So many terms of a series are enough, with factors of at most 0.03 and 0.62.
const TERMS: u32 = 16;

/// An unevaluated sum of two numbers, the second a rounding error of the first.
#[derive(Clone, Copy)]
struct Double(f64, f64);

/// The sum of two numbers.
fn sum(a: f64, b: f64) -> Double {
    let sum = a + b;
    let rest = sum - a;
    Double(sum, (a - (sum - rest)) + (b - rest))
}

/// The product of two numbers, by Dekker’s halves.
fn product(a: f64, b: f64) -> Double {
    const HALF: f64 = 134_217_729.0;
    let halves = |x: f64| {
        let high = HALF * x - (HALF * x - x);
        (high, x - high)
    };
    let product = a * b;
    let ((a, c), (b, d)) = (halves(a), halves(b));
    Double(product, ((a * b - product) + a * d + c * b) + c * d)
}

impl Double {
    #[inline(never)]
    fn plus(self, other: Self) -> Self {
        let Self(high, low) = sum(self.0, other.0);
        sum(high, low + self.1 + other.1)
    }

    #[inline(never)]
    fn times(self, other: Self) -> Self {
        let Self(high, low) = product(self.0, other.0);
        sum(high, low + self.0 * other.1 + self.1 * other.0)
    }

    #[inline(never)]
    fn over(self, other: Self) -> Self {
        let quotient = self.0 / other.0;
        let rest = self.plus(other.times(Self(-quotient, 0.0)));
        sum(quotient, rest.0 / other.0)
    }
}

/// c₀ (1 + c₁ (1 + c₂ (1 + …))).
fn nested(factor: impl Fn(u32) -> Double) -> Double {
    let one = Double(1.0, 0.0);
    (1..TERMS).rev().fold(one, |inner, k| one.plus(factor(k).times(inner)))
}

/// The natural logarithm of a positive number that is not subnormal.
pub(super) fn ln(x: f64) -> f64 {
    let bits = x.to_bits();
    let mut exponent = (bits >> 52) as i64 - 1023;
    let mut mantissa = f64::from_bits(bits & (u64::MAX >> 12) | 1023 << 52);
    if mantissa > SQRT_2 {
        mantissa /= 2.0;
        exponent += 1;
    }
    // 2 artanh s with s = (m − 1) / (m + 1).
    let s = Double(mantissa - 1.0, 0.0).over(sum(mantissa, 1.0));
    let square = s.times(s);
    let terms = nested(|k| {
        let k = f64::from(2 * k);
        square.times(Double(k - 1.0, 0.0).over(Double(k + 1.0, 0.0)))
    });
    let exponent = Double(exponent as f64, 0.0);
    let Double(high, low) = exponent.times(Double(LN_2, LN_2_REST)).plus(s.plus(s).times(terms));
    high + low
}

/// The cosine of an angle from 0 to 2π.
pub(super) fn cos(angle: f64) -> f64 {
    let quarters = (angle / FRAC_PI_2 + 0.5).floor();
    let rest = Double(angle, 0.0).plus(Double(-quarters, 0.0).times(Double(FRAC_PI_2, FRAC_PI_2_REST)));
    let square = rest.times(rest);
    // The series of the cosine, or of the sine where a quarter is left.
    let odd = quarters % 2.0;
    let terms = nested(|k| {
        let k = f64::from(2 * k) + odd;
        square.times(Double(-1.0, 0.0).over(Double(k * (k - 1.0), 0.0)))
    });
    let Double(high, low) = if odd == 0.0 { terms } else { terms.times(rest) };
    if matches!(quarters as u8, 1 | 2) { -(high + low) } else { high + low }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_agree_with_libm_but_for_its_last_bit() {
        for k in 1..2000 {
            let x = f64::from(k) / 2000.0;
            for (ours, theirs) in [(ln(x), libm::log(x)), (cos(x * 6.2), libm::cos(x * 6.2))] {
                assert!((ours - theirs).abs() <= f64::EPSILON * theirs.abs(), "{x}: {ours:e} is not {theirs:e}");
            }
        }
    }

    #[test]
    fn hard_cases_are_rounded_correctly() {
        // By 200 bits; a usual library is a unit off in each.
        for (x, expected) in [
            (1e-99, -227.955_924_206_410_51),
            (0.587_235_662_893_967_6, -0.532_329_069_714_801_9),
            (0.406_985_653_753_851_4, -0.898_977_342_922_830_2),
            (0.235_930_518_822_712_13, -1.444_217_929_072_349),
            (1.0, 0.0),
        ] {
            assert_eq!(ln(x), expected, "{x}");
        }
        for (angle, expected) in [
            (4.987_829_366_716_343, 0.271_970_749_512_764_6),
            (1.100_147_341_036_345_1, 0.453_464_805_086_377_15),
            (4.854_486_007_568_116, 0.141_619_316_161_925_72),
            (0.0, 1.0),
        ] {
            assert_eq!(cos(angle), expected, "{angle}");
        }
    }
}
