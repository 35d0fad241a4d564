//! Whole runs: 60 particles × 1000 iterations in 10 dimensions, and the same through argmin's `ParticleSwarm`; and on the
//! 10 m grid, where an evaluation is a path of eight segments among grown cells.
//!
//! `cargo bench --bench swarms`; `scripts/bench-wasm` prints the ratio of wasm under Node to native.

use std::hint::black_box;

use argmin::{
    core::{CostFunction, Error, Executor},
    solver::particleswarm::ParticleSwarm,
};
use criterion::{BenchmarkId, Criterion, criterion_group, criterion_main};
use forage::{
    Scene,
    describe::{Entry, Start},
    kernel::Stepper,
    params::Parameters,
    scene::Function,
    standard,
};
use rand::SeedableRng;
use std::sync::Arc;

const DIMENSION: usize = 10;
const PARTICLES: usize = 60;
const ITERATIONS: u64 = 1000;
const FUNCTIONS: [Function; 3] = [Function::Sphere, Function::Rosenbrock, Function::Ackley];

fn scene(function: Function) -> Arc<Scene> {
    let text = format!(
        r#"{{"format": "forage-scene", "version": 1, "kind": "function", "name": "bench", "title": "bench", "function": "{}", "dimension": {DIMENSION}}}"#,
        function.name()
    );
    Arc::new(standard().read_scene(&text).expect("the scene is valid"))
}

fn whole_run(entry: &'static Entry, scene: &Arc<Scene>) -> f64 {
    let sizes = [("population", PARTICLES as f64), ("iterations", ITERATIONS as f64)];
    let given = sizes.into_iter().map(|(name, size)| (name, size.into())).collect();
    let settings = Parameters::new(entry.parameters, scene.kind(), &given).expect("the sizes are valid");
    let mut run = Stepper::from(
        (entry.start)(&Start { entry, scene, parameters: &settings, seed: 1, entries: &**standard() }).expect("defaults start"),
    );
    while run.step(|_| Vec::new()) {}
    run.planner.best().map_or(f64::NAN, |best| best.cost)
}

/// argmin's problem: the textbook formula with std's functions, as a user of argmin would write it.
struct Textbook(Function);

impl CostFunction for Textbook {
    type Param = Vec<f64>;
    type Output = f64;

    #[expect(clippy::disallowed_methods, reason = "argmin is measured as its users run it, with std's functions")]
    fn cost(&self, x: &Vec<f64>) -> Result<f64, Error> {
        let n = x.len() as f64;
        Ok(match self.0 {
            Function::Ackley => {
                let squares: f64 = x.iter().map(|x| x * x).sum();
                let cosines: f64 = x.iter().map(|x| (std::f64::consts::TAU * x).cos()).sum();
                -20.0 * (-0.2 * (squares / n).sqrt()).exp() - (cosines / n).exp() + 20.0 + std::f64::consts::E
            }
            other => other.value(x),
        })
    }
}

fn through_argmin(function: Function) -> f64 {
    let side = function.half_side();
    let bounds = (vec![-side; DIMENSION], vec![side; DIMENSION]);
    // The constants of `pso`: the same inertia and accelerations.
    let solver = ParticleSwarm::new(bounds, PARTICLES)
        .with_inertia_factor(0.7298)
        .and_then(|solver| solver.with_cognitive_factor(1.49618))
        .and_then(|solver| solver.with_social_factor(1.49618))
        .expect("the factors are allowed");
    let result = Executor::new(Textbook(function), solver).configure(|state| state.max_iters(ITERATIONS)).run().expect("argmin runs");
    result.state.best_cost
}

fn swarms(criterion: &mut Criterion) {
    for function in FUNCTIONS {
        let scene = scene(function);
        let mut group = criterion.benchmark_group(format!("{} D{DIMENSION}, {PARTICLES} x {ITERATIONS}", function.name()));
        group.sample_size(20);
        for entry in standard().suited(&scene).filter(|entry| entry.family == "swarm") {
            group.bench_function(BenchmarkId::new("forage", entry.name), |b| b.iter(|| black_box(whole_run(entry, &scene))));
        }
        group.bench_function(BenchmarkId::new("argmin", "ParticleSwarm"), |b| b.iter(|| black_box(through_argmin(function))));
        group.finish();
    }
}

fn grid(criterion: &mut Criterion) {
    let scene = forage::shipped("qpso-10m").expect("it ships");
    let mut group = criterion.benchmark_group(format!("10 m grid D8, {PARTICLES} x {ITERATIONS}"));
    group.sample_size(20);
    for entry in standard().suited(&scene).filter(|entry| entry.family == "swarm") {
        group.bench_function(BenchmarkId::new("forage", entry.name), |b| b.iter(|| black_box(whole_run(entry, &scene))));
    }
    group.finish();
}

/// Why the inner loop does not draw from ChaCha directly: 1.2 million uniform numbers, what such a run needs.
fn generators(criterion: &mut Criterion) {
    use rand::RngExt;
    let mut group = criterion.benchmark_group("1.2 million uniform numbers");
    group.sample_size(20);
    let mut stream = forage::kernel::rng::Stream::new(1, 0);
    group.bench_function("xoshiro256++", |b| b.iter(|| (0..1_200_000).map(|_| stream.unit()).sum::<f64>()));
    let mut chacha = chacha20::ChaCha8Rng::seed_from_u64(1);
    group.bench_function("ChaCha8", |b| b.iter(|| (0..1_200_000).map(|_| chacha.random::<f64>()).sum::<f64>()));
    group.finish();
}

criterion_group!(benches, swarms, grid, generators);
criterion_main!(benches);
