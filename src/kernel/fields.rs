//! The fields of a scene file, read one by one, so that every error names the field.
//!
//! A reader takes the fields that it knows from [`Fields`]; any others are refused. The functions here read and write the
//! values in it.

use serde_json::{Map, Value};

use crate::message;

use super::{
    Error, Message, allowed,
    digits::Digits,
    error::{finite, list_of, one_of},
};

/// An object that is read field by field. Fields that were not read are refused at the end.
#[derive(Debug)]
pub struct Fields {
    /// The object's path, e.g. `discs[2]`; empty for the scene itself.
    at: String,
    /// The fields that were not read yet.
    left: Vec<(String, Value)>,
    /// The names that were read: what is allowed here.
    known: Vec<&'static str>,
}

impl Fields {
    /// The fields of a value that must be an object. `at` is its path, e.g. `discs[2]`; `allowed` describes it for the error.
    ///
    /// # Errors
    /// [`Error::Refused`] for anything else.
    pub fn of(at: &str, value: Value, allowed: impl Into<Message>) -> Result<Self, Error> {
        match value {
            Value::Object(left) => Ok(Self { at: at.to_owned(), left: left.into_iter().collect(), known: Vec::new() }),
            other => Err(Error::refused(at, shown(&other), allowed)),
        }
    }

    /// The fields of a whole scene: their paths are their names.
    pub(super) fn of_scene(value: Value) -> Result<Self, Error> {
        let fields = Self::of("scene", value, message!("error-scene", "an object with format, version, kind, name, title, …"))?;
        Ok(Self { at: String::new(), ..fields })
    }

    /// Whether there is a field of this name that was not read yet.
    pub fn has(&self, name: &str) -> bool {
        self.place(name).is_some()
    }

    /// The text in a field that was not read yet.
    pub(crate) fn peek(&self, name: &str) -> Option<&str> {
        self.place(name).and_then(|at| self.left[at].1.as_str())
    }

    /// Lists a field among those that are allowed here, without reading it.
    pub fn allow(&mut self, name: &'static str) {
        self.known.push(name);
    }

    /// A field's path, e.g. `discs[2].radius`.
    pub fn path(&self, name: &str) -> String {
        if self.at.is_empty() { name.to_owned() } else { format!("{}.{name}", self.at) }
    }

    /// Takes a field's value; null if there is no such field.
    pub fn take(&mut self, name: &'static str) -> Value {
        self.known.push(name);
        self.place(name).map_or(Value::Null, |at| self.left.remove(at).1)
    }

    fn place(&self, name: &str) -> Option<usize> {
        self.left.iter().position(|(known, _)| known == name)
    }

    /// The error for a field whose value is not allowed.
    pub fn refuse(&self, name: &str, found: &Value, allowed: impl Into<Message>) -> Error {
        Error::refused(self.path(name), shown(found), allowed)
    }

    /// Takes a field and refuses a value that does not fit.
    ///
    /// # Errors
    /// [`Error::Refused`] with `allowed`.
    pub fn expect(&mut self, name: &'static str, fits: impl Fn(&Value) -> bool, allowed: impl Into<Message>) -> Result<(), Error> {
        let found = self.take(name);
        if fits(&found) { Ok(()) } else { Err(self.refuse(name, &found, allowed)) }
    }

    /// Takes a value of any form, if there is one. −0 becomes 0.
    pub fn optional(&mut self, name: &'static str) -> Option<Value> {
        let mut found = self.take(name);
        plus_zero(&mut found);
        Some(found).filter(|found| !found.is_null())
    }

    /// Takes a text, if there is one.
    ///
    /// # Errors
    /// [`Error::Refused`] for anything else.
    pub fn optional_text(&mut self, name: &'static str) -> Result<Option<String>, Error> {
        match self.take(name) {
            Value::Null => Ok(None),
            Value::String(text) => Ok(Some(text)),
            other => Err(self.refuse(name, &other, allowed::text())),
        }
    }

    /// Takes a text.
    ///
    /// # Errors
    /// [`Error::Refused`] for anything else.
    pub fn text(&mut self, name: &'static str) -> Result<String, Error> {
        self.optional_text(name)?.ok_or_else(|| self.refuse(name, &Value::Null, allowed::text()))
    }

    /// Takes one of some names.
    ///
    /// # Errors
    /// [`Error::Refused`] with the names that are allowed.
    pub fn one_of<T: Copy, const N: usize>(&mut self, name: &'static str, all: [T; N], name_of: fn(T) -> &'static str) -> Result<T, Error> {
        let found = self.take(name);
        let known = all.into_iter().find(|&one| found == name_of(one));
        known.ok_or_else(|| self.refuse(name, &found, one_of(&all.map(name_of))))
    }

    /// Takes a number.
    ///
    /// # Errors
    /// [`Error::Refused`] for anything else.
    pub fn number(&mut self, name: &'static str) -> Result<f64, Error> {
        let found = self.take(name);
        number(self.path(name), &found)
    }

    /// Takes a point in the plane.
    ///
    /// # Errors
    /// [`Error::Refused`] for anything else.
    pub fn point(&mut self, name: &'static str) -> Result<[f64; 2], Error> {
        let found = self.take(name);
        point_of(&self.path(name), &found)
    }

    /// Takes a list of points in the plane.
    ///
    /// # Errors
    /// [`Error::Refused`] for anything else.
    pub fn points(&mut self, name: &'static str) -> Result<Vec<[f64; 2]>, Error> {
        each(&self.path(name), self.list(name)?, |path, value| point_of(path, &value))
    }

    /// Takes a point in the plane, if there is one.
    ///
    /// # Errors
    /// [`Error::Refused`] for anything else.
    pub fn optional_point(&mut self, name: &'static str) -> Result<Option<[f64; 2]>, Error> {
        if self.has(name) {
            return self.point(name).map(Some);
        }
        self.allow(name);
        Ok(None)
    }

