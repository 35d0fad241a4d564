//! Everything that is printed goes through here.

use std::io::{self, Write};

use serde::Serialize;
use serde_json::{
    Serializer,
    ser::{Formatter, PrettyFormatter},
};

use super::{
    Failure,
    text::{self, is_unsafe},
};

/// Prints a text for people to standard output.
pub(super) fn print(text: &str) -> Result<(), Failure> {
    print_raw(text::escape_lines(text.trim_end()).as_bytes())
}

/// Prints a value as JSON to standard output.
pub(super) fn print_json(value: &impl Serialize) -> Result<(), Failure> {
    print_raw(&json(value)?)
}

/// A value as indented JSON. NaN becomes null.
fn json(value: &impl Serialize) -> Result<Vec<u8>, Failure> {
    let mut bytes = Vec::new();
    let mut serializer = Serializer::with_formatter(&mut bytes, Escaped(PrettyFormatter::new()));
    value.serialize(&mut serializer).map_err(|problem| Failure::File("standard output".to_owned(), problem.into()))?;
    Ok(bytes)
}

/// Indented JSON in which characters that a terminal would act on are written `\u009b`.
struct Escaped<'a>(PrettyFormatter<'a>);

impl Formatter for Escaped<'_> {
    fn write_string_fragment<W: ?Sized + Write>(&mut self, writer: &mut W, mut fragment: &str) -> io::Result<()> {
        while let Some((at, character)) = fragment.char_indices().find(|(_, character)| is_unsafe(*character)) {
            // None of them needs two units of UTF-16.
            write!(writer, "{}\\u{:04x}", &fragment[..at], u32::from(character))?;
            fragment = &fragment[at + character.len_utf8()..];
        }
        writer.write_all(fragment.as_bytes())
    }

    fn begin_array<W: ?Sized + Write>(&mut self, writer: &mut W) -> io::Result<()> {
        self.0.begin_array(writer)
    }

    fn end_array<W: ?Sized + Write>(&mut self, writer: &mut W) -> io::Result<()> {
        self.0.end_array(writer)
    }

    fn begin_array_value<W: ?Sized + Write>(&mut self, writer: &mut W, first: bool) -> io::Result<()> {
        self.0.begin_array_value(writer, first)
    }

    fn end_array_value<W: ?Sized + Write>(&mut self, writer: &mut W) -> io::Result<()> {
        self.0.end_array_value(writer)
    }

    fn begin_object<W: ?Sized + Write>(&mut self, writer: &mut W) -> io::Result<()> {
        self.0.begin_object(writer)
    }

    fn end_object<W: ?Sized + Write>(&mut self, writer: &mut W) -> io::Result<()> {
        self.0.end_object(writer)
    }

    fn begin_object_key<W: ?Sized + Write>(&mut self, writer: &mut W, first: bool) -> io::Result<()> {
        self.0.begin_object_key(writer, first)
    }

    fn begin_object_value<W: ?Sized + Write>(&mut self, writer: &mut W) -> io::Result<()> {
        self.0.begin_object_value(writer)
    }

    fn end_object_value<W: ?Sized + Write>(&mut self, writer: &mut W) -> io::Result<()> {
        self.0.end_object_value(writer)
    }
}

/// Prints what programs read, as it is, and ends the line.
pub(super) fn print_raw(bytes: &[u8]) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    let written = out.write_all(bytes).and_then(|()| out.write_all(b"\n")).and_then(|()| out.flush());
    match written {
        // The reader has gone away, as in `forage list | head`.
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Ok(()),
        written => written.map_err(|error| Failure::File("standard output".to_owned(), error)),
    }
}

/// Prints a line for people to standard error; nobody need be there to read it.
pub(super) fn note(text: &str) {
    let _ = writeln!(io::stderr(), "forage: {}", text::escape(text));
}

/// Prints several of them.
pub(super) fn notes(texts: &[String]) {
    texts.iter().for_each(|text| note(text));
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn json_has_no_character_that_a_terminal_acts_on() {
        let value = serde_json::json!({ "a\u{9b}b": ["\u{7f}\u{202e}x\u{2066}", [], {}, 1.5, null], "é中\u{1f41d}": "\u{1b}\n" });
        let printed = String::from_utf8(json(&value).unwrap()).unwrap();
        assert!(!printed.contains(|c: char| c != '\n' && is_unsafe(c)), "{printed:?}");
        assert!(printed.contains(r#""\u007f\u202ex\u2066""#) && printed.contains('\u{1f41d}'), "{printed}");
        assert_eq!(serde_json::from_str::<serde_json::Value>(&printed).unwrap(), value);
        let plain = serde_json::json!({ "a": [1, { "b": [] }], "c": {} });
        assert_eq!(json(&plain).unwrap(), serde_json::to_vec_pretty(&plain).unwrap());
    }

    #[test]
    fn what_cannot_be_written_as_json_is_a_failure() {
        let unnamed = std::collections::BTreeMap::from([(vec![1], 2)]);
        assert!(matches!(json(&unnamed), Err(Failure::File(..))));
    }
}
