//! Numbers and values as they stand in a row.

use forage::Value;

/// A value as it stands in a row.
pub(super) fn value_text(value: &Value) -> String {
    match value {
        Value::Number(number) => number_text(*number),
        Value::Flag(flag) => flag.to_string(),
        Value::Text(text) => text.clone(),
    }
}

/// The shortest digits that give the number again, which JSON can read, too: `40`, `0.4`, `1e-9`.
pub(super) fn number_text(number: f64) -> String {
    let text = format!("{number:?}");
    text.strip_suffix(".0").map(str::to_owned).unwrap_or(text)
}
