//! Frames: what a planner draws in one iteration, as layers of vertices in one buffer, and a table of spans.

use serde::Serialize;

use crate::geometry::Bounds;

/// The name of a layer in drawings, explanations, pages, pictures and links. A planner brings new ones by listing layers under
/// them in its entry.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(transparent)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename = "LayerName"))]
pub struct LayerKey(pub &'static str);

/// How a span's vertices belong together.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
#[repr(u32)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub enum Shape {
    /// Each vertex is a point of its own.
    Points,
    /// The vertices form one line.
    Polyline,
    /// Vertices in pairs, a line each.
    Segments,
    /// A grid of values, row by row along x and then y; z of the first vertex is the number of vertices in a row. A vertex is
    /// the middle of its square, whose side is the distance between neighbours. A weight below 0 is not drawn.
    Field,
    /// The vertices form one line with round ends; the weight is half its width, in the scene's unit. One vertex: a disc.
    Tube,
}

impl Shape {
    /// Every shape, in the order of their numbers.
    pub const ALL: [Self; 5] = [Self::Points, Self::Polyline, Self::Segments, Self::Field, Self::Tube];

    /// The name in JavaScript.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Points => "points",
            Self::Polyline => "polyline",
            Self::Segments => "segments",
            Self::Field => "field",
            Self::Tube => "tube",
        }
    }
}

/// Vertices that belong together, one row of the table: `count` of them from `first` on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Span {
    /// The layer that they belong to.
    pub layer: LayerKey,
    /// That layer's index among the frame's layers.
    pub index: usize,
    /// How they belong together.
    pub shape: Shape,
    /// The first vertex.
    pub first: u32,
    /// The number of vertices.
    pub count: u32,
}

/// What a planner draws in one iteration. The buffers are re-used from frame to frame.
#[derive(Debug, Clone)]
pub struct Frame {
    vertices: Vec<f32>,
    /// The table as it crosses to the page: layer, shape, first, count.
    table: Vec<u32>,
    /// The layers that can be drawn; the table's first column counts them from 0.
    layers: Vec<LayerKey>,
    /// The layer of the open span; `None`: it is not one of `layers`, so that its vertices are dropped.
    open: Option<usize>,
    unlisted: Vec<LayerKey>,
    budget: usize,
    thinning: u32,
    /// The visible part of the plane; `None`: all of it.
    window: Option<Bounds>,
}

/// Numbers per vertex: x, y, z, weight.
pub const VERTEX: usize = 4;
/// Numbers per span.
pub const SPAN: usize = 4;

impl Default for Frame {
    fn default() -> Self {
        Self {
            vertices: Vec::new(),
            table: Vec::new(),
            layers: Vec::new(),
            open: None,
            unlisted: Vec::new(),
            budget: Self::BUDGET,
            thinning: 1,
            window: None,
        }
    }
}

impl Frame {
    /// The default of [`Frame::budget`]: what a canvas draws in a few tens of milliseconds.
    pub const BUDGET: usize = 100_000;

    /// Empties the frame and lists the layers that can be drawn next, each of them with up to `budget` vertices.
    pub fn clear(&mut self, budget: usize, layers: impl IntoIterator<Item = LayerKey>) {
        self.vertices.clear();
        self.table.clear();
        self.layers.clear();
        self.layers.extend(layers);
        self.open = None;
        self.unlisted.clear();
        self.budget = budget.max(1);
        self.thinning = 1;
    }

    /// Sets the visible part of the plane; layers with fine details draw only that.
    pub fn look_at(&mut self, window: Option<Bounds>) {
        self.window = window;
    }

    /// The visible part of the plane; `None`: all of it.
    pub fn window(&self) -> Option<Bounds> {
        self.window
    }

    /// The largest number of vertices of a layer.
    pub fn budget(&self) -> usize {
        self.budget
    }

    /// The smallest n for which every n-th of `pieces` with `vertices` vertices each fits into the budget. A line's vertex
    /// counts four times: that is about what drawing it costs.
    pub fn thin(&mut self, pieces: usize, vertices: usize, lines: bool) -> usize {
        let step = self.thin_context(pieces, vertices, lines);
        self.thinning = self.thinning.max(step as u32);
        step
    }

    /// The same for a layer that is off by default: it does not count in [`Frame::thinning`].
    pub fn thin_context(&self, pieces: usize, vertices: usize, lines: bool) -> usize {
        let cost = pieces.saturating_mul(vertices).saturating_mul(if lines { 4 } else { 1 });
        cost.div_ceil(self.budget).max(1)
    }