    /// Takes a list.
    ///
    /// # Errors
    /// [`Error::Refused`] for anything else.
    pub fn list(&mut self, name: &'static str) -> Result<Vec<Value>, Error> {
        match self.take(name) {
            Value::Array(items) => Ok(items),
            other => Err(self.refuse(name, &other, allowed::list())),
        }
    }

    /// Takes true or false; `default` if there is no such field.
    ///
    /// # Errors
    /// [`Error::Refused`] for anything else.
    pub fn flag(&mut self, name: &'static str, default: bool) -> Result<bool, Error> {
        match self.take(name) {
            Value::Null => Ok(default),
            Value::Bool(flag) => Ok(flag),
            other => Err(self.refuse(name, &other, message!("error-flag", "true or false"))),
        }
    }

    /// Refuses the fields that were not read.
    ///
    /// # Errors
    /// [`Error::Refused`] with the names that are allowed.
    pub fn end(self) -> Result<(), Error> {
        match self.left.first() {
            Some((name, _)) => Err(Error::refused(
                self.path(name),
                message!("error-this-field", "this field"),
                message!("error-left-out-or-one-of", "left out, or one of {known}", known = self.known.join(", ")),
            )),
            None => Ok(()),
        }
    }

    /// Takes a list; an empty one if there is no such field.
    ///
    /// # Errors
    /// [`Error::Refused`] for anything else.
    pub fn optional_list(&mut self, name: &'static str) -> Result<Vec<Value>, Error> {
        if self.has(name) {
            return self.list(name);
        }
        self.allow(name);
        Ok(Vec::new())
    }

    /// Takes a point in space.
    ///
    /// # Errors
    /// [`Error::Refused`] for anything else.
    pub fn point_in_space(&mut self, name: &'static str) -> Result<[f64; 3], Error> {
        let found = self.take(name);
        let path = self.path(name);
        let Some([x, y, z]) = found.as_array().map(Vec::as_slice) else {
            return Err(Error::refused(path, shown(&found), allowed::point_in_space()));
        };
        Ok([number(format!("{path}[0]"), x)?, number(format!("{path}[1]"), y)?, number(format!("{path}[2]"), z)?])
    }

    /// Takes a number, if there is one.
    ///
    /// # Errors
    /// [`Error::Refused`] for anything else.
    pub fn optional_number(&mut self, name: &'static str) -> Result<Option<f64>, Error> {
        if self.has(name) {
            return self.number(name).map(Some);
        }
        self.allow(name);
        Ok(None)
    }
}

/// Reads each item of a list. `path` is the list's field; `read` gets the item's.
///
/// # Errors
/// As `read`.
pub fn each<T>(path: &str, list: Vec<Value>, read: impl Fn(&str, Value) -> Result<T, Error>) -> Result<Vec<T>, Error> {
    let mut out = Vec::with_capacity(list.len());
    for (i, value) in list.into_iter().enumerate() {
        out.push(read(&format!("{path}[{i}]"), value)?);
    }
    Ok(out)
}

/// Reads a point in the plane; `path` is its field.
fn point_of(path: &str, found: &Value) -> Result<[f64; 2], Error> {
    let Some([x, y]) = found.as_array().map(Vec::as_slice) else {
        return Err(Error::refused(path, shown(found), allowed::point()));
    };
    Ok([number(format!("{path}[0]"), x)?, number(format!("{path}[1]"), y)?])
}

/// Reads a number; `path` is its field. −0 becomes 0: JavaScript's whole numbers lose the sign on their way in, and both must
/// give the same bits.
///
/// # Errors
/// [`Error::Refused`] for anything else.
pub fn number(path: String, found: &Value) -> Result<f64, Error> {
    found.as_f64().map(|number| number + 0.0).ok_or_else(|| Error::refused(path, shown(found), finite()))
}

/// The same for every number in a value that is kept as it is. Natively whole numbers of more than 2^53 become what they are in
/// JavaScript.
fn plus_zero(value: &mut Value) {
    match value {
        Value::Number(number) if number.as_f64() == Some(0.0) => *value = Value::from(0),
        #[cfg(not(target_arch = "wasm32"))]
        Value::Number(number) if !number.is_f64() && number.as_f64().is_some_and(|number| number.abs() >= 9_007_199_254_740_992.0) => {
            *value = Value::from(number.as_f64());
        }
        Value::Array(items) => items.iter_mut().for_each(plus_zero),
        Value::Object(fields) => fields.values_mut().for_each(plus_zero),
        _ => {}
    }
}

/// A value as errors show it.
pub fn shown(value: &Value) -> String {
    match value {
        Value::Null => "nothing".to_owned(),
        Value::Object(_) => allowed::object().to_string(),
        Value::Array(items) => list_of(items.len()).to_string(),
        Value::String(text) => format!("\"{text}\""),
        Value::Bool(flag) => flag.to_string(),
        Value::Number(number) => Digits(number.as_f64().unwrap_or_default()).to_string(),
    }
}

/// A point as JSON.
pub fn point(point: [f64; 2]) -> Value {
    Value::Array(point.map(Value::from).to_vec())
}

/// A list of points as JSON.
pub fn points(points: &[[f64; 2]]) -> Value {
    Value::Array(points.iter().copied().map(point).collect())
}

/// An object as JSON, its fields in this order.
// One by one: collecting would bring in a sort.
pub fn object(fields: Vec<(&'static str, Value)>) -> Value {
    let mut object = Map::new();
    for (name, value) in fields {
        object.insert(name.to_owned(), value);
    }
    Value::Object(object)
}
