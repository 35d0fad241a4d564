//! What must hold for every planner in the catalogue, on every kind of scene, for many seeds. A new planner is tested
//! by being listed: each check is a test of its own for each planner, called `family::planner::what_holds`.
//!
//! `PROPTEST_CASES` says how many random runs of a planner each property sees.
#![cfg(not(target_arch = "wasm32"))]

#[path = "support/trial.rs"]
mod trial;

use std::{collections::BTreeSet, process::ExitCode, sync::Arc};

use forage::{
    Frame, Overrides, Run, Scene, Setup, Status, Value,
    arm::ArmScene,
    describe::{Entry, Formula, Group, Scope, Shown, layers},
    kernel::{Item, LayerKey, Shape},
    params::{Domain, Parameter, When},
    scene::{DiscsScene, GRID, GridScene, TourScene},
    standard,
};
use libtest_mimic::Arguments;
use proptest::{
    prelude::*,
    test_runner::{Config, TestCaseResult, TestRunner},
};
use trial::trial;

/// The shipped scenes that a planner runs on.
fn scenes(entry: &Entry) -> Vec<Arc<Scene>> {
    standard().scenes().iter().filter(|scene| entry.check_scene(scene).is_ok()).cloned().collect()
}

/// Holds a property against random values: a few for each planner, or as many as `PROPTEST_CASES` says.
fn property<S: Strategy>(values: &S, check: impl Fn(S::Value) -> TestCaseResult) {
    let cases = if std::env::var_os("PROPTEST_CASES").is_some() { Config::default().cases } else { 4 };
    let config = Config { cases, failure_persistence: None, ..Config::default() };
    TestRunner::new(config).run(values, check).unwrap_or_else(|failure| panic!("{failure}"));
}

fn given(pairs: &[(&str, f64)]) -> Overrides {
    pairs.iter().map(|&(name, value)| (name, Value::from(value))).collect()
}

/// So many particles or ants, where the planner has some, and so many iterations.
fn sized(entry: &Entry, scene: &Scene, size: f64, iterations: f64) -> Overrides {
    let mut given = given(&[("iterations", iterations)]);
    // A planner of planners judges each particle by a short run.
    for (name, value) in [("population", size), ("ants", size), ("seeds", 1.0), ("colony_iterations", 1.0)] {
        if entry.parameter(name).is_some() {
            given.insert(name, Value::from(value));
        }
    }
    // Ants would build sixty-six roads a run.
    if entry.stops && scene.kind() == GRID {
        given.insert("roads", Value::from("a-star"));
    }
    given
}

/// What the planner calls the number of those that search side by side.
fn size_name(entry: &Entry) -> Option<&'static str> {
    entry.all_parameters().map(|p| p.name).find(|name| ["population", "ants"].contains(name))
}

fn session(entry: &Entry, scene: &Arc<Scene>, params: Overrides, seed: u64) -> Run {
    Run::new(standard(), Setup { planner: entry.name.to_owned(), scene: Arc::clone(scene), params, seed }).unwrap()
}

