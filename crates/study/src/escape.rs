//! Characters that are not printed as they are: they end a line, move the cursor or change the reading direction.

use std::{borrow::Cow, fmt::Write, path::Path};

use serde::Serializer;

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

/// Escapes each line of a text that is meant to have several.
pub fn escape_lines(text: &str) -> String {
    text.split('\n').map(escape).collect::<Vec<_>>().join("\n")
}

/// Control characters, separators of lines and paragraphs, and marks that change the reading direction.
pub fn is_unsafe(character: char) -> bool {
    character.is_control() || matches!(character, '\u{61c}' | '\u{200e}' | '\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}')
}

/// A file's name in one line.
pub fn path_text(path: &Path) -> String {
    escape(&path.to_string_lossy()).into_owned()
}

/// Writes a file's name into JSON, whatever its bytes: those that are not UTF-8 become U+FFFD.
///
/// # Errors
/// What the serializer refuses.
pub fn serialize_path<S: Serializer>(path: &Path, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(&path.to_string_lossy())
}

/// As [`serialize_path`], for several.
///
/// # Errors
/// What the serializer refuses.
pub fn serialize_paths<S: Serializer>(paths: &[std::path::PathBuf], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(paths.iter().map(|path| path.to_string_lossy()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn control_characters_and_direction_marks_are_visible() {
        assert_eq!(escape("a\u{1b}[31mb\nc\td\re"), "a\\u{1b}[31mb\\nc\\td\\re");
        assert_eq!(escape("\u{202e}fdp\u{2066}\u{2069}\u{9b}\u{7f}"), "\\u{202e}fdp\\u{2066}\\u{2069}\\u{9b}\\u{7f}");
        assert!(matches!(escape("30 × 30 – “plain”, 中文, \u{1f41d}"), Cow::Borrowed(_)));
        for unsafe_one in ('\u{202a}'..='\u{202e}').chain('\u{2066}'..='\u{2069}').chain('\0'..=' ').filter(|c| *c != ' ') {
            assert!(escape(&unsafe_one.to_string()).starts_with('\\'), "{unsafe_one:?}");
        }
        assert_eq!(escape_lines("a\u{7}\nb"), "a\\u{7}\nb");
    }
}
