//! What many runs have in common.

use wasm_bindgen::prelude::*;

use forage::{
    kernel::allowed,
    statistics::{self, Group},
};

use crate::{
    JsComparison, JsGroups, plain,
    read::{property, read_list, read_text, refused},
    tool::Tool,
};

type Compare = fn(&[Group]) -> Result<JsComparison, JsValue>;

static STATISTICS: Tool<Compare> = Tool::new("statistics");

/// Offers the statistics of many runs.
pub fn offer_statistics() {
    const COMPARE: Compare = |groups| plain(&statistics::compare(groups));
    STATISTICS.offer(&COMPARE);
}

/// Summarises groups of runs, and tests whether they differ: what `forage experiment` prints.
///
/// # Errors
/// For anything that is no list of groups, each with a name and its values, and for values that are not finite.
#[wasm_bindgen]
pub fn compare(groups: &JsGroups) -> Result<JsComparison, JsValue> {
    let groups = read_list("groups", groups)?;
    let groups = groups.iter().enumerate().map(|(i, group)| read_group(&format!("groups[{i}]"), group)).collect::<Result<Vec<_>, _>>()?;
    STATISTICS.get()?(&groups)
}

fn read_group(place: &str, group: &JsValue) -> Result<Group, JsValue> {
    let name = read_text(&format!("{place}.name"), &property(group, "name"))?;
    let values = read_list(&format!("{place}.values"), &property(group, "values"))?;
    let values = values.iter().enumerate().map(|(k, value)| match value.as_f64() {
        Some(number) if number.is_finite() => Ok(Some(number)),
        None if value.is_null() || value.is_undefined() => Ok(None),
        _ => Err(refused(&format!("{place}.values[{k}]"), value, allowed::group_value())),
    });
    Ok(Group { name, values: values.collect::<Result<_, _>>()? })
}
