//! Test functions by formula next to the same functions as they are built in, for a swarm of 100 positions; and whole runs of `pso` on
//! both. It prints how many times as long a formula takes.
//!
//! `cargo bench --bench functions`

#![expect(clippy::disallowed_types, reason = "a benchmark tells time")]
use std::{
    hint::black_box,
    sync::Arc,
    time::{Duration, Instant},
};

use forage::{
    Overrides, Run, Scene, Setup, Status,
    kernel::rng::Stream,
    scene::{Function, FunctionScene},
    standard,
    swarm::objective::{Evaluation, Scratch},
};

const POSITIONS: usize = 100;
/// Both take turns so many times, and the fastest turn of each counts.
const TURNS: usize = 40;

fn expression(function: Function) -> &'static str {
    match function {
        Function::Matyas => "0.26*(x^2 + y^2) - 0.48*x*y",
        Function::EggCrate => "x^2 + y^2 + 25*(sin(x)^2 + sin(y)^2)",
        Function::Sphere => "sum(x[i]^2)",
        Function::Rosenbrock => "sum(100*(x[i+1] - x[i]^2)^2 + (1 - x[i])^2, i, 1, n - 1)",
        Function::Ackley => "-20*exp(-0.2*sqrt(sum(x[i]^2)/n)) - exp(sum(cos(2*pi*x[i]))/n) + 20 + e",
        Function::Rastrigin => "sum(x[i]^2 - 10*cos(2*pi*x[i]) + 10)",
    }
}

fn scene(fields: &str, dimension: usize) -> Arc<Scene> {
    let head = r#""format": "forage-scene", "version": 1, "kind": "function", "name": "bench", "title": "Bench""#;
    Arc::new(standard().read_scene(&format!("{{{head}, {fields}, \"dimension\": {dimension}}}")).expect("the scene is valid"))
}

fn timed(mut of: impl FnMut()) -> Duration {
    let begin = Instant::now();
    of();
    begin.elapsed()
}

/// How many times as long the second takes.
fn ratio(mut ours: impl FnMut(), mut by_formula: impl FnMut()) -> f64 {
    let (mut least, mut least_by_formula) = (Duration::MAX, Duration::MAX);
    for _ in 0..TURNS {
        least = least.min(timed(&mut ours));
        least_by_formula = least_by_formula.min(timed(&mut by_formula));
    }
    least_by_formula.as_secs_f64() / least.as_secs_f64()
}

fn evaluations(scene: &Scene) -> impl FnMut() {
    let objective = Arc::clone(scene.get::<FunctionScene>().expect("it is a function").objective());
    let (mut rng, dimension) = (Stream::new(1, 0), objective.search_box().dimension());
    let mut xs = vec![0.0; POSITIONS * dimension];
    xs.chunks_exact_mut(dimension).for_each(|x| objective.draw(x, &mut rng));
    let (mut scratch, mut out) = (Scratch::default(), vec![Evaluation::from(0.0); POSITIONS]);
    move || {
        for _ in 0..200 {
            objective.evaluate_all(black_box(&xs), &mut scratch, &mut out);
            black_box(&out);
        }
    }
}

fn runs(scene: &Arc<Scene>) -> impl FnMut() {
    let scene = Arc::clone(scene);
    move || {
        let setup = Setup { planner: "pso".into(), scene: Arc::clone(&scene), params: Overrides::new(), seed: 1 };
        let mut run = Run::with_keyframes(standard(), setup, 0).expect("the setup is valid");
        while run.step(100) == Status::Running {}
        black_box(run.best());
    }
}

fn main() {
    println!("{:12} {:>4}  {:>12}  {:>12}", "function", "n", "evaluations", "runs of pso");
    for function in Function::ALL {
        let (least, most) = function.dimensions();
        for dimension in [2, 10, 30].into_iter().filter(|n| (least..=most).contains(n)) {
            let side = function.half_side();
            let named = scene(&format!("\"function\": \"{}\"", function.name()), dimension);
            let bounds = format!("\"bounds\": {{\"min\": -{side}, \"max\": {side}}}");
            let formula = scene(&format!("\"expression\": \"{}\", {bounds}", expression(function)), dimension);
            let of_evaluations = ratio(evaluations(&named), evaluations(&formula));
            let of_runs = ratio(runs(&named), runs(&formula));
            println!("{:12} {dimension:4}  {of_evaluations:11.2}×  {of_runs:11.2}×", function.name());
        }
    }
}
