//! The numbers of those that search side by side.

use serde::Serialize;

/// A number of each of those that search side by side.
#[derive(Debug, Clone, Copy, Serialize)]
pub struct Member {
    /// An identifier.
    pub name: &'static str,
    /// TeX.
    pub symbol: &'static str,
    /// A few words.
    pub title: &'static str,
    /// What it says.
    pub help: &'static str,
    /// From 0 to this: drawn as a bar. `None`: only written.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub full: Option<f64>,
    /// What the numbers 0, 1, … stand for, if they are not numbers.
    #[serde(skip_serializing_if = "<[_]>::is_empty")]
    pub words: &'static [&'static str],
}

impl Member {
    /// A number that is only written, by its name, TeX, title and help.
    pub const fn new(name: &'static str, symbol: &'static str, title: &'static str, help: &'static str) -> Self {
        Self { name, symbol, title, help, full: None, words: &[] }
    }

    /// The same, drawn as a bar from 0 to this.
    #[must_use]
    pub const fn full(self, full: f64) -> Self {
        Self { full: Some(full), ..self }
    }

    /// The same, of one of these words.
    #[must_use]
    pub const fn words(self, words: &'static [&'static str]) -> Self {
        Self { words, ..self }
    }
}
