//! What must hold for every planner in the catalogue: the checks of the conformance suite, and what is particular to ours. A
//! new planner is tested by being listed: each check is a test of its own for each planner, called
//! `family::planner::what_holds`.
//!
//! `FORAGE_RANDOM_RUNS` says how many random runs of a planner each check sees.
#![cfg(not(target_arch = "wasm32"))]

#[path = "support/trial.rs"]
mod trial;

use std::{collections::BTreeSet, process::ExitCode, sync::Arc};

use forage::{
    Overrides, Run, Scene, Setup, Status, Value,
    arm::ArmScene,
    describe::Entry,
    kernel::rng::Stream,
    scene::{DiscsScene, GRID, GridScene},
    standard,
    testing::{CHECKS, Check, Suite},
};
use libtest_mimic::Arguments;
use trial::trial;

/// The shipped scenes that a planner runs on.
fn scenes(entry: &Entry) -> Vec<Arc<Scene>> {
    standard().scenes().iter().filter(|scene| entry.check_scene(scene).is_ok()).cloned().collect()
}

fn given(pairs: &[(&str, f64)]) -> Overrides {
    pairs.iter().map(|&(name, value)| (name, Value::from(value))).collect()
}

/// How many random runs a check sees.
fn random_runs() -> u32 {
    std::env::var("FORAGE_RANDOM_RUNS").ok().and_then(|runs| runs.parse().ok()).unwrap_or(Suite::RANDOM_RUNS)
}

