//! How fast ants walk: steps per second on small and large maps, and a whole published run.
//!
//! `cargo bench --bench ants` prints both; throughput is in steps of an ant (those taken back included).

use std::{hint::black_box, sync::Arc};

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use forage::{
    Overrides, Run, Scene, Setup, Value,
    kernel::rng::Stream,
    scene::{GridScene, Header, grid},
    shipped, standard,
};

/// A square map, a quarter of it blocked at random, from one corner to the other; the diagonal is kept free.
fn map(side: usize) -> Arc<Scene> {
    let mut rng = Stream::new(1, 0);
    let mut blocked: Vec<_> = (0..side * side).map(|_| rng.unit() < 0.25).collect();
    for i in 0..side {
        for j in i.saturating_sub(1)..(i + 2).min(side) {
            blocked[i * side + j] = false;
        }
    }
    let mut grid = GridScene::new(1.0, side, blocked);
    grid.start = Some([0.5, 0.5]);
    grid.goal = Some([side as f64 - 0.5, side as f64 - 0.5]);
    let header = Header { name: "map".into(), title: "Map".into(), note: None, source: None, units: None, exact: None, published: None };
    Arc::new(grid::KIND.scene(header, grid).expect("the ends are free"))
}

fn start(scene: &Arc<Scene>, planner: &str, params: &[(&str, f64)]) -> Run {
    let params: Overrides = params.iter().map(|&(name, value)| (name, Value::from(value))).collect();
    Run::with_keyframes(standard(), Setup { planner: planner.into(), scene: Arc::clone(scene), params, seed: 1 }, 0).expect("a valid setup")
}

fn steps(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("ant steps");
    for side in [20, 100, 512] {
        let scene = map(side);
        for planner in ["aco", "aco-direction"] {
            // Ten iterations, as many steps as they take; the set-up is not counted.
            let mut probe = start(&scene, planner, &[]);
            probe.step(10);
            let taken = probe.readings().get("ant_steps").unwrap_or(0.0);
            group.throughput(Throughput::Elements(taken as u64));
            group.sample_size(20);
            group.bench_function(format!("{planner}, {side} × {side}"), |bencher| {
                bencher.iter_batched(|| start(&scene, planner, &[]), |mut run| run.step(10), criterion::BatchSize::LargeInput);
            });
        }
    }
    group.finish();
}

fn run(criterion: &mut Criterion) {
    let scene = shipped("ant-bat-30").expect("it ships");
    let mut group = criterion.benchmark_group("50 ants, 100 iterations, 30 × 30");
    for planner in ["aco", "aco-dijkstra", "aco-direction", "aco-wolf"] {
        group.bench_function(planner, |bencher| {
            bencher.iter(|| {
                let mut run = start(&scene, planner, &[("ants", 50.0)]);
                black_box(run.step(100))
            });
        });
    }
    group.finish();
}

criterion_group!(benches, steps, run);
criterion_main!(benches);
