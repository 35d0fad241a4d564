//! The scene file: JSON in and out, every refusal with the field it is about.

use serde::{Serialize, de::DeserializeOwned, ser::SerializeMap};
use serde_json::{Map, Value};

use crate::error::Error;

use super::{Body, DiscsScene, FunctionScene, Header, Kind, Scene};

const FORMAT: &str = "forage-scene";
const VERSION: u64 = 1;
const HEADER: [&str; 7] = ["name", "title", "note", "source", "units", "exact", "published"];

impl Serialize for Scene {
    fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut out = serializer.serialize_map(None)?;
        out.serialize_entry("format", FORMAT)?;
        out.serialize_entry("version", &VERSION)?;
        out.serialize_entry("kind", &self.kind())?;
        let Header { name, title, note, source, units, exact, published } = &self.header;
        out.serialize_entry("name", name)?;
        out.serialize_entry("title", title)?;
        for (key, text) in [("note", note), ("source", source), ("units", units)] {
            text.iter().try_for_each(|text| out.serialize_entry(key, text))?;
        }
        match &self.body {
            Body::Function(FunctionScene { function, dimension }) => {
                out.serialize_entry("function", function)?;
                out.serialize_entry("dimension", dimension)?;
            }
            Body::Discs(DiscsScene { bounds, start, goal, discs }) => {
                out.serialize_entry("bounds", bounds)?;
                out.serialize_entry("start", start)?;
                out.serialize_entry("goal", goal)?;
                out.serialize_entry("discs", discs)?;
            }
        }
        for (key, value) in [("exact", exact), ("published", published)] {
            value.iter().try_for_each(|value| out.serialize_entry(key, value))?;
        }
        out.end()
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
        let value: Value = serde_json::from_str(text).map_err(|problem| Error::malformed("scene", format!("not JSON: {problem}")))?;
        Self::from_value(value)
    }

    /// Reads a scene from an object in memory.
    ///
    /// # Errors
    /// The field, its value and what is allowed.
    pub fn from_value(value: Value) -> Result<Self, Error> {
        let Value::Object(mut fields) = value else {
            return Err(Error::refused("scene", shown(&value), "an object with format, version, kind, name, title, …"));
        };
        expect(&mut fields, "format", &Value::from(FORMAT))?;
        expect(&mut fields, "version", &Value::from(VERSION))?;
        let kind = fields.remove("kind").unwrap_or(Value::Null);
        let kind = Kind::ALL
            .into_iter()
            .find(|k| kind == k.name())
            .ok_or_else(|| Error::refused("kind", shown(&kind), format!("one of {}", Kind::ALL.map(Kind::name).join(", "))))?;
        let header: Map<String, Value> = HEADER.iter().filter_map(|&name| fields.remove_entry(name)).collect();
        let header = read(Value::Object(header))?;
        let body = Value::Object(fields);
        let body = match kind {
            Kind::Function => Body::Function(read(body)?),
            Kind::Discs => Body::Discs(read(body)?),
        };
        Self::new(header, body)
    }

    /// The scene file's text.
    pub fn to_json(&self) -> String {
        // Scenes hold strings and finite numbers only: this cannot fail.
        serde_json::to_string_pretty(self).unwrap_or_default()
    }
}

fn expect(fields: &mut Map<String, Value>, name: &str, wanted: &Value) -> Result<(), Error> {
    match fields.remove(name) {
        Some(found) if found == *wanted => Ok(()),
        found => Err(Error::refused(name, shown(&found.unwrap_or(Value::Null)), wanted.to_string())),
    }
}

/// Deserialises and, on failure, says which field held what.
fn read<T: DeserializeOwned>(mut value: Value) -> Result<T, Error> {
    plus_zero(&mut value);
    serde_path_to_error::deserialize(&value).map_err(|error| {
        let path = error.path().to_string();
        let problem = error.inner().to_string();
        let field = if path == "." { missing(&problem) } else { path.clone() };
        let found = if path == "." { Some(Value::Null) } else { at(&value, &path) };
        match found {
            Some(found) if !problem.starts_with("unknown field") => Error::refused(field, shown(&found), expected(&problem)),
            _ => Error::refused(field, "this field", expected(&problem)),
        }
    })
}

/// −0 becomes 0: JavaScript's whole numbers lose the sign on their way in, and both must give the same bits.
fn plus_zero(value: &mut Value) {
    match value {
        Value::Number(number) if number.as_f64() == Some(0.0) => *value = Value::from(0),
        Value::Array(items) => items.iter_mut().for_each(plus_zero),
        Value::Object(fields) => fields.values_mut().for_each(plus_zero),
        _ => {}
    }
}

/// The value at a path like `discs[2].radius`.
fn at(value: &Value, path: &str) -> Option<Value> {
    let pointer: String = path.replace('[', ".").replace(']', "").split('.').flat_map(|part| ["/", part]).collect();
    value.pointer(&pointer).cloned()
}

fn shown(value: &Value) -> String {
    match value {
        Value::Null => "nothing".to_owned(),
        Value::Object(_) => "an object".to_owned(),
        Value::Array(items) => format!("a list of {}", items.len()),
        other => other.to_string(),
    }
}

/// The name in serde's "missing field `x`".
fn missing(problem: &str) -> String {
    problem.split('`').nth(1).unwrap_or("scene").to_owned()
}

/// serde's sentence, without what it repeats.
fn expected(problem: &str) -> String {
    let rest = problem.split_once("expected ").map_or(problem, |(_, rest)| rest);
    match problem.split_once(' ') {
        Some(("missing", _)) => "given".to_owned(),
        Some(("unknown", _)) if problem.starts_with("unknown field") => {
            format!("left out, or {rest}")
        }
        _ => rest.to_owned(),
    }
}