/// A best cost never rises, a path begins at the start and ends at the goal, and what is said to be feasible
/// really crosses nothing (checked here by dense sampling, not by the geometry that said so).
fn a_run_only_gets_better_and_its_verdict_is_true(entry: &'static Entry) {
    let scenes = scenes(entry);
    property(&(0..scenes.len(), 0..10_000_u64, 1..60_u32), |(scene, seed, population)| {
        let scene = &scenes[scene];
        let mut session = session(entry, scene, sized(entry, scene, f64::from(population), 60.0), seed);
        let (mut best, mut free) = (f64::INFINITY, f64::INFINITY);
        let first = session.outcome().evaluations;
        loop {
            if let Some(now) = session.readings().get("best").filter(|best| !best.is_nan()) {
                prop_assert!(now <= best, "best rose from {best} to {now}");
                best = now;
            }
            if let Some(now) = session.readings().get("free").filter(|f| !f.is_nan()) {
                prop_assert!(now <= free, "free rose from {free} to {now}");
                free = now;
            }
            if session.step(1) != Status::Running {
                break;
            }
        }
        let outcome = session.outcome();
        // What has stages counts its iterations in one of them.
        let staged = !session.stages().is_empty();
        prop_assert!(outcome.status != Status::Exhausted || outcome.iterations == 60 || staged);
        prop_assert!(outcome.iterations <= session.limit());
        if size_name(entry).is_some() && !staged {
            let rounds = (outcome.evaluations - first) / (u64::from(population) * 60);
            let all = outcome.evaluations - first == rounds * u64::from(population) * 60;
            prop_assert!((1..=2).contains(&rounds) && all, "every particle is evaluated equally often, once or twice, in every iteration");
            prop_assert!(entry.family != "swarm" || first >= u64::from(population));
        }
        prop_assert_eq!(outcome.cost.is_some(), outcome.path.is_some() || outcome.position.is_some() || outcome.tip_path.is_some());
        if let Some(order) = &outcome.order {
            let mut sorted = order.clone();
            sorted.sort_unstable();
            prop_assert_eq!(sorted, (0..scene.stops().len()).collect::<Vec<_>>(), "a tour is a permutation");
            prop_assert!(outcome.feasible && outcome.gap.is_none_or(|gap| gap > -1e-9));
        }
        let ends = match &outcome.order {
            Some(order) => {
                let stops = scene.stops();
                let closed = !scene.get::<TourScene>().is_ok_and(|tour| !tour.closed);
                Some((stops[order[0]], stops[if closed { order[0] } else { order[order.len() - 1] }]))
            }
            None => scene.ends(),
        };
        if let (Some(path), Some((start, goal))) = (&outcome.path, ends) {
            prop_assert_eq!(path[0], start);
            prop_assert_eq!(path[path.len() - 1], goal);
            let deepest = samples(path).map(|point| clearance(scene, point)).fold(f64::INFINITY, f64::min);
            prop_assert!(!outcome.feasible || deepest > -1e-12, "said to be free, but {deepest} inside an obstacle");
            prop_assert!(deepest >= outcome.clearance.unwrap_or(f64::INFINITY) - 1e-12, "sampling found it deeper than the clearance says");
            if outcome.feasible && outcome.order.is_none() {
                prop_assert!(outcome.gap.unwrap() > -1e-9, "shorter than the exact optimum: {:?}", outcome.gap);
            }
        }
        if let (Some(tip), Ok(arm)) = (&outcome.tip_path, scene.get::<ArmScene>()) {
            let apart = |a: [f64; 3], b: [f64; 3]| (0..3).map(|i| (a[i] - b[i]) * (a[i] - b[i])).sum::<f64>().sqrt();
            prop_assert!(apart(tip[0], arm.start) < 1e-6 && apart(tip[tip.len() - 1], arm.goal) < 1e-6);
            let inside = |p: [f64; 3]| arm.cuboids.iter().any(|c| (0..3).all(|i| c.min[i] < p[i] && p[i] < c.max[i]));
            let touches = tip
                .windows(2)
                .any(|w| (0..=50).map(|k| f64::from(k) / 50.0).any(|t| inside([0, 1, 2].map(|i| w[0][i] + t * (w[1][i] - w[0][i])))));
            prop_assert!(!outcome.feasible || !touches, "said to be free, but it lies in a cuboid");
            prop_assert!(outcome.gap.is_none_or(|gap| !outcome.feasible || gap > -1e-9), "shorter than the exact optimum");
        }
        if let Some(position) = &outcome.position {
            let side = scene.view().max[0];
            prop_assert!(position.iter().all(|x| x.abs() <= side));
        }
        Ok(())
    });
}

/// Any iteration, reached forward, backward or again, is the same to the last bit; so is its picture.
fn rewinding_is_exact(entry: &'static Entry) {
    let scenes = scenes(entry);
    property(&(0..scenes.len(), 0..1000_u64, prop::collection::vec(0..80_u64, 6)), |(scene, seed, visits)| {
        let scene = &scenes[scene];
        let params = sized(entry, scene, 12.0, 80.0);
        let mut forward = session(entry, scene, params.clone(), seed);
        let mut once = vec![snapshot(&mut forward)];
        while forward.status() == Status::Running {
            forward.step(1);
            once.push(snapshot(&mut forward));
        }
        let mut replayed = Run::with_keyframes(
            standard(),
            Setup { planner: entry.name.to_owned(), scene: Arc::clone(scene), params, seed },
            if seed % 2 == 0 { 0 } else { 20_000 },
        )
        .unwrap();
        for k in visits {
            forward.seek(k);
            replayed.seek(k);
            let k = (k as usize).min(once.len() - 1);
            prop_assert_eq!(forward.iteration(), k as u64);
            prop_assert_eq!(&snapshot(&mut forward), &once[k]);
            prop_assert_eq!(&snapshot(&mut replayed), &once[k]);
        }
        Ok(())
    });
}

