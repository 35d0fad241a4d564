//! Why something did what it did.

use serde::Serialize;

use super::{LayerKey, Shape};

/// Something in a frame that can be asked about: the `index`-th piece of a layer.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Item {
    /// The layer that it is a piece of.
    pub layer: LayerKey,
    /// Which one, counted over all pieces, drawn or not.
    pub index: usize,
}

/// A number in an inspection.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Quantity {
    /// The name that formulas use for it.
    pub name: &'static str,
    /// TeX.
    pub symbol: &'static str,
    /// A few words.
    pub title: &'static str,
    /// The number.
    pub value: f64,
}

/// A column of an inspection's table.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Column {
    /// An identifier.
    pub name: &'static str,
    /// TeX.
    pub symbol: &'static str,
    /// A few words.
    pub title: &'static str,
}

/// A mark to draw over the picture.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Mark {
    /// One of the entry's layers: what it shows, and how it looks.
    #[serde(rename = "role")]
    pub layer: LayerKey,
    /// How its vertices belong together.
    pub shape: Shape,
    /// In the scene's unit; in the plane z is 0.
    pub vertices: Vec<[f64; 3]>,
}

impl Mark {
    /// A mark in the plane.
    pub fn plane(layer: LayerKey, shape: Shape, vertices: Vec<[f64; 2]>) -> Self {
        Self { layer, shape, vertices: vertices.into_iter().map(|[x, y]| [x, y, 0.0]).collect() }
    }
}

/// Why something did what it did in the step that led to this iteration.
#[derive(Debug, Clone, PartialEq)]
pub struct Inspection {
    /// What was asked about.
    pub item: Item,
    /// Its name for people.
    pub title: String,
    /// What happened, in a word.
    pub event: &'static str,
    /// The same in a sentence.
    pub summary: String,
    /// The numbers behind it.
    pub values: Vec<Quantity>,
    /// Names of the entry's formulas that say it.
    pub formulas: Vec<&'static str>,
    /// The table's columns.
    pub columns: Vec<Column>,
    /// A label for each row.
    pub labels: Vec<String>,
    /// The table.
    pub rows: Vec<Vec<f64>>,
    /// Arrows and marks.
    pub marks: Vec<Mark>,
}
