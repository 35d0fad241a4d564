//! Everything that is printed goes through here.

use std::{
    fmt::{Display, Write as _},
    io::{self, Write},
    process::ExitCode,
};

use forage::kernel::message::in_english;
use serde::Serialize;

use super::{
    failure::Failure,
    text::{self, is_unsafe},
};

/// Prints a text for people to standard output.
pub(super) fn print(text: &str) -> Result<(), Failure> {
    print_raw(text::escape_lines(text.trim_end()).as_bytes())
}

/// Prints a value as JSON to standard output.
pub(super) fn print_json(value: &impl Serialize) -> Result<(), Failure> {
    print_raw(json(value)?.as_bytes())
}

/// A value as indented JSON, in English, NaN as null, in which characters that a terminal would act on are written `\u009b`.
fn json(value: &impl Serialize) -> Result<String, Failure> {
    let json = in_english(|| serde_json::to_string_pretty(value)).map_err(|error| Failure::output(error.into()))?;
    let mut safe = String::with_capacity(json.len());
    for character in json.chars() {
        // Control characters below U+0020 are escaped in texts already; the line breaks between them stay. None of the others needs two
        // units of UTF-16.
        if character != '\n' && is_unsafe(character) {
            // Writing to a string cannot fail.
            let _ = write!(safe, "\\u{:04x}", u32::from(character));
        } else {
            safe.push(character);
        }
    }
    Ok(safe)
}

/// Prints what programs read, as it is, and ends the line.
pub(super) fn print_raw(bytes: &[u8]) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    let written = out.write_all(bytes).and_then(|()| out.write_all(b"\n")).and_then(|()| out.flush());
    match written {
        // The reader has gone away, as in `forage list | head`.
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(()),
        written => written.map_err(Failure::output),
    }
}

/// Prints a line for people to standard error; nobody need be there to read it.
pub(super) fn note(said: impl Display) {
    let _ = writeln!(io::stderr(), "forage: {}", text::escape(&said.to_string()));
}

/// Prints several of them.
pub(super) fn notes<T: Display>(texts: &[T]) {
    texts.iter().for_each(note);
}

/// Prints why a command failed on standard error and returns the exit code.
pub(super) fn report(failure: &Failure) -> ExitCode {
    note(failure.message());
    ExitCode::from(failure.code())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn json_has_no_character_that_a_terminal_acts_on() {
        let value = serde_json::json!({ "a\u{9b}b": ["\u{7f}\u{202e}x\u{2066}", [], {}, 1.5, null], "é中\u{1f41d}": "\u{1b}\n" });
        let printed = json(&value).unwrap();
        assert!(!printed.contains(|c: char| c != '\n' && is_unsafe(c)), "{printed:?}");
        assert!(printed.contains(r#""\u007f\u202ex\u2066""#) && printed.contains('\u{1f41d}'), "{printed}");
        assert_eq!(serde_json::from_str::<serde_json::Value>(&printed).unwrap(), value);
        let plain = serde_json::json!({ "a": [1, { "b": [] }], "c": {} });
        assert_eq!(json(&plain).unwrap(), serde_json::to_string_pretty(&plain).unwrap());
    }

    #[test]
    fn what_cannot_be_written_as_json_is_a_failure() {
        let unnamed = std::collections::BTreeMap::from([(vec![1], 2)]);
        assert!(matches!(json(&unnamed), Err(Failure::File(..))));
    }
}
