//! Planners in JavaScript. What their code does is called through an object of functions, which the package makes of it; here are the
//! runs, and what is lent to the code.

use std::{cell::RefCell, sync::Arc};

use js_sys::{Array, Float64Array, Function, Reflect, Uint32Array};
use wasm_bindgen::{JsCast, prelude::*};

use forage::{
    Error,
    describe::{Entry, Start},
    kernel::{Candidate, Inspection, Item, Message, Shape, Started, javascript},
    params::Object,
};
use forage_script::{self as script, Advanced, Call, Drawn, Script, Tools};

use crate::{code::cause, js_error, plain, registry::know_own, tool::Tool};

struct Own {
    register: fn(&JsValue, &JsValue) -> Result<(), JsValue>,
    scalar: fn(u32, f64, f64) -> Result<f64, JsValue>,
    list: fn(u32, &[f64]) -> Result<f64, JsValue>,
}

static OWN: Tool<Own> = Tool::new("code");

/// Offers planners in JavaScript.
pub(crate) fn offer() {
    OWN.offer(&Own { register, scalar, list });
}

/// Adds a planner: what it says of itself, and the functions that its code is called by.
///
/// # Errors
/// An `Error` with the field that is wrong.
#[wasm_bindgen(js_name = registerPlanner, skip_typescript)]
pub fn register_planner(description: &JsValue, host: &JsValue) -> Result<(), JsValue> {
    (OWN.get()?.register)(description, host)
}

/// Of what is lent to the code of a planner, by number: what takes up to two numbers.
///
/// # Errors
/// An `Error` for what is refused, and where nothing is lent.
#[wasm_bindgen(skip_typescript)]
pub fn lent(what: u32, a: f64, b: f64) -> Result<f64, JsValue> {
    (OWN.get()?.scalar)(what, a, b)
}

/// The same of what takes a list.
///
/// # Errors
/// As `lent`.
#[wasm_bindgen(js_name = lentList, skip_typescript)]
pub fn lent_list(what: u32, numbers: &[f64]) -> Result<f64, JsValue> {
    (OWN.get()?.list)(what, numbers)
}