/// A link opens the very same state, with an edited scene and changed parameters.
fn a_link_reproduces_the_hash(entry: &'static Entry) {
    let scenes = scenes(entry);
    property(&(0..scenes.len(), 0..forage::kernel::rng::MAX_SEED, 0..30_u64, 1..40_u32), |(scene, seed, k, population)| {
        let scene = &scenes[scene];
        let edited = scene.to_json().replace(scene.header().title.as_str(), "edited & <named> 5 % \u{2713}");
        let scene = Arc::new(standard().read_scene(&edited).unwrap());
        let mut session = session(entry, &scene, sized(entry, &scene, f64::from(population), 40.0), seed);
        session.seek(k);
        let k = session.iteration();
        let link = forage::Link::parse(standard(), &session.link().unwrap()).unwrap();
        prop_assert_eq!(link.iteration, k);
        let mut opened = Run::new(standard(), link.setup).unwrap();
        opened.seek(k);
        prop_assert_eq!(Some(opened.hash()), link.hash);
        prop_assert_eq!(opened.link(), session.link());
        Ok(())
    });
}

/// A run that calls itself deterministic comes out the same whatever its seed; one that does not has a stream in its state.
fn only_random_runs_depend_on_their_seed(entry: &'static Entry) {
    for scene in scenes(entry) {
        let end = |seed| {
            let mut session = session(entry, &scene, sized(entry, &scene, 8.0, 30.0), seed);
            while session.step(1) == Status::Running {}
            let mut outcome = serde_json::to_value(session.outcome()).unwrap();
            let hash = outcome["hash"].take();
            outcome["seed"].take();
            (hash, outcome)
        };
        let [(first, told), (second, other)] = [1, 2].map(end);
        assert_ne!(first, second, "the seed is part of the hash");
        if told["deterministic"] == true {
            assert_eq!(told, other, "{} on {} calls itself deterministic", entry.name, scene.name());
        }
    }
}

/// The hash is of the setup, too: before the first step it tells planners, scenes, seeds and parameters apart that begin
/// alike. What is written about a scene is not part of it.
fn no_two_setups_share_a_hash() {
    let hash = |entry: &Entry, scene: &Arc<Scene>, params: Overrides, seed| session(entry, scene, params, seed).hash();
    let mut hashes = BTreeSet::new();
    let mut setups = 0;
    for entry in standard().planners() {
        for scene in scenes(entry) {
            for (iterations, seed) in [(40.0, 1), (41.0, 1), (40.0, 2)] {
                hashes.insert(hash(entry, &scene, sized(entry, &scene, 5.0, iterations), seed));
                setups += 1;
            }
        }
    }
    assert_eq!(hashes.len(), setups);
    let scene = forage::shipped("wcpso-discs").unwrap();
    let edited = |from: &str, to: &str| Arc::new(standard().read_scene(&scene.to_json().replacen(from, to, 1)).unwrap());
    let pso = |scene: &Arc<Scene>| hash(forage::standard().planner("pso").unwrap(), scene, Overrides::new(), 1);
    assert_eq!(pso(&scene), pso(&edited(scene.header().title.as_str(), "Another title")));
    assert_ne!(pso(&scene), pso(&edited("\"radius\": 1.0", "\"radius\": 1.01")));
}

/// Points along a path, close together.
fn samples(path: &[[f64; 2]]) -> impl Iterator<Item = [f64; 2]> {
    let pieces = (20_000 / path.len()).max(50);
    path.windows(2).flat_map(move |w| {
        (0..=pieces).map(move |i| i as f64 / pieces as f64).map(move |t| [0, 1].map(|axis| w[0][axis] + t * (w[1][axis] - w[0][axis])))
    })
}

