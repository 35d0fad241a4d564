//! What JavaScript gives, read and checked: every refusal names the field, the value and what is allowed.

use std::{cell::RefCell, sync::Arc};

use wasm_bindgen::{JsCast, JsValue};

use forage::{
    Error, Overrides, Scene, Setup, Value,
    describe::{Rgba, read_color},
    kernel::{Item, LayerKey, Message, SceneKindId, allowed, digits::Digits, javascript, limits},
};

use crate::{JsNumber, JsRamp, code::scene_of, js_error, registry::ask};

/// A value that is not what it must be.
pub(crate) fn refused(field: &str, value: &JsValue, allowed: Message) -> JsValue {
    let shown = match (value.as_string(), value.as_f64(), value.as_bool()) {
        (Some(text), ..) => format!("\"{text}\""),
        (_, Some(number), _) => Digits(number).to_string(),
        (.., Some(flag)) => flag.to_string(),
        _ if value.is_undefined() || value.is_null() => allowed::nothing().to_string(),
        _ => allowed::object().to_string(),
    };
    js_error(Error::refused(field, shown, allowed))
}

/// A property; undefined where there is none.
pub(crate) fn property(object: &JsValue, name: &str) -> JsValue {
    js_sys::Reflect::get(object, &name.into()).unwrap_or_default()
}

pub(crate) fn read_text(field: &str, value: &JsValue) -> Result<String, JsValue> {
    value.as_string().ok_or_else(|| refused(field, value, allowed::text()))
}

pub(crate) fn read_number(field: &str, value: &JsValue) -> Result<f64, JsValue> {
    value.as_f64().ok_or_else(|| refused(field, value, allowed::number()))
}

pub(crate) fn read_flag(field: &str, value: &JsValue) -> Result<bool, JsValue> {
    value.as_bool().ok_or_else(|| refused(field, value, allowed::flag()))
}

pub(crate) fn read_list(field: &str, value: &JsValue) -> Result<Vec<JsValue>, JsValue> {
    let list = javascript::items(field, value).map_err(js_error)?;
    list.map(|list| list.to_vec()).ok_or_else(|| refused(field, value, allowed::list()))
}

pub(crate) fn read_parameter(name: &str, value: &JsValue) -> Result<Value, JsValue> {
    let number = || value.as_f64().map(Value::Number);
    let read = value.as_bool().map(Value::Flag).or_else(number).or_else(|| value.as_string().map(Value::Text));
    read.ok_or_else(|| refused(name, value, allowed::value()))
}

pub(crate) fn read_parameters(value: &JsValue) -> Result<Overrides, JsValue> {
    let mut given = Overrides::new();
    if value.is_undefined() || value.is_null() {
        return Ok(given);
    }
    if !value.is_object() {
        return Err(refused("params", value, allowed::parameters()));
    }
    for name in javascript::keys("params", value).map_err(js_error)?.iter().filter_map(|name| name.as_string()) {
        let value = read_parameter(&name, &property(value, &name))?;
        given.insert(name, value);
    }
    Ok(given)
}

pub(crate) fn read_scene(value: &JsValue) -> Result<Arc<Scene>, JsValue> {
    match value.as_string() {
        Some(name) => ask(|registry| registry.scene(&name)),
        None => match scene_of(value)? {
            Some(scene) => Ok(scene),
            None => same_scene(value),
        },
    }
}

/// The scene of an object. The one that was read last is kept: what follows from a scene, an exact optimum above all, takes
/// longer than to see that it is the same.
fn same_scene(value: &JsValue) -> Result<Arc<Scene>, JsValue> {
    thread_local!(static LAST: RefCell<Option<(String, Arc<Scene>)>> = const { RefCell::new(None) });
    // First: what cannot be read may have the text of what can.
    let read = javascript::read("scene", value).map_err(js_error)?;
    let text = js_sys::JSON::stringify(value).ok().filter(|text| text.is_string()).and_then(|text| text.as_string());
    let last = LAST.with_borrow(|last| last.as_ref().filter(|(known, _)| text.as_ref() == Some(known)).map(|(_, scene)| Arc::clone(scene)));
    if let Some(scene) = last {
        return Ok(scene);
    }
    let scene = Arc::new(ask(|registry| registry.read_scene_value(read.clone()))?);
    LAST.set(text.map(|text| (text, Arc::clone(&scene))));
    Ok(scene)
}

