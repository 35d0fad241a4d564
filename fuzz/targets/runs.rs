//! Random operations on a run of any planner: whichever way it comes to an iteration, the state there has the same hash.

use std::{collections::BTreeMap, sync::Arc};

use arbitrary::{Result, Unstructured};
use forage::{
    Frame, Overrides, Run, Scene, Setup, Value,
    describe::Entry,
    geometry::Bounds,
    kernel::{Item, SceneKindId, Stepped},
    params::{Domain, Parameter},
    run::run_subtasks,
    standard,
};

use super::check_refusal;

/// Runs are short: an input is worth little time.
const MOST_ITERATIONS: u64 = 6;
const MOST_OPERATIONS: usize = 24;
/// Larger maps and more stops would take all of it for their first iteration.
const MOST_OBSTACLES: usize = 900;
const MOST_STOPS: usize = 60;

pub fn operate(drawn: &mut Unstructured) -> Result<()> {
    let entry = *drawn.choose(standard().planners())?;
    let scenes: Vec<_> = standard().scenes().iter().filter(|scene| entry.check_scene(scene).is_ok() && is_small(scene)).collect();
    let scene = Arc::clone(drawn.choose(&scenes)?);
    let params = parameters(drawn, entry, scene.kind())?;
    let mut setup = Setup { planner: entry.name.to_owned(), scene, params, seed: u64::from(u8::from_le(drawn.arbitrary()?)) };
    let bytes = *drawn.choose(&[0, 4096, Run::KEYFRAME_BUDGET])?;
    let mut run = match Run::with_keyframes(standard(), setup.clone(), bytes) {
        Ok(run) => run,
        Err(error) => {
            check_refusal(&error);
            return Ok(());
        }
    };
    let mut hashes = BTreeMap::new();
    check_hash(&run, &mut hashes);
    for _ in 0..MOST_OPERATIONS {
        if drawn.is_empty() {
            break;
        }
        match drawn.int_in_range(0..=13)? {
            0..=1 => drop(run.step(drawn.int_in_range(1..=3)?)),
            2 => drop(run.part()),
            3 => {
                // A step that has begun is completed by the next one.
                while run.is_partly() && run.part() == Stepped::Partly {}
            }
            4 => drop(run.seek(drawn.int_in_range(0..=MOST_ITERATIONS)?)),
            5 => drop(run.rewind(drawn.int_in_range(0..=MOST_ITERATIONS)?)),
            6 => draw(drawn, &run)?,
            7 => inspect(drawn, &mut run)?,
            8 => {
                let point = [coordinate(drawn)?, coordinate(drawn)?];
                if let Some(item) = run.pick(point, coordinate(drawn)?) {
                    run.inspect(item);
                }
            }
            9 => {
                let (mut members, outcome) = (Vec::new(), run.outcome());
                run.members(&mut members);
                assert!(outcome.evaluations == run.evaluations() && run.curve().is_sorted_by(|a, b| a.evaluations <= b.evaluations));
                assert!(members.len().is_multiple_of(entry.members.len().max(1)));
                assert_eq!(run.readings().iter().count(), run.readings().iter().count());
            }
            10 => {
                // Its link opens this state.
                if let Some(link) = run.link() {
                    let mut other = Run::from_link(standard(), &link).unwrap_or_else(|error| panic!("{error}: {link}"));
                    other.seek(run.iteration());
                    assert_eq!(other.hash(), run.hash(), "{link}");
                }
            }
            11 => {
                // Another parameter: another run, at the same iteration. What is refused changes nothing.
                let at = run.iteration();
                let mut changed = setup.clone();
                changed.params = parameters(drawn, entry, setup.scene.kind())?;
                match Run::with_keyframes(standard(), changed.clone(), bytes) {
                    Ok(other) => {
                        (run, setup) = (other, changed);
                        hashes.clear();
                        run.seek(at);
                    }
                    Err(error) => check_refusal(&error),
                }
            }
            12 => {
                // What the subtasks find may come from elsewhere.
                let subtasks = run.subtasks();
                if let Ok(found) = run_subtasks(standard(), run.scene(), &subtasks) {
                    run.provide(found).unwrap_or_else(|error| panic!("{error}"));
                }
            }
            _ => {
                for follower in standard().followers() {
                    if let Err(error) = run.follow(follower.name, &Overrides::new()) {
                        check_refusal(&error);
                    }
                }
            }
        }
        check_hash(&run, &mut hashes);
    }
    Ok(())
}

