//! Trees for an arm's tip on the paper's cuboid and on the one that OMPL was measured with: extensions a second, time to a
//! first path, its nodes, the length of what is handed over; then forward and inverse kinematics a second, and how long it
//! takes to follow a path.
//!
//! `cargo bench --bench trees` prints the tables, `cargo bench --bench trees -- rrt-guided` those of one planner. The time is
//! that of a machine; only ratios mean something elsewhere.

#![expect(clippy::disallowed_types, reason = "a benchmark tells time")]

use std::{
    hint::black_box,
    sync::Arc,
    time::{Duration, Instant},
};

use forage::{
    Overrides, Scene, Value,
    arm::{ArmScene, Posture},
    describe::{Entry, Start},
    follow::motion,
    geometry::length_in_space,
    kernel::{Readings, Solution, Stepper, rng::Stream},
    params::Parameters,
    shipped, standard,
};

/// Planners, whether the whole arm counts, and what differs from their defaults. OMPL's trees are of the tip alone; its RRT samples the
/// goal once in twenty steps, the paper's never.
const RUNS: [(&str, bool, &[(&str, f64)]); 10] = [
    ("rrt", false, &[]),
    ("rrt", false, &[("goal_bias", 0.05)]),
    ("rrt-guided", false, &[]),
    ("rrt-guided", true, &[]),
    ("rrt-connect", false, &[]),
    ("rrt-connect", true, &[]),
    ("rrt-star", false, &[]),
    ("rrt-star", true, &[]),
    ("rrt-star", false, &[("iterations", 1000.0)]),
    ("rrt-joint", true, &[]),
];

/// OMPL 1.5.2 in C++ with an exact segment test on `arm-bench`, step and tolerance 0.03, medians, on another machine of this
/// kind: milliseconds and nodes. Its paths are 1.40 m long after simplification.
const OMPL: [(&str, f64, u32); 2] = [("RRT", 0.24, 197), ("RRT-Connect", 0.12, 108)];

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_unstable_by(f64::total_cmp);
    if values.is_empty() { f64::NAN } else { values[values.len() / 2] }
}

/// Whether the whole arm counts, and parameters.
type Given = (bool, &'static [(&'static str, f64)]);

/// What a seed gives.
struct Run {
    extensions: u64,
    /// In the tree, all along.
    seconds: f64,
    /// To a first path.
    first: f64,
    /// When that was found.
    nodes: f64,
    raw: f64,
    finished: f64,
    /// Shortening, fitting, smoothing.
    finishing: f64,
    /// The arm along it.
    following: f64,
}

fn settings(entry: &'static Entry, scene: &Scene, (whole, given): Given, finish: bool) -> Parameters {
    let mut params: Overrides = given.iter().map(|&(name, number)| (name, Value::from(number))).collect();
    if entry.parameters.iter().flat_map(|group| *group).any(|parameter| parameter.name == "reachable") {
        params.insert("reachable", Value::Flag(whole));
    }
    for part in ["shorten", "polyline", "smooth"] {
        params.insert(part, Value::Flag(finish));
    }
    Parameters::new(entry.parameters, scene.kind(), &params).unwrap()
}

fn tip_length(solution: &Solution) -> f64 {
    match solution {
        Solution::Reach { path, .. } => length_in_space(path),
        _ => f64::NAN,
    }
}

/// A whole run as it is, and again with what is made of its path. `None` without a path.
fn run(entry: &'static Entry, scene: &Arc<Scene>, given: Given, seed: u64) -> Option<Run> {
    let mut run = Stepper::from(
        (entry.start)(&Start { entry, scene, parameters: &settings(entry, scene, given, false), seed, entries: &**standard() }).unwrap(),
    );
    let begun = Instant::now();
    while run.planner.best().is_none() && run.step(|_| Vec::new()) {}
    let first = begun.elapsed().as_secs_f64();
    let raw = tip_length(&run.planner.best()?.solution);
    let mut readings = Readings::default();
    run.planner.read(&mut readings);
    let nodes = readings.get("nodes").unwrap_or(f64::NAN);
    let begun = Instant::now();
    while run.step(|_| Vec::new()) {}
    let seconds = first + begun.elapsed().as_secs_f64();

    let mut run = Stepper::from(
        (entry.start)(&Start { entry, scene, parameters: &settings(entry, scene, given, true), seed, entries: &**standard() }).unwrap(),
    );
    while run.step(|_| Vec::new()) {}
    let begun = Instant::now();
    let solution = run.planner.best()?.solution;
    let finishing = begun.elapsed().as_secs_f64();
    let begun = Instant::now();
    black_box(motion::along(scene, Some(&solution), &Overrides::new()).unwrap());
    let following = begun.elapsed().as_secs_f64();
    let extensions = run.iteration;
    Some(Run { extensions, seconds, first, nodes, raw, finished: tip_length(&solution), finishing, following })
}