/// A point's distance from the nearest obstacle (robot included), computed without the crate's geometry: disc by disc,
/// cell by cell. Inside a cell it is only said to be inside.
fn clearance(scene: &Scene, p: [f64; 2]) -> f64 {
    if let Ok(discs) = scene.get::<DiscsScene>() {
        return discs.discs.iter().map(|d| apart(p[0] - d.center[0], p[1] - d.center[1]) - d.radius).fold(f64::INFINITY, f64::min);
    }
    let Ok(grid) = scene.get::<GridScene>() else { return f64::INFINITY };
    let (cell, radius) = (grid.cell, grid.radius());
    let outside = (0..2).any(|axis| p[axis] < 0.0 || p[axis] > grid.bounds().max[axis]);
    let blocked = (0..grid.blocked.len()).filter(|&i| grid.blocked[i]).map(|i| [i % grid.columns, i / grid.columns]);
    let from = |[column, row]: [usize; 2]| {
        let beyond = |x: f64, low: usize| (low as f64 * cell - x).max(x - (low + 1) as f64 * cell).max(0.0);
        apart(beyond(p[0], column), beyond(p[1], row)) - radius
    };
    if outside { f64::NEG_INFINITY } else { blocked.map(from).fold(f64::INFINITY, f64::min) }
}

fn apart(dx: f64, dy: f64) -> f64 {
    (dx * dx + dy * dy).sqrt()
}

fn snapshot(session: &mut Run) -> (String, String, Vec<u32>) {
    let mut frame = Frame::default();
    session.draw(&mut frame, Frame::BUDGET);
    let drawn = frame.vertices().iter().map(|v| v.to_bits()).chain(frame.table().iter().copied()).collect();
    (session.hash(), format!("{:?}", session.readings()), drawn)
}

/// Any population runs, from one to a hundred thousand.
fn any_population_runs(entry: &'static Entry) {
    for scene in scenes(entry) {
        for (population, iterations) in [(1.0, 1.0), (1.0, 50.0), (2.0, 50.0), (3.0, 1_000_000.0)] {
            let mut session = session(entry, &scene, sized(entry, &scene, population, iterations), 5);
            session.step(60);
            let outcome = session.outcome();
            let staged = !session.stages().is_empty();
            assert!(outcome.iterations == iterations.min(60.0) as u64 || outcome.status == Status::Solved || staged);
            assert!(outcome.cost.is_none_or(f64::is_finite), "{} on {}", entry.name, scene.name());
            assert!(outcome.cost.is_some() || entry.family != "swarm");
        }
    }
    for name in ["wcpso-discs", "sphere"].into_iter().filter(|_| entry.family == "swarm") {
        let scene = forage::shipped(name).unwrap();
        if entry.check_scene(&scene).is_err() {
            continue;
        }
        let mut session = session(entry, &scene, given(&[("population", 100_000.0)]), 5);
        session.step(2);
        let mut frame = Frame::default();
        session.draw(&mut frame, Frame::BUDGET);
        assert!(frame.vertices().len() / 4 <= 4 * Frame::BUDGET, "a frame keeps to its budget");
        assert!(name == "sphere" || frame.thinning() > 1);
    }
}

/// Both ends of each parameter's range run; what lies beyond is refused with name, value and range.
fn every_parameter_is_checked_at_both_ends(entry: &'static Entry) {
    for scene in scenes(entry).into_iter().filter(|scene| ["wcpso-discs", "sphere", "qpso-10m"].contains(&scene.name())) {
        for parameter in entry.parameters_on(scene.kind()) {
            let start = |value: f64| {
                let mut params = sized(entry, &scene, 4.0, 20.0);
                meet_conditions(entry, parameter, &mut params);
                params.insert(parameter.name, Value::from(value));
                Run::new(standard(), Setup { planner: entry.name.to_owned(), scene: Arc::clone(&scene), params, seed: 1 })
            };
            let (min, max) = match parameter.domain {
                Domain::Number { min, max, .. } => (min, max),
                Domain::Integer { min, max, .. } => (min as f64, max as f64),
                _ => {
                    assert_eq!(start(0.5).err().unwrap().field(), parameter.name);
                    continue;
                }
            };
            for value in [min, max] {
                let mut session = start(value).unwrap_or_else(|error| panic!("{}: {error}", entry.name));
                session.step(if value >= 1000.0 { 2 } else { 20 });
                // What is not there yet is not a number; nothing is infinite.
                let found = session.outcome().cost.is_some();
                assert!(
                    session.readings().iter().all(|(name, value)| value.is_finite()
                        || (value.is_nan() && (!found || ["free", "f", "mean", "settled", "smallest_distance"].contains(&name)))),
                    "{} {}={value}",
                    entry.name,
                    parameter.name
                );
            }
            for value in [min - 1.0, max * 2.0 + 1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
                let error = start(value).err().unwrap_or_else(|| panic!("{} accepts {}={value}", entry.name, parameter.name));
                assert_eq!((error.field(), error.value()), (parameter.name, value.to_string().as_str()));
                assert!(error.allowed().contains(&min.to_string()) && error.allowed().contains(&max.to_string()), "{error}");
            }
        }
    }
}

