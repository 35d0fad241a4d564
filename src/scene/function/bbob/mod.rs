//! The 24 noiseless functions of the suite `bbob`, in any instance: scenes with `"function": "bbob-15", "instance": 3`.
//!
//! [BBOB]: N. Hansen, S. Finck, R. Ros and A. Auger: Real-parameter black-box optimization benchmarking 2009: noiseless functions
//! definitions. INRIA, research report 6829.

mod core;
mod draws;
mod peaks;
mod precise;
mod shape;

use std::sync::Arc;

use serde_json::Value;

use crate::{
    kernel::{
        Error, Message, Minimum,
        error::one_of,
        fields::Fields,
        objective::{Evaluation, Objective, Scratch, SearchBox},
    },
    math, message,
};

use self::{
    core::Core,
    draws::{Matrix, normal, position, uniform},
    peaks::Peaks,
    shape::{each, growing, oscillated, share},
};
use super::{
    body::FunctionScene,
    read::{FUNCTION, SUITE, SUITE_NAMES, dimension},
};

/// How many functions there are.
pub const FUNCTIONS: usize = 24;
/// The dimensions that they have.
pub const DIMENSIONS: (usize, usize) = (2, 40);
/// How many instances there are of each.
pub const INSTANCES: usize = 200_000;
/// The box has these sides; beyond it the optimum is not.
const SIDE: f64 = 5.0;
/// Seeds of rotations are so far from those of positions.
const ROTATIONS: i64 = 1_000_000;
const INSTANCE: &str = "instance";
/// Of these the position itself is what is turned, stretched or measured, not its distance from the optimum.
const NOT_MOVED: [usize; 7] = [5, 9, 19, 20, 21, 22, 24];

/// What is done with a position before its value is computed.
#[derive(Clone, Copy)]
enum Stage {
    /// T_osz of [BBOB], §0.2: a smooth distortion without a direction.
    Oscillate,
    /// T_asy with its β: the positive side is another one than the negative side.
    Skew(f64),
    /// A rotation R.
    Turn,
    /// Λ^α Q, with another rotation.
    Inner(f64),
    /// R Λ^α Q.
    Both(f64),
    /// Q alone, and a half is added.
    TurnAndAdd,
    /// Λ^α: the coordinates count the more the higher their number.
    Condition(f64),
    /// As Λ^10, but what is positive at each second coordinate counts ten times.
    Lift,
    /// One is added.
    Add,
    /// Twice as far, towards the optimum's side of each coordinate.
    Double,
}

use Stage::{Add, Both, Condition, Double, Inner, Lift, Oscillate, Skew, Turn, TurnAndAdd};

/// What is done for each function, and how much it costs to be outside of the box, for each unit squared; less than 0: divided by the number
/// of variables.
const RECIPES: [(&[Stage], f64); FUNCTIONS] = [
    (&[], 0.0),
    (&[Oscillate], 0.0),
    (&[Oscillate, Skew(0.2), Condition(10.0)], 0.0),
    (&[Oscillate, Lift], 100.0),
    (&[], 0.0),
    (&[Both(10.0)], 0.0),
    (&[Inner(10.0)], 1.0),
    (&[Add], 0.0),
    (&[TurnAndAdd], 0.0),
    (&[Turn, Oscillate], 0.0),
    (&[Turn, Oscillate], 0.0),
    (&[Turn, Skew(0.5), Turn], 0.0),
    (&[Both(10.0)], 0.0),
    (&[Turn], 0.0),
    (&[Turn, Oscillate, Skew(0.2), Both(10.0)], 0.0),
    (&[Turn, Oscillate, Both(0.01)], -10.0),
    (&[Turn, Skew(0.5), Inner(10.0)], 10.0),
    (&[Turn, Skew(0.5), Inner(1000.0)], 10.0),
    (&[TurnAndAdd], 0.0),
    (&[Double], 0.0),
    (&[Inner(1.0)], 1.0),
    (&[Inner(1.0)], 1.0),
    (&[Both(100.0)], 1.0),
    (&[Double], 1e4),
];

/// A stage with what was drawn for it.
#[derive(Debug)]
enum Step {
    Oscillate,
    Skew(f64),
    Turn(Matrix),
    /// Each coordinate times a factor.
    Stretch(Vec<f64>),
    /// A number is added to each coordinate.
    Add(f64),
    Lift(Vec<f64>),
}

/// A function of the suite.
#[derive(Debug)]
struct Bbob {
    search_box: SearchBox,
    /// What is subtracted first; empty: nothing.
    origin: Vec<f64>,
    steps: Vec<Step>,
    core: Core,
    /// How much it costs to be outside of the box, for each unit squared.
    penalty: f64,
    minimum: f64,
    minimiser: Vec<f64>,
}