    /// Opens a span; vertices pushed from here on belong to it. A layer that the frame does not list is not drawn.
    pub fn begin(&mut self, layer: LayerKey, shape: Shape) {
        // Most spans follow one of the same layer.
        if self.open.is_none_or(|open| self.layers[open] != layer) {
            self.open = self.layers.iter().position(|&listed| listed == layer);
        }
        match self.open {
            Some(open) => self.table.extend([open as u32, shape as u32, (self.vertices.len() / VERTEX) as u32, 0]),
            None if !self.unlisted.contains(&layer) => self.unlisted.push(layer),
            None => {}
        }
    }

    /// Adds a vertex of a field's row of this length to the open span.
    #[inline]
    pub fn push_field(&mut self, [x, y]: [f64; 2], row: usize, weight: f64) {
        self.push_in_space([x, y, row as f64], weight);
    }

    /// Adds a vertex in the plane to the open span.
    #[inline]
    pub fn push(&mut self, [x, y]: [f64; 2], weight: f64) {
        self.push_in_space([x, y, 0.0], weight);
    }

    /// Adds a vertex in space to the open span.
    pub fn push_in_space(&mut self, [x, y, z]: [f64; 3], weight: f64) {
        if self.open.is_some() {
            self.vertices.extend([x as f32, y as f32, z as f32, weight as f32]);
            if let Some(count) = self.table.last_mut() {
                *count += 1;
            }
        }
    }

    /// The layers that can be drawn, in the order of the table's indices.
    pub fn layers(&self) -> &[LayerKey] {
        &self.layers
    }

    /// Layers that were drawn and that the frame does not list: a mistake in the planner's entry.
    pub fn unlisted(&self) -> &[LayerKey] {
        &self.unlisted
    }

    /// All vertices, each as x, y, z and weight.
    pub fn vertices(&self) -> &[f32] {
        &self.vertices
    }

    /// All spans, each as layer, shape, first and count; the layer as its index in [`Frame::layers`].
    pub fn table(&self) -> &[u32] {
        &self.table
    }

    /// The n of which layers drew every n-th piece, the largest of all layers; 1: every piece is drawn.
    pub fn thinning(&self) -> u32 {
        self.thinning
    }

    /// The spans, in drawing order.
    pub fn spans(&self) -> impl Iterator<Item = Span> + '_ {
        self.table.chunks_exact(SPAN).map(|row| Span {
            layer: self.layers[row[0] as usize],
            index: row[0] as usize,
            shape: Shape::ALL[row[1] as usize],
            first: row[2],
            count: row[3],
        })
    }

    /// The vertices of a span as points in the plane.
    pub fn points(&self, span: Span) -> impl Iterator<Item = [f64; 2]> + '_ {
        let from = span.first as usize * VERTEX;
        let to = from + span.count as usize * VERTEX;
        self.vertices[from..to].chunks_exact(VERTEX).map(|v| [f64::from(v[0]), f64::from(v[1])])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const RED: LayerKey = LayerKey("red");
    const BLUE: LayerKey = LayerKey("blue");

    #[test]
    fn shape_numbers_index_their_list() {
        for (i, shape) in Shape::ALL.into_iter().enumerate() {
            assert_eq!(shape as usize, i);
        }
    }

    #[test]
    fn a_layer_is_drawn_by_its_key_and_one_that_is_not_listed_is_reported() {
        let mut frame = Frame::default();
        frame.clear(10, [RED, BLUE]);
        for layer in [BLUE, LayerKey("green"), BLUE, RED] {
            frame.begin(layer, Shape::Points);
            frame.push([1.0, 2.0], 3.0);
        }
        let drawn: Vec<_> = frame.spans().map(|span| (span.layer, span.index, span.first, span.count)).collect();
        assert_eq!(drawn, [(BLUE, 1, 0, 1), (BLUE, 1, 1, 1), (RED, 0, 2, 1)]);
        assert_eq!(frame.vertices().len(), 3 * VERTEX);
        assert_eq!(frame.unlisted(), [LayerKey("green")]);
        frame.clear(10, [RED]);
        assert!(frame.unlisted().is_empty() && frame.table().is_empty());
    }

    #[test]
    fn thinning_keeps_to_the_budget() {
        let mut frame = Frame::default();
        frame.clear(1000, []);
        assert_eq!(frame.thin(1000, 1, false), 1);
        assert_eq!(frame.thin(1001, 1, false), 2);
        assert_eq!(frame.thin(1000, 5, true), 20);
        assert_eq!(frame.thinning(), 20);
    }
}
