//! A file with its name, and how messages speak of it.

use forage::{
    kernel::{Error, Message, json},
    message,
    scene::MAX_SIDE,
};

/// A file: its name and its bytes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NamedFile {
    /// Its name, with or without folders.
    pub name: String,
    /// Its content.
    pub bytes: Vec<u8>,
}

impl NamedFile {
    /// A file of these bytes.
    pub fn new(name: impl Into<String>, bytes: impl Into<Vec<u8>>) -> Self {
        Self { name: name.into(), bytes: bytes.into() }
    }

    /// Its name without folders, as messages have it.
    pub(super) fn label(&self) -> &str {
        Some(base(&self.name)).filter(|name| !name.is_empty()).unwrap_or("file")
    }

    /// Its content as text.
    pub(super) fn text(&self) -> Result<&str, Error> {
        let text = str::from_utf8(&self.bytes).map_err(|error| {
            let line = self.bytes[..error.valid_up_to()].split(|&byte| byte == b'\n').count();
            self.wrong(line, &message!("files-no-text", "bytes that are no text (UTF-8)"))
        })?;
        Ok(text.strip_prefix('\u{feff}').unwrap_or(text))
    }

    /// Its lines with their numbers, without spaces at their ends.
    pub(super) fn lines(&self) -> Result<impl Iterator<Item = (usize, &str)>, Error> {
        Ok(self.text()?.lines().enumerate().map(|(i, line)| (i + 1, line.trim_end())))
    }

    /// What is wrong with it, and where.
    pub(super) fn wrong(&self, line: usize, problem: &Message) -> Error {
        Error::malformed(self.label(), message!("files-line", "line {line}: {problem}", line, problem))
    }

    /// Refuses a file that ends too early.
    pub(super) fn ends(&self, line: usize, expected: &Message) -> Error {
        self.wrong(line, &message!("files-ends", "the file ends, expected {expected}", expected))
    }

    /// Refuses a file that ends without a word that it must have.
    pub(super) fn ends_without(&self, line: usize, word: &str) -> Error {
        self.wrong(line, &message!("files-ends-without", "the file ends without `{word}`", word))
    }

    /// Refuses a key that was in an earlier line.
    pub(super) fn again(&self, line: usize, key: &str, earlier: usize) -> Error {
        self.wrong(line, &message!("files-again", "`{key}` again, first in line {earlier}", key, earlier))
    }

    /// Refuses what was found at a place where something else is expected.
    pub(super) fn unexpected(&self, line: usize, found: &str, expected: &Message) -> Error {
        // The whole of a long line helps nobody.
        let mut shown: String = found.chars().take(40).collect();
        if shown.len() < found.len() {
            shown.push('…');
        }
        self.wrong(line, &message!("files-unexpected", "found `{found}`, expected {expected}", found = shown, expected))
    }

    /// A number of rows or columns; `expected` says it with the largest.
    pub(super) fn side(&self, line: usize, found: &str, expected: fn(usize) -> Message) -> Result<usize, Error> {
        let side = found.parse().ok().filter(|side| (1..=MAX_SIDE).contains(side));
        side.ok_or_else(|| self.unexpected(line, found, &expected(MAX_SIDE)))
    }
}

/// A path without its folders.
pub(super) fn base(name: &str) -> &str {
    name.rsplit(['/', '\\']).next().unwrap_or(name)
}

/// A path without folders and ending; `.opt.tour` is one ending.
pub(super) fn stem(name: &str) -> &str {
    let base = base(name);
    let Some((stem, ending)) = base.rsplit_once('.') else {
        return base;
    };
    let optimal = if ending.eq_ignore_ascii_case("tour") { without_opt(stem) } else { None };
    optimal.unwrap_or(stem)
}

/// Whether a tour's file says by its name that none is shorter.
pub(super) fn is_optimal(name: &str) -> bool {
    name.rsplit_once('.').is_some_and(|(stem, _)| without_opt(stem).is_some())
}

fn without_opt(stem: &str) -> Option<&str> {
    let (stem, opt) = stem.rsplit_once('.')?;
    opt.eq_ignore_ascii_case("opt").then_some(stem)
}

/// The number that a word stands for, if its size is at most `most`. −0 becomes 0, as in scene files.
pub(super) fn number_up_to(most: f64, word: &str) -> Option<f64> {
    json::number(word).map(|number| number + 0.0).filter(|number| number.abs() <= most)
}

/// A picture's or a map's width that is expected.
pub(super) fn a_width(most: usize) -> Message {
    message!("files-width", "a width from 1 to {most}", most)
}

/// A picture's or a map's height that is expected.
pub(super) fn a_height(most: usize) -> Message {
    message!("files-height", "a height from 1 to {most}", most)
}

/// A number of a column or a key that is expected.
pub(super) fn for_number(name: &str, least: f64, most: f64) -> Message {
    message!("files-number", "for {name} a number from {least} to {most}", name, least, most)
}
