//! Functions from code: a JavaScript function that is minimised.

use std::{cell::RefCell, sync::Arc};

use js_sys::{Float64Array, Function};
use wasm_bindgen::{JsCast, prelude::*};

use forage::{
    Error, Scene,
    kernel::{
        Message, allowed, error, javascript,
        objective::{Evaluation, Objective, Scratch, SearchBox},
    },
    scene::function::{CodeFault, check_repeatable, from_code, refused_cost},
};

use crate::{js_error, own, read::property, tool::Tool};

struct Code {
    scene: fn(&JsValue) -> Result<Arc<Scene>, JsValue>,
}

static CODE: Tool<Code> = Tool::new("code");

/// Offers functions and planners from code.
pub fn offer_code() {
    CODE.offer(&Code { scene: read_scene });
    own::offer();
}

/// The scene of an object with a function; `None` for another value.
pub(crate) fn scene_of(value: &JsValue) -> Result<Option<Arc<Scene>>, JsValue> {
    let is_code = value.is_object() && [ONE, MANY].iter().any(|name| !property(value, name).is_undefined());
    is_code.then(|| (CODE.get()?.scene)(value)).transpose()
}

/// The property with a function of one position.
const ONE: &str = "objective";
/// The property with a function of many positions at once.
const MANY: &str = "objectives";

thread_local!(static FUNCTIONS: RefCell<Vec<Option<Given>>> = const { RefCell::new(Vec::new()) });

/// A function that was given.
#[derive(Clone)]
struct Given {
    function: Function,
    /// It takes many positions at once.
    many: bool,
    /// What it did wrong last.
    wrong: Option<CodeFault>,
}

/// What a function of JavaScript computes. The function itself stays where values of JavaScript can be.
struct FromCode {
    at: usize,
    search_box: SearchBox,
}

impl FromCode {
    fn given(&self) -> Option<Given> {
        FUNCTIONS.with_borrow(|all| all.get(self.at).cloned().flatten())
    }

    fn note(&self, wrong: CodeFault) {
        FUNCTIONS.with_borrow_mut(|all| {
            if let Some(Some(given)) = all.get_mut(self.at) {
                given.wrong = Some(wrong);
            }
        });
    }

    /// A number that a function gave; NaN of something else.
    fn number(&self, found: &JsValue) -> f64 {
        found.as_f64().unwrap_or_else(|| {
            self.note(CodeFault::NoNumber(shown(found)));
            f64::NAN
        })
    }

    fn threw(&self, error: &JsValue) {
        self.note(CodeFault::Threw(cause(error)));
    }
}

impl Drop for FromCode {
    fn drop(&mut self) {
        FUNCTIONS.with_borrow_mut(|all| all[self.at] = None);
    }
}

impl Objective for FromCode {
    fn search_box(&self) -> &SearchBox {
        &self.search_box
    }

    fn evaluate(&self, x: &[f64], scratch: &mut Scratch) -> Evaluation {
        let mut found = [Evaluation::from(f64::NAN)];
        self.evaluate_all(x, scratch, &mut found);
        found[0]
    }

    fn evaluate_all(&self, xs: &[f64], _scratch: &mut Scratch, out: &mut [Evaluation]) {
        let Some(Given { function, many, .. }) = self.given() else { return };
        let n = self.search_box.dimension();
        if !many {
            for (x, out) in xs.chunks_exact(n).zip(out) {
                let found = function.call1(&JsValue::UNDEFINED, &Float64Array::new_from_slice(x));
                *out = found
                    .map_or_else(
                        |error| {
                            self.threw(&error);
                            f64::NAN
                        },
                        |found| self.number(&found),
                    )
                    .into();
            }
            return;
        }
        out.fill(f64::NAN.into());
        match function.call2(&JsValue::UNDEFINED, &Float64Array::new_from_slice(xs), &JsValue::from(n as u32)) {
            Err(error) => self.threw(&error),
            Ok(found) => {
                let length = property(&found, "length").as_f64();
                if length != Some(out.len() as f64) {
                    let found = length.map_or_else(|| shown(&found), |length| error::list_of(length as usize).to_string());
                    self.note(CodeFault::NoList(found, out.len()));
                    return;
                }
                for (i, out) in out.iter_mut().enumerate() {
                    *out = self.number(&js_sys::Reflect::get_u32(&found, i as u32).unwrap_or_default()).into();
                }
            }
        }
    }

    fn refuses(&self, cost: f64) -> Option<Message> {
        refused_cost(cost, self.given().and_then(|given| given.wrong))
    }
}

fn read_scene(value: &JsValue) -> Result<Arc<Scene>, JsValue> {
    let many = !property(value, MANY).is_undefined();
    let (name, other) = if many { (MANY, ONE) } else { (ONE, MANY) };
    let function = property(value, name);
    let function = function.dyn_into::<Function>().map_err(|other| js_error(Error::refused(name, shown(&other), allowed::function())))?;
    let fields = js_sys::Object::new();
    for key in javascript::keys("scene", value).map_err(js_error)?.iter().filter_map(|key| key.as_string()).filter(|key| key != name) {
        js_sys::Reflect::set(&fields, &key.as_str().into(), &property(value, &key))?;
    }
    if !property(value, other).is_undefined() {
        return Err(js_error(Error::refused(other, shown(&property(value, other)), allowed::nothing())));
    }
    let fields = javascript::read("scene", &fields).map_err(js_error)?;
    let scene = from_code(fields, |search_box| {
        let at = FUNCTIONS.with_borrow_mut(|all| {
            let given = Some(Given { function, many, wrong: None });
            if let Some(at) = all.iter().position(Option::is_none) {
                all[at] = given;
                return at;
            }
            all.push(given);
            all.len() - 1
        });
        let objective = FromCode { at, search_box };
        check_repeatable(name, &objective)?;
        Ok(Arc::new(objective))
    });
    scene.map(Arc::new).map_err(js_error)
}

/// What was thrown, in words.
pub(crate) fn cause(error: &JsValue) -> String {
    error.dyn_ref::<js_sys::Error>().map_or_else(|| shown(error), |error| String::from(error.message()))
}

fn shown(value: &JsValue) -> String {
    if let Some(text) = value.as_string() {
        return format!("\"{text}\"");
    }
    if let Some(flag) = value.as_bool() {
        return flag.to_string();
    }
    if value.is_undefined() || value.is_null() { allowed::nothing().to_string() } else { allowed::object().to_string() }
}
