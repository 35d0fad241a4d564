//! Numbers as text: the shortest digits that stand for the same bits.
//!
//! In WebAssembly JavaScript finds the digits, instead of the tables and the arithmetic that it takes in the download. Both sides
//! find the same ones, and they are laid out alike.

use std::fmt;

/// A number, to be written as Rust does: without an exponent by `{}`, with one by `{:e}`.
#[derive(Debug, Clone, Copy)]
pub struct Digits(pub f64);

/// A position in words: `(1, 2.5)`.
pub fn coordinates(position: &[f64]) -> String {
    let numbers: Vec<_> = position.iter().map(|number| Digits(*number).to_string()).collect();
    format!("({})", numbers.join(", "))
}

#[cfg(not(target_arch = "wasm32"))]
impl fmt::Display for Digits {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.0)
    }
}

#[cfg(not(target_arch = "wasm32"))]
impl fmt::LowerExp for Digits {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:e}", self.0)
    }
}

#[cfg(target_arch = "wasm32")]
impl fmt::Display for Digits {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        written(self.0, f, false)
    }
}

#[cfg(target_arch = "wasm32")]
impl fmt::LowerExp for Digits {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        written(self.0, f, true)
    }
}

#[cfg(target_arch = "wasm32")]
#[inline(never)]
fn written(number: f64, f: &mut fmt::Formatter<'_>, exponent: bool) -> fmt::Result {
    if number.is_nan() {
        return f.write_str("NaN");
    }
    if number.is_sign_negative() {
        f.write_str("-")?;
    }
    let size = number.abs();
    if size.is_infinite() {
        return f.write_str("inf");
    }
    if size < 1e15 && size.fract() == 0.0 && !exponent {
        return write!(f, "{}", size as u64);
    }
    let number = js_sys::Number::from(size);
    let mut decimal = Decimal::of(&js_sys::JSON::stringify(&number).map(String::from).unwrap_or_default());
    // Halfway between two texts JavaScript takes the one with the even digit, and Rust the upper one, as `toPrecision` does.
    if let Ok(upper) = number.to_precision(decimal.digits.len() as u8)
        && upper.unchecked_into_f64() == size
    {
        decimal = Decimal::of(&String::from(upper));
    }
    decimal.write(f, exponent)
}

/// 0.DIGITS · 10^point, without zeros at the ends of the digits; 0 has the digit 0.
#[cfg(any(test, target_arch = "wasm32"))]
struct Decimal {
    digits: String,
    point: i32,
}

#[cfg(any(test, target_arch = "wasm32"))]
impl Decimal {
    /// The text of a number in JavaScript that is not negative: `12`, `0.5`, `1.5e-7`.
    fn of(text: &str) -> Self {
        let (mantissa, shift) = text.split_once('e').unwrap_or((text, "0"));
        let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
        let mut digits = [whole, fraction].concat();
        let mut point = whole.len() as i32 + shift.parse().unwrap_or(0);
        while digits.len() > 1 && digits.ends_with('0') {
            digits.pop();
        }
        while digits.len() > 1 && digits.starts_with('0') {
            digits.remove(0);
            point -= 1;
        }
        Self { digits, point }
    }

    fn write(self, f: &mut dyn fmt::Write, exponent: bool) -> fmt::Result {
        let Self { digits, mut point } = self;
        let end = point - 1;
        if exponent {
            point = 1;
        } else if point <= 0 {
            f.write_str("0.")?;
        }
        for _ in point..0 {
            f.write_char('0')?;
        }
        for (at, digit) in (0..).zip(digits.chars()) {
            if at == point && at > 0 {
                f.write_char('.')?;
            }
            f.write_char(digit)?;
        }
        for _ in digits.len() as i32..point {
            f.write_char('0')?;
        }
        if exponent { write!(f, "e{end}") } else { Ok(()) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kernel::Digest;

    /// The digest of the texts of 20,000 random numbers, which tests/wasm.test.mjs compares.
    const TEXTS: &str = "dd9a836bc19eeaf5";

    /// All bit patterns alike, and numbers of every usual size.
    fn numbers() -> impl Iterator<Item = f64> {
        let mut state = 1_u64;
        let mut next = move || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            state
        };
        (0..10_000).flat_map(move |i| [f64::from_bits(next()), (next() >> 11) as f64 / format!("1e{}", i % 23).parse::<f64>().unwrap()])
    }

    /// As JavaScript writes a number that is not negative.
    fn in_javascript(number: f64) -> String {
        if number == 0.0 || (1e-6..1e21).contains(&number) {
            return number.to_string();
        }
        let text = format!("{number:e}");
        if text.contains("e-") { text } else { text.replace('e', "e+") }
    }

    #[test]
    fn digits_of_javascript_are_laid_out_as_here() {
        for number in numbers().chain([0.0, 1e21, 1e-6, 1e-7, 5e-324, f64::MAX, 1e15, 123.0, 100.0]).filter(|number| number.is_finite()) {
            let mut texts = [String::new(), String::new()];
            Decimal::of(&in_javascript(number.abs())).write(&mut texts[0], false).unwrap();
            Decimal::of(&in_javascript(number.abs())).write(&mut texts[1], true).unwrap();
            assert_eq!(texts, [format!("{}", number.abs()), format!("{:e}", number.abs())]);
        }
    }

    #[test]
    fn the_texts_of_random_numbers_are_those_in_webassembly() {
        let texts: Vec<_> = numbers().map(|number| Digits(number).to_string()).collect();
        let mut digest = Digest::default();
        digest.bytes(texts.join("\n").as_bytes());
        assert_eq!(digest.hex(), TEXTS);
    }
}