impl Step {
    /// From `z` into `z`, with `room` of the same length.
    fn apply(&self, z: &mut [f64], room: &mut [f64]) {
        let n = z.len();
        match self {
            Self::Oscillate => each(z, &|_, z| oscillated(z)),
            Self::Skew(beta) => each(z, &|i, z| if z > 0.0 { math::pow(z, 1.0 + beta * share(i, n) * z.sqrt()) } else { z }),
            Self::Turn(matrix) => {
                room.copy_from_slice(z);
                matrix.apply(room, z);
            }
            Self::Stretch(factors) => each(z, &|i, z| z * factors[i]),
            Self::Add(offset) => each(z, &|_, z| z + offset),
            Self::Lift(factors) => each(z, &|i, z| z * factors[i] * if z > 0.0 && i % 2 == 0 { 10.0 } else { 1.0 }),
        }
    }
}

/// −1 where a drawn number is less, otherwise 1; times a number.
#[inline(never)]
fn signs(mut drawn: Vec<f64>, least: f64, by: f64) -> Vec<f64> {
    each(&mut drawn, &|_, x| if x < least { -by } else { by });
    drawn
}

/// What is drawn for an instance.
struct Draws {
    seed: i64,
    n: usize,
}

impl Draws {
    #[inline(never)]
    fn r(&self) -> Matrix {
        Matrix::rotation(self.seed + ROTATIONS, self.n)
    }

    /// Λ^α Q.
    #[inline(never)]
    fn inner(&self, alpha: f64) -> Matrix {
        Matrix::rotation(self.seed, self.n).stretched(&growing(alpha.sqrt(), self.n))
    }

    fn both(&self, alpha: f64) -> Matrix {
        self.r().times(&self.inner(alpha))
    }

    /// Where the optimum is, but for the peaks.
    fn optimum(&self, function: usize) -> Vec<f64> {
        let Self { seed, n } = *self;
        let mut drawn = position(if function == 12 { seed + ROTATIONS } else { seed }, n);
        match function {
            4 => each(&mut drawn, &|i, x| if i % 2 == 0 { x.abs() } else { x }),
            5 => return signs(drawn, 0.0, SIDE),
            8 => each(&mut drawn, &|_, x| 0.75 * x),
            9 | 19 => {
                drawn = Matrix::rotation(seed, n).columns();
                each(&mut drawn, &|_, sum| sum / 2.0);
            }
            20 => return signs(uniform(seed, n), 0.5, core::SCHWEFEL / 2.0),
            24 => return signs(normal(seed, n), 0.0, core::LUNACEK / 2.0),
            _ => {}
        }
        drawn
    }
}

impl Bbob {
    /// `function`: 1 to 24.
    fn new(function: usize, instance: usize, n: usize) -> Self {
        // Some share what is drawn for others.
        let drawn_as = match function {
            4 => 3,
            18 => 17,
            own => own,
        };
        let draws = Draws { seed: (drawn_as + 10_000 * instance) as i64, n };
        let mut minimiser = draws.optimum(function);
        let mut first = vec![1.0; n];
        let core = match function {
            1 => Core::Squares(first),
            2 | 10 => Core::Squares(growing(1e6, n)),
            3 | 4 | 15 => Core::Rastrigin,
            5 => Core::Slope(minimiser.clone(), growing(10.0, n)),
            6 => Core::Sector(minimiser.clone()),
            7 => Core::Steps(draws.r(), growing(100.0, n)),
            8 | 9 => Core::Rosenbrock,
            11 => {
                first[0] = 1e6;
                Core::Squares(first)
            }
            12 => {
                first[1..].fill(1e6);
                Core::Squares(first)
            }
            13 => Core::Ridge,
            14 => Core::Powers,
            16 => Core::weierstrass(),
            17 | 18 => Core::Schaffers,
            19 => Core::GriewankRosenbrock,
            20 => Core::Schwefel(growing(10_f64.sqrt(), n)),
            21 | 22 => {
                let (peaks, highest) = Peaks::new(if function == 21 { 101 } else { 21 }, draws.seed, n);
                minimiser = highest;
                Core::Gallagher(peaks)
            }
            23 => Core::Katsuura,
            _ => Core::Lunacek(draws.both(100.0)),
        };
        let (stages, penalty) = RECIPES[function - 1];
        let mut steps = Vec::with_capacity(stages.len() + 1);
        for stage in stages {
            steps.push(match *stage {
                Oscillate => Step::Oscillate,
                Skew(beta) => Step::Skew(beta),
                Turn => Step::Turn(draws.r()),
                Inner(alpha) => Step::Turn(draws.inner(alpha)),
                Both(alpha) => Step::Turn(draws.both(alpha)),
                TurnAndAdd => Step::Turn(draws.inner(1.0)),
                Condition(alpha) => Step::Stretch(growing(alpha.sqrt(), n)),
                Lift => Step::Lift(growing(10_f64.sqrt(), n)),
                Add => Step::Add(1.0),
                Double => Step::Stretch(signs(minimiser.clone(), 0.0, 2.0)),
            });
            if matches!(stage, TurnAndAdd) {
                steps.push(Step::Add(0.5));
            }
        }
        Self {
            search_box: SearchBox::of(std::iter::repeat_n([-SIDE, SIDE], n)),
            origin: if NOT_MOVED.contains(&function) { Vec::new() } else { minimiser.clone() },
            steps,
            core,
            penalty: if penalty < 0.0 { -penalty / n as f64 } else { penalty },
            minimum: draws::value(draws.seed),
            minimiser,
        }
    }
}

