//! JavaScript's values as JSON has them.

use js_sys::{Array, JsString, Object, Reflect, Symbol};
use serde_json::{Map, Value};
use wasm_bindgen::{JsCast, JsValue};

use super::{Error, allowed, limits};

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
        if Array::is_array(value) {
            return self.list(value.unchecked_ref(), depth + 1);
        }
        if value.is_object() && !Symbol::iterator().js_in(value) {
            return self.object(value.unchecked_ref(), depth + 1);
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

    fn object(&mut self, object: &Object, depth: usize) -> Result<Value, Error> {
        let names = Object::keys(object);
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
