//! Explanations of single items of a frame.

use serde::Serialize;

use super::{LayerKey, Shape};

/// A piece of a layer that can be explained, e.g. one particle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Item {
    /// The layer that it belongs to.
    pub layer: LayerKey,
    /// Its index among all pieces of the layer, drawn or not.
    pub index: usize,
}

/// A number in an inspection.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Quantity {
    /// The name that formulas use for it.
    pub name: &'static str,
    /// The symbol, in TeX.
    pub symbol: &'static str,
    /// The title, a few words.
    pub title: &'static str,
    /// The number.
    pub value: f64,
}

/// A column of an inspection's table.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Column {
    /// An identifier.
    pub name: &'static str,
    /// The symbol, in TeX.
    pub symbol: &'static str,
    /// The title, a few words.
    pub title: &'static str,
}

/// A mark to draw over the picture.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Mark {
    /// One of the entry's layers, which says what it shows and how it looks.
    #[serde(rename = "role")]
    pub layer: LayerKey,
    /// How its vertices belong together.
    pub shape: Shape,
    /// The vertices, in the scene's unit; in the plane z is 0.
    pub vertices: Vec<[f64; 3]>,
}

impl Mark {
    /// A mark in the plane.
    pub fn plane(layer: LayerKey, shape: Shape, vertices: Vec<[f64; 2]>) -> Self {
        Self { layer, shape, vertices: vertices.into_iter().map(|[x, y]| [x, y, 0.0]).collect() }
    }
}

/// An explanation: what an item did in the step that led to this iteration, and why.
#[derive(Debug, Clone, PartialEq)]
pub struct Inspection {
    /// The item that is explained.
    pub item: Item,
    /// Its name for people.
    pub title: String,
    /// What happened, in a word.
    pub event: &'static str,
    /// The same in a sentence.
    pub summary: String,
    /// The numbers behind it.
    pub values: Vec<Quantity>,
    /// Names of the entry's formulas that were applied.
    pub formulas: Vec<&'static str>,
    /// The table's columns.
    pub columns: Vec<Column>,
    /// A label for each row of the table.
    pub labels: Vec<String>,
    /// The table, row by row.
    pub rows: Vec<Vec<f64>>,
    /// Marks to draw over the picture.
    pub marks: Vec<Mark>,
}