fn is_small(scene: &Scene) -> bool {
    let obstacles = scene.get::<forage::scene::GridScene>().map_or(0, |grid| grid.blocked.len());
    obstacles <= MOST_OBSTACLES && scene.stops().len() <= MOST_STOPS
}

/// At each iteration there is one state.
fn check_hash(run: &Run, hashes: &mut BTreeMap<u64, String>) {
    if !run.is_partly() {
        let hash = run.hash();
        assert_eq!(*hashes.entry(run.iteration()).or_insert_with(|| hash.clone()), hash, "iteration {}", run.iteration());
    }
}

fn coordinate(drawn: &mut Unstructured) -> Result<f64> {
    Ok(f64::from(drawn.arbitrary::<i8>()?) / 4.0)
}

/// Some parameters, also at the ends of their ranges and beyond; few particles and iterations.
fn parameters(drawn: &mut Unstructured, entry: &'static Entry, kind: SceneKindId) -> Result<Overrides> {
    let mut params = Overrides::new();
    for parameter in entry.parameters_on(kind) {
        if let Some(value) = small(parameter, kind) {
            params.insert(parameter.name, value);
        } else if drawn.ratio(1, 4)? {
            params.insert(parameter.name, value(drawn, parameter)?);
        }
    }
    Ok(params)
}

/// Sizes, and roads that are quickly found.
fn small(parameter: &Parameter, kind: SceneKindId) -> Option<Value> {
    match (parameter.domain, parameter.default_on(kind)) {
        (Domain::Integer { min, .. }, Value::Number(default)) if default > 6.0 => Some(Value::from(default.min(6.0).max(min as f64))),
        (Domain::Choice { .. }, _) if parameter.name == "roads" => Some(Value::from("a-star")),
        _ => None,
    }
}

fn value(drawn: &mut Unstructured, parameter: &Parameter) -> Result<Value> {
    Ok(match parameter.domain {
        Domain::Number { min, max, .. } => match drawn.int_in_range(0..=5)? {
            0 => Value::from(min),
            1 => Value::from(max),
            2 => Value::from(drawn.arbitrary::<f64>()?),
            _ => Value::from(min + (max - min) * f64::from(drawn.arbitrary::<u8>()?) / 255.0),
        },
        Domain::Integer { min, .. } => Value::from(min as f64 + f64::from(drawn.int_in_range(0..=6)?)),
        Domain::Choice { options } | Domain::Subset { options, .. } => Value::from(drawn.choose(options)?.value),
        _ => Value::Flag(drawn.arbitrary()?),
    })
}

fn draw(drawn: &mut Unstructured, run: &Run) -> Result<()> {
    let mut frame = Frame::default();
    if drawn.arbitrary()? {
        let (min, size) = ([coordinate(drawn)?, coordinate(drawn)?], [coordinate(drawn)?.abs(), coordinate(drawn)?.abs()]);
        frame.look_at(Some(Bounds { min, max: [min[0] + size[0], min[1] + size[1]] }));
    }
    run.draw(&mut frame, usize::from(drawn.arbitrary::<u16>()?));
    assert!(frame.unlisted().is_empty(), "{:?}", frame.unlisted());
    assert!(frame.vertices().iter().all(|number| number.is_finite()), "{:?} is drawn", run.entry().name);
    Ok(())
}

fn inspect(drawn: &mut Unstructured, run: &mut Run) -> Result<()> {
    let layers: Vec<_> = run.entry().layers.iter().filter(|layer| layer.pickable).collect();
    if layers.is_empty() {
        return Ok(());
    }
    let item = Item { layer: drawn.choose(&layers)?.key, index: usize::from(drawn.arbitrary::<u8>()?) };
    if let Some(explained) = run.inspect(item) {
        assert!(!explained.summary.text().is_empty());
        let names: Vec<_> = explained.suppositions.iter().map(|label| label.name).collect();
        if !names.is_empty() {
            let name = *drawn.choose(&names)?;
            let supposed = run.suppose(item, name, u64::from(drawn.arbitrary::<u8>()?));
            assert!(supposed.is_ok(), "{name} is offered");
        }
    }
    Ok(())
}
