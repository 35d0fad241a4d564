//! Pictures as SVG.

use wasm_bindgen::prelude::*;

use forage::picture;

use crate::{
    JsNames, Session,
    read::{read_layer, read_list, read_text},
};

#[wasm_bindgen]
impl Session {
    /// A picture of the present state with these layers.
    ///
    /// # Errors
    /// For an unknown layer.
    pub fn svg(&self, dark: bool, layers: &JsNames) -> Result<String, JsValue> {
        let names = read_list("layers", layers)?;
        let layers = names.iter().map(|name| read_layer(&read_text("layers", name)?)).collect::<Result<Vec<_>, _>>()?;
        Ok(picture::svg(&self.run, dark, &layers))
    }
}
