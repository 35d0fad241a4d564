//! Explanations of single items of a frame.

use std::borrow::Cow;

use serde::{Serialize, Serializer, ser::SerializeStruct};

use super::{LayerKey, Message, Shape, message::ENGLISH, words};

/// A piece of a layer that can be explained, e.g. one particle.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Item {
    /// The layer that it belongs to.
    #[serde(rename = "role")]
    pub layer: LayerKey,
    /// Its index among all pieces of the layer, drawn or not.
    pub index: usize,
}

/// What a number in an inspection is called, or a column of its table. Made by [`label!`](crate::label!).
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Label {
    /// An identifier; formulas use it.
    pub name: &'static str,
    /// The symbol, in TeX.
    pub symbol: &'static str,
    #[cfg_attr(feature = "types", ts(rename = "title", type = "string"))]
    key: &'static str,
    #[cfg_attr(feature = "types", ts(skip))]
    english: &'static str,
}

impl Label {
    /// For [`label!`](crate::label!).
    #[doc(hidden)]
    pub const fn new(key: &'static str, name: &'static str, symbol: &'static str, english: &'static str) -> Self {
        // Where the English is inside, it is said without a key.
        let key = if ENGLISH && cfg!(target_arch = "wasm32") { "" } else { key };
        Self { name, symbol, key, english: words(english) }
    }

    /// A name that is said as it is.
    pub const fn verbatim(name: &'static str) -> Self {
        Self { name, symbol: "", key: "", english: name }
    }

    /// The title, a few words.
    pub fn title(&self) -> Message {
        Message::new(self.key, Cow::Borrowed(self.english), Vec::new())
    }

    /// A number of this name.
    pub const fn is(self, value: f64) -> Quantity {
        Quantity { label: self, value }
    }
}

impl Serialize for Label {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut out = serializer.serialize_struct("Label", 3)?;
        out.serialize_field("name", self.name)?;
        out.serialize_field("symbol", self.symbol)?;
        out.serialize_field("title", &self.title())?;
        out.end()
    }
}

/// A number in an inspection.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Quantity {
    /// What it is called.
    #[cfg_attr(feature = "types", ts(flatten))]
    pub label: Label,
    /// The number.
    pub value: f64,
}

impl Serialize for Quantity {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut out = serializer.serialize_struct("Quantity", 4)?;
        out.serialize_field("name", self.label.name)?;
        out.serialize_field("symbol", self.label.symbol)?;
        out.serialize_field("title", &self.label.title())?;
        out.serialize_field("value", &self.value)?;
        out.end()
    }
}

/// A mark to draw over the picture.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
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
///
/// Made by [`Inspection::new`]; what is not set is empty.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Inspection {
    /// The item that is explained.
    pub item: Item,
    /// Its name for people.
    pub title: Message,
    /// What happened, in a word.
    pub event: &'static str,
    /// The same in a sentence.
    pub summary: Message,
    /// The numbers behind it.
    pub values: Vec<Quantity>,
    /// Names of the entry's formulas that were applied.
    pub formulas: Vec<&'static str>,
    /// The table's columns.
    #[cfg_attr(feature = "types", ts(rename = "table", type = "InspectionTable"))]
    pub columns: Vec<Label>,
    /// A label for each row of the table.
    #[cfg_attr(feature = "types", ts(skip))]
    pub labels: Vec<Message>,
    /// The table, row by row.
    #[cfg_attr(feature = "types", ts(skip))]
    pub rows: Vec<Vec<f64>>,
    /// Marks to draw over the picture.
    #[cfg_attr(feature = "types", ts(rename = "layers"))]
    pub marks: Vec<Mark>,
    /// What can be supposed otherwise in this step: [`Run::suppose`](crate::Run::suppose) answers each.
    pub suppositions: Vec<Label>,
}

impl Inspection {
    /// With a title, an event and a sentence; the rest is empty.
    pub fn new(item: Item, title: Message, event: &'static str, summary: Message) -> Self {
        Self {
            item,
            title,
            event,
            summary,
            values: Vec::new(),
            formulas: Vec::new(),
            columns: Vec::new(),
            labels: Vec::new(),
            rows: Vec::new(),
            marks: Vec::new(),
            suppositions: Vec::new(),
        }
    }
}

/// An inspection's table: a row for each dimension, way-point, sample, …
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename = "InspectionTable"))]
pub(crate) struct Table<'a> {
    columns: &'a [Label],
    /// A label for each row.
    labels: &'a [Message],
    /// The numbers, row by row.
    rows: &'a [Vec<f64>],
}

impl Serialize for Inspection {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut out = serializer.serialize_struct("Inspection", 9)?;
        out.serialize_field("item", &self.item)?;
        out.serialize_field("title", &self.title)?;
        out.serialize_field("event", self.event)?;
        out.serialize_field("summary", &self.summary)?;
        out.serialize_field("values", &self.values)?;
        out.serialize_field("formulas", &self.formulas)?;
        out.serialize_field("table", &Table { columns: &self.columns, labels: &self.labels, rows: &self.rows })?;
        out.serialize_field("layers", &self.marks)?;
        out.serialize_field("suppositions", &self.suppositions)?;
        out.end()
    }
}

/// What a number in an inspection is called: the key of its title, its name, its symbol in TeX, and its title in English.
///
/// ```
/// use forage::label;
/// let cost = label!("demo-cost", "cost", "f(x)", "cost").is(2.5);
/// assert_eq!((cost.label.name, cost.value, cost.label.title().to_string().as_str()), ("cost", 2.5, "cost"));
/// ```
#[cfg(not(target_arch = "wasm32"))]
#[macro_export]
macro_rules! label {
    ($key:literal, $name:literal, $symbol:literal, $title:literal) => {{
        $crate::kernel::inventory::submit! { $crate::kernel::Sentence { key: $key, english: $title, plurals: &[], symbol: $symbol } }
        $crate::kernel::Label::new($key, $name, $symbol, $title)
    }};
}

/// What a number in an inspection is called.
#[cfg(target_arch = "wasm32")]
#[macro_export]
macro_rules! label {
    ($key:literal, $name:literal, $symbol:literal, $title:literal) => {
        $crate::kernel::Label::new($key, $name, $symbol, $title)
    };
}
