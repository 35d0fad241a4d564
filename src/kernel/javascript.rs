//! JavaScript's values as JSON has them.

use js_sys::{Array, JsString, Reflect, Symbol};
use serde_json::{Map, Value};
use wasm_bindgen::prelude::*;

use super::{Error, allowed, limits};

// Those of js-sys let through what a proxy throws: the stack would be gone, and what is borrowed would remain so.
#[wasm_bindgen]
extern "C" {
    #[wasm_bindgen(catch, js_namespace = Object, js_name = keys)]
    fn keys_of(object: &JsValue) -> Result<Array, JsValue>;
    #[wasm_bindgen(catch, js_namespace = Array, js_name = isArray)]
    fn is_array(value: &JsValue) -> Result<bool, JsValue>;
    #[wasm_bindgen(catch, js_namespace = Array, js_name = from)]
    fn copy_of(list: &JsValue) -> Result<Array, JsValue>;
}

/// What cannot be read: a proxy that throws.
fn unreadable(field: &str) -> Error {
    Error::refused(field, allowed::unreadable(), allowed::plain())
}

/// The names of an object's own properties.
///
/// # Errors
/// [`Error::Refused`] for `field`, where they cannot be read.
pub fn keys(field: &str, object: &JsValue) -> Result<Array, Error> {
    keys_of(object).map_err(|_| unreadable(field))
}

/// The items of a list within [`limits::VALUES`]; `None` of another value.
///
/// # Errors
/// [`Error::Refused`] for `field`, where they cannot be read, and for too many.
pub fn items(field: &str, value: &JsValue) -> Result<Option<Array>, Error> {
    if !is_array(value).map_err(|_| unreadable(field))? {
        return Ok(None);
    }
    let length = Reflect::get(value, &"length".into()).ok().and_then(|length| length.as_f64());
    limits::check_values(field, length.ok_or_else(|| unreadable(field))? as usize)?;
    copy_of(value).map(Some).map_err(|_| unreadable(field))
}

/// Reads a value of plain objects, lists, texts, numbers, true, false and null, within the [`limits`]. What is undefined or no
/// finite number becomes null, as in `JSON.stringify`.
///
/// # Errors
/// [`Error::Refused`] for `field`: a value of another kind, nested too deep (as one that holds itself is) or too large.
pub fn read(field: &str, value: &JsValue) -> Result<Value, Error> {
    Walk { field, values: 1, bytes: 0 }.read(value, 0)
}

struct Walk<'a> {
    field: &'a str,
    /// As many as there would be in JSON text, by [`limits::check_json`].
    values: usize,
    /// Of all texts.
    bytes: usize,
}

impl Walk<'_> {
    fn read(&mut self, value: &JsValue, depth: usize) -> Result<Value, Error> {
        if value.is_null() || value.is_undefined() {
            return Ok(Value::Null);
        }
        if let Some(flag) = value.as_bool() {
            return Ok(Value::Bool(flag));
        }
        if let Some(number) = value.as_f64() {
            // Whole numbers as JSON text has them.
            let whole = number as i64;
            let fits = whole as f64 == number && whole.unsigned_abs() < 1 << 53;
            return Ok(if fits { Value::from(whole) } else { Value::from(number) });
        }
        if let Some(text) = value.dyn_ref() {
            return self.text(text).map(Value::String);
        }
        if let Some(list) = items(self.field, value)? {
            return self.list(&list, depth + 1);
        }
        if value.is_object() && !Reflect::has(value, &Symbol::iterator()).map_err(|_| unreadable(self.field))? {
            return self.object(value, depth + 1);
        }
        let kind = if value.is_object() {
            allowed::iterable()
        } else {
            allowed::of_kind(&String::from(value.js_typeof().unchecked_into::<JsString>()))
        };
        Err(Error::refused(self.field, kind, allowed::plain()))
    }

    fn text(&mut self, text: &JsString) -> Result<String, Error> {
        self.bytes += text.length() as usize;
        limits::check_bytes(self.field, self.bytes, limits::FILE_BYTES)?;
        Ok(text.into())
    }

    /// Goes a level down, to so many values.
    fn enter(&mut self, depth: usize, length: u32) -> Result<(), Error> {
        self.values += length.max(1) as usize;
        limits::check_depth(self.field, depth).and_then(|()| limits::check_values(self.field, self.values))
    }

    fn list(&mut self, list: &Array, depth: usize) -> Result<Value, Error> {
        self.enter(depth, list.length())?;
        let items = (0..list.length()).map(|i| self.read(&list.get(i), depth));
        items.collect::<Result<_, _>>().map(Value::Array)
    }

    fn object(&mut self, object: &JsValue, depth: usize) -> Result<Value, Error> {
        let names = keys(self.field, object)?;
        self.enter(depth, names.length())?;
        let mut fields = Map::new();
        for i in 0..names.length() {
            let name = names.get(i);
            let value = self.read(&Reflect::get(object, &name).unwrap_or_default(), depth)?;
            fields.insert(self.text(name.unchecked_ref())?, value);
        }
        Ok(Value::Object(fields))
    }
}
