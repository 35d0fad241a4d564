//! The fields of a scene's file, read one by one, so that every refusal names the field.

use serde_json::{Map, Value};

use super::Error;

/// What an object still holds while it is read field by field. What nobody asked for is refused at the end.
pub(crate) struct Fields {
    /// Where the object stands, e.g. `discs[2]`; empty for the scene itself.
    pub(crate) at: String,
    /// The fields that nobody asked for yet.
    pub(crate) left: Map<String, Value>,
    /// The names that were asked for: what is allowed here.
    pub(crate) known: Vec<&'static str>,
}

impl Fields {
    /// The fields of a value that must be an object; `at` says where it stands.
    pub(crate) fn of(at: &str, value: Value, allowed: &str) -> Result<Self, Error> {
        match value {
            Value::Object(left) => Ok(Self { at: at.to_owned(), left, known: Vec::new() }),
            other => Err(Error::refused(at, shown(&other), allowed)),
        }
    }

    /// A field's path, e.g. `discs[2].radius`.
    pub(crate) fn path(&self, name: &str) -> String {
        if self.at.is_empty() { name.to_owned() } else { format!("{}.{name}", self.at) }
    }

    /// A field's value; null where there is none.
    pub(crate) fn take(&mut self, name: &'static str) -> Value {
        self.known.push(name);
        self.left.remove(name).unwrap_or(Value::Null)
    }

    /// The refusal of a field.
    pub(crate) fn refuse(&self, name: &str, found: &Value, allowed: &str) -> Error {
        Error::refused(self.path(name), shown(found), allowed)
    }

    /// Refuses a field that does not fit.
    pub(crate) fn expect(&mut self, name: &'static str, fits: impl Fn(&Value) -> bool, allowed: &str) -> Result<(), Error> {
        let found = self.take(name);
        if fits(&found) { Ok(()) } else { Err(self.refuse(name, &found, allowed)) }
    }

    /// Anything, as it stands in the file.
    pub(crate) fn optional(&mut self, name: &'static str) -> Option<Value> {
        let mut found = self.take(name);
        plus_zero(&mut found);
        Some(found).filter(|found| !found.is_null())
    }

    /// A text, if there is one.
    pub(crate) fn optional_text(&mut self, name: &'static str) -> Result<Option<String>, Error> {
        match self.take(name) {
            Value::Null => Ok(None),
            Value::String(text) => Ok(Some(text)),
            other => Err(self.refuse(name, &other, "a text")),
        }
    }

    /// A text.
    pub(crate) fn text(&mut self, name: &'static str) -> Result<String, Error> {
        self.optional_text(name)?.ok_or_else(|| self.refuse(name, &Value::Null, "a text"))
    }

    /// One of some names.
    pub(crate) fn one_of<T: Copy, const N: usize>(
        &mut self,
        name: &'static str,
        all: [T; N],
        name_of: fn(T) -> &'static str,
    ) -> Result<T, Error> {
        let found = self.take(name);
        let known = all.into_iter().find(|&one| found == name_of(one));
        known.ok_or_else(|| self.refuse(name, &found, &format!("one of {}", all.map(name_of).join(", "))))
    }

    /// A number.
    pub(crate) fn number(&mut self, name: &'static str) -> Result<f64, Error> {
        let found = self.take(name);
        number(self.path(name), &found)
    }

    /// A point in the plane.
    pub(crate) fn point(&mut self, name: &'static str) -> Result<[f64; 2], Error> {
        let found = self.take(name);
        point_of(&self.path(name), &found)
    }

    /// A point in the plane, if there is one.
    pub(crate) fn optional_point(&mut self, name: &'static str) -> Result<Option<[f64; 2]>, Error> {
        if self.left.contains_key(name) {
            return self.point(name).map(Some);
        }
        self.known.push(name);
        Ok(None)
    }

    /// A list.
    pub(crate) fn list(&mut self, name: &'static str) -> Result<Vec<Value>, Error> {
        match self.take(name) {
            Value::Array(items) => Ok(items),
            other => Err(self.refuse(name, &other, "a list")),
        }
    }

    /// True or false.
    pub(crate) fn flag(&mut self, name: &'static str, default: bool) -> Result<bool, Error> {
        match self.take(name) {
            Value::Null => Ok(default),
            Value::Bool(flag) => Ok(flag),
            other => Err(self.refuse(name, &other, "true or false")),
        }
    }

    /// Refuses what nobody asked for.
    pub(crate) fn end(self) -> Result<(), Error> {
        match self.left.keys().next() {
            Some(name) => Err(Error::refused(self.path(name), "this field", format!("left out, or one of {}", self.known.join(", ")))),
            None => Ok(()),
        }
    }

    /// An empty list for a field that is not there.
    pub(crate) fn absent(&mut self, name: &'static str) -> Vec<Value> {
        self.known.push(name);
        Vec::new()
    }

    /// A point in space.
    pub(crate) fn point_in_space(&mut self, name: &'static str) -> Result<[f64; 3], Error> {
        let found = self.take(name);
        let path = self.path(name);
        let Some([x, y, z]) = found.as_array().map(Vec::as_slice) else {
            return Err(Error::refused(path, shown(&found), "a point in space, [x, y, z]"));
        };
        Ok([number(format!("{path}[0]"), x)?, number(format!("{path}[1]"), y)?, number(format!("{path}[2]"), z)?])
    }

    /// A number, if there is one.
    pub(crate) fn number_or(&mut self, name: &'static str, otherwise: f64) -> Result<f64, Error> {
        if self.left.contains_key(name) {
            return self.number(name);
        }
        self.known.push(name);
        Ok(otherwise)
    }
}

/// A point, with the field it stands in.
pub(crate) fn point_of(path: &str, found: &Value) -> Result<[f64; 2], Error> {
    let Some([x, y]) = found.as_array().map(Vec::as_slice) else {
        return Err(Error::refused(path, shown(found), "a point, [x, y]"));
    };
    Ok([number(format!("{path}[0]"), x)?, number(format!("{path}[1]"), y)?])
}

/// A number. −0 becomes 0: JavaScript's whole numbers lose the sign on their way in, and both must give the same bits.
pub(crate) fn number(path: String, found: &Value) -> Result<f64, Error> {
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

/// What a refusal says of a value.
pub(crate) fn shown(value: &Value) -> String {
    match value {
        Value::Null => "nothing".to_owned(),
        Value::Object(_) => "an object".to_owned(),
        Value::Array(items) => format!("a list of {}", items.len()),
        Value::String(text) => format!("\"{text}\""),
        Value::Bool(flag) => flag.to_string(),
        Value::Number(number) => number.as_f64().unwrap_or_default().to_string(),
    }
}

/// A point as it is written.
pub(crate) fn point(point: [f64; 2]) -> Value {
    Value::Array(point.map(Value::from).to_vec())
}

/// Points as they are written.
pub(crate) fn points(points: &[[f64; 2]]) -> Value {
    Value::Array(points.iter().copied().map(point).collect())
}

/// One by one: collecting would bring in a sort for every number of fields.
pub(crate) fn object(fields: &mut dyn Iterator<Item = (&'static str, Value)>) -> Value {
    let mut object = Map::new();
    for (name, value) in fields {
        object.insert(name.to_owned(), value);
    }
    Value::Object(object)
}
