//! Golden hashes of complete runs: every planner, every kind of scene, several seeds. `tests/wasm.rs` checks the same
//! stored files in wasm under Node.
#![cfg(not(target_arch = "wasm32"))]

mod support;

use forage::{Given, Session, Setup, Value, catalogue::PLANNERS, shipped_names};
use support::{Driven, Followed, Golden, ITERATIONS, Log, bits, digest, drives, line, logs, motions, stored};

fn run(planner: &str, scene: &str, seed: u32, set: &str) -> Golden {
    let mut params = Given::from_iter([("iterations", Value::from(f64::from(ITERATIONS)))]);
    let more: std::collections::BTreeMap<String, serde_json::Value> = serde_json::from_str(&format!("{{{set}}}")).unwrap();
    more.into_iter().for_each(|(name, value)| params.insert(name, Value::from(value.to_string().trim_matches('"'))));
    let setup = Setup { planner: planner.to_owned(), scene: forage::shipped(scene).unwrap(), params, seed: u64::from(seed) };
    let mut session = Session::new(setup).unwrap();
    session.step(u64::from(ITERATIONS / 2));
    let half = session.hash();
    session.step(u64::MAX);
    let outcome = session.outcome();
    let exact = session.exact();
    let paths = match (&outcome.path, &outcome.tip_path) {
        (Some(path), _) => digest([path.as_flattened(), exact.map_or(&[][..], |exact| exact.path.as_flattened())].concat().as_slice()),
        (_, Some(tip)) => digest([tip.as_flattened(), exact.map_or(&[][..], |exact| exact.tip_path.as_flattened())].concat().as_slice()),
        _ => "none".to_owned(),
    };
    let cost = bits(outcome.cost);
    Golden { planner: planner.to_owned(), scene: scene.to_owned(), seed, set: set.to_owned(), paths, half, end: session.hash(), cost }
}