fn trees(scene: &Arc<Scene>, seeds: u64) {
    let exact = scene.exact().map_or(f64::NAN, |exact| exact.length);
    println!("\n{}: medians of {seeds} seeds, step 0.03 m; the exact optimum is {exact:.4} m", scene.name());
    println!(
        "{:30} {:>6} {:>13} {:>14} {:>7} {:>8} {:>10} {:>9} {:>13} {:>14}",
        "planner", "found", "extensions/s", "first path ms", "nodes", "tree m", "finished m", "worst m", "finishing ms", "following ms"
    );
    let only: Vec<String> = std::env::args().skip(1).filter(|arg| !arg.starts_with("--")).collect();
    for (name, whole, given) in RUNS.into_iter().filter(|(name, ..)| only.is_empty() || only.iter().any(|only| only == name)) {
        let entry = standard().planner(name).unwrap();
        let runs: Vec<Run> = (1..=seeds).filter_map(|seed| run(entry, scene, (whole, given), seed)).collect();
        let of = |of: fn(&Run) -> f64| median(runs.iter().map(of).collect());
        let rate = runs.iter().map(|run| run.extensions as f64).sum::<f64>() / runs.iter().map(|run| run.seconds).sum::<f64>();
        let name = format!("{name}, {}", if whole { "arm" } else { "tip" });
        let label = given.iter().fold(name, |label, (name, value)| format!("{label} {name}={value}"));
        let worst = runs.iter().map(|run| run.finished).fold(f64::NAN, f64::max);
        println!(
            "{label:30} {:>6} {rate:>13.0} {:>14.4} {:>7.0} {:>8.4} {:>10.4} {worst:>9.4} {:>13.3} {:>14.2}",
            runs.len(),
            1e3 * of(|run| run.first),
            of(|run| run.nodes),
            of(|run| run.raw),
            of(|run| run.finished),
            1e3 * of(|run| run.finishing),
            1e3 * of(|run| run.following),
        );
    }
    if scene.name() == "arm-bench" {
        for (name, ms, nodes) in OMPL {
            println!("{:30} {:>6} {:>13} {ms:>14.4} {nodes:>7} {:>8} {:>10.2}", format!("OMPL 1.5.2 {name}"), "", "", "", 1.40);
        }
    }
}

/// How often a second something can be done with a posture, one after the other.
fn rate<T>(postures: &[Posture], time: Duration, mut act: impl FnMut(usize, &Posture) -> T) -> f64 {
    let begun = Instant::now();
    let mut count = 0_u32;
    loop {
        for (i, posture) in postures.iter().enumerate() {
            black_box(act(i, black_box(posture)));
            count += 1;
        }
        if begun.elapsed() >= time {
            return f64::from(count) / begun.elapsed().as_secs_f64();
        }
    }
}

fn kinematics(time: Duration) {
    println!("\n{:14} {:>16} {:>16} {:>20} {:>12}", "arm of", "skeletons/s", "tip poses/s", "inverse, all/s", "solutions");
    for name in ["arm-cuboid", "arm-puma"] {
        let scene = shipped(name).unwrap();
        let arm = &scene.get::<ArmScene>().unwrap().arm;
        let mut rng = Stream::new(1, 0);
        let postures: Vec<Posture> = (0..1000).map(|_| arm.joints.map(|joint| rng.between(joint.min, joint.max).to_radians())).collect();
        let poses: Vec<_> = postures.iter().map(|posture| arm.forward(posture)[6]).collect();
        let home = arm.home();
        let solutions = poses.iter().filter_map(|pose| arm.inverse(pose, &home).ok()).map(|found| found.len()).sum::<usize>();
        println!(
            "{name:14} {:>16.0} {:>16.0} {:>20.0} {:>12.2}",
            rate(&postures, time, |_, posture| arm.skeleton(posture)),
            rate(&postures, time, |_, posture| arm.forward(posture)[6]),
            rate(&postures, time, |i, _| arm.inverse(&poses[i], &home)),
            solutions as f64 / poses.len() as f64,
        );
    }
}

fn main() {
    // As a test it only has to run.
    let bench = std::env::args().any(|arg| arg == "--bench");
    let (seeds, time) = if bench { (200, Duration::from_secs(1)) } else { (2, Duration::ZERO) };
    for name in ["arm-cuboid", "arm-bench"] {
        trees(&shipped(name).unwrap(), seeds);
    }
    kinematics(time);
}
