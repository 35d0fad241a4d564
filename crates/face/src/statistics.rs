//! What many runs have in common.

use js_sys::Float64Array;
use wasm_bindgen::prelude::*;

use forage::{
    kernel::allowed,
    statistics::{self, Curve, Group},
};

use crate::{
    JsBands, JsComparison, JsCurves, JsGroups, JsNumbers, JsReached, JsReachedRuns, js_error, plain,
    read::{property, read_flag, read_list, read_text, refused, typed_array},
    tool::Tool,
};

struct Statistics {
    compare: fn(&JsValue) -> Result<JsComparison, JsValue>,
    bands: fn(&JsValue, &JsValue) -> Result<JsBands, JsValue>,
    reached: fn(&JsValue, &JsValue) -> Result<JsReached, JsValue>,
}

static STATISTICS: Tool<Statistics> = Tool::new("statistics");

/// Offers the statistics of many runs.
pub fn offer_statistics() {
    STATISTICS.offer(&Statistics {
        compare: |groups| plain(&statistics::compare(&each("groups", groups, read_group)?)),
        bands: |groups, ends| {
            let groups = each("groups", groups, |place, group| each(place, group, read_curve))?;
            plain(&statistics::bands(&groups, &numbers("ends", ends)?).map_err(js_error)?)
        },
        reached: |runs, spent| {
            let spent = if spent.is_undefined() { None } else { Some(numbers("spent", spent)?) };
            plain(&statistics::reached(&results("runs", runs)?, spent.as_deref()).map_err(js_error)?)
        },
    });
}

/// Summarises groups of runs, and tests whether they differ: what `forage experiment` prints. Groups that are `deterministic` take no part
/// in tests.
///
/// # Errors
/// For anything that is no list of groups, each with a name and its values, and for values that are not finite.
#[wasm_bindgen]
pub fn compare(groups: &JsGroups) -> Result<JsComparison, JsValue> {
    (STATISTICS.get()?.compare)(groups)
}

/// Quartiles of the best values of groups of runs over evaluations: of each group the curves of its runs, as `curve()` gives them, and
/// after how many evaluations its longest run ended.
///
/// # Errors
/// For anything that is no list of lists of curves, for numbers that are not finite, for evaluations that are not in order, and for lists
/// of different lengths where each number belongs to one of the other list.
#[wasm_bindgen]
pub fn bands(groups: &JsCurves, ends: &JsNumbers) -> Result<JsBands, JsValue> {
    (STATISTICS.get()?.bands)(groups, ends)
}

/// Which share of runs had come near enough to the optimum after so many evaluations: of each run the `reached` of its record. `spent`: how
/// many evaluations each took in all, for the expected running time.
///
/// # Errors
/// For anything that is no list of finite numbers and null, and for lists of different lengths.
#[wasm_bindgen]
pub fn reached(runs: &JsReachedRuns, spent: Option<JsNumbers>) -> Result<JsReached, JsValue> {
    (STATISTICS.get()?.reached)(runs, &spent.map_or(JsValue::UNDEFINED, Into::into))
}

/// Reads each item of a list; `read` gets the item's path, e.g. `groups[2]`.
fn each<T>(field: &str, list: &JsValue, read: impl Fn(&str, &JsValue) -> Result<T, JsValue>) -> Result<Vec<T>, JsValue> {
    read_list(field, list)?.iter().enumerate().map(|(k, item)| read(&format!("{field}[{k}]"), item)).collect()
}

/// Finite numbers, and null for runs that failed.
fn results(field: &str, list: &JsValue) -> Result<Vec<Option<f64>>, JsValue> {
    each(field, list, |place, value| match value.as_f64() {
        Some(number) if number.is_finite() => Ok(Some(number)),
        None if value.is_null() || value.is_undefined() => Ok(None),
        _ => Err(refused(place, value, allowed::group_value())),
    })
}

/// Finite numbers.
fn numbers(field: &str, list: &JsValue) -> Result<Vec<f64>, JsValue> {
    if let Some(list) = typed_array::<Float64Array>(list).map(Float64Array::to_vec).filter(|list| list.iter().all(|x| x.is_finite())) {
        return Ok(list);
    }
    let found = results(field, list)?;
    match found.iter().position(Option::is_none) {
        Some(at) => Err(refused(&format!("{field}[{at}]"), &JsValue::NULL, allowed::number())),
        None => Ok(found.into_iter().flatten().collect()),
    }
}

fn read_group(place: &str, group: &JsValue) -> Result<Group, JsValue> {
    let name = read_text(&format!("{place}.name"), &property(group, "name"))?;
    let values = results(&format!("{place}.values"), &property(group, "values"))?;
    let deterministic = property(group, "deterministic");
    let deterministic = !deterministic.is_undefined() && read_flag(&format!("{place}.deterministic"), &deterministic)?;
    Ok(Group { name, values, deterministic })
}

fn read_curve(place: &str, curve: &JsValue) -> Result<Curve, JsValue> {
    let column = |name| numbers(&format!("{place}.{name}"), &property(curve, name));
    Ok(Curve { evaluations: column("evaluations")?, values: column("values")? })
}
