//! The JavaScript face: what a WebAssembly module offers, whatever its registry lists. A module is a crate that calls `know`:
//!
//! ```ignore
//! #[wasm_bindgen(start)]
//! fn start() {
//!     forage_face::know(0, |registry| registry.with(&discs::KIND).with(&pso::ENTRY));
//! }
//! ```
//!
//! Plain objects in and out; typed arrays for numbers; errors as `Error` with the native message and the fields
//! `field`, `value` and `allowed`. Nothing panics across this boundary on any input.
//!
//! `types` names what crosses the boundary, `read` checks what comes in, this file does the work of a run. What few runs need is
//! a tool: the linker keeps everything that is exported, so an export only passes on to what a module has offered
//! (`offer_arm`, `offer_code`, `offer_files`, `offer_links`, `offer_pictures`, `offer_statistics`).
#![cfg(target_arch = "wasm32")]

mod arm;
mod code;
mod convert;
mod field;
mod files;
mod follow;
mod generate;
mod links;
mod own;
mod pictures;
mod read;
mod registry;
mod scenes;
mod statistics;
mod tool;
mod trial;
mod types;
mod words;

use std::sync::Arc;

use js_sys::{Float32Array, Float64Array, Uint8ClampedArray, Uint32Array};
use wasm_bindgen::{JsCast, prelude::*};
use web_sys::ImageData;

use forage::{
    Error, Frame,
    geometry::Bounds,
    kernel::{Status, Stepped, SubtaskResult, allowed, javascript, rng},
    params::Object,
    picture, run,
};

pub use arm::{arm_pose, arm_solutions, offer_arm, reachability};
pub use code::offer_code;
pub use files::{export_scene, import_scene, offer_files};
pub use generate::generate_scene;
pub use links::{offer_links, parse_link};
pub use own::{lent, lent_list, register_planner};
pub use pictures::offer_pictures;
pub use registry::{Entries, add_scenes, know};
pub use scenes::check_scene;
pub use statistics::{bands, compare, offer_statistics, reached};
pub use trial::Trial;
pub use types::*;

use convert::{js_error, object, plain};
use read::{
    count, count_or, in_memory, read_ends, read_item, read_kind, read_layer, read_number, read_parameter, read_point, read_ramp,
    read_setup, read_text,
};
use registry::ask;

fn status(status: Status) -> Result<JsStatus, JsValue> {
    plain(&status)
}

/// Up to `n` steps by `part`; it leaves off within one that is long.
fn advance(n: Option<JsNumber>, part: impl FnMut() -> Stepped) -> Result<Stepped, JsValue> {
    match count_or("n", n, 1)? {
        0 => Err(js_error(Error::refused("n", 0_u64, allowed::steps()))),
        n => Ok(Stepped::repeat(n, part)),
    }
}

/// What such steps have led to.
fn advanced(stepped: Stepped, now: Status) -> Result<JsAdvanced, JsValue> {
    match stepped {
        Stepped::Partly => Ok(JsValue::from("partly").unchecked_into()),
        Stepped::Whole | Stepped::Not => plain(&now),
    }
}

/// Checks one parameter's value by itself, whatever the other parameters are.
///
/// # Errors
/// An `Error` with `field`, `value` and `allowed`.
#[wasm_bindgen(js_name = checkParameter)]
pub fn check_parameter(planner: &JsPlannerName, kind: &JsKind, name: &JsText, value: &JsParameterValue) -> Result<(), JsValue> {
    let planner = read_text("planner", planner)?;
    let entry = ask(|registry| registry.planner(&planner))?;
    let (kind, name) = (read_kind(kind)?, &*read_text("name", name)?);
    let known = || entry.parameters_on(kind);
    let parameter = known().find(|p| p.name == name).ok_or_else(|| js_error(Error::unknown("parameter", name, known().map(|p| p.name))))?;
    parameter.check(&read_parameter(name, value)?).map_err(js_error)
}

