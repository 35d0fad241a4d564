//! Test functions whose minimum is not in the middle of the search box: scenes of kind `function`.

use crate::{
    describe::{Draft, Generator},
    kernel::{rng::Stream, words},
    params::{Choice, Param, ParamValue, Parameters},
    scene::{self, Function, FunctionScene, MAX_DIMENSION},
};

const fn choice(function: Function, title: &'static str, help: &'static str) -> Choice {
    Choice::new(function.name(), title, help)
}

impl ParamValue for Function {}

const FUNCTION: Param<Function> = Param::choice(
    "function",
    "",
    "Function",
    &[
        choice(Function::Sphere, "Sphere", "A bowl without other minima, [WCPSO] f3."),
        choice(Function::Rosenbrock, "Rosenbrock", "A narrow, curved valley with a flat floor, [WCPSO] f4."),
        choice(Function::Ackley, "Ackley", "A deep hole in a rippled, nearly flat plain, [WCPSO] f5."),
        choice(Function::Rastrigin, "Rastrigin", "A bowl full of regular dents, [LTQPSO]."),
        choice(Function::Matyas, "Matyas", "A flat valley along a diagonal, in two variables, [WCPSO] f1."),
        choice(Function::EggCrate, "Egg crate", "A bowl with waves in both of its variables, [WCPSO] f2."),
    ],
    &[Function::Sphere, Function::Rosenbrock, Function::Ackley, Function::Rastrigin, Function::Matyas, Function::EggCrate],
    "Which function.",
);
const DIMENSION: Param<u64> =
    Param::integer("dimension", "D", "Dimension", [1, MAX_DIMENSION as u64, 2], "How many variables.").slider(1.0, 30.0, false);

/// A test function with its minimum somewhere else.
pub const SHIFTED: Generator = Generator {
    name: "shifted",
    title: "Shifted function",
    help: words("A test function whose minimum is not in the middle."),
    kind: scene::FUNCTION,
    parameters: &[&[FUNCTION.entry(), DIMENSION.entry()]],
    draw,
};

/// How far the minimum is moved at most, as a share of the way to the rim.
const REACH: f64 = 0.6;

fn draw(parameters: &Parameters, seed: u64) -> Draft {
    let stream = &mut Stream::new(seed, 0);
    let function = parameters[FUNCTION];
    let dimension = parameters[DIMENSION] as usize;
    let reach = REACH * (function.half_side() - function.minimiser());
    let shift = (0..dimension).map(|_| stream.between(-reach, reach)).collect();
    let size = format!("{}-{dimension}", function.name());
    Draft::new(FunctionScene::named(function, dimension, shift), size)
}