impl Objective for Bbob {
    fn search_box(&self) -> &SearchBox {
        &self.search_box
    }

    fn evaluate(&self, x: &[f64], scratch: &mut Scratch) -> Evaluation {
        scratch.numbers.clear();
        scratch.numbers.extend(x);
        scratch.numbers.resize(2 * x.len(), 0.0);
        let (z, room) = scratch.numbers.split_at_mut(x.len());
        z.iter_mut().zip(&self.origin).for_each(|(z, origin)| *z -= origin);
        for step in &self.steps {
            step.apply(z, room);
        }
        let outside: f64 = x.iter().map(|x| x.abs() - SIDE).filter(|beyond| *beyond > 0.0).map(|beyond| beyond * beyond).sum();
        (self.core.value(z, room) + self.penalty * outside + self.minimum).into()
    }
}

fn from_to(min: usize, max: usize) -> Message {
    message!("error-from-to", "from {min} to {max}", min, max)
}

impl FunctionScene {
    /// A function of the suite `bbob`, 1 to 24, in one of its instances, from 1.
    ///
    /// # Errors
    /// [`Error::Refused`] for a function, an instance or a dimension that the suite does not have.
    ///
    /// ```
    /// use forage::scene::FunctionScene;
    ///
    /// let rastrigin = FunctionScene::bbob(15, 3, 2)?;
    /// let at = rastrigin.minimiser().unwrap();
    /// assert_eq!(rastrigin.value(&at), rastrigin.minimum().unwrap().value);
    /// # Ok::<(), forage::Error>(())
    /// ```
    pub fn bbob(function: usize, instance: usize, dimension: usize) -> Result<Self, Error> {
        if !(1..=FUNCTIONS).contains(&function) {
            return Err(Error::refused(FUNCTION, format!("{SUITE}{function}"), one_of(&[SUITE_NAMES])));
        }
        if !(1..=INSTANCES).contains(&instance) {
            return Err(Error::refused(INSTANCE, instance, from_to(1, INSTANCES)));
        }
        let (low, high) = DIMENSIONS;
        if !(low..=high).contains(&dimension) {
            return Err(Error::refused("dimension", dimension, from_to(low, high)));
        }
        Ok(Self::of_suite(function, instance, dimension))
    }

    /// The same of what is checked.
    pub(in crate::scene) fn of_suite(function: usize, instance: usize, dimension: usize) -> Self {
        let found = Bbob::new(function, instance, dimension);
        let fields = vec![
            (FUNCTION, Value::from(format!("{SUITE}{function}"))),
            (INSTANCE, Value::from(instance)),
            ("dimension", Value::from(dimension)),
        ];
        let (minimum, minimiser) = (Minimum::from(found.minimum), found.minimiser.clone());
        Self::written(Arc::new(found), fields, Some(minimum), Some(minimiser), false)
    }
}

/// Reads the fields of such a scene.
pub(super) fn read(fields: &mut Fields) -> Result<FunctionScene, Error> {
    let name = fields.text(FUNCTION)?;
    let number = (1..=FUNCTIONS).find(|number| name.strip_prefix(SUITE) == Some(number.to_string().as_str()));
    let function = number.ok_or_else(|| fields.refuse(FUNCTION, &Value::from(name.as_str()), one_of(&[SUITE_NAMES])))?;
    let mut instance = 1;
    if fields.has(INSTANCE) {
        let given = fields.number(INSTANCE)?;
        instance = given as usize;
        if instance as f64 != given {
            return Err(Error::refused(INSTANCE, given, from_to(1, INSTANCES)));
        }
    }
    fields.allow(INSTANCE);
    FunctionScene::bbob(function, instance, dimension(fields)?)
}