thread_local! {
    /// Planners that were given, and the functions that their code is called by.
    static SCRIPTS: RefCell<Vec<(&'static Entry, JsValue)>> = const { RefCell::new(Vec::new()) };
    /// What is lent to the calls under way, the last one last; none while it is in use.
    static LENT: RefCell<Vec<Option<Tools>>> = const { RefCell::new(Vec::new()) };
}

fn register(description: &JsValue, host: &JsValue) -> Result<(), JsValue> {
    let description = javascript::read("planner", description).map_err(js_error)?;
    let entry = script::entry(&description, start).map_err(js_error)?;
    SCRIPTS.with_borrow_mut(|all| all.push((entry, host.clone())));
    know_own(entry);
    Ok(())
}

/// A run goes on with its code when another one of its planner's name has come: the entry says which one it is.
fn start(start: &Start) -> Result<Started, Error> {
    let at = SCRIPTS.with_borrow(|all| all.iter().position(|(entry, _)| std::ptr::eq(*entry, start.entry)));
    let Some(at) = at else { return Err(Error::unknown("planner", start.entry.name, [])) };
    let script: Arc<dyn Script> = Arc::new(FromScript { at });
    script::begin(&script, start.entry, start)
}

/// Uses what is lent to the call under way. It is taken meanwhile: a function that is minimised may be code as well.
fn with_tools(work: &dyn Fn(&mut Tools) -> Result<f64, Error>) -> Result<f64, JsValue> {
    let tools = LENT.with_borrow_mut(|lent| lent.last_mut().and_then(Option::take));
    let Some(mut tools) = tools else { return Err(js_error(script::not_lent())) };
    let result = work(&mut tools);
    LENT.with_borrow_mut(|lent| {
        if let Some(last) = lent.last_mut() {
            *last = Some(tools);
        }
    });
    result.map_err(js_error)
}

fn scalar(what: u32, a: f64, b: f64) -> Result<f64, JsValue> {
    match script::mathematics(what, a, b) {
        Some(found) => Ok(found),
        None => with_tools(&|tools| tools.scalar(what, a, b)),
    }
}

fn list(what: u32, numbers: &[f64]) -> Result<f64, JsValue> {
    with_tools(&|tools| tools.list(what, numbers))
}

/// A planner by its place among those that were given.
struct FromScript {
    at: usize,
}

impl FromScript {
    fn call(&self, name: &str, arguments: &[JsValue]) -> Result<JsValue, Message> {
        let host = SCRIPTS.with_borrow(|all| all[self.at].1.clone());
        let arguments: Array = arguments.iter().collect();
        let function = Reflect::get(&host, &name.into()).map(JsCast::unchecked_into::<Function>);
        function.and_then(|function| Reflect::apply(&function, &host, &arguments)).map_err(|error| script::threw(&cause(&error)))
    }

    fn lending<T>(&self, tools: Tools, name: &str, arguments: &[JsValue], read: impl Fn(f64) -> T) -> Call<T> {
        LENT.with_borrow_mut(|lent| lent.push(Some(tools)));
        let result = self.call(name, arguments);
        let tools = LENT.with_borrow_mut(Vec::pop).flatten();
        Call { tools, result: result.map(|found| read(found.as_f64().unwrap_or(f64::NAN))) }
    }

    fn number(&self, name: &str, state: u32) -> f64 {
        self.call(name, &[state.into()]).ok().and_then(|found| found.as_f64()).unwrap_or(0.0)
    }
}

/// An item of a list.
fn item(list: &JsValue, at: u32) -> JsValue {
    Reflect::get_u32(list, at).unwrap_or_default()
}

impl Script for FromScript {
    fn start(&self, start: &Start, tools: Tools) -> Call<u32> {
        let scene = plain::<JsValue>(&**start.scene).unwrap_or_default();
        let parameters = plain::<JsValue>(&Object(start.parameters.all())).unwrap_or_default();
        let sides = tools.objective().map(|objective| {
            let search_box = objective.search_box();
            [search_box.low(), search_box.high()].map(|side| JsValue::from(Float64Array::new_from_slice(side)))
        });
        let [low, high] = sides.unwrap_or_default();
        self.lending(tools, "start", &[scene, parameters, (start.seed as f64).into(), low, high], |state| state as u32)
    }

    fn advance(&self, state: u32, tools: Tools) -> Call<Advanced> {
        // One that is done says so by its sign.
        self.lending(tools, "advance", &[state.into()], |found| Advanced { state: found.abs() as u32, done: found.is_sign_negative() })
    }

    fn best(&self, state: u32) -> Result<Option<Candidate>, Message> {
        let found = self.call("best", &[state.into()])?;
        if found.is_null() {
            return Ok(None);
        }
        let [cost, kind] = [0, 1].map(|at| item(&found, at).as_f64().unwrap_or(f64::NAN));
        Ok(Some(script::candidate(cost, kind as u32, Float64Array::new(&item(&found, 2)).to_vec())))
    }

    fn readings(&self, state: u32) -> Result<Vec<f64>, Message> {
        Ok(Float64Array::new(&self.call("readings", &[state.into()])?).to_vec())
    }

    fn draw(&self, state: u32) -> Vec<Drawn> {
        let Ok(found) = self.call("draw", &[state.into()]) else { return Vec::new() };
        let piece = |piece: JsValue| {
            let shape = item(&piece, 1).as_string()?;
            let shape = Shape::ALL.into_iter().find(|known| known.name() == shape)?;
            let vertices = Float64Array::new(&item(&piece, 2)).to_vec().as_chunks::<3>().0.to_vec();
            Some(Drawn { layer: item(&piece, 0).as_f64()? as usize, shape, vertices })
        };
        found.unchecked_into::<Array>().iter().filter_map(piece).collect()
    }

    fn explain(&self, state: u32, of: Item) -> Option<Inspection> {
        let found = self.call("explain", &[state.into(), of.layer.0.into(), (of.index as f64).into()]).ok()?;
        let [title, summary] = [item(&found, 0).as_string()?, item(&found, 1).as_string()?];
        let values: Array = item(&found, 2).unchecked_into();
        let value = |value: JsValue| Some((item(&value, 0).as_string()?, item(&value, 1).as_f64()?));
        Some(script::inspection(of, title, summary, values.iter().filter_map(value).collect()))
    }

    fn copy(&self, state: u32) -> u32 {
        self.number("copy", state) as u32
    }

    fn forget(&self, state: u32) {
        let _ = self.call("forget", &[state.into()]);
    }

    fn digest(&self, state: u32) -> u64 {
        let Ok(found) = self.call("digest", &[state.into()]) else { return 0 };
        let [high, low] = [0, 1].map(|at| u64::from(Uint32Array::new(&found).get_index(at)));
        high << 32 | low
    }

    fn size(&self, state: u32) -> usize {
        self.number("size", state) as usize
    }
}
