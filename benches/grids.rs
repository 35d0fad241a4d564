//! A* over 512 × 512 cells, a quarter of them blocked, from corner to corner: ours and the `pathfinding` crate's, at equal
//! cost.
//!
//! `cargo bench --bench grids`.

use std::{hint::black_box, sync::Arc};

use criterion::{BatchSize, Criterion, criterion_group, criterion_main};
use forage::{
    Scene,
    describe::{Entry, Start},
    geometry::{Cells, DIRECTIONS},
    kernel::{ReferenceOptimum, Solution, Stepper, rng::Stream},
    params::{Overrides, Parameters},
    scene::{GridScene, grid},
    standard,
};
use pathfinding::directed::astar::astar;

const SIDE: usize = 512;
/// The same as a coordinate.
const END: i32 = 512;
/// Straight and diagonal steps in whole numbers: in this ratio, ways of fewer than 470,832 steps are in the right order.
const STEP: [u64; 2] = [470_832, 665_857];

/// The first map with a way from corner to corner.
fn map() -> Arc<Scene> {
    let header = forage::shipped("ant-bat-30").expect("it ships").header().clone();
    (0..100)
        .map(|seed| {
            let mut rng = Stream::new(seed, 0);
            let mut blocked: Vec<_> = (0..SIDE * SIDE).map(|_| rng.unit() < 0.25).collect();
            (blocked[0], blocked[SIDE * SIDE - 1]) = (false, false);
            let far = SIDE as f64 - 0.5;
            let mut grid = GridScene::new(1.0, SIDE, blocked);
            (grid.start, grid.goal) = (Some([0.5, 0.5]), Some([far, far]));
            Arc::new(grid::KIND.scene(header.clone(), grid).expect("the ends are free"))
        })
        .find(|scene| scene.exact_by(ReferenceOptimum::Cells).is_some())
        .expect("of a hundred maps one has a way")
}

fn entry(name: &str) -> &'static Entry {
    standard().planners().iter().copied().find(|entry| entry.name == name).expect("it is listed")
}

/// A whole run, step by step: the path's length.
fn forage(entry: &'static Entry, scene: &Arc<Scene>) -> f64 {
    let settings = Parameters::new(entry.parameters, scene.kind(), &Overrides::new()).expect("defaults are valid");
    let mut run = Stepper::from(
        (entry.start)(&Start { entry, scene, parameters: &settings, seed: 1, entries: &**standard() }).expect("defaults start"),
    );
    while run.step(|_| Vec::new()) {}
    match run.planner.best().map(|best| (best.cost, best.solution)) {
        Some((cost, Solution::Path(_))) => cost,
        _ => f64::NAN,
    }
}

/// Column and row, as in pathfinding's documentation.
type At = (i32, i32);

/// The same by pathfinding, as its documentation shows it: successors of a place with their costs, and a heuristic.
fn pathfinding<S: IntoIterator<Item = (At, u64)>>(grid: &GridScene, successors: impl FnMut(&At) -> S) -> f64 {
    let goal = END - 1;
    let ahead = |&(x, y): &At| {
        let (x, y) = ((goal - x) as u64, (goal - y) as u64);
        STEP[0] * x.abs_diff(y) + STEP[1] * x.min(y)
    };
    let (way, _) = astar(&(0, 0), successors, ahead, |&at| at == (goal, goal)).expect("there is a way");
    let way: Vec<_> = way.into_iter().map(|(x, y)| y as usize * SIDE + x as usize).collect();
    grid.cells().steps(&way).length()
}

/// Its successors by looking at the blocked cells: a diagonal step needs both cells beside it free.
fn by_blocked(blocked: &[bool], (x, y): At) -> impl Iterator<Item = (At, u64)> {
    let free = move |x: i32, y: i32| (0..END).contains(&x) && (0..END).contains(&y) && !blocked[y as usize * SIDE + x as usize];
    DIRECTIONS
        .into_iter()
        .enumerate()
        .filter(move |&(d, [dx, dy])| free(x + dx, y + dy) && (d & 1 == 0 || (free(x + dx, y) && free(x, y + dy))))
        .map(move |(d, [dx, dy])| ((x + dx, y + dy), STEP[d & 1]))
}

/// Its successors by the steps that we have worked out beforehand.
fn by_moves(cells: &Cells, (x, y): At) -> impl Iterator<Item = (At, u64)> {
    let moves = cells.moves(y as usize * SIDE + x as usize);
    (0..8).filter(move |d| moves >> d & 1 != 0).map(move |d| ((x + DIRECTIONS[d][0], y + DIRECTIONS[d][1]), STEP[d & 1]))
}

fn grids(criterion: &mut Criterion) {
    let scene = map();
    let grid = scene.get::<GridScene>().expect("it is one");
    let (blocked, cells) = (&grid.blocked, grid.cells());
    let ours = forage(entry("a-star"), &scene);
    for theirs in [pathfinding(grid, |&at| by_blocked(blocked, at)), pathfinding(grid, |&at| by_moves(cells, at))] {
        assert!((ours - theirs).abs() < 1e-9, "{ours} {theirs}");
    }

    let mut group = criterion.benchmark_group(format!("A* over {SIDE} x {SIDE} cells, a quarter blocked"));
    group.sample_size(30);
    // A copy of a grid works out the steps from cell to cell anew.
    let fresh = || Arc::new(grid::KIND.scene(scene.header().clone(), grid.clone()).expect("it is valid"));
    group.bench_function("from blocked cells, forage", |b| {
        // What is handed back is dropped when the clock has stopped: a scene is no part of a search.
        b.iter_batched(fresh, |scene| (forage(entry("a-star"), &scene), scene), BatchSize::PerIteration);
    });
    group.bench_function("from blocked cells, pathfinding", |b| {
        let run =
            |scene: Arc<Scene>| (pathfinding(grid, |&at| by_blocked(&scene.get::<GridScene>().expect("it is one").blocked, at)), scene);
        b.iter_batched(fresh, run, BatchSize::PerIteration);
    });
    group.bench_function("steps known, forage", |b| b.iter(|| black_box(forage(entry("a-star"), &scene))));
    group.bench_function("steps known, pathfinding", |b| b.iter(|| black_box(pathfinding(grid, |&at| by_moves(cells, at)))));
    group.bench_function("working out the steps", |b| {
        let steps = |scene: Arc<Scene>| (black_box(scene.get::<GridScene>().expect("it is one").cells().len()), scene);
        b.iter_batched(fresh, steps, BatchSize::PerIteration);
    });
    group.finish();

    let mut group = criterion.benchmark_group(format!("other searches over {SIDE} x {SIDE} cells, a quarter blocked"));
    group.sample_size(10);
    for name in ["dijkstra", "theta-star"] {
        group.bench_function(name, |b| b.iter(|| black_box(forage(entry(name), &scene))));
    }
    group.finish();
}

criterion_group!(benches, grids);
criterion_main!(benches);