/// The sizes that the planner's paper recommends for a setup; null where it says nothing.
///
/// # Errors
/// As the constructor of `Session`.
#[wasm_bindgen]
pub fn suggest(setup: &JsSetup) -> Result<JsSuggestionOrNull, JsValue> {
    let setup = read_setup(setup)?;
    plain(&ask(|registry| setup.suggest(registry))?)
}

/// Carries out a run that a planner of planners needs (`Session.jobs`), to its end: the job and the scene it belongs to.
///
/// # Errors
/// As the constructor of `Session`.
#[wasm_bindgen(js_name = carryOut)]
pub fn run_to_end(setup: &JsRun) -> Result<JsFinding, JsValue> {
    let ends = read_ends(setup)?;
    let mut setup = read_setup(setup)?;
    if let Some(ends) = ends {
        setup.scene = Arc::new(setup.scene.between(ends).map_err(js_error)?);
    }
    plain(&ask(|registry| run::run_to_end(registry, setup.clone()))?)
}

/// What a method throws of an object that is freed, or that was `reset` away; the package's glue calls it.
#[wasm_bindgen(skip_typescript)]
pub fn freed(name: &str, reset: bool) -> JsValue {
    let (value, allowed) = if reset { (allowed::before_reset(), allowed::after_reset()) } else { (allowed::freed(), allowed::not_freed()) };
    js_error(Error::refused(name, value, allowed))
}

/// A fresh seed from the system.
///
/// # Errors
/// When the system gives no randomness.
#[wasm_bindgen(js_name = newSeed)]
pub fn new_seed() -> Result<f64, JsValue> {
    rng::fresh_seed().map(|seed| seed as f64).map_err(js_error)
}

/// One run: a scene, a planner with parameters and a seed, stepped, rewound, judged and shared.
#[wasm_bindgen]
pub struct Session {
    run: run::Run,
    frame: Frame,
    /// The names of the frame's layers.
    layers: JsValue,
    /// Of the last heat map: see `heights`.
    heights: Option<[f64; 3]>,
}

#[wasm_bindgen]
impl Session {
    /// Starts a run at iteration 0.
    ///
    /// # Errors
    /// An `Error` with `field`, `value` and `allowed` for whatever is refused.
    #[wasm_bindgen(constructor)]
    pub fn new(setup: &JsSetup) -> Result<Session, JsValue> {
        let setup = read_setup(setup)?;
        ask(|registry| run::Run::new(registry, setup.clone())).map(Session::of)
    }

    fn of(run: run::Run) -> Self {
        let layers: js_sys::Array = run.entry().drawn_and_marked().0.iter().map(|layer| JsValue::from(layer.key.0)).collect();
        Self { run, frame: Frame::default(), layers: layers.into(), heights: None }
    }

    /// Takes up to `n` steps, one unless given; stops where the planner does. Infinity: to the end.
    ///
    /// # Errors
    /// For an `n` that is no whole number.
    pub fn step(&mut self, n: Option<JsNumber>) -> Result<JsStatus, JsValue> {
        status(self.run.step(count_or("n", n, 1)?))
    }

    /// Takes up to `n` steps, one unless given, but leaves off within one that is long: `partly` means that it is to be called again
    /// for the rest of that step. In between other things can be done, and iteration and status are those before the step. Whole steps
    /// have the same result.
    ///
    /// # Errors
    /// For an `n` that is no whole number from 1 on.
    pub fn advance(&mut self, n: Option<JsNumber>) -> Result<JsAdvanced, JsValue> {
        let stepped = advance(n, || self.run.part())?;
        advanced(stepped, self.run.status())
    }

    /// Whether a step has begun and is not over. What is drawn and read then is what the planner has so far within it.
    #[wasm_bindgen(getter)]
    pub fn partly(&self) -> bool {
        self.run.is_partly()
    }