/// Gives the parameters that this one depends on the values that it needs.
fn meet_conditions(entry: &Entry, parameter: &Parameter, params: &mut Overrides) {
    if let Some(When { parameter: name, value }) = parameter.when {
        params.insert(name, Value::from(value));
        meet_conditions(entry, entry.parameter(name).unwrap(), params);
    }
}

/// Every condition names a parameter of the same planner and a value that it may have; so does every layer's.
fn every_condition_can_be_met(entry: &'static Entry) {
    for when in entry.all_parameters().filter_map(|p| p.when).chain(entry.layers.iter().filter_map(|l| l.when)) {
        let other = entry.parameter(when.parameter).unwrap();
        other.check(&Value::from(when.value)).unwrap();
    }
}

/// Encoding and planner vary independently: a swarm runs on every kind of path, way-points or polar, smoothed or not.
fn every_encoding_runs(entry: &'static Entry) {
    let mut all: Vec<_> = scenes(entry).into_iter().filter(|scene| scene.ends().is_some()).collect();
    // A point among the same walls: its best paths touch corners exactly, where rounding decides.
    let mut point: serde_json::Value = serde_json::from_str(&forage::shipped("qpso-10m").unwrap().to_json()).unwrap();
    point.as_object_mut().unwrap().remove("robot");
    all.push(Arc::new(standard().read_scene_value(point).unwrap()));
    for scene in all {
        for (encoding, corners) in [("waypoints", 3), ("polar", 7)] {
            let points = corners + 2;
            let run = |smooth: bool| {
                let mut params = given(&[("iterations", 400.0)]);
                params.insert("encoding", Value::from(encoding));
                params.insert("smooth", Value::Flag(smooth));
                if encoding == "waypoints" {
                    params.insert("waypoints", Value::from(corners as f64));
                }
                let mut session = session(entry, &scene, params, 7);
                session.step(u64::MAX);
                session.outcome()
            };
            let (raw, smooth) = (run(false), run(true));
            assert_eq!(raw.path.as_ref().unwrap().len(), points, "{} {encoding}", entry.name);
            assert!(smooth.path.as_ref().unwrap().len() <= (points - 1) * 8 + 1);
            assert_eq!(raw.cost, smooth.cost, "smoothing is not part of the search");
            assert_eq!(raw.feasible, smooth.feasible, "{} {encoding} on {}: smoothing never leaves free space", entry.name, scene.name());
            if raw.feasible {
                assert!(smooth.length.unwrap() <= raw.length.unwrap() + 1e-12, "{} {encoding} on {}", entry.name, scene.name());
            }
        }
    }
}

