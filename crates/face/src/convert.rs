//! Rust values as JavaScript has them.

use serde::Serialize;
use wasm_bindgen::{JsCast, JsValue};

use forage::Error;

/// An `Error` with the native message and its parts.
#[cold]
#[inline(never)]
pub(crate) fn js_error(error: Error) -> JsValue {
    js_error_as(error.code(), error)
}

/// The same with a code of its own.
#[cold]
#[inline(never)]
#[expect(clippy::needless_pass_by_value, reason = "it is dropped here, not wherever something is refused")]
pub(crate) fn js_error_as(code: &str, error: Error) -> JsValue {
    let js = js_sys::Error::new(&error.to_string());
    for (name, part) in [("code", code), ("field", error.field()), ("value", error.value()), ("allowed", &*error.allowed())] {
        // Setting a property of an ordinary object cannot fail.
        let _ = js_sys::Reflect::set(&js, &name.into(), &part.into());
    }
    js.into()
}

/// A plain object of anything serialisable.
///
/// # Errors
/// An `Error` for what JavaScript has no value for: a whole number beyond 2^53 − 1.
pub(crate) fn plain<T: JsCast>(value: &impl Serialize) -> Result<T, JsValue> {
    Ok(value.serialize(&serde_wasm_bindgen::Serializer::json_compatible())?.unchecked_into())
}

/// An object of these properties.
pub(crate) fn object<T: JsCast>(properties: &[(&str, JsValue)]) -> T {
    let object = js_sys::Object::new();
    for (name, value) in properties {
        // Setting a property of an ordinary object cannot fail.
        let _ = js_sys::Reflect::set(&object, &(*name).into(), value);
    }
    object.unchecked_into()
}
