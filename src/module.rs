//! The wasm module that ships: the JavaScript face with everything there is. Without the feature `standard` this crate has the
//! face alone, for a module that lists less, or more.

use wasm_bindgen::prelude::wasm_bindgen;

use crate::{Registry, wasm};

#[wasm_bindgen(start)]
fn start() {
    wasm::know(Registry::standard());
}