/// All planners on all shipped scenes they run on, three seeds each where that makes a difference.
fn every_run() -> Vec<Golden> {
    let mut runs = Vec::new();
    for entry in PLANNERS {
        for scene in shipped_names().filter(|scene| entry.check_scene(scene).is_ok()) {
            // A planner of planners carries out hundreds of runs a step: short ones will do.
            let mut set = if entry.family == "tuning" { r#""population": 4, "seeds": 2, "colony_iterations": 3"# } else { "" };
            // Ants would build sixty-six roads a run; one run below has them do so.
            if entry.stops && scene.kind() == forage::scene::Kind::Grid {
                set = r#""roads": "a-star""#;
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
            runs.extend(seeds.iter().map(|&seed| run(entry.name, scene.name(), seed, set)));
        }
    }
    // What no default reaches.
    runs.extend([
        run("ltqpso", "qpso-10m", 1, r#""initial": "normal", "segments": 12"#),
        run("qpso", "qpso-10m", 2, r#""encoding": "waypoints", "redraws": 20"#),
        run("wcpso", "qpso-10m", 3, r#""encoding": "waypoints", "smoothing": 0.9"#),
        run("ltqpso", "wcpso-discs", 4, r#""encoding": "polar", "smooth": true"#),
        run("pso", "wcpso-discs", 5, r#""encoding": "polar", "initial": "normal", "initial_std": 60, "redraws": 5"#),
        run("aco", "ant-bat-30", 3, r#""dead_end": "backtrack", "smooth": true, "alpha": 1.3"#),
        run("aco-wolf", "wolf-ant-20", 5, r#""step_limit": 40, "epsilon": 0, "tau_max": 1000"#),
        run("aco-dijkstra", "qpso-10m", 6, r#""q0_start": 0.9, "q0_end": 0.2, "seeded": 9"#),
        run("a-star", "wolf-ant-20", 1, r#""weight": 2.5, "expand": 3, "smooth": true"#),
        run(
            "pso-tuning",
            "wolf-ant-20",
            4,
            r#""colony": "aco-direction", "tune": "gamma,tau_0,ants", "population": 3, "colony_iterations": 2"#,
        ),
        run("bat", "ant-bat-30", 3, r#""population": 7"#),
        run("bat", "ant-bat-30", 4, r#""roads": "theta-star", "round": "open", "polish": true"#),
        run("two-opt", "ant-bat-30", 5, r#""roads": "dijkstra", "smooth": false, "round": "first-to-last""#),
        run("rrt-guided", "arm-cuboid", 7, r#""iterations": 2000, "step_size": 0.05, "samples": 30, "keep": 6"#),
        run("rrt", "arm-bench", 8, r#""iterations": 20000, "goal_bias": 0.05, "polyline": false, "blend": 6"#),
        run("rrt-star", "arm-cuboid", 9, r#""iterations": 1500, "informed": false, "rewire": 6"#),
        run("rrt-star", "wcpso-discs", 9, r#""iterations": 1500, "smooth": true"#),
        run("rrt-joint", "arm-puma", 10, r#""iterations": 2000, "radius": 0.02, "goals": 3, "shorten": false"#),
        run("cpso", "discs-slalom", 6, r#""early_stop": 30, "ordered": false"#),
    ]);
    runs
}

#[test]
fn every_planner_gives_the_stored_bits_on_every_scene() {
    let runs = every_run();
    if std::env::var_os("FORAGE_BLESS").is_some() {
        std::fs::write("tests/golden.json", serde_json::to_string_pretty(&runs).unwrap() + "\n").unwrap();
        return; // the file is part of the test's program: the next run compares with it
    }
    let stored = stored();
    assert_eq!(runs.len(), stored.len(), "a planner or a scene came or went: bless the file");
    for (run, stored) in runs.iter().zip(&stored) {
        assert_eq!(run, stored);
    }
}

fn drive(planner: &str, scene: &str, seed: u32, look_ahead: f64) -> Driven {
    let setup = Setup { planner: planner.to_owned(), scene: forage::shipped(scene).unwrap(), params: Given::new(), seed: u64::from(seed) };
    let mut session = Session::new(setup).unwrap();
    session.step(u64::MAX);
    let drive = session.drive(&Given::from_iter([("look_ahead", Value::from(look_ahead))])).unwrap().unwrap();
    Driven { planner: planner.to_owned(), scene: scene.to_owned(), seed, look_ahead, rows: digest(&drive.rows) }
}

/// Whole drives, to the last bit: free ones and one or another that touches.
#[test]
fn every_drive_gives_the_stored_bits() {
    let mut runs = vec![drive("ltqpso", "qpso-10m-empty", 1, 0.35), drive("wcpso", "qpso-10m", 1, 0.35)];
    for seed in [1, 2, 12_345] {
        runs.extend([0.2, 0.35, 1.0].map(|look_ahead| drive("ltqpso", "qpso-10m", seed, look_ahead)));
    }
    if std::env::var_os("FORAGE_BLESS").is_some() {
        std::fs::write("tests/drives.json", serde_json::to_string_pretty(&runs).unwrap() + "\n").unwrap();
        return;
    }
    assert_eq!(runs, drives());
}

fn follow(planner: &str, scene: &str, seed: u32, set: &str) -> Followed {
    let setup = Setup { planner: planner.to_owned(), scene: forage::shipped(scene).unwrap(), params: Given::new(), seed: u64::from(seed) };
    let mut session = Session::new(setup).unwrap();
    session.step(u64::MAX);
    let more: std::collections::BTreeMap<String, serde_json::Value> = serde_json::from_str(&format!("{{{set}}}")).unwrap();
    let mut given = Given::new();
    more.into_iter().for_each(|(name, value)| given.insert(name, Value::from(value.to_string().trim_matches('"'))));
    let motion = session.motion(&given).unwrap().unwrap();
    let rows = digest(&[motion.rows, motion.skeletons].concat());
    Followed { planner: planner.to_owned(), scene: scene.to_owned(), seed, set: set.to_owned(), rows }
}

/// Whole motions of arms, to the last bit.
#[test]
fn every_motion_gives_the_stored_bits() {
    let mut all = Vec::new();
    for planner in ["rrt-guided", "rrt-connect", "rrt-joint"] {
        all.extend(["arm-cuboid", "arm-free", "arm-puma"].map(|scene| follow(planner, scene, 1, "")));
    }
    all.push(follow("rrt-guided", "arm-cuboid", 2, r#""orientation": "random", "seed": 3"#));
    all.push(follow("rrt-guided", "arm-cuboid", 3, r#""orientation": "home", "postures": "nearest""#));
    all.push(follow("rrt-star", "arm-cuboid", 4, r#""radius": 0.02, "spacing": 0.05"#));
    if std::env::var_os("FORAGE_BLESS").is_some() {
        std::fs::write("tests/motions.json", serde_json::to_string_pretty(&all).unwrap() + "\n").unwrap();
        return;
    }
    assert_eq!(all, motions());
}

fn log(planner: &str, scene: &str, seed: u32, set: &str) -> Log {
    let more: std::collections::BTreeMap<String, serde_json::Value> = serde_json::from_str(&format!("{{{set}}}")).unwrap();
    let mut params = Given::new();
    more.into_iter().for_each(|(name, value)| params.insert(name, Value::from(value.to_string().trim_matches('"'))));
    let setup = Setup { planner: planner.to_owned(), scene: forage::shipped(scene).unwrap(), params, seed: u64::from(seed) };
    let mut session = Session::new(setup).unwrap();
    session.step(u64::MAX);
    let lines = session.events().iter().map(|e| line(e.iteration, e.time, e.place, e.kind, e.obstacle, &e.reason)).collect();
    Log { planner: planner.to_owned(), scene: scene.to_owned(), seed, set: set.to_owned(), lines }
}

/// Every decision of whole drives, with its time and place to the last bit and its reason to the last word.
#[test]
fn every_log_of_events_is_the_stored_one() {
    let mut all = vec![log("wolf-ant-drive", "wolf-ant-20", 11, "")];
    for planner in ["wolf-ant-drive", "a-star-drive", "d-star-lite-drive"] {
        all.extend(["wolf-ant-20", "crossing", "patrol", "corridor"].map(|scene| log(planner, scene, 1, "")));
    }
    // A blind robot: what comes, comes.
    all.push(log("a-star-drive", "crossing", 1, r#""robot": "given", "sensor": 0, "border": "bounce""#));
    if std::env::var_os("FORAGE_BLESS").is_some() {
        std::fs::write("tests/events.json", serde_json::to_string_pretty(&all).unwrap() + "\n").unwrap();
        return;
    }
    assert_eq!(all, logs());
    let told = |kind: &str| all.iter().flat_map(|log| &log.lines).any(|line| line.contains(kind));
    for kind in ["set-out", "seen", "foreseen", "detour", "back", "replan", "wait", "go-on", "evade", "collision", "arrived"] {
        assert!(told(kind), "no stored log has {kind}");
    }
}

#[test]
fn seeds_and_parameters_change_the_hash() {
    let hashes: std::collections::BTreeSet<_> = stored().into_iter().map(|run| run.end).collect();
    assert!(hashes.len() >= 100, "all planners, both kinds of scene, several seeds");
    assert_eq!(hashes.len(), stored().len(), "no two golden runs end alike");
}
