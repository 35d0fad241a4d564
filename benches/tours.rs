//! Tour planners: iterations a second on 12, 52, 100 and 280 stops, and how far each is from the optimum after a second.
//!
//! `cargo bench --bench tours` prints the table. The time is that of a machine; only ratios mean something elsewhere.

#![expect(clippy::disallowed_types, reason = "a benchmark tells time")]

use std::{
    sync::Arc,
    time::{Duration, Instant},
};

use forage::{Overrides, Run, Scene, Setup, Status, Value, shipped, standard};

/// The 12 stops of the published grid by exact roads, and the shipped tours.
fn scenes() -> Vec<Arc<Scene>> {
    let tours = standard().scenes().iter().filter(|scene| scene.kind() == forage::scene::TOUR).cloned();
    std::iter::once(shipped("ant-bat-30").unwrap()).chain(tours).collect()
}

fn start(planner: &str, scene: &Arc<Scene>, polish: bool, seed: u64) -> Run {
    let mut params: Overrides = [("iterations", Value::from(1e6))].into_iter().collect();
    if scene.name() == "ant-bat-30" {
        params.insert("roads", Value::from("dijkstra"));
        params.insert("smooth", Value::from("false"));
    }
    if polish {
        params.insert("polish", Value::from("true"));
    }
    let mut run = Run::with_keyframes(standard(), Setup { planner: planner.into(), scene: Arc::clone(scene), params, seed }, 0).unwrap();
    // The roads are not what is measured.
    run.step(run.stages().iter().rev().nth(1).map_or(0, |roads| roads.end.unwrap_or(0)));
    run
}

/// Iterations a second, the gap after some time (`None` where no optimum is known), and how long it went.
fn race(mut run: Run, time: Duration) -> (f64, Option<f64>, Duration) {
    let from = run.iteration();
    let begun = Instant::now();
    while begun.elapsed() < time && run.step(1) == Status::Running {}
    let took = begun.elapsed();
    ((run.iteration() - from) as f64 / took.as_secs_f64(), run.outcome().gap, took)
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_unstable_by(f64::total_cmp);
    values[values.len() / 2]
}

fn main() {
    // As a test it only has to run.
    let (time, seeds) = if std::env::args().any(|arg| arg == "--bench") { (Duration::from_secs(1), 3) } else { (Duration::ZERO, 1) };
    println!("{:16} {:>5} {:14} {:>14} {:>12} {:>10}", "scene", "stops", "planner", "iterations/s", "gap", "seconds");
    for scene in scenes() {
        let stops = scene.stops().len();
        for entry in standard().planners().iter().copied().filter(|entry| entry.stops && entry.check_scene(&scene).is_ok()) {
            let polish = entry.parameter("polish").is_some();
            for polish in [false, true].into_iter().take(1 + usize::from(polish)) {
                let runs: Vec<_> = (1..=seeds).map(|seed| race(start(entry.name, &scene, polish, seed), time)).collect();
                let name = format!("{}{}", entry.name, if polish { " polish" } else { "" });
                let gaps: Vec<_> = runs.iter().filter_map(|(_, gap, _)| *gap).collect();
                let gap = if gaps.is_empty() { "unknown".to_owned() } else { format!("{:.2} %", 100.0 * median(gaps)) };
                let rate = median(runs.iter().map(|(rate, ..)| *rate).collect());
                let seconds = median(runs.iter().map(|(.., took)| took.as_secs_f64()).collect());
                println!("{:16} {stops:>5} {name:14} {rate:>14.0} {gap:>12} {seconds:>10.3}", scene.name());
            }
        }
    }
}
