//! A TSPLIB file, line by line where keywords stand and word by word in its sections.

use std::{iter::Enumerate, str::Lines};

use forage::{
    kernel::{Error, Message},
    message,
};

use crate::file::NamedFile;

/// The place up to which a file was read.
pub(super) struct Words<'a> {
    pub(super) file: &'a NamedFile,
    lines: Enumerate<Lines<'a>>,
    /// The number of the line that was read last.
    pub(super) line: usize,
    /// What is left of it.
    left: &'a str,
}

impl<'a> Words<'a> {
    pub(super) fn new(file: &'a NamedFile) -> Result<Self, Error> {
        Ok(Self { file, lines: file.text()?.lines().enumerate(), line: 0, left: "" })
    }

    /// Goes on to the next line that is not empty; `false` at the end of the file.
    fn advance(&mut self) -> bool {
        while self.left.is_empty() {
            let Some((i, line)) = self.lines.next() else {
                return false;
            };
            (self.line, self.left) = (i + 1, line.trim());
        }
        true
    }

    /// The next line's keyword and value, which is empty for a section; `None` at the end, marked or not.
    pub(super) fn keyword(&mut self) -> Option<(&'a str, &'a str)> {
        if !self.advance() {
            return None;
        }
        let line = std::mem::take(&mut self.left);
        let end = line.find(|c: char| c == ':' || c.is_whitespace()).unwrap_or(line.len());
        let (keyword, rest) = line.split_at(end);
        let rest = rest.trim_start();
        // A section may begin in the line of its keyword.
        let value = rest.strip_prefix(':').unwrap_or(rest).trim_start();
        if keyword.ends_with("_SECTION") {
            self.left = value;
            return Some((keyword, ""));
        }
        (keyword != "EOF").then_some((keyword, value))
    }

    /// The next word of a section; `None` at the end of the file.
    pub(super) fn word(&mut self) -> Option<&'a str> {
        if !self.advance() {
            return None;
        }
        let end = self.left.find(char::is_whitespace).unwrap_or(self.left.len());
        let (word, left) = self.left.split_at(end);
        self.left = left.trim_start();
        Some(word)
    }

    /// Goes past a word if it is the next one.
    pub(super) fn skip(&mut self, word: &str) -> bool {
        let rest = if self.advance() { self.left.strip_prefix(word) } else { None };
        let rest = rest.filter(|rest| rest.is_empty() || rest.starts_with(char::is_whitespace));
        self.left = rest.map_or(self.left, str::trim_start);
        rest.is_some()
    }

    /// The next word, as `read` takes it; where it takes it for nothing it is refused, and `expected` says why.
    pub(super) fn take<T>(&mut self, read: impl FnOnce(&str) -> Option<T>, expected: &dyn Fn() -> Message) -> Result<T, Error> {
        let word = self.word();
        word.and_then(read).ok_or_else(|| self.refuse(word, &expected()))
    }

    /// Refuses a word, or that there is none.
    #[cold]
    pub(super) fn refuse(&self, word: Option<&str>, expected: &Message) -> Error {
        match word {
            Some(word) => self.file.unexpected(self.line, word, expected),
            None => self.file.ends(self.line, expected),
        }
    }

    /// The number of a stop, from 0.
    pub(super) fn stop(&mut self, n: usize, called: &mut [bool]) -> Result<usize, Error> {
        let read = |word: &str| word.parse().ok().filter(|id| (1..=n).contains(id));
        let id = self.take(read, &|| message!("files-stop", "a stop from 1 to {n}", n))?;
        if std::mem::replace(&mut called[id - 1], true) {
            let expected = message!("files-stop-once", "a stop that is not listed above: each once");
            return Err(self.file.unexpected(self.line, &id.to_string(), &expected));
        }
        Ok(id - 1)
    }

    /// The end of a section's last line; `expected` says after what.
    pub(super) fn end_of_line(&self, expected: &dyn Fn() -> Message) -> Result<(), Error> {
        if self.left.is_empty() { Ok(()) } else { Err(self.file.unexpected(self.line, self.left, &expected())) }
    }
}
