//! Test functions whose minimum is not in the middle of the search box: scenes of kind `function`.

use std::sync::Arc;

use crate::{
    kernel::rng::Stream,
    params::{Choice, Parameter, Settings},
    scene::{Function, FunctionScene, MAX_DIMENSION, function},
};

use super::plot::{Draw, Generator, Made};

const fn choice(function: Function, title: &'static str) -> Choice {
    Choice { value: function.name(), title, help: "" }
}

pub(super) const SHIFTED: Generator = Generator {
    name: "shifted",
    title: "Shifted function",
    help: "A test function whose minimum is not in the middle.",
    parameters: &[
        Parameter::choice(
            "function",
            "",
            "Function",
            &[
                choice(Function::Sphere, "Sphere"),
                choice(Function::Rosenbrock, "Rosenbrock"),
                choice(Function::Ackley, "Ackley"),
                choice(Function::Rastrigin, "Rastrigin"),
                choice(Function::Matyas, "Matyas"),
                choice(Function::EggCrate, "Egg crate"),
            ],
            "Which function.",
        ),
        Parameter::integer("dimension", "D", "Dimension", [1, MAX_DIMENSION as u64, 2], "How many variables.").slider(1.0, 30.0, false),
    ],
    draw: Draw::Other(&function::KIND, draw),
};

/// How far the minimum is moved at most, as a share of the way to the rim.
const REACH: f64 = 0.6;

fn draw(settings: &Settings, stream: &mut Stream) -> Made {
    let function = Function::ALL.into_iter().find(|function| function.name() == settings.choice("function")).unwrap_or(Function::Sphere);
    let dimension = settings.integer("dimension") as usize;
    let reach = REACH * (function.half_side() - function.minimiser());
    let shift = (0..dimension).map(|_| stream.between(-reach, reach)).collect();
    let size = format!("{}-{dimension}", function.name());
    Made { body: Arc::new(FunctionScene { function, dimension, shift }), size, note: None }
}