pub(crate) fn read_kind(value: &JsValue) -> Result<SceneKindId, JsValue> {
    let name = read_text("kind", value)?;
    ask(|registry| registry.kind(&name).map(|kind| kind.id))
}

pub(crate) fn read_item(value: &JsValue) -> Result<Item, JsValue> {
    let layer = read_layer(&property(value, "role"))?;
    Ok(Item { layer, index: in_memory(whole("index", &property(value, "index"))?) })
}

pub(crate) fn read_layer(name: &JsValue) -> Result<LayerKey, JsValue> {
    let name = read_text("role", name)?;
    ask(|registry| registry.layer_key(&name))
}

pub(crate) fn read_point(field: &str, value: &JsValue) -> Result<[f64; 2], JsValue> {
    match read_list(field, value)?.as_slice() {
        [x, y] => Ok([read_number(field, x)?, read_number(field, y)?]),
        _ => Err(refused(field, value, allowed::point())),
    }
}

/// Colours from the smallest value to the largest; `None` where they are left out.
pub(crate) fn read_ramp(value: Option<JsRamp>) -> Result<Option<Vec<Rgba>>, JsValue> {
    let Some(value) = value else { return Ok(None) };
    let list = read_list("ramp", &value)?;
    if !(2..=16).contains(&list.len()) {
        return Err(js_error(Error::refused("ramp", list.len(), allowed::colors())));
    }
    let read = |(i, color): (usize, &JsValue)| {
        let known = color.as_string().and_then(|text| read_color(&text));
        known.ok_or_else(|| refused(&format!("ramp[{i}]"), color, allowed::color()))
    };
    list.iter().enumerate().map(read).collect::<Result<_, _>>().map(Some)
}

/// The ends of a job, where it has its own.
pub(crate) fn read_ends(setup: &JsValue) -> Result<Option<[[f64; 2]; 2]>, JsValue> {
    let ends = if setup.is_object() { property(setup, "ends") } else { JsValue::UNDEFINED };
    if ends.is_undefined() {
        return Ok(None);
    }
    match read_list("ends", &ends)?.as_slice() {
        [start, goal] => Ok(Some([read_point("ends[0]", start)?, read_point("ends[1]", goal)?])),
        _ => Err(refused("ends", &ends, allowed::two_points())),
    }
}

/// A whole number that JavaScript holds exactly.
pub(crate) fn whole(field: &str, value: &JsValue) -> Result<u64, JsValue> {
    let number = value.as_f64().filter(|number| (0.0..=limits::WHOLE as f64).contains(number) && number.fract() == 0.0);
    number.map(|number| number as u64).ok_or_else(|| refused(field, value, limits::whole_range()))
}

/// How many of something, or up to which: a whole number, or Infinity for all there are.
pub(crate) fn count(field: &str, value: &JsValue) -> Result<u64, JsValue> {
    if value.as_f64() == Some(f64::INFINITY) { Ok(u64::MAX) } else { whole(field, value) }
}

/// A number of things in memory: where it is more than there can be, the largest there can be.
pub(crate) fn in_memory(number: u64) -> usize {
    usize::try_from(number).unwrap_or(usize::MAX)
}

/// A typed array; `None` for what only calls itself one, whose size cannot be asked for.
pub(crate) fn typed_array<T: JsCast>(value: &JsValue) -> Option<&T> {
    value.dyn_ref().filter(|_| js_sys::ArrayBuffer::is_view(value))
}

/// The same where it may be left out.
pub(crate) fn count_or(field: &str, value: Option<JsNumber>, unless_given: u64) -> Result<u64, JsValue> {
    value.map_or(Ok(unless_given), |value| count(field, &value))
}

/// A setup: planner, scene (or a shipped one's name), parameters and seed.
pub(crate) fn read_setup(setup: &JsValue) -> Result<Setup, JsValue> {
    if !setup.is_object() {
        return Err(refused("setup", setup, allowed::setup()));
    }
    let part = |name| property(setup, name);
    let seed = part("seed");
    let seed = if seed.is_undefined() || seed.is_null() { 1 } else { whole("seed", &seed)? };
    let planner = read_text("planner", &part("planner"))?;
    let params = read_parameters(&part("params"))?;
    Ok(Setup { planner, scene: read_scene(&part("scene"))?, params, seed })
}
