//! Pictures as SVG.

use wasm_bindgen::prelude::*;

use forage::{kernel::LayerKey, picture, run};

use crate::{
    JsFlag, JsLayerNames, Session,
    read::{read_flag, read_layer, read_list},
    tool::Tool,
};

type Draw = fn(&mut run::Run, bool, &[LayerKey]) -> String;

static PICTURES: Tool<Draw> = Tool::new("pictures");

/// Offers pictures as SVG.
pub fn offer_pictures() {
    const DRAW: Draw = |run, dark, layers| picture::svg(run, dark, layers);
    PICTURES.offer(&DRAW);
}

#[wasm_bindgen]
impl Session {
    /// A picture of the present state with these layers.
    ///
    /// # Errors
    /// For an unknown layer.
    pub fn svg(&mut self, dark: &JsFlag, layers: &JsLayerNames) -> Result<String, JsValue> {
        let dark = read_flag("dark", dark)?;
        let names = read_list("layers", layers)?;
        let layers = names.iter().map(read_layer).collect::<Result<Vec<_>, _>>()?;
        Ok(PICTURES.get()?(&mut self.run, dark, &layers))
    }
}