    /// Takes steps until so many candidates are evaluated, or up to `n` of them; stops where the planner does.
    ///
    /// # Errors
    /// For numbers that are not whole.
    #[wasm_bindgen(js_name = stepTo)]
    pub fn step_to(&mut self, evaluations: &JsNumber, n: Option<JsNumber>) -> Result<JsStatus, JsValue> {
        let evaluations = count("evaluations", evaluations)?;
        status(self.run.step_to(evaluations, count_or("n", n, u64::MAX)?))
    }

    /// Goes to iteration `k`, forward or back, exactly. Infinity: to the end.
    ///
    /// # Errors
    /// For a `k` that is no whole number.
    pub fn seek(&mut self, k: &JsNumber) -> Result<JsStatus, JsValue> {
        status(self.run.seek(count("k", k)?))
    }

    /// Jumps to the latest state at or before `k` that is at hand; returns its iteration. `step` goes the rest of the way.
    ///
    /// # Errors
    /// For a `k` that is no whole number.
    pub fn rewind(&mut self, k: &JsNumber) -> Result<f64, JsValue> {
        Ok(self.run.rewind(count("k", k)?) as f64)
    }

    /// How many iterations were taken to come here.
    #[wasm_bindgen(getter)]
    pub fn iteration(&self) -> f64 {
        self.run.iteration() as f64
    }

    /// Candidate solutions evaluated so far: what planners are compared by.
    #[wasm_bindgen(getter)]
    pub fn evaluations(&self) -> f64 {
        self.run.evaluations() as f64
    }

    /// The iteration at which the run ends at the latest.
    #[wasm_bindgen(getter)]
    pub fn limit(&self) -> f64 {
        self.run.limit() as f64
    }

    /// The last iteration, as soon as it is known: of runs that may be over before their limit, once they came to their end.
    #[wasm_bindgen(getter)]
    pub fn end(&self) -> Option<f64> {
        self.run.end().map(|end| end as f64)
    }

    /// Whether there is more to do, or why not.
    ///
    /// # Errors
    /// Where a number of it is more than JavaScript can hold.
    #[wasm_bindgen(getter)]
    pub fn status(&self) -> Result<JsStatus, JsValue> {
        status(self.run.status())
    }

    /// The planner's name.
    #[wasm_bindgen(getter, unchecked_return_type = "PlannerName")]
    pub fn planner(&self) -> String {
        self.run.entry().name.to_owned()
    }

    /// The seed.
    #[wasm_bindgen(getter)]
    pub fn seed(&self) -> f64 {
        self.run.seed() as f64
    }

    /// The scene, as it is understood.
    ///
    /// # Errors
    /// Where a number of it is more than JavaScript can hold.
    #[wasm_bindgen(getter)]
    pub fn scene(&self) -> Result<JsScene, JsValue> {
        plain(&**self.run.scene())
    }

    /// Every parameter's value.
    ///
    /// # Errors
    /// Where a number of it is more than JavaScript can hold.
    #[wasm_bindgen(getter)]
    pub fn parameters(&self) -> Result<JsParameters, JsValue> {
        plain(&Object(self.run.parameters().all()))
    }

    /// The values of the feasible best whenever it changed, up to the furthest iteration. From the first call on it grows with each step;
    /// what was before takes a replay.
    pub fn curve(&mut self) -> JsTrialCurve {
        trial::curve_of(&mut self.run)
    }

    /// The numbers of this iteration, by name.
    ///
    /// # Errors
    /// Where a number of it is more than JavaScript can hold.
    pub fn readings(&mut self) -> Result<JsReadings, JsValue> {
        plain(&Object(&self.run.readings().iter().filter(|(_, value)| value.is_finite()).collect::<Vec<_>>()))
    }

