//! The language that is printed: that of `--lang`, or else the environment's.

use std::{borrow::Cow, fmt::Write};

use forage_languages::{closest, speak, speaker};

/// Speaks the language that the command line or the environment asks for. An option that asks for none of them is refused
/// later.
pub(super) fn choose() {
    let asked = option(std::env::args_os().skip(1).map(|word| word.to_string_lossy().into_owned()));
    let wanted = asked.map_or_else(environment, |asked| closest(&asked));
    if let Some(tag) = wanted.filter(|&tag| tag != "en") {
        speak(tag);
    }
}

/// The value of `--lang`, which may be anywhere.
fn option(words: impl Iterator<Item = String>) -> Option<String> {
    let mut words = words.take_while(|word| word != "--");
    while let Some(word) = words.next() {
        if word == "--lang" {
            return words.next();
        }
        if let Some(value) = word.strip_prefix("--lang=") {
            return Some(value.to_owned());
        }
    }
    None
}

/// That of the first variable that says one, as POSIX orders them.
fn environment() -> Option<&'static str> {
    let set = |name: &&str| std::env::var(name).ok().filter(|value| !value.is_empty());
    ["LC_ALL", "LC_MESSAGES", "LANG"].iter().find_map(set).and_then(|locale| closest(&locale))
}

/// A text of the catalogue. `place`: the names that lead to it.
pub(super) fn say<'a>(text: &'a str, place: &str) -> &'a str {
    speaker().map_or(text, |speaker| speaker.text(text, place))
}

/// A text with numbers in it, which are translated once for all numbers: `There are {1} stops, not {2}`.
pub(super) fn say_numbered(text: &str) -> Cow<'_, str> {
    let Some(speaker) = speaker() else { return Cow::Borrowed(text) };
    let direct = speaker.text(text, "");
    if direct != text {
        return Cow::Borrowed(direct);
    }
    let (pattern, numbers) = numbered(text);
    let said = speaker.text(&pattern, "");
    if said == pattern {
        return Cow::Borrowed(text);
    }
    Cow::Owned(numbers.iter().enumerate().fold(said.to_owned(), |said, (k, number)| said.replace(&format!("{{{}}}", k + 1), number)))
}

/// The same, for what other crates print.
pub(super) fn said(text: &str) -> String {
    say_numbered(text).into_owned()
}

/// A text with `{1}`, `{2}` … for its numbers, and the numbers, as package/texts.js finds them.
fn numbered(text: &str) -> (String, Vec<&str>) {
    let (mut pattern, mut numbers, mut at) = (String::new(), Vec::new(), 0);
    while let Some(character) = text[at..].chars().next() {
        let begins = !text[..at].ends_with(|c: char| c.is_ascii_alphanumeric() || "_.{".contains(c));
        let length = if begins { list_length(&text[at..]) } else { 0 };
        if length == 0 {
            pattern.push(character);
            at += character.len_utf8();
        } else {
            numbers.push(&text[at..at + length]);
            // Writing to a string cannot fail.
            let _ = write!(pattern, "{{{}}}", numbers.len());
            at += length;
        }
    }
    (pattern, numbers)
}

/// How long the number is that a text begins with, or the numbers with spaces between them. 0: none.
fn list_length(text: &str) -> usize {
    let mut end = number_length(text);
    while end > 0 && text[end..].starts_with(' ') {
        match number_length(&text[end + 1..]) {
            0 => break,
            more => end += 1 + more,
        }
    }
    end
}

/// Digits with points and commas between them, and a power of ten.
fn number_length(text: &str) -> usize {
    let digits = |at: usize| text[at..].bytes().take_while(u8::is_ascii_digit).count();
    let sign = |at: usize| text[at..].chars().next().filter(|c| ['-', '−', '+'].contains(c)).map_or(0, char::len_utf8);
    let mut end = if text.starts_with('+') { 0 } else { sign(0) };
    if digits(end) == 0 {
        return 0;
    }
    end += digits(end);
    while text[end..].starts_with(['.', ',']) && digits(end + 1) > 0 {
        end += 1 + digits(end + 1);
    }
    if text[end..].starts_with('e') {
        let sign = sign(end + 1);
        let power = digits(end + 1 + sign);
        end += if power > 0 { 1 + sign + power } else { 0 };
    }
    if text[end..].starts_with(|c: char| c.is_ascii_alphanumeric() || c == '_' || c == '}') { 0 } else { end }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_option_may_be_anywhere_before_the_end_of_options() {
        let found = |line: &str| option(line.split(' ').map(str::to_owned));
        assert_eq!(found("--lang zh-CN run pso"), Some("zh-CN".to_owned()));
        assert_eq!(found("run pso --lang=de"), Some("de".to_owned()));
        assert_eq!(found("run -- --lang zh-CN"), None);
        assert_eq!(found("run --lang"), None);
    }

    #[test]
    fn numbers_are_told_from_texts() {
        // package/texts.js finds the same.
        let cases: Vec<(String, String, Vec<String>)> = serde_json::from_str(include_str!("../../../tests/numbered.json")).unwrap();
        for (text, pattern, numbers) in &cases {
            let (found, values) = numbered(text);
            assert_eq!((&found, values), (pattern, numbers.iter().map(String::as_str).collect()), "{text}");
        }
    }
}
