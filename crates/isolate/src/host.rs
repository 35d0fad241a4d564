//! A code's planner, called as a script.

use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use forage::{
    describe::Start,
    kernel::{Candidate, Inspection, Item, Message, Shape},
    params::Object,
};
use forage_script::{Advanced, Call, Drawn, Script, Tools, candidate, inspection, threw};
use rquickjs::Value;
use serde_json::json;

use crate::interpreter::{Given, Interpreter, LOOK, STEP, list};

/// The shapes by the numbers that the inside gives them.
const SHAPES: [Shape; 3] = [Shape::Points, Shape::Polyline, Shape::Segments];

/// A code and an interpreter that has run it.
pub(crate) struct Hosted {
    code: Arc<str>,
    interpreter: Mutex<Interpreter>,
}

impl Hosted {
    pub(crate) fn new(code: &str) -> Result<Self, Message> {
        Ok(Self { code: code.into(), interpreter: Mutex::new(Interpreter::new(code)?) })
    }

    /// The same code in another interpreter.
    pub(crate) fn again(&self) -> Result<Self, Message> {
        let hosted = Self::new(&self.code)?;
        // Its planner is taken when it is asked for what it says of itself.
        hosted.described()?;
        Ok(hosted)
    }

    /// What the planner says of itself, as JSON.
    pub(crate) fn described(&self) -> Result<String, Message> {
        self.interpreter().call("described", STEP, [], text)
    }

    fn interpreter(&self) -> MutexGuard<'_, Interpreter> {
        self.interpreter.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn number(&self, name: &str, state: u32) -> f64 {
        self.interpreter().call(name, STEP, [of(state)], number).unwrap_or(0.0)
    }

    fn list(&self, name: &str, state: u32) -> Result<Option<Vec<f64>>, Message> {
        self.interpreter().call(name, LOOK, [of(state)], list)
    }
}

/// The argument that says of which state.
fn of(state: u32) -> Given {
    Given::Number(f64::from(state))
}

fn number(value: &Value) -> f64 {
    value.as_number().unwrap_or(f64::NAN)
}

fn text(value: &Value) -> String {
    value.get().unwrap_or_default()
}

impl Script for Hosted {
    fn start(&self, start: &Start, tools: Tools) -> Call<u32> {
        let scene = json!(&**start.scene).to_string();
        let parameters = json!(Object(start.parameters.all())).to_string();
        let sides = tools.objective().map(|objective| [objective.search_box().low().to_vec(), objective.search_box().high().to_vec()]);
        let seed = start.seed as f64;
        let interpreter = self.interpreter();
        interpreter.lending(tools, || {
            let mut given = vec![Given::Text(scene), Given::Text(parameters), Given::Number(seed)];
            given.extend(sides.into_iter().flatten().map(Given::Numbers));
            interpreter.call("start", STEP, given, number).map(|state| state as u32).map_err(|why| threw(&why.text()))
        })
    }

    fn advance(&self, state: u32, tools: Tools) -> Call<Advanced> {
        let interpreter = self.interpreter();
        interpreter.lending(tools, || {
            let found = interpreter.call("advance", STEP, [of(state)], number).map_err(|why| threw(&why.text()))?;
            // One that is done says so by its sign.
            Ok(Advanced { state: found.abs() as u32, done: found.is_sign_negative() })
        })
    }

    fn best(&self, state: u32) -> Result<Option<Candidate>, Message> {
        let found = self.list("best", state).map_err(|why| threw(&why.text()))?;
        Ok(found.and_then(|found| match &*found {
            [cost, kind, numbers @ ..] => Some(candidate(*cost, *kind as u32, numbers.to_vec())),
            _ => None,
        }))
    }

    fn readings(&self, state: u32) -> Result<Vec<f64>, Message> {
        Ok(self.list("readings", state)?.unwrap_or_default())
    }

    fn draw(&self, state: u32) -> Vec<Drawn> {
        let all = self.list("draw", state).ok().flatten().unwrap_or_default();
        let (mut left, mut drawn) = (&all[..], Vec::new());
        while let [layer, shape, count, rest @ ..] = left {
            let Some((vertices, after)) = rest.split_at_checked(*count as usize) else { break };
            if let Some(&shape) = SHAPES.get(*shape as usize) {
                drawn.push(Drawn { layer: *layer as usize, shape, vertices: vertices.as_chunks::<3>().0.to_vec() });
            }
            left = after;
        }
        drawn
    }

    fn explain(&self, state: u32, item: Item) -> Option<Inspection> {
        let (layer, index) = (item.layer.0, item.index as f64);
        let found =
            self.interpreter().call("explain", LOOK, [of(state), Given::Text(layer.to_owned()), Given::Number(index)], text).ok()?;
        let (title, summary, values): (String, String, Vec<(String, f64)>) = serde_json::from_str(&found).ok()?;
        Some(inspection(item, title, summary, values))
    }

    fn copy(&self, state: u32) -> u32 {
        self.number("copy", state) as u32
    }

    fn forget(&self, state: u32) {
        let _ = self.interpreter().call("forget", LOOK, [of(state)], |_| ());
    }

    fn digest(&self, state: u32) -> u64 {
        match self.interpreter().call("digest", STEP, [of(state)], list) {
            Ok(Some(halves)) if halves.len() == 2 => (halves[0] as u64) << 32 | halves[1] as u64,
            _ => 0,
        }
    }

    fn size(&self, state: u32) -> usize {
        self.number("size", state) as usize
    }
}
