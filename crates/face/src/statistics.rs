//! What many runs have in common.

use wasm_bindgen::prelude::*;

use forage::{
    Error,
    kernel::{Message, allowed},
    statistics::{self, Group},
};

use crate::{JsComparison, JsGroups, js_error, plain};

/// Summarises groups of runs, and tests whether they differ: what `forage experiment` prints.
///
/// # Errors
/// For anything that is no list of groups, each with a name and its values, and for values that are not finite.
#[wasm_bindgen]
pub fn compare(groups: &JsGroups) -> Result<JsComparison, JsValue> {
    let groups: Vec<Group> = serde_wasm_bindgen::from_value(groups.into())
        .map_err(|problem| js_error(Error::malformed("groups", Message::verbatim(problem.to_string()))))?;
    for (i, group) in groups.iter().enumerate() {
        if let Some((k, value)) =
            group.values.iter().enumerate().find_map(|(k, value)| Some((k, value.filter(|value| !value.is_finite())?)))
        {
            return Err(js_error(Error::refused(format!("groups[{i}].values[{k}]"), value, allowed::group_value())));
        }
    }
    plain(&statistics::compare(&groups))
}
