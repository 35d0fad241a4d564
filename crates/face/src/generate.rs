//! Random scenes.

use wasm_bindgen::prelude::*;

use crate::{
    JsGiven, JsNumber, JsScene, JsText, js_error, plain,
    read::{read_parameters, read_text, whole},
    registry::registry,
};

/// A random scene: the same for the same parameters and seed.
///
/// # Errors
/// An `Error` with `field`, `value` and `allowed` for whatever is refused.
#[wasm_bindgen(js_name = generateScene)]
pub fn generate_scene(name: &JsText, params: &JsGiven, seed: &JsNumber) -> Result<JsScene, JsValue> {
    let given = read_parameters(params)?;
    plain(&registry().generate(&read_text("name", name)?, &given, whole("seed", seed)?).map_err(js_error)?)
}
