use std::sync::{
    Mutex,
    atomic::{AtomicU32, Ordering::Relaxed},
};

use serde_json::{Value as Json, json};

use super::*;
use forage::{
    Overrides, Registry, Run, Setup,
    describe::{Entry, Start},
    kernel::{Candidate, Error, Inspection, Item, LayerKey, Message, Shape, Solution, Started, Status},
    message, shipped,
};

/// A cost and a position.
type Place = (f64, Vec<f64>);

/// Goes a random step from its best position, in Rust: what a script of another language does.
struct Climber {
    states: Mutex<Vec<Option<Place>>>,
    alive: AtomicU32,
}

static CLIMBER: Climber = Climber { states: Mutex::new(Vec::new()), alive: AtomicU32::new(0) };

impl Climber {
    fn keep(&self, state: Place) -> u32 {
        self.alive.fetch_add(1, Relaxed);
        let mut states = self.states.lock().unwrap();
        states.push(Some(state));
        states.len() as u32 - 1
    }

    fn state(&self, state: u32) -> Place {
        self.states.lock().unwrap()[state as usize].clone().expect("it was not forgotten")
    }
}

struct Shared;

impl Script for Shared {
    fn start(&self, start: &Start, mut tools: Tools) -> Call<u32> {
        let search_box = std::sync::Arc::clone(tools.objective().expect("it is a function"));
        let (low, high) = (search_box.search_box().low(), search_box.search_box().high());
        let x: Vec<_> = low.iter().zip(high).map(|(low, high)| low + (high - low) * tools.random()).collect();
        let cost = tools.evaluate(&x).expect("the dimension is right");
        let wrong = start.parameters.all().iter().any(|(name, value)| *name == "wrong" && value.to_string() == "true");
        let result = if wrong { Err(message!("demo-wrong", "it was asked to")) } else { Ok(CLIMBER.keep((cost, x))) };
        Call { tools: Some(tools), result }
    }

    fn advance(&self, state: u32, mut tools: Tools) -> Call<Advanced> {
        let (cost, x) = CLIMBER.state(state);
        let tried: Vec<_> = x.iter().map(|x| (x + tools.normal()).clamp(-100.0, 100.0)).collect();
        let found = tools.evaluate(&tried).expect("the dimension is right");
        let next = if found < cost { (found, tried) } else { (cost, x) };
        self.forget(state);
        Call { tools: Some(tools), result: Ok(Advanced { state: CLIMBER.keep(next), done: false }) }
    }

    fn best(&self, state: u32) -> Result<Option<Candidate>, Message> {
        let (cost, x) = CLIMBER.state(state);
        Ok(Some(Candidate { cost, solution: Solution::Position(x) }))
    }

    fn readings(&self, state: u32) -> Result<Vec<f64>, Message> {
        Ok(vec![CLIMBER.state(state).0])
    }

    fn draw(&self, state: u32) -> Vec<Drawn> {
        let (_, x) = CLIMBER.state(state);
        vec![Drawn { layer: 0, shape: Shape::Points, vertices: vec![[x[0], x[1], 0.0]] }]
    }

    fn explain(&self, _state: u32, item: Item) -> Option<Inspection> {
        Some(Inspection::new(item, message!("demo-title", "The climber"), "step", message!("demo-sum", "It went on.")))
    }

    fn copy(&self, state: u32) -> u32 {
        CLIMBER.keep(CLIMBER.state(state))
    }

    fn forget(&self, state: u32) {
        CLIMBER.alive.fetch_sub(1, Relaxed);
        CLIMBER.states.lock().unwrap()[state as usize] = None;
    }

    fn digest(&self, state: u32) -> u64 {
        let (cost, x) = CLIMBER.state(state);
        x.iter().fold(cost.to_bits(), |all, x| (all ^ x.to_bits()).rotate_left(7))
    }

    fn size(&self, _state: u32) -> usize {
        100
    }
}

