//! The scene file: JSON in and out, every refusal with the field it is about.

mod arm;
mod discs;
mod function;
mod grid;
mod tour;

use serde::Serialize;
use serde_json::Value;

use crate::kernel::{Error, Kind, fields::Fields, json};

use super::{Body, Header, Scene};

const FORMAT: &str = "forage-scene";
const VERSION: u32 = 1;

impl Serialize for Scene {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.fields())
    }
}

impl Scene {
    /// Reads a scene file's text.
    ///
    /// ```
    /// let text = r#"{"format": "forage-scene", "version": 1, "kind": "function", "name": "s", "title": "Sphere",
    ///                "function": "sphere", "dimension": 3}"#;
    /// assert_eq!(forage::Scene::from_json(text)?.name(), "s");
    /// let wrong = text.replace("3", "-3");
    /// assert_eq!(forage::Scene::from_json(&wrong).unwrap_err().field(), "dimension");
    /// # Ok::<(), forage::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Malformed`] if it is not JSON, otherwise the field, its value and what is allowed.
    pub fn from_json(text: &str) -> Result<Self, Error> {
        let value = json::parse(text).map_err(|problem| Error::malformed("scene", format!("not JSON: {problem}")))?;
        Self::from_value(value)
    }

    /// Reads a scene from an object in memory.
    ///
    /// # Errors
    /// The field, its value and what is allowed.
    pub fn from_value(value: Value) -> Result<Self, Error> {
        let mut fields = Fields::of("scene", value, "an object with format, version, kind, name, title, …")?;
        fields.at.clear();
        fields.expect("format", |found| found == FORMAT, &format!("\"{FORMAT}\""))?;
        fields.expect("version", |found| found.as_f64() == Some(f64::from(VERSION)), &VERSION.to_string())?;
        let kind = fields.one_of("kind", Kind::ALL, Kind::name)?;
        let header = Header {
            name: fields.text("name")?,
            title: fields.text("title")?,
            note: fields.optional_text("note")?,
            source: fields.optional_text("source")?,
            units: fields.optional_text("units")?,
            exact: fields.optional("exact"),
            published: fields.optional("published"),
        };
        let body = match kind {
            Kind::Function => Body::Function(function::read(&mut fields)?),
            Kind::Discs => Body::Discs(discs::read(&mut fields)?),
            Kind::Grid => Body::Grid(grid::read(&mut fields)?),
            Kind::Tour => Body::Tour(tour::read(&mut fields)?),
            Kind::Arm => Body::Arm(arm::read(&mut fields)?),
        };
        fields.end()?;
        Self::new(header, body)
    }

    /// The scene file's text.
    pub fn to_json(&self) -> String {
        // Scenes hold strings and finite numbers only: this cannot fail.
        serde_json::to_string_pretty(self).unwrap_or_default()
    }

    /// The scene file's text on one line, as links carry it.
    pub(crate) fn to_compact_json(&self) -> String {
        json::object(self.fields().iter().map(|(name, value)| (*name, value)))
    }

    /// What a run depends on, on one line: kind and content, without name, title and notes.
    pub(crate) fn content(&self) -> String {
        let mut out = vec![("kind", Value::from(self.kind().name()))];
        self.write_body(&mut out);
        json::object(out.iter().map(|(name, value)| (*name, value)))
    }

    fn write_body(&self, out: &mut Vec<(&'static str, Value)>) {
        match &self.body {
            Body::Function(scene) => function::write(scene, out),
            Body::Discs(scene) => discs::write(scene, out),
            Body::Grid(scene) => grid::write(scene, out),
            Body::Tour(scene) => tour::write(scene, out),
            Body::Arm(scene) => arm::write(scene, out),
        }
    }

    /// The file's fields, in the order in which they are written.
    fn fields(&self) -> Vec<(&'static str, Value)> {
        let Header { name, title, note, source, units, exact, published } = &self.header;
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
        self.write_body(&mut out);
        for (key, kept) in [("exact", exact), ("published", published)] {
            out.extend(kept.iter().map(|kept| (key, kept.clone())));
        }
        out
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = r#"{"format": "forage-scene", "version": 1, "kind": "discs", "name": "a", "title": "A",
        "bounds": {"min": [0, 0], "max": [8, 8.5]}, "start": [0, -0.0], "goal": [8, 8], "discs": [{"center": [4, 4], "radius": 1}]}"#;

    fn refused(from: &str, to: &str) -> [String; 3] {
        assert!(TEXT.contains(from));
        let error = Scene::from_json(&TEXT.replacen(from, to, 1)).unwrap_err();
        [error.field(), error.value(), error.allowed()].map(str::to_owned)
    }

    #[test]
    fn every_refusal_names_the_field_what_it_holds_and_what_is_allowed() {
        for (from, to, expected) in [
            ("forage-scene", "other", ["format", "\"other\"", "\"forage-scene\""]),
            (": 1,", ": 2,", ["version", "2", "1"]),
            ("\"discs\",", "3,", ["kind", "3", "one of function, discs, grid, tour, arm"]),
            ("\"title\": \"A\",", "", ["title", "nothing", "a text"]),
            ("\"A\"", "true", ["title", "true", "a text"]),
            ("[8, 8]", "[8]", ["goal", "a list of 1", "a point, [x, y]"]),
            ("[8, 8]", "[8, \"8\"]", ["goal[1]", "\"8\"", "a finite number"]),
            ("{\"min\": [0, 0], \"max\": [8, 8.5]}", "7", ["bounds", "7", "an object with min and max"]),
            ("\"max\": [8, 8.5]", "\"max\": {}", ["bounds.max", "an object", "a point, [x, y]"]),
            ("\"radius\": 1", "\"radius\": null", ["discs[0].radius", "nothing", "a finite number"]),
            (", \"radius\": 1", "", ["discs[0].radius", "nothing", "a finite number"]),
            ("\"radius\"", "\"r\": 1, \"radius\"", ["discs[0].r", "this field", "left out, or one of center, radius"]),
        ] {
            assert_eq!(refused(from, to), expected);
        }
        let [field, _, allowed] = refused("\"start\"", "\"walls\": 3, \"start\"");
        assert!(field == "walls" && allowed.contains("bounds") && allowed.contains("note"), "{allowed}");
    }

    #[test]
    fn the_compact_text_is_read_back_as_the_same_scene() {
        let scene = Scene::from_json(TEXT).unwrap();
        let text = scene.to_compact_json();
        assert!(text.contains(r#""start":[0,0],"goal":[8,8]"#) && text.contains("8.5"), "{text}");
        assert_eq!(Scene::from_json(&text).unwrap(), scene);
    }
}
