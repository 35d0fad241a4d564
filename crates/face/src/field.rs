//! A function's heights on a canvas.

use wasm_bindgen::{JsCast, prelude::*};
use web_sys::{ImageData, OffscreenCanvasRenderingContext2d};

use forage::{describe::layers::HEIGHTS, geometry::Bounds, kernel::allowed, picture};

use crate::{
    JsContext, JsPoint, JsRamp, Session,
    read::{property, read_point, read_ramp, refused},
};

/// The largest canvas that a field is painted on: its heights take 8 bytes a pixel.
const MOST_PIXELS: f64 = 16_777_216.0;

#[wasm_bindgen]
impl Session {
    /// Fills a canvas with the scene's heights over a part of the plane; false if the scene has none. Without a ramp it has the
    /// catalogue's colours on a light ground.
    ///
    /// # Errors
    /// For what is no such context or no ramp, and when the canvas refuses the pixels.
    #[wasm_bindgen(js_name = paintField)]
    pub fn paint_field(&mut self, ctx: &JsContext, min: &JsPoint, max: &JsPoint, ramp: Option<JsRamp>) -> Result<bool, JsValue> {
        let view = Bounds { min: read_point("min", min)?, max: read_point("max", max)? };
        let colors = read_ramp(ramp)?.unwrap_or_else(|| HEIGHTS.map(|color| color.on(false)).to_vec());
        // Not the canvas's own getters: what only calls itself a context throws there.
        let side = |name| property(&property(ctx, "canvas"), name).as_f64().unwrap_or(f64::NAN);
        let (width, height) = (side("width"), side("height"));
        let known = ctx.dyn_ref().filter(|_| width * height <= MOST_PIXELS);
        let ctx: &OffscreenCanvasRenderingContext2d = known.ok_or_else(|| refused("ctx", ctx, allowed::canvas()))?;
        let (width, height) = (width as u32, height as u32);
        let Some(map) = picture::heat_map(self.run.scene(), view, width as usize, height as usize, &colors) else {
            return Ok(false);
        };
        let image = ImageData::new_with_u8_clamped_array_and_sh(wasm_bindgen::Clamped(&map.pixels), width, height)?;
        ctx.put_image_data(&image, 0.0, 0.0)?;
        self.heights = Some(map.heights);
        Ok(true)
    }

    /// The values of the first, the middle and the last colour that `paintField` painted last; undefined before.
    #[wasm_bindgen(getter, unchecked_return_type = "Float64Array | undefined")]
    pub fn heights(&self) -> Option<Box<[f64]>> {
        self.heights.map(|heights| heights.as_slice().into())
    }
}