    /// The kept readings of iterations after `after` (all of them for −1).
    ///
    /// # Errors
    /// For an `after` that is no whole number.
    pub fn trace(&self, after: &JsNumber) -> Result<JsTrace, JsValue> {
        let trace = self.run.trace();
        let after = if after.as_f64() == Some(-1.0) { None } else { Some(count("after", after)?) };
        let (iterations, rows) = trace.since(after);
        let iterations: Vec<f64> = iterations.iter().map(|&k| k as f64).collect();
        Ok(object(&[
            ("columns", plain(&trace.columns())?),
            ("iterations", Float64Array::from(iterations.as_slice()).into()),
            ("rows", Float64Array::from(rows).into()),
        ]))
    }

    /// Which part of the plane is looked at: layers that are only worth drawing from near are drawn for it. Undefined: all.
    ///
    /// # Errors
    /// For corners that are no points.
    #[wasm_bindgen(js_name = lookAt)]
    pub fn look_at(&mut self, min: &JsPointOrUndefined, max: &JsPointOrUndefined) -> Result<(), JsValue> {
        let window = if min.is_undefined() { None } else { Some(Bounds { min: read_point("min", min)?, max: read_point("max", max)? }) };
        self.frame.look_at(window);
        Ok(())
    }

    /// A field of the frame that was drawn last, coloured: pheromone, settled cells; null if this layer has none. Without a ramp it has
    /// the layer's colours on a light ground.
    ///
    /// # Errors
    /// For an unknown layer, for what is no ramp, or when there is no `ImageData` here.
    #[wasm_bindgen(js_name = layerImage)]
    pub fn layer_image(&self, role: &JsLayerName, ramp: Option<JsRamp>) -> Result<JsLayerImageOrNull, JsValue> {
        let colors = read_ramp(ramp)?;
        let layer = self.run.entry().layer(read_layer(role)?);
        let drawn = layer.and_then(|layer| {
            let colors = colors.or_else(|| layer.look.ramp.map(|ramp| ramp.on(false).to_vec()))?;
            picture::raster(&self.frame, layer, &colors)
        });
        let Some(raster) = drawn else {
            return Ok(JsValue::NULL.unchecked_into());
        };
        let (width, height) = (raster.width as u32, raster.height as u32);
        // A copy: an `ImageData` of a slice would show memory that is freed when this returns.
        let pixels = Uint8ClampedArray::from(&raster.pixels[..]);
        let image = ImageData::new_with_js_u8_clamped_array_and_sh(&pixels, width, height)?;
        Ok(object(&[
            ("image", image.into()),
            ("min", plain(&raster.bounds.min)?),
            ("max", plain(&raster.bounds.max)?),
            ("range", plain(&raster.range)?),
        ]))
    }

    /// The runs of other planners, on this scene, that the next step needs; none for most planners. Carry them out with
    /// `carryOut`, in workers if you like, and `supply` what they found; a step without that carries them out itself.
    ///
    /// # Errors
    /// Where a number of it is more than JavaScript can hold.
    pub fn jobs(&mut self) -> Result<JsJobs, JsValue> {
        plain(&self.run.subtasks())
    }

    /// Takes what the runs of `jobs` found, in their order.
    ///
    /// # Errors
    /// For anything that is no list of as many findings, for numbers that are not finite and paths that leave the scene.
    pub fn supply(&mut self, findings: &JsFindings) -> Result<(), JsValue> {
        let read = javascript::read("findings", findings).and_then(|found| SubtaskResult::read_list("findings", found));
        read.and_then(|found| self.run.provide(found)).map_err(js_error)
    }

    /// The parts of the run that have their own kind of step, in their order; empty for most planners.
    ///
    /// # Errors
    /// Where a number of it is more than JavaScript can hold.
    #[wasm_bindgen(getter)]
    pub fn stages(&self) -> Result<JsStages, JsValue> {
        plain(&self.run.stages())
    }

    /// What happened so far in simulated time, and what was decided and why, in the order of time; empty for most planners.
    /// `from`: without so many of the first.
    ///
    /// # Errors
    /// For a `from` that is no whole number.
    pub fn events(&self, from: Option<JsNumber>) -> Result<JsEvents, JsValue> {
        let events = self.run.events();
        plain(&&events[events.len().min(in_memory(count_or("from", from, 0)?))..])
    }

