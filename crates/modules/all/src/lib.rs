//! The WebAssembly module with all that ships.
#![cfg(target_arch = "wasm32")]

use forage::Registry;
use wasm_bindgen::prelude::wasm_bindgen;

#[wasm_bindgen(start)]
fn start() {
    forage_face::know(Registry::standard());
}
