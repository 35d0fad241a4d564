//! Who follows the path that a run found.

use js_sys::Float64Array;
use wasm_bindgen::{JsCast, prelude::*};

use forage::{describe::Extra, params::Object};

use crate::{JsDriveOrNull, JsGiven, JsMotionOrNull, Session, js_error, object, plain, read::read_parameters, registry::ask};

#[wasm_bindgen]
impl Session {
    /// The scene's robot driving along the best path so far; null where it has no outline or there is no path.
    ///
    /// # Errors
    /// An `Error` with `field`, `value` and `allowed` for a parameter that is refused.
    pub fn drive(&self, params: &JsGiven) -> Result<JsDriveOrNull, JsValue> {
        self.follow("drive", params).map(JsCast::unchecked_into)
    }

    /// The scene's arm following the best path so far; null where there is no arm or no path.
    ///
    /// # Errors
    /// An `Error` with `field`, `value` and `allowed` for a parameter that is refused.
    pub fn motion(&self, params: &JsGiven) -> Result<JsMotionOrNull, JsValue> {
        self.follow("motion", params).map(JsCast::unchecked_into)
    }

    fn follow(&self, follower: &str, params: &JsGiven) -> Result<JsValue, JsValue> {
        let overrides = read_parameters(params)?;
        let known = ask(|registry| registry.follower(follower))?;
        let found = self.run.best().map(|best| best.solution);
        let Some(followed) = (known.follow)(self.run.scene(), found.as_ref(), &overrides).map_err(js_error)? else {
            return Ok(JsValue::NULL);
        };
        let mut properties = vec![
            ("columns", plain(&known.columns.iter().map(|column| column.name).collect::<Vec<_>>())?),
            ("rows", Float64Array::from(followed.rows()).into()),
            ("outcome", plain(&&*followed.outcome())?),
            ("parameters", plain(&Object(followed.parameters().all()))?),
        ];
        for (name, extra) in followed.extra() {
            let value = match extra {
                Extra::Rows(rows) => Float64Array::from(rows).into(),
                Extra::Named(numbers) => plain(&Object(&numbers))?,
            };
            properties.push((name, value));
        }
        Ok(object(&properties))
    }
}
