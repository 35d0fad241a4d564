//! The scene file: JSON in and out, every refusal with the field it is about.

mod arm;
mod grid;
mod tour;

use serde::Serialize;
use serde_json::{Map, Value};

use crate::{
    geometry::{Bounds, Disc},
    kernel::{Error, json},
};

use super::{Body, DiscsScene, Function, FunctionScene, Header, Kind, Scene};

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
            Kind::Function => Body::Function(fields.function()?),
            Kind::Discs => Body::Discs(fields.discs_scene()?),
            Kind::Grid => Body::Grid(fields.grid()?),
            Kind::Tour => Body::Tour(fields.tour()?),
            Kind::Arm => Body::Arm(fields.arm_scene()?),
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
        match &self.body {
            Body::Function(FunctionScene { function, dimension, shift }) => {
                out.extend([("function", text(function.name())), ("dimension", Value::from(*dimension))]);
                if !shift.is_empty() {
                    out.push(("shift", Value::from(shift.as_slice())));
                }
            }
            Body::Discs(DiscsScene { bounds, start, goal, discs }) => {
                let bounds = object(&mut [("min", point(bounds.min)), ("max", point(bounds.max))].into_iter());
                let discs = discs
                    .iter()
                    .map(|disc| object(&mut [("center", point(disc.center)), ("radius", Value::from(disc.radius))].into_iter()))
                    .collect();
                out.extend([("bounds", bounds), ("start", point(*start)), ("goal", point(*goal)), ("discs", Value::Array(discs))]);
            }
            Body::Grid(grid) => grid::write(grid, &mut out),
            Body::Tour(tour) => tour::write(tour, &mut out),
            Body::Arm(scene) => arm::write(scene, &mut out),
        }
        for (key, kept) in [("exact", exact), ("published", published)] {
            out.extend(kept.iter().map(|kept| (key, kept.clone())));
        }
        out
    }
}

fn point(point: [f64; 2]) -> Value {
    Value::Array(point.map(Value::from).to_vec())
}

fn points(points: &[[f64; 2]]) -> Value {
    Value::Array(points.iter().copied().map(point).collect())
}