/// A check of the conformance suite. A planner of planners judges each particle by a short run, and ants would build
/// sixty-six roads a run.
fn conforms(entry: &Entry, check: Check) {
    let suite = Suite::new(standard(), entry.name).random_runs(random_runs());
    let suite = match entry.family {
        "tuning" => suite.set("seeds", 1.0).set("colony_iterations", 1.0).set("population", 4.0),
        "tour" => suite.set("roads", "a-star"),
        // Smoothing may free a path that the swarm still charges: then one that costs more replaces it.
        "swarm" if check.name == "results_only_get_better" => suite.set("smooth", Value::Flag(false)),
        _ => suite,
    };
    suite.run_checks(&[check]).assert();
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

/// Readings of the best never rise, each particle is evaluated equally often, and what is said to be feasible really crosses
/// nothing (checked here by dense sampling, not by the geometry that said so).
fn what_a_run_says_is_true(entry: &'static Entry) {
    let scenes = scenes(entry);
    let mut stream = Stream::new(7, 0);
    for _ in 0..random_runs() {
        let scene = &scenes[stream.below(scenes.len())];
        let population = 1 + stream.below(59) as u64;
        let seed = stream.below(10_000) as u64;
        let mut session = session(entry, scene, sized(entry, scene, population as f64, 60.0), seed);
        let first = session.outcome().evaluations;
        let mut least = [f64::INFINITY; 2];
        loop {
            for (name, least) in ["best", "free"].into_iter().zip(&mut least) {
                if let Some(now) = session.readings().get(name).filter(|value| !value.is_nan()) {
                    assert!(now <= *least, "{name} rose from {least} to {now}");
                    *least = now;
                }
            }
            if session.step(1) != Status::Running {
                break;
            }
        }
        let staged = !session.stages().is_empty();
        let outcome = session.outcome();
        assert!(outcome.failed_at.is_none() || outcome.status == Status::Failed, "{:?} of a run that has not failed", outcome.failed_at);
        if size_name(entry).is_some() && !staged {
            let rounds = (outcome.evaluations - first) / (population * 60);
            let all = outcome.evaluations - first == rounds * population * 60;
            assert!((1..=2).contains(&rounds) && all, "every particle is evaluated equally often, once or twice, in every iteration");
            assert!(entry.family != "swarm" || first >= population);
        }
        if outcome.cost.is_some() {
            for (name, value) in &outcome.readings {
                assert!(!value.is_nan() || ["free", "f", "mean", "settled", "smallest_distance"].contains(name), "{name}");
            }
        }
        if let Some(path) = &outcome.path {
            let deepest = samples(path).map(|point| clearance(scene, point)).fold(f64::INFINITY, f64::min);
            assert!(!outcome.feasible || deepest > -1e-12, "said to be free, but {deepest} inside an obstacle");
            assert!(deepest >= outcome.clearance.unwrap_or(f64::INFINITY) - 1e-12, "sampling found it deeper than the clearance says");
        }
        if let (Some(tip), Ok(arm)) = (&outcome.tip_path, scene.get::<ArmScene>()) {
            let inside = |p: [f64; 3]| arm.cuboids.iter().any(|c| (0..3).all(|i| c.min[i] < p[i] && p[i] < c.max[i]));
            let touches = tip
                .windows(2)
                .any(|w| (0..=50).map(|k| f64::from(k) / 50.0).any(|t| inside([0, 1, 2].map(|i| w[0][i] + t * (w[1][i] - w[0][i])))));
            assert!(!outcome.feasible || !touches, "said to be free, but it lies in a cuboid");
        }
    }
}

/// Nothing is offered that cannot be tried, and nothing tried of which it cannot be read what it does.
fn every_planner_has_a_case_and_says_what_it_does() {
    for entry in standard().planners() {
        assert!(!entry.cases.is_empty() && entry.pseudocode.len() > 3, "{}", entry.name);
        // With numbers of the iteration, not of the setup alone.
        let live =
            entry.readings.iter().filter(|reading| entry.pseudocode.iter().any(|line| line.contains(&format!("@{}@", reading.name))));
        assert!(live.count() > 0, "{}", entry.name);
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

/// Any small population runs, and finds something if it is a swarm.
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
}

/// Encoding and planner vary independently: a swarm runs on every kind of path, way-points or polar, smoothed or not.
fn every_encoding_runs(entry: &'static Entry) {
    let mut all: Vec<_> =
        scenes(entry).into_iter().filter(|scene| scene.ends().is_some()).map(|scene| (scene, Some(10.0), 100.0)).collect();
    // A point among the same walls: its best paths touch corners exactly, where rounding decides. A whole population finds them, and late.
    let mut point: serde_json::Value = serde_json::from_str(&forage::shipped("qpso-10m").unwrap().to_json()).unwrap();
    point.as_object_mut().unwrap().remove("robot");
    all.push((Arc::new(standard().read_scene_value(point).unwrap()), None, 400.0));
    for (scene, population, iterations) in all {
        for (encoding, corners) in [("waypoints", 3), ("polar", 7)] {
            let points = corners + 2;
            let run = |smooth: bool| {
                let mut params = given(&[("iterations", iterations)]);
                if let Some(population) = population {
                    params.insert("population", Value::from(population));
                }
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

fn main() -> ExitCode {
    let mut trials = vec![
        trial("what_cannot_run_is_refused", what_cannot_run_is_refused),
        trial("every_planner_has_a_case_and_says_what_it_does", every_planner_has_a_case_and_says_what_it_does),
        trial("no_two_setups_share_a_hash", no_two_setups_share_a_hash),
    ];
    for &entry in standard().planners() {
        let mut add = |name: &str, check: Box<dyn FnOnce() + Send>| {
            trials.push(trial(format!("{}::{}::{name}", entry.family, entry.name), check));
        };
        for &check in CHECKS {
            add(check.name, Box::new(move || conforms(entry, check)));
        }
        add("what_a_run_says_is_true", Box::new(|| what_a_run_says_is_true(entry)));
        add("any_population_runs", Box::new(|| any_population_runs(entry)));
        if entry.family == "swarm" {
            add("every_encoding_runs", Box::new(|| every_encoding_runs(entry)));
        }
    }
    libtest_mimic::run(&Arguments::from_args(), trials).exit_code()
}
