//! Text that comes from outside: names, notes, file names.

use std::{borrow::Cow, fmt::Write, path::Path};

/// Makes control characters and characters that change the reading direction visible: ESC becomes `\u{1b}`, a line break `\n`.
///
/// Everything that comes from outside (names, titles, notes, file names, values) goes through this before it is printed.
pub fn escape(text: &str) -> Cow<'_, str> {
    if !text.chars().any(is_unsafe) {
        return Cow::Borrowed(text);
    }
    let mut safe = String::with_capacity(text.len() + 16);
    for character in text.chars() {
        match character {
            '\n' => safe.push_str("\\n"),
            '\r' => safe.push_str("\\r"),
            '\t' => safe.push_str("\\t"),
            other if is_unsafe(other) => {
                // Writing to a string cannot fail.
                let _ = write!(safe, "\\u{{{:x}}}", u32::from(other));
            }
            other => safe.push(other),
        }
    }
    Cow::Owned(safe)
}

/// Control characters, separators of lines and paragraphs, and marks that change the reading direction.
pub fn is_unsafe(character: char) -> bool {
    character.is_control() || matches!(character, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
}

/// A file's name for people.
pub fn file_name(path: &Path) -> String {
    escape(&path.to_string_lossy()).into_owned()
}