/// What an entry promises, its planner keeps: readings, layers, formulas and inspections agree with the catalogue.
fn the_entry_describes_what_the_planner_does(entry: &'static Entry) {
    let presets = entry.presets.iter().map(|preset| (forage::shipped(preset.scene).unwrap(), preset.given()));
    for (scene, params) in scenes(entry).into_iter().map(|scene| (scene, Overrides::new())).chain(presets) {
        let mut given = sized(entry, &scene, 80.0, 120.0);
        params.iter().for_each(|(name, value)| given.insert(name, value.clone()));
        let mut session = session(entry, &scene, given, 3);
        session.step(60);
        let known: Vec<_> = entry.readings.iter().map(|reading| reading.name).collect();
        let told: Vec<_> = session.readings().iter().map(|(name, _)| name).collect();
        assert!(told.iter().all(|name| known.contains(name)), "{}: {told:?} but the entry lists {known:?}", entry.name);
        assert!(entry.readings.iter().any(|reading| reading.group == Group::Cost));
        let mut frame = Frame::default();
        session.draw(&mut frame, Frame::BUDGET);
        let (_, marks) = entry.drawn_and_marked();
        assert!(marks.iter().all(|layer| layer.shown == Shown::Inspection), "{} lists a layer after those of explanations", entry.name);
        assert!(frame.unlisted().is_empty(), "{} draws {:?}, which its entry does not list", entry.name, frame.unlisted());
        for span in frame.spans() {
            assert!(span.shape != Shape::Polyline || span.count >= 2);
        }
        let numbers: Vec<_> = told.iter().copied().chain(session.parameters().all().iter().map(|(name, _)| *name)).collect();
        for formula in entry.formulas.iter().filter(|f| f.scope == Scope::Iteration && is_carried_out(f, &session)) {
            for name in placeholders(formula.live) {
                assert!(numbers.contains(&name), "{}: nothing fills @{name}@ in {}", entry.name, formula.name);
            }
        }
        let mut picked = check_inspections(entry, &mut session);
        // What has stages shows some things only later.
        if !session.stages().is_empty() {
            session.step(10_000);
            picked.extend(check_inspections(entry, &mut session));
        }
        let kind = scene.kind();
        let still = scene.get::<GridScene>().is_ok_and(|grid| grid.moving.is_empty());
        for layer in entry.layers.iter().filter(|layer| layer.pickable && (layer.kinds.is_empty() || layer.kinds.contains(&kind))) {
            let there = picked.contains(&layer.key) || (layer.key == layers::MOVING.key && still);
            assert!(there, "{} on {} draws no {} that could be picked", entry.name, scene.name(), layer.key.0);
        }
    }
}

/// Whatever can be picked can be asked about, and what is told can be typeset. Returns the roles of what there was.
fn check_inspections(entry: &Entry, session: &mut Run) -> Vec<LayerKey> {
    let mut there = Vec::new();
    let mut frame = Frame::default();
    session.draw(&mut frame, usize::MAX);
    let symbols = serde_json::to_value(standard().catalogue()).unwrap()["symbols"].clone();
    let symbols: Vec<_> = symbols.as_array().unwrap().iter().map(|symbol| symbol.as_str().unwrap()).collect();
    let kind = session.scene().kind();
    let here = entry.layers.iter().filter(|layer| layer.kinds.is_empty() || layer.kinds.contains(&kind));
    for layer in here.filter(|layer| layer.pickable).map(|layer| layer.key) {
        let spans = || frame.spans().filter(|span| span.layer == layer);
        let pieces: usize = spans().map(|span| if span.shape == Shape::Polyline { 1 } else { span.count as usize }).sum();
        if pieces > 0 {
            there.push(layer);
        }
        for index in (0..pieces).step_by((pieces / 80).max(1)) {
            let Some(told) = session.inspect(Item { layer, index }) else {
                // A field has values for all cells, and nothing to say of some.
                let field = spans().next().unwrap();
                assert!(field.shape == Shape::Field && frame.vertices()[4 * (field.first as usize + index) + 3] < 0.0);
                continue;
            };
            for mark in &told.marks {
                assert!(entry.layer(mark.layer).is_some(), "{} marks {:?}, which its entry does not list", entry.name, mark.layer);
            }
            for name in &told.formulas {
                let formula =
                    entry.formulas.iter().find(|f| f.name == *name).unwrap_or_else(|| panic!("{} has no formula {name}", entry.name));
                assert!(is_carried_out(formula, session), "{}: {} is not carried out with these parameters", entry.name, formula.name);
                for name in placeholders(formula.live) {
                    assert!(told.values.iter().any(|v| v.name == name), "{}: nothing fills @{name}@ in {}", entry.name, formula.name);
                }
            }
            assert!(told.rows.len() == told.labels.len() && told.rows.iter().all(|row| row.len() == told.columns.len()));
            assert!(told.rows.iter().flatten().chain(told.values.iter().map(|v| &v.value)).all(|value| value.is_finite()));
            let used = told.values.iter().map(|v| v.symbol).chain(told.columns.iter().map(|c| c.symbol));
            used.for_each(|symbol| assert!(symbols.contains(&symbol), "{symbol} is not listed, so no page can typeset it"));
        }
        assert!(session.inspect(Item { layer, index: usize::MAX }).is_none());
    }
    there
}

