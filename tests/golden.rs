//! Golden hashes of complete runs: every planner, every kind of scene, several seeds. `tests/wasm.test.mjs` checks the same
//! stored files in wasm under Node.
//!
//! A test for each planner, so that a failure names it. `FORAGE_BLESS=1 cargo test --test golden` stores all runs again, but for
//! what they show: `FORAGE_BLESS=contents` stores that.
#![cfg(not(target_arch = "wasm32"))]

#[path = "support/contents.rs"]
mod contents;
mod support;
#[path = "support/trial.rs"]
mod trial;

use std::process::ExitCode;

use contents::shown;
use forage::{
    Overrides, Run, Setup, Value,
    describe::{Entry, Extra},
    standard,
};
use libtest_mimic::Arguments;
use support::{Driven, Followed, Golden, ITERATIONS, Log, bits, digest, drives, line, logs, motions, stored};
use trial::trial;

/// A golden run, and what it showed at its beginning, half way and at its end.
fn run(planner: &str, scene: &str, seed: u32, set: &str) -> (Golden, [String; 3]) {
    let mut params = Overrides::from_iter([("iterations", Value::from(f64::from(ITERATIONS)))]);
    let more: std::collections::BTreeMap<String, serde_json::Value> = serde_json::from_str(&format!("{{{set}}}")).unwrap();
    let iterations = more.get("iterations").map_or(u64::from(ITERATIONS), |given| given.as_u64().unwrap());
    more.into_iter().for_each(|(name, value)| params.insert(name, Value::from(value.to_string().trim_matches('"'))));
    let setup = Setup { planner: planner.to_owned(), scene: forage::shipped(scene).unwrap(), params, seed: u64::from(seed) };
    let mut run = Run::new(standard(), setup).unwrap();
    let first = shown(&mut run);
    run.step(iterations / 2);
    let (half, middle) = (run.hash(), shown(&mut run));
    run.step(u64::MAX);
    let last = shown(&mut run);
    let outcome = run.outcome();
    let exact = run.exact();
    let paths = match (&outcome.path, &outcome.tip_path) {
        (Some(path), _) => digest([path.as_flattened(), exact.map_or(&[][..], |exact| exact.path.as_flattened())].concat().as_slice()),
        (_, Some(tip)) => digest([tip.as_flattened(), exact.map_or(&[][..], |exact| exact.tip_path.as_flattened())].concat().as_slice()),
        _ => "none".to_owned(),
    };
    let cost = bits(outcome.cost);
    let (planner, scene, set) = (planner.to_owned(), scene.to_owned(), set.to_owned());
    (Golden { planner, scene, seed, set, paths, half, end: run.hash(), cost }, [first, middle, last])
}

