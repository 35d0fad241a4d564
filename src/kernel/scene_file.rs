//! The scene file: JSON out, and the head of what is read. [`crate::describe::SceneKind`] reads the rest.

use serde::Serialize;
use serde_json::Value;

use super::{Error, Fields, Header, Message, Scene, json};

const FORMAT: &str = "forage-scene";
const VERSION: u32 = 1;

impl Serialize for Scene {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.fields())
    }
}

impl Scene {
    /// The scene file's text.
    pub fn to_json(&self) -> String {
        json::pretty(self.fields().iter().map(|(name, value)| (*name, value)))
    }

    /// The scene file's text on one line, as links carry it.
    pub(crate) fn to_compact_json(&self) -> String {
        json::object(self.fields().iter().map(|(name, value)| (*name, value)))
    }

    /// The file's fields, in the order in which they are written.
    fn fields(&self) -> Vec<(&'static str, Value)> {
        let Header { name, title, note, source, units, exact, published } = self.header();
        let text = |text: &str| Value::from(text);
        let mut out = vec![
            ("format", text(FORMAT)),
            ("version", Value::from(VERSION)),
            ("kind", text(self.kind().name())),
            ("name", text(name)),
            ("title", text(title)),
        ];
        for (key, note) in [("note", note), ("source", source), ("units", units)] {
            out.extend(note.iter().map(|note| (key, text(note))));
        }
        self.body().write(&mut out);
        for (key, kept) in [("exact", exact), ("published", published)] {
            out.extend(kept.iter().map(|kept| (key, kept.clone())));
        }
        out
    }
}

/// The fields of a scene, after format and version.
pub(crate) fn open(value: Value) -> Result<Fields, Error> {
    let mut fields = Fields::of_scene(value)?;
    fields.expect("format", |found| found == FORMAT, Message::verbatim(format!("\"{FORMAT}\"")))?;
    fields.expect("version", |found| found.as_f64() == Some(f64::from(VERSION)), Message::verbatim(VERSION.to_string()))?;
    Ok(fields)
}

impl Header {
    /// Reads what every scene has.
    pub(crate) fn read(fields: &mut Fields) -> Result<Self, Error> {
        Ok(Self {
            name: fields.text("name")?,
            title: fields.text("title")?,
            note: fields.optional_text("note")?,
            source: fields.optional_text("source")?,
            units: fields.optional_text("units")?,
            exact: fields.optional("exact"),
            published: fields.optional("published"),
        })
    }
}