fn start(start: &Start) -> Result<Started, Error> {
    let script: std::sync::Arc<dyn Script> = std::sync::Arc::new(Shared);
    begin(&script, start.entry, start)
}

fn described(more: Json) -> Result<&'static Entry, Error> {
    let mut description = json!({
        "name": "climber", "title": "Climber", "kinds": ["function"],
        "parameters": [{"name": "wrong", "type": "flag", "default": false}],
        "readings": [{"name": "cost"}],
        "layers": [{"role": "particles", "pickable": true}],
    });
    let (Json::Object(description), Json::Object(more)) = (&mut description, more) else { panic!("both are objects") };
    description.extend(more);
    entry(&Json::Object(description.clone()), start)
}

fn run(params: Overrides, seed: u64) -> Result<Run, Error> {
    let registry = std::sync::Arc::new(Registry::standard().with(described(json!({}))?));
    Run::new(&registry, Setup { planner: "climber".into(), scene: shipped("sphere-2")?, params, seed })
}

#[test]
fn a_script_has_what_planners_have() {
    let alive = CLIMBER.alive.load(Relaxed);
    let mut run = run(Overrides::new(), 3).unwrap();
    let first = run.hash();
    assert_eq!(run.step(400), Status::Running);
    let (hash, cost) = (run.hash(), run.best().unwrap().cost);
    assert_eq!(run.evaluations(), 401);
    assert_eq!(run.readings().get("cost"), Some(cost));
    assert!(!run.outcome().deterministic && run.outcome().position.is_some());
    run.seek(0);
    assert_eq!(run.hash(), first);
    run.seek(400);
    assert_eq!((run.hash(), run.best().unwrap().cost), (hash, cost), "the same again");
    let item = Item { layer: LayerKey("particles"), index: 0 };
    assert_eq!(run.inspect(item).unwrap().title.text(), "The climber");
    assert_eq!(run.pick([0.0, 0.0], 1000.0), Some(item));
    let link = run.link().unwrap();
    let opened = Run::from_link(run.registry().unwrap(), &link).unwrap();
    assert_eq!(opened.entry().name, "climber");
    assert_eq!(run.step(u64::MAX), Status::Exhausted);
    assert_eq!(run.iteration(), 1000);
    assert!(run.best().unwrap().cost < 1.0);
    drop((run, opened));
    assert_eq!(CLIMBER.alive.load(Relaxed), alive, "no state is left");
}

#[test]
fn what_does_not_start_is_refused() {
    let error = run(Overrides::from_iter([("wrong", forage::Value::Flag(true))]), 1).err().unwrap();
    assert!(error.field() == "planner" && error.to_string().contains("it was asked to"), "{error}");
}

#[test]
fn a_description_becomes_an_entry() {
    let entry = described(json!({"parameters": [
        {"name": "c1", "symbol": "c_1", "type": "number", "default": 1.5, "min": 0, "max": 4},
        {"name": "ants", "type": "integer", "default": 20, "min": 1, "max": 1000},
        {"name": "update", "type": "choice", "options": [{"value": "all"}, {"value": "some"}, {"value": "best"}], "default": "best"},
        {"name": "iterations", "type": "integer", "default": 50, "min": 1, "max": 100},
    ]}))
    .unwrap();
    let names: Vec<_> =
        entry.all_parameters().map(|parameter| (parameter.name, parameter.default_on(forage::scene::FUNCTION).to_string())).collect();
    assert_eq!(names, [("c1", "1.5".into()), ("ants", "20".into()), ("update", "best".into()), ("iterations", "50".into())]);
    for wrong in [json!({"name": 5}), json!({"kinds": []}), json!({"kinds": ["arm"]}), json!({"parameters": [{"name": "a"}]})] {
        let error = described(wrong.clone()).err().unwrap_or_else(|| panic!("{wrong} is accepted"));
        assert_eq!(error.field(), "planner", "{error}");
    }
}