    /// The numbers of those that search side by side, row by row; the columns are the planner's `members`.
    pub fn members(&self) -> Float64Array {
        let mut rows = Vec::new();
        self.run.members(&mut rows);
        Float64Array::from(rows.as_slice())
    }

    /// Draws the present state; the arrays are views into the wasm memory, valid until the next call of anything here.
    ///
    /// # Errors
    /// For a budget that is no whole number.
    #[expect(unsafe_code, reason = "a view must not outlive the next call; the types say so, and the worker copies at once")]
    pub fn frame(&mut self, budget: Option<JsNumber>) -> Result<JsFrame, JsValue> {
        self.run.draw(&mut self.frame, in_memory(count_or("budget", budget, Frame::BUDGET as u64)?));
        let frame: JsFrame = object(&[("layers", self.layers.clone()), ("thinning", self.frame.thinning().into())]);
        let keys = [JsValue::from("vertices"), JsValue::from("spans")];
        let views = || unsafe { (Float32Array::view(self.frame.vertices()), Uint32Array::view(self.frame.table())) };
        // Each value of JavaScript takes a place. Where a view's place made memory grow, that emptied the view before it.
        let mut shown = views();
        if shown.0.length() as usize != self.frame.vertices().len() {
            shown = views();
        }
        for (key, view) in keys.iter().zip([shown.0.as_ref(), shown.1.as_ref()]) {
            js_sys::Reflect::set(&frame, key, view)?;
        }
        Ok(frame)
    }

    /// Everything there is to say about where the run stands.
    ///
    /// # Errors
    /// Where a number of it is more than JavaScript can hold.
    pub fn outcome(&mut self) -> Result<JsOutcome, JsValue> {
        plain(&self.run.outcome())
    }

    /// Why an item did what it did in the step that led here.
    ///
    /// # Errors
    /// For an unknown layer.
    pub fn inspect(&mut self, item: &JsItem) -> Result<JsInspectionOrNull, JsValue> {
        plain(&self.run.inspect(read_item(item)?))
    }

    /// What an item would have done in the step that led here with one thing otherwise: one of the `suppositions` of its explanation.
    /// `draw` numbers the other random numbers. Its layers are `supposed`.
    ///
    /// # Errors
    /// For an unknown layer or supposition, and for a `draw` that is no whole number.
    pub fn suppose(&mut self, item: &JsItem, supposition: &str, draw: Option<JsNumber>) -> Result<JsInspectionOrNull, JsValue> {
        let draw = count_or("draw", draw, 0)?;
        plain(&self.run.suppose(read_item(item)?, supposition, draw).map_err(js_error)?)
    }

    /// The nearest thing that can be inspected within `reach` of a point, in the scene's unit.
    ///
    /// # Errors
    /// For what is no number.
    pub fn pick(&self, x: &JsNumber, y: &JsNumber, reach: &JsNumber) -> Result<JsItemOrNull, JsValue> {
        let (point, reach) = ([read_number("x", x)?, read_number("y", y)?], read_number("reach", reach)?);
        plain(&self.run.pick(point, reach))
    }

    /// The exact optimum as a path, by the rule that the planner keeps to; null where there is none.
    ///
    /// # Errors
    /// Where a number of it is more than JavaScript can hold.
    pub fn exact(&self) -> Result<JsExactOrNull, JsValue> {
        plain(&self.run.exact())
    }

    /// The readings of past iterations as CSV.
    pub fn csv(&self) -> String {
        let mut text = Vec::new();
        // Writing to memory cannot fail, and the text is ASCII.
        let _ = self.run.trace().write_csv(&mut text);
        String::from_utf8(text).unwrap_or_default()
    }

    /// The hash of iteration, best and the whole state, in hexadecimal.
    pub fn hash(&self) -> String {
        self.run.hash()
    }
}