/// One by one: collecting would bring in a sort for every number of fields.
fn object(fields: &mut dyn Iterator<Item = (&'static str, Value)>) -> Value {
    let mut object = Map::new();
    for (name, value) in fields {
        object.insert(name.to_owned(), value);
    }
    Value::Object(object)
}

/// What an object still holds while it is read field by field. What nobody asked for is refused at the end.
struct Fields {
    /// Where the object stands, e.g. `discs[2]`; empty for the scene itself.
    at: String,
    left: Map<String, Value>,
    /// The names that were asked for: what is allowed here.
    known: Vec<&'static str>,
}

impl Fields {
    fn of(at: &str, value: Value, allowed: &str) -> Result<Self, Error> {
        match value {
            Value::Object(left) => Ok(Self { at: at.to_owned(), left, known: Vec::new() }),
            other => Err(Error::refused(at, shown(&other), allowed)),
        }
    }

    /// A field's path, e.g. `discs[2].radius`.
    fn path(&self, name: &str) -> String {
        if self.at.is_empty() { name.to_owned() } else { format!("{}.{name}", self.at) }
    }

    fn take(&mut self, name: &'static str) -> Value {
        self.known.push(name);
        self.left.remove(name).unwrap_or(Value::Null)
    }

    fn refuse(&self, name: &str, found: &Value, allowed: &str) -> Error {
        Error::refused(self.path(name), shown(found), allowed)
    }

    fn expect(&mut self, name: &'static str, fits: impl Fn(&Value) -> bool, allowed: &str) -> Result<(), Error> {
        let found = self.take(name);
        if fits(&found) { Ok(()) } else { Err(self.refuse(name, &found, allowed)) }
    }

    /// Anything, as it stands in the file.
    fn optional(&mut self, name: &'static str) -> Option<Value> {
        let mut found = self.take(name);
        plus_zero(&mut found);
        Some(found).filter(|found| !found.is_null())
    }

    fn optional_text(&mut self, name: &'static str) -> Result<Option<String>, Error> {
        match self.take(name) {
            Value::Null => Ok(None),
            Value::String(text) => Ok(Some(text)),
            other => Err(self.refuse(name, &other, "a text")),
        }
    }

    fn text(&mut self, name: &'static str) -> Result<String, Error> {
        self.optional_text(name)?.ok_or_else(|| self.refuse(name, &Value::Null, "a text"))
    }

    fn one_of<T: Copy, const N: usize>(&mut self, name: &'static str, all: [T; N], name_of: fn(T) -> &'static str) -> Result<T, Error> {
        let found = self.take(name);
        let known = all.into_iter().find(|&one| found == name_of(one));
        known.ok_or_else(|| self.refuse(name, &found, &format!("one of {}", all.map(name_of).join(", "))))
    }

    fn number(&mut self, name: &'static str) -> Result<f64, Error> {
        let found = self.take(name);
        number(self.path(name), &found)
    }

    fn point(&mut self, name: &'static str) -> Result<[f64; 2], Error> {
        let found = self.take(name);
        point_of(&self.path(name), &found)
    }

    fn optional_point(&mut self, name: &'static str) -> Result<Option<[f64; 2]>, Error> {
        if self.left.contains_key(name) {
            return self.point(name).map(Some);
        }
        self.known.push(name);
        Ok(None)
    }

    fn list(&mut self, name: &'static str) -> Result<Vec<Value>, Error> {
        match self.take(name) {
            Value::Array(items) => Ok(items),
            other => Err(self.refuse(name, &other, "a list")),
        }
    }

    fn flag(&mut self, name: &'static str, default: bool) -> Result<bool, Error> {
        match self.take(name) {
            Value::Null => Ok(default),
            Value::Bool(flag) => Ok(flag),
            other => Err(self.refuse(name, &other, "true or false")),
        }
    }

    fn function(&mut self) -> Result<FunctionScene, Error> {
        let function = self.one_of("function", Function::ALL, Function::name)?;
        let dimension = self.number("dimension")?;
        if dimension.fract() != 0.0 || !(0.0..=f64::from(u32::MAX)).contains(&dimension) {
            return Err(Error::refused("dimension", dimension, "a positive whole number"));
        }
        let mut shift = Vec::new();
        if self.left.contains_key("shift") {
            for (i, value) in self.list("shift")?.iter().enumerate() {
                shift.push(number(format!("shift[{i}]"), value)?);
            }
        }
        self.known.push("shift");
        Ok(FunctionScene { function, dimension: dimension as usize, shift })
    }

    fn discs_scene(&mut self) -> Result<DiscsScene, Error> {
        Ok(DiscsScene {
            bounds: bounds(self.take("bounds"))?,
            start: self.point("start")?,
            goal: self.point("goal")?,
            discs: self.list("discs")?.into_iter().enumerate().map(|(i, value)| disc(i, value)).collect::<Result<_, _>>()?,
        })
    }

    fn end(self) -> Result<(), Error> {
        match self.left.keys().next() {
            Some(name) => Err(Error::refused(self.path(name), "this field", format!("left out, or one of {}", self.known.join(", ")))),
            None => Ok(()),
        }
    }
}

fn bounds(value: Value) -> Result<Bounds, Error> {
    let mut fields = Fields::of("bounds", value, "an object with min and max")?;
    let bounds = Bounds { min: fields.point("min")?, max: fields.point("max")? };
    fields.end()?;
    Ok(bounds)
}

fn disc(i: usize, value: Value) -> Result<Disc, Error> {
    let mut fields = Fields::of(&format!("discs[{i}]"), value, "an object with center and radius")?;
    let disc = Disc { center: fields.point("center")?, radius: fields.number("radius")? };
    fields.end()?;
    Ok(disc)
}

/// A point, with the field it stands in.
fn point_of(path: &str, found: &Value) -> Result<[f64; 2], Error> {
    let Some([x, y]) = found.as_array().map(Vec::as_slice) else {
        return Err(Error::refused(path, shown(found), "a point, [x, y]"));
    };
    Ok([number(format!("{path}[0]"), x)?, number(format!("{path}[1]"), y)?])
}

/// A number. −0 becomes 0: JavaScript's whole numbers lose the sign on their way in, and both must give the same bits.
fn number(path: String, found: &Value) -> Result<f64, Error> {
    found.as_f64().map(|number| number + 0.0).ok_or_else(|| Error::refused(path, shown(found), "a finite number"))
}

/// The same for every number in what is kept as it stands.
fn plus_zero(value: &mut Value) {
    match value {
        Value::Number(number) if number.as_f64() == Some(0.0) => *value = Value::from(0),
        Value::Array(items) => items.iter_mut().for_each(plus_zero),
        Value::Object(fields) => fields.values_mut().for_each(plus_zero),
        _ => {}
    }
}

fn shown(value: &Value) -> String {
    match value {
        Value::Null => "nothing".to_owned(),
        Value::Object(_) => "an object".to_owned(),
        Value::Array(items) => format!("a list of {}", items.len()),
        Value::String(text) => format!("\"{text}\""),
        Value::Bool(flag) => flag.to_string(),
        Value::Number(number) => number.as_f64().unwrap_or_default().to_string(),
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