fn is_carried_out(formula: &Formula, session: &Run) -> bool {
    let is_set = |When { parameter, value }: When| {
        session.parameters().all().iter().any(|(name, set)| *name == parameter && set.to_string() == value)
    };
    formula.when.is_none_or(is_set)
}

fn placeholders(tex: &str) -> Vec<&str> {
    let parts: Vec<_> = tex.split('@').collect();
    parts.chunks(2).filter_map(|pair| pair.get(1).copied()).collect()
}

fn what_cannot_run_is_refused() {
    let scene = forage::shipped("sphere").unwrap();
    let error = |planner: &str, params: Overrides, seed| {
        Run::new(standard(), Setup { planner: planner.to_owned(), scene: Arc::clone(&scene), params, seed }).err().unwrap()
    };
    assert_eq!(error("psso", Overrides::new(), 1).field(), "planner");
    assert_eq!(error("pso", given(&[("omega", 1.0)]), 1).value(), "omega");
    assert_eq!(error("pso", given(&[("waypoints", 3.0)]), 1).value(), "waypoints", "it means nothing on functions");
    assert_eq!(error("pso", Overrides::new(), u64::MAX).field(), "seed");
}

/// A check of one planner.
type Check = fn(&'static Entry);

const CHECKS: &[(&str, Check)] = &[
    ("a_run_only_gets_better_and_its_verdict_is_true", a_run_only_gets_better_and_its_verdict_is_true),
    ("rewinding_is_exact", rewinding_is_exact),
    ("a_link_reproduces_the_hash", a_link_reproduces_the_hash),
    ("only_random_runs_depend_on_their_seed", only_random_runs_depend_on_their_seed),
    ("any_population_runs", any_population_runs),
    ("every_parameter_is_checked_at_both_ends", every_parameter_is_checked_at_both_ends),
    ("every_condition_can_be_met", every_condition_can_be_met),
    ("the_entry_describes_what_the_planner_does", the_entry_describes_what_the_planner_does),
    ("a_preset_runs_where_it_says_and_changes_something", a_preset_runs_where_it_says_and_changes_something),
];

/// A preset's values are allowed, differ from the defaults, and start a run on its scene.
fn a_preset_runs_where_it_says_and_changes_something(entry: &'static Entry) {
    for preset in entry.presets {
        let scene = forage::shipped(preset.scene).unwrap();
        let given = entry.preset(preset.name, scene.kind()).unwrap();
        let mut params = given.clone();
        if given.get("iterations").is_none() {
            params.insert("iterations", Value::from(3.0));
        }
        let mut session = session(entry, &scene, params, 1);
        session.step(2);
        assert_eq!(session.iteration(), 2, "{} {}", entry.name, preset.name);
        for (name, value) in preset.given().iter() {
            let parameter = entry.parameter(name);
            let parameter = parameter.unwrap_or_else(|| panic!("{} has no parameter {name}", entry.name));
            parameter.check(value).unwrap();
            assert!(entry.kinds.iter().any(|&kind| parameter.default_on(kind) != *value), "{} {}: {name}", entry.name, preset.name);
        }
    }
}

fn main() -> ExitCode {
    let mut trials = vec![
        trial("what_cannot_run_is_refused", what_cannot_run_is_refused),
        trial("no_two_setups_share_a_hash", no_two_setups_share_a_hash),
    ];
    for entry in standard().planners() {
        let encodings: Option<(&str, Check)> = (entry.family == "swarm").then_some(("every_encoding_runs", every_encoding_runs));
        for (name, check) in CHECKS.iter().copied().chain(encodings) {
            trials.push(trial(format!("{}::{}::{name}", entry.family, entry.name), move || check(entry)));
        }
    }
    libtest_mimic::run(&Arguments::from_args(), trials).exit_code()
}
