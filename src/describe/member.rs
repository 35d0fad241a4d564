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
