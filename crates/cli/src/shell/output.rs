//! Everything that is printed goes through here.

use std::io::{self, Write};

use serde::Serialize;

use super::{Failure, text};

/// Prints a text for people to standard output.
pub(super) fn print(text: &str) -> Result<(), Failure> {
    print_raw(text::escape_lines(text.trim_end()).as_bytes())
}

/// Prints a value as JSON to standard output.
pub(super) fn print_json(value: &impl Serialize) -> Result<(), Failure> {
    // NaN becomes null.
    let json = serde_json::to_string_pretty(value).map_err(|error| Failure::File("standard output".to_owned(), error.into()))?;
    print_raw(text::escape_json(&json).as_bytes())
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
