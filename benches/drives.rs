//! Drives among moving obstacles: how much faster than real time, on the scenes that ship and among many obstacles.
//!
//! `cargo bench --bench drives` prints the table: simulated seconds over seconds, and over those of `a-star-drive`.

#![expect(clippy::disallowed_types, reason = "a benchmark tells time")]

use std::{
    sync::Arc,
    time::{Duration, Instant},
};

use forage::{Overrides, Run, Scene, Setup, Status, Value, scene::GridScene, shipped, standard};

fn scenes() -> Vec<Arc<Scene>> {
    let random = |side: f64, moving: f64| {
        let given =
            [("columns", side), ("rows", side), ("share", 0.2), ("moving", moving)].map(|(name, number)| (name, Value::from(number)));
        Arc::new(standard().generate("random", &given.into_iter().collect(), 1).unwrap())
    };
    let shipped = ["wolf-ant-20", "crossing", "patrol", "corridor"].map(|name| shipped(name).unwrap());
    shipped.into_iter().chain([random(40.0, 30.0), random(100.0, 100.0)]).collect()
}

/// Simulated seconds a second, over as many whole drives as there is time for; planning by ants does not count.
fn pace(planner: &str, scene: &Arc<Scene>, time: Duration) -> f64 {
    let (mut simulated, mut took) = (0.0, Duration::ZERO);
    while simulated == 0.0 || took < time {
        let params: Overrides = [("border", Value::from("bounce"))].into_iter().collect();
        let mut run =
            Run::with_keyframes(standard(), Setup { planner: planner.into(), scene: Arc::clone(scene), params, seed: 1 }, 0).unwrap();
        let planned = run.stages().iter().rev().nth(1).map_or(0, |plan| plan.end.unwrap_or(0));
        run.step(planned);
        let begun = Instant::now();
        while run.step(u64::MAX) == Status::Running {}
        took += begun.elapsed();
        simulated += run.readings().get("time").unwrap_or(0.0).max(f64::MIN_POSITIVE);
    }
    simulated / took.as_secs_f64()
}

fn main() {
    // As a test it only has to run.
    let time = if std::env::args().any(|arg| arg == "--bench") { Duration::from_secs(1) } else { Duration::ZERO };
    println!("{:28} {:>9} {:18} {:>16} {:>14}", "scene", "obstacles", "planner", "simulated s / s", "of A*’s");
    for scene in scenes() {
        let obstacles = scene.get::<GridScene>().map_or(0, |grid| grid.moving.len());
        let first = pace("a-star-drive", &scene, time);
        for entry in standard().planners().iter().copied().filter(|entry| entry.family == "dynamic") {
            let pace = if entry.name == "a-star-drive" { first } else { pace(entry.name, &scene, time) };
            println!("{:28} {obstacles:>9} {:18} {pace:>16.0} {:>14.2}", scene.name(), entry.name, pace / first);
        }
    }
}
