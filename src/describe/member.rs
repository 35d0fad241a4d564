//! The numbers that a planner reports of each member of its population.

use serde::Serialize;

use crate::kernel::words;

/// A number that a planner reports of each member of its population: particle, bat, ant, …
#[derive(Debug, Clone, Copy, Serialize)]
#[non_exhaustive]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Member {
    /// An identifier.
    pub name: &'static str,
    /// The symbol, in TeX.
    pub symbol: &'static str,
    /// The title, a few words.
    pub title: &'static str,
    /// What it says.
    pub help: &'static str,
    /// The value of a full bar, which begins at 0; `None`: no bar.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "types", ts(optional))]
    pub full: Option<f64>,
    /// What the values 0, 1, … stand for, if they are codes.
    #[serde(skip_serializing_if = "<[_]>::is_empty")]
    #[cfg_attr(feature = "types", ts(optional, as = "Option<Vec<String>>"))]
    pub words: &'static [&'static str],
}

impl Member {
    /// A number without a bar, with its name, symbol, title and help text.
    pub const fn new(name: &'static str, symbol: &'static str, title: &'static str, help: &'static str) -> Self {
        Self { name, symbol: words(symbol), title: words(title), help: words(help), full: None, words: &[] }
    }

    /// The same with a bar from 0 to this.
    #[must_use]
    pub const fn full(self, full: f64) -> Self {
        Self { full: Some(full), ..self }
    }

    /// The same, as a code for one of these words.
    #[must_use]
    pub const fn words(self, words: &'static [&'static str]) -> Self {
        Self { words, ..self }
    }
}
