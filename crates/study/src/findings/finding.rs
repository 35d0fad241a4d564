//! What arithmetic says of one printed figure.

use serde::Serialize;

use super::super::marks::Source;

/// What arithmetic says of a figure.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Finding {
    /// Where it stands: `[WCPSO] Table 2`.
    pub place: String,
    /// What is printed.
    pub figure: String,
    /// Whether it can be.
    pub source: Source,
    /// The arithmetic.
    pub because: String,
    /// The figures that it is about: how the table’s name begins, the row and the measure.
    pub rows: Vec<[String; 3]>,
}

impl Finding {
    pub(super) fn new(place: &str, figure: impl Into<String>, source: Source, because: impl Into<String>) -> Self {
        Self { place: place.to_owned(), figure: figure.into(), source, because: because.into(), rows: Vec::new() }
    }

    /// Names a figure that it is about.
    pub(super) fn about(mut self, table: &str, row: impl Into<String>, measure: &str) -> Self {
        self.rows.push([table.to_owned(), row.into(), measure.to_owned()]);
        self
    }
}
