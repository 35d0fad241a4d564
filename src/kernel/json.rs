//! JSON text and numbers, read and written alike natively and in WebAssembly.
//!
//! In WebAssembly JavaScript's own parser reads, instead of a second one with tables of its own in the download. Both
//! round correctly, so the bits are the same. The writer is the same everywhere, and so is the text of a link.

use std::fmt::Write;

use serde_json::Value;

use crate::message;

use super::{Error, digits::Digits, limits};

/// Reads JSON; `field` is what an error calls it.
///
/// # Errors
/// [`Error::Refused`] for a text that is nested too deep or too large, see [`limits`]. [`Error::Malformed`] for what is no JSON:
/// what is wrong, in WebAssembly in the words of the JavaScript engine.
pub fn parse(field: &str, text: &str) -> Result<Value, Error> {
    limits::check_json(field, text)?;
    parsed(field, text)
}

#[cfg(not(target_arch = "wasm32"))]
fn parsed(field: &str, text: &str) -> Result<Value, Error> {
    serde_json::from_str(text).map_err(|problem| no_json(field, problem))
}

#[cfg(target_arch = "wasm32")]
fn parsed(field: &str, text: &str) -> Result<Value, Error> {
    let value = js_sys::JSON::parse(text).map_err(|problem| no_json(field, String::from(js_sys::Error::from(problem).message())))?;
    super::javascript::read(field, &value)
}

fn no_json(field: &str, problem: impl std::fmt::Display) -> Error {
    Error::malformed(field, message!("error-not-json", "not JSON: {problem}", problem = problem.to_string()))
}

/// The number that a text of digits, point, signs and exponent stands for; `None` for any other text.
pub fn number(text: &str) -> Option<f64> {
    let plain = text.bytes().all(|byte| byte.is_ascii_digit() || b"+-.eE".contains(&byte));
    if plain { decimal(text) } else { None }
}

#[cfg(not(target_arch = "wasm32"))]
fn decimal(text: &str) -> Option<f64> {
    text.parse().ok()
}

#[cfg(target_arch = "wasm32")]
fn decimal(text: &str) -> Option<f64> {
    // For JavaScript an empty text is 0.
    let number = wasm_bindgen::JsValue::from_str(text).unchecked_into_f64();
    (!text.is_empty() && !number.is_nan()).then_some(number)
}

/// Writes an object's fields in their order, without spaces.
pub fn object<'a>(fields: impl IntoIterator<Item = (&'a str, &'a Value)>) -> String {
    let mut writer = Writer { out: String::new(), level: None };
    writer.object(&mut fields.into_iter());
    writer.out
}

/// Writes an object's fields in their order, for people: each in a line, and so is each item of a list.
pub fn pretty<'a>(fields: impl IntoIterator<Item = (&'a str, &'a Value)>) -> String {
    let mut writer = Writer { out: String::new(), level: Some(0) };
    writer.object(&mut fields.into_iter());
    writer.out
}

struct Writer {
    out: String,
    /// How deep the line is indented; `None` where there are no lines.
    level: Option<usize>,
}

impl Writer {
    fn object(&mut self, fields: &mut dyn Iterator<Item = (&str, &Value)>) {
        self.open('{');
        let mut count = 0;
        for (name, value) in fields {
            self.separate(count);
            write_text(&mut self.out, name);
            self.out.push_str(if self.level.is_some() { ": " } else { ":" });
            self.value(value);
            count += 1;
        }
        self.close('}', count);
    }

    fn value(&mut self, value: &Value) {
        match value {
            Value::Null => self.out.push_str("null"),
            Value::Bool(flag) => self.out.push_str(if *flag { "true" } else { "false" }),
            Value::Number(number) => {
                let value = number.as_f64().unwrap_or_default();
                write_number(&mut self.out, value);
                if self.level.is_some() && number.is_f64() && value.fract() == 0.0 && value.abs() < 1e21 {
                    self.out.push_str(".0");
                }
            }
            Value::String(text) => write_text(&mut self.out, text),
            Value::Array(items) => {
                self.open('[');
                for (i, item) in items.iter().enumerate() {
                    self.separate(i);
                    self.value(item);
                }
                self.close(']', items.len());
            }
            Value::Object(fields) => self.object(&mut fields.iter().map(|(name, value)| (name.as_str(), value))),
        }
    }

    fn open(&mut self, bracket: char) {
        self.out.push(bracket);
        self.level = self.level.map(|level| level + 1);
    }

    fn close(&mut self, bracket: char, count: usize) {
        self.level = self.level.map(|level| level - 1);
        if count > 0 {
            self.line();
        }
        self.out.push(bracket);
    }

    fn separate(&mut self, i: usize) {
        if i > 0 {
            self.out.push(',');
        }
        self.line();
    }

    fn line(&mut self) {
        if let Some(level) = self.level {
            self.out.push('\n');
            (0..level).for_each(|_| self.out.push_str("  "));
        }
    }
}

/// Whole numbers without a point; exponents only for the very small and the very large.
fn write_number(out: &mut String, number: f64) {
    let size = number.abs();
    // Writing to a string cannot fail.
    let digits = Digits(number);
    let _ = if size == 0.0 || (1e-6..1e21).contains(&size) { write!(out, "{digits}") } else { write!(out, "{digits:e}") };
}

fn write_text(out: &mut String, text: &str) {
    out.push('"');
    for character in text.chars() {
        match character {
            '"' | '\\' => out.extend(['\\', character]),
            '\0'..='\x1f' => {
                let _ = write!(out, "\\u{:04x}", character as u32);
            }
            _ => out.push(character),
        }
    }
    out.push('"');
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_written_is_read_back() {
        let value = parse("a", r#"{"a": [1, 2.5, -3e-9, 1e300, true, null], "b": {"c\n\"\\": "ä\u0001"}}"#).unwrap();
        let text = object(value.as_object().unwrap().iter().map(|(name, value)| (name.as_str(), value)));
        assert_eq!(text, r#"{"a":[1,2.5,-3e-9,1e300,true,null],"b":{"c\u000a\"\\":"ä\u0001"}}"#);
        assert_eq!(parse("a", &text).unwrap(), value);
        let text = pretty(value.as_object().unwrap().iter().map(|(name, value)| (name.as_str(), value)));
        assert_eq!(parse("a", &text).unwrap(), value);
    }

    #[test]
    fn people_get_lines() {
        let value = parse("a", r#"{"a": [[1, 2.5], [3.0, -4.0]], "b": {}, "c": ["x", {"e": null}], "d": []}"#).unwrap();
        let text = pretty(value.as_object().unwrap().iter().map(|(name, value)| (name.as_str(), value)));
        assert_eq!(text, serde_json::to_string_pretty(&value).unwrap());
    }

    #[test]
    fn numbers_are_decimal_digits_only() {
        assert_eq!(["0.5", "-1e3", "+2", "5."].map(number), [Some(0.5), Some(-1000.0), Some(2.0), Some(5.0)]);
        assert_eq!(["", ".", "e", "1e", "0x10", "inf", "NaN", "1 2"].map(number), [None; 8]);
    }
}
