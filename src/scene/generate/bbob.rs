//! The functions of the suite `bbob`: the seed is the instance.

use crate::{
    describe::{Draft, Generator},
    kernel::words,
    params::{Choice, Param, ParamValue, Parameters},
    scene::{
        self, FunctionScene,
        function::{BBOB_DIMENSIONS, BBOB_INSTANCES},
    },
};

/// The number of a function.
struct Suite(usize);

impl ParamValue for Suite {}

const FUNCTION: Param<Suite> = Param::choice(
    "function",
    "",
    "Function",
    &[
        Choice::new("bbob-1", "1 Sphere", "A bowl: the easiest of all."),
        Choice::new("bbob-2", "2 Separable ellipsoid", "A long bowl with a condition of a million, along the axes."),
        Choice::new("bbob-3", "3 Separable Rastrigin", "A bowl full of dents, along the axes and distorted."),
        Choice::new("bbob-4", "4 Büche–Rastrigin", "Dents that are deeper on one side."),
        Choice::new("bbob-5", "5 Linear slope", "A plane: the optimum is in a corner of the box."),
        Choice::new("bbob-6", "6 Attractive sector", "A bowl that is steep on all sides but one."),
        Choice::new("bbob-7", "7 Step ellipsoid", "Plateaus, on which nothing leads down."),
        Choice::new("bbob-8", "8 Rosenbrock", "A narrow, curved valley."),
        Choice::new("bbob-9", "9 Rotated Rosenbrock", "The same valley, turned."),
        Choice::new("bbob-10", "10 Ellipsoid", "A long bowl with a condition of a million, turned and distorted."),
        Choice::new("bbob-11", "11 Discus", "One direction counts a million times as much as all others."),
        Choice::new("bbob-12", "12 Bent cigar", "A long, bent ridge: all directions but one count a million times as much."),
        Choice::new("bbob-13", "13 Sharp ridge", "A ridge with an edge on which the gradient does not point along it."),
        Choice::new("bbob-14", "14 Different powers", "The directions become ever flatter towards the optimum, each in its own way."),
        Choice::new("bbob-15", "15 Rastrigin", "A bowl full of dents, turned, stretched and distorted."),
        Choice::new("bbob-16", "16 Weierstrass", "Rough at every scale, and the same again and again."),
        Choice::new("bbob-17", "17 Schaffers F7", "Waves whose size changes, asymmetric."),
        Choice::new("bbob-18", "18 Ill-conditioned Schaffers F7", "The same with a condition of a thousand."),
        Choice::new("bbob-19", "19 Griewank–Rosenbrock F8F2", "A valley under waves."),
        Choice::new("bbob-20", "20 Schwefel", "Its best places are near the corners, far from one another."),
        Choice::new("bbob-21", "21 Gallagher, 101 peaks", "Many peaks without an order."),
        Choice::new("bbob-22", "22 Gallagher, 21 peaks", "A few peaks without an order, some very narrow."),
        Choice::new("bbob-23", "23 Katsuura", "Rough and with many optima of nearly the same value."),
        Choice::new("bbob-24", "24 Lunacek bi-Rastrigin", "Two bowls full of dents: the wider one leads astray."),
    ],
    &[
        Suite(1),
        Suite(2),
        Suite(3),
        Suite(4),
        Suite(5),
        Suite(6),
        Suite(7),
        Suite(8),
        Suite(9),
        Suite(10),
        Suite(11),
        Suite(12),
        Suite(13),
        Suite(14),
        Suite(15),
        Suite(16),
        Suite(17),
        Suite(18),
        Suite(19),
        Suite(20),
        Suite(21),
        Suite(22),
        Suite(23),
        Suite(24),
    ],
    "Which function.",
);
const DIMENSION: Param<u64> = Param::integer(
    "dimension",
    "D",
    "Dimension",
    [BBOB_DIMENSIONS.0 as u64, BBOB_DIMENSIONS.1 as u64, 2],
    "How many variables; the suite has 2, 3, 5, 10, 20 and 40.",
);

/// A function of the suite `bbob`.
pub const BBOB: Generator = Generator {
    name: "bbob",
    title: "Function of the suite bbob",
    help: words("One of the 24 noiseless functions by which optimisers are compared. The seed, from 1 to 200,000, is the instance."),
    kind: scene::FUNCTION,
    parameters: &[&[FUNCTION.entry(), DIMENSION.entry()]],
    draw,
};

fn draw(parameters: &Parameters, seed: u64) -> Draft {
    let Suite(function) = parameters[FUNCTION];
    let dimension = parameters[DIMENSION] as usize;
    let instances = BBOB_INSTANCES as u64;
    let instance = (seed % instances + instances - 1) % instances + 1;
    Draft::new(FunctionScene::of_suite(function, instance as usize, dimension), format!("{function}-{dimension}"))
}
