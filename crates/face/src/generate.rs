//! Random scenes.

use wasm_bindgen::prelude::*;

use crate::{
    JsGeneratorName, JsGiven, JsNumber, JsScene, plain,
    read::{read_parameters, read_text, whole},
    registry::ask,
};

/// A random scene: the same for the same parameters and seed.
///
/// # Errors
/// An `Error` with `field`, `value` and `allowed` for whatever is refused.
#[wasm_bindgen(js_name = generateScene)]
pub fn generate_scene(name: &JsGeneratorName, params: &JsGiven, seed: &JsNumber) -> Result<JsScene, JsValue> {
    let given = read_parameters(params)?;
    let (name, seed) = (read_text("name", name)?, whole("seed", seed)?);
    plain(&ask(|registry| registry.generate(&name, &given, seed))?)
}
