//! What there is.

use js_sys::{Array, Reflect};
use wasm_bindgen::prelude::*;

use crate::{JsCatalogue, plain, registry::registry};

// Of labels only a native program has a list; the package holds what it prints.
#[wasm_bindgen(raw_module = "./symbols.js")]
extern "C" {
    fn symbols() -> Array;
}

/// Every planner with its parameters, the scenes that ship, and the names of layers and shapes.
///
/// # Errors
/// Where a number of it is more than JavaScript can hold.
#[wasm_bindgen]
pub fn catalogue() -> Result<JsCatalogue, JsValue> {
    let catalogue: JsCatalogue = plain(&registry().catalogue())?;
    // Setting a property of an ordinary object cannot fail.
    let _ = Reflect::set(&catalogue, &"symbols".into(), &symbols());
    Ok(catalogue)
}
