//! Pictures as SVG.

use wasm_bindgen::prelude::*;

use forage::picture;

use crate::{
    JsFlag, JsNames, Session,
    read::{read_flag, read_layer, read_list},
};

#[wasm_bindgen]
impl Session {
    /// A picture of the present state with these layers.
    ///
    /// # Errors
    /// For an unknown layer.
    pub fn svg(&self, dark: &JsFlag, layers: &JsNames) -> Result<String, JsValue> {
        let dark = read_flag("dark", dark)?;
        let names = read_list("layers", layers)?;
        let layers = names.iter().map(read_layer).collect::<Result<Vec<_>, _>>()?;
        Ok(picture::svg(&self.run, dark, &layers))
    }
}
