//! Scenes, checked.

use wasm_bindgen::prelude::*;

use crate::{JsScene, plain, read::read_scene};

/// Checks a scene and returns it as it is understood.
///
/// # Errors
/// An `Error` with `field`, `value` and `allowed`.
#[wasm_bindgen(js_name = checkScene)]
pub fn check_scene(scene: &JsScene) -> Result<JsScene, JsValue> {
    plain(&*read_scene(scene)?)
}