/// A golden run to be made: planner, scene, seed, parameters.
type Spec = (&'static str, &'static str, u32, &'static str);

/// All planners on all shipped scenes they run on, three seeds each where that makes a difference.
fn specs() -> Vec<Spec> {
    let mut specs = Vec::new();
    for entry in standard().planners() {
        for scene in standard().scenes().iter().filter(|scene| entry.check_scene(scene).is_ok()) {
            // A planner of planners carries out hundreds of runs a step: short ones will do.
            let mut set =
                if entry.name == "pso-tuning" { r#""iterations": 30, "population": 4, "seeds": 2, "colony_iterations": 3"# } else { "" };
            // Ants would build sixty-six roads a run; one run below has them do so.
            if entry.stops && scene.kind() == forage::scene::GRID {
                set = r#""roads": "a-star""#;
            }
            // Few will do where each tour of hundreds of stops is improved by local search.
            if scene.name() == "random-280" && entry.parameter("local_search").is_some() {
                set = r#""population": 8"#;
            }
            // A drive takes longer than two hundred periods.
            if ["a-star-drive", "d-star-lite-drive"].contains(&entry.name) {
                set = r#""iterations": 5000"#;
            }
            let seeds: &[u32] = match entry.name {
                "a-star-drive" | "d-star-lite-drive" => &[1],
                // What draws nothing has one run; what draws only where it begins soon has the same one again.
                _ if entry.family == "search" => &[1],
                "held-karp" => &[1],
                // Its arm goes past these cuboids as if there were none: the same runs as on arm-cuboid.
                "rrt-joint" if ["arm-free", "arm-bench"].contains(&scene.name()) => &[],
                "two-opt" => &[1, 2],
                _ => &[1, 2, 12_345],
            };
            specs.extend(seeds.iter().map(|&seed| (entry.name, scene.name(), seed, set)));
        }
    }
    // What no default reaches.
    specs.extend([
        ("ltqpso", "qpso-10m", 1, r#""initial": "normal", "segments": 12"#),
        ("qpso", "qpso-10m", 2, r#""encoding": "waypoints", "redraws": 20"#),
        ("wcpso", "qpso-10m", 3, r#""encoding": "waypoints", "smoothing": 0.9"#),
        ("ltqpso", "wcpso-discs", 4, r#""encoding": "polar", "smooth": true"#),
        ("pso", "wcpso-discs", 5, r#""encoding": "polar", "initial": "normal", "initial_std": 60, "redraws": 5"#),
        ("aco", "ant-bat-30", 3, r#""dead_end": "backtrack", "smooth": true, "alpha": 1.3"#),
        ("aco-wolf", "wolf-ant-20", 5, r#""step_limit": 40, "epsilon": 0, "tau_max": 1000"#),
        ("aco-dijkstra", "qpso-10m", 6, r#""q0_start": 0.9, "q0_end": 0.2, "seeded": 9"#),
        ("a-star", "wolf-ant-20", 1, r#""weight": 2.5, "expand": 3, "smooth": true"#),
        (
            "pso-tuning",
            "wolf-ant-20",
            4,
            r#""colony": "aco-direction", "tune": "gamma,tau_0,ants", "population": 3, "colony_iterations": 2"#,
        ),
        ("bat", "ant-bat-30", 3, r#""population": 7"#),
        ("bat", "ant-bat-30", 4, r#""roads": "theta-star", "round": "open", "polish": true"#),
        ("bat", "random-280", 6, r#""iterations": 2"#),
        ("tour-pso", "random-280", 7, r#""iterations": 2"#),
        ("bat", "random-52", 5, r#""local_search": "none""#),
        ("bat", "random-52", 6, r#""local_search": "none", "replace": "better""#),
        ("tour-pso", "random-52", 7, r#""local_search": "none""#),
        ("bat-continuous", "matyas", 8, r#""pull": "printed", "random": "particle""#),
        ("rrt-guided", "arm-cuboid", 11, r#""choice": "distance""#),
        ("two-opt", "ant-bat-30", 5, r#""roads": "dijkstra", "smooth": false, "round": "first-to-last""#),
        ("rrt-guided", "arm-cuboid", 7, r#""iterations": 2000, "step_size": 0.05, "samples": 30, "keep": 6"#),
        ("rrt", "arm-bench", 8, r#""iterations": 20000, "goal_bias": 0.05, "polyline": false, "blend": 6"#),
        ("rrt-star", "arm-cuboid", 9, r#""iterations": 1500, "informed": false, "rewire": 6"#),
        ("rrt-star", "wcpso-discs", 9, r#""iterations": 1500, "smooth": true"#),
        ("rrt-joint", "arm-puma", 10, r#""iterations": 2000, "radius": 0.02, "goals": 3, "shorten": false"#),
        ("cpso", "discs-slalom", 6, r#""early_stop": 30, "ordered": false"#),
        ("cpso", "sphere", 7, r#""w_law": "linear", "random": "particle""#),
        ("pso", "egg-crate", 8, r#""v_max": 1, "v_max_unit": "absolute""#),
        (
            "wcpso",
            "matyas",
            1,
            r#""hen_keep": "better", "hen_partner": "best", "hen_timing": "after", "patience": 1, "random": "particle""#,
        ),
        ("wcpso", "rosenbrock", 2, r#""s2": "source", "w_law": "linear", "c1_law": "linear", "c2_law": "linear""#),
        ("wcpso", "wcpso-discs", 6, r#""hen_timing": "after", "hen_partner": "best""#),
        ("wcpso", "wcpso-discs", 7, r#""hen_keep": "better""#),
        ("wcpso", "wcpso-discs", 8, r#""perturb": false"#),
    ]);
    specs
}

/// Every golden run of a planner has the stored bits, and there are as many as stored.
fn check_planner(planner: &str) {
    let stored: Vec<_> = stored().into_iter().filter(|run| run.planner == planner).collect();
    let specs: Vec<_> = specs().into_iter().filter(|spec| spec.0 == planner).collect();
    assert_eq!(specs.len(), stored.len(), "{planner} has other golden runs than tests/golden.json: bless the file");
    let contents = contents::stored();
    for ((planner, scene, seed, set), stored) in specs.into_iter().zip(stored) {
        let (run, shown) = run(planner, scene, seed, set);
        // What is shown says more of a mistake than a hash.
        let key = contents::key(planner, scene, seed, set);
        assert_eq!(Some(&shown), contents.get(&key), "what {key} shows");
        assert_eq!(run, stored);
    }
}

/// Writes a stored file again.
fn bless(file: &str, stored: &impl serde::Serialize) {
    std::fs::write(file, serde_json::to_string_pretty(stored).unwrap() + "\n").unwrap();
}

fn drive(planner: &str, scene: &str, seed: u32, look_ahead: f64) -> Driven {
    let setup =
        Setup { planner: planner.to_owned(), scene: forage::shipped(scene).unwrap(), params: Overrides::new(), seed: u64::from(seed) };
    let mut run = Run::new(standard(), setup).unwrap();
    run.step(u64::MAX);
    let drive = run.follow("drive", &Overrides::from_iter([("look_ahead", Value::from(look_ahead))])).unwrap().unwrap();
    Driven { planner: planner.to_owned(), scene: scene.to_owned(), seed, look_ahead, rows: digest(drive.rows()) }
}

/// Whole drives: free ones and one or another that touches.
fn every_drive() -> Vec<Driven> {
    let mut runs = vec![drive("ltqpso", "qpso-10m-empty", 1, 0.35), drive("wcpso", "qpso-10m", 1, 0.35)];
    for seed in [1, 2, 12_345] {
        runs.extend([0.2, 0.35, 1.0].map(|look_ahead| drive("ltqpso", "qpso-10m", seed, look_ahead)));
    }
    runs
}

fn follow(planner: &str, scene: &str, seed: u32, set: &str) -> Followed {
    let setup =
        Setup { planner: planner.to_owned(), scene: forage::shipped(scene).unwrap(), params: Overrides::new(), seed: u64::from(seed) };
    let mut run = Run::new(standard(), setup).unwrap();
    run.step(u64::MAX);
    let more: std::collections::BTreeMap<String, serde_json::Value> = serde_json::from_str(&format!("{{{set}}}")).unwrap();
    let mut given = Overrides::new();
    more.into_iter().for_each(|(name, value)| given.insert(name, Value::from(value.to_string().trim_matches('"'))));
    let motion = run.follow("motion", &given).unwrap().unwrap();
    let extra = motion.extra();
    let [("skeletons", Extra::Rows(skeletons))] = extra[..] else { panic!("{extra:?}") };
    let rows = digest(&[motion.rows(), skeletons].concat());
    Followed { planner: planner.to_owned(), scene: scene.to_owned(), seed, set: set.to_owned(), rows }
}

/// Whole motions of arms.
fn every_motion() -> Vec<Followed> {
    let mut all = Vec::new();
    for planner in ["rrt-guided", "rrt-connect", "rrt-joint"] {
        all.extend(["arm-cuboid", "arm-free", "arm-puma"].map(|scene| follow(planner, scene, 1, "")));
    }
    all.push(follow("rrt-guided", "arm-cuboid", 2, r#""orientation": "random", "seed": 3"#));
    all.push(follow("rrt-guided", "arm-cuboid", 3, r#""orientation": "home", "postures": "nearest""#));
    all.push(follow("rrt-star", "arm-cuboid", 4, r#""radius": 0.02, "spacing": 0.05"#));
    all
}

fn log(planner: &str, scene: &str, seed: u32, set: &str) -> Log {
    let more: std::collections::BTreeMap<String, serde_json::Value> = serde_json::from_str(&format!("{{{set}}}")).unwrap();
    let mut params = Overrides::new();
    more.into_iter().for_each(|(name, value)| params.insert(name, Value::from(value.to_string().trim_matches('"'))));
    let setup = Setup { planner: planner.to_owned(), scene: forage::shipped(scene).unwrap(), params, seed: u64::from(seed) };
    let mut run = Run::new(standard(), setup).unwrap();
    run.step(u64::MAX);
    let lines = run.events().iter().map(|e| line(e.iteration, e.time, e.place, e.kind, e.obstacle, &e.reason.text())).collect();
    Log { planner: planner.to_owned(), scene: scene.to_owned(), seed, set: set.to_owned(), lines }
}

/// Every decision of whole drives, with its time, place and reason.
fn every_log() -> Vec<Log> {
    let mut all = vec![log("wolf-ant-drive", "wolf-ant-20", 23, "")];
    for planner in ["wolf-ant-drive", "a-star-drive", "d-star-lite-drive"] {
        all.extend(["wolf-ant-20", "crossing", "patrol", "corridor"].map(|scene| log(planner, scene, 1, "")));
    }
    // A blind robot: what comes, comes.
    all.push(log("a-star-drive", "crossing", 1, r#""robot": "given", "sensor": 0, "border": "bounce""#));
    all
}

/// The stored logs have every kind of event.
fn check_kinds_of_events() {
    let all = logs();
    let has = |kind: &str| all.iter().flat_map(|log| &log.lines).any(|line| line.contains(kind));
    for kind in ["set-out", "seen", "foreseen", "detour", "back", "replan", "wait", "go-on", "evade", "collision", "arrived"] {
        assert!(has(kind), "no stored log has {kind}");
    }
}

/// No two golden runs end in the same state: seeds and parameters change the hash.
fn check_hashes_differ() {
    let hashes: std::collections::BTreeSet<_> = stored().into_iter().map(|run| run.end).collect();
    assert!(hashes.len() >= 100, "all planners, all kinds of scene, several seeds");
    assert_eq!(hashes.len(), stored().len(), "no two golden runs end alike");
}

fn main() -> ExitCode {
    if let Some(what) = std::env::var_os("FORAGE_BLESS") {
        let all = specs().into_iter().map(|(planner, scene, seed, set)| {
            let (run, shown) = run(planner, scene, seed, set);
            (run, (contents::key(planner, scene, seed, set), shown))
        });
        let (runs, shown): (Vec<_>, contents::Contents) = all.unzip();
        if what == "contents" {
            bless("tests/contents.json", &shown);
            return ExitCode::SUCCESS;
        }
        bless("tests/golden.json", &runs);
        bless("tests/drives.json", &every_drive());
        bless("tests/motions.json", &every_motion());
        bless("tests/events.json", &every_log());
        return ExitCode::SUCCESS;
    }
    let of_planner = |entry: &'static Entry| {
        trial(format!("{}::{}::golden_runs_have_the_stored_bits", entry.family, entry.name), || check_planner(entry.name))
    };
    let mut trials: Vec<_> = standard().planners().iter().copied().map(of_planner).collect();
    trials.extend([
        trial("drive::drives_have_the_stored_bits", || assert_eq!(every_drive(), drives())),
        trial("arm::motions_have_the_stored_bits", || assert_eq!(every_motion(), motions())),
        trial("dynamic::events_are_the_stored_ones", || assert_eq!(every_log(), logs())),
        trial("dynamic::every_kind_of_event_is_stored", check_kinds_of_events),
        trial("golden_runs_end_in_different_states", check_hashes_differ),
    ]);
    libtest_mimic::run(&Arguments::from_args(), trials).exit_code()
}
