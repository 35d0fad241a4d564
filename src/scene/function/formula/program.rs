//! A compiled formula: steps one after the other, each over one number or over all terms of a sum at once.

use super::functions::{modulo, power};

/// Where numbers come from.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum From {
    /// One number, the same for all.
    Constant(f64),
    /// Constants, one after the other, from this one on.
    Constants(usize),
    /// The variable of this index.
    Variable(usize),
    /// Variables, one after the other, from this one on.
    Variables(usize),
    /// The one result of an earlier step, at this place.
    Result(usize),
    /// The results of an earlier step, from this place on.
    Results(usize),
}

impl From {
    /// Whether it is one number.
    pub fn is_one(self) -> bool {
        matches!(self, Self::Constant(_) | Self::Variable(_) | Self::Result(_))
    }
}

/// What two numbers become.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Pair {
    Add,
    Subtract,
    Multiply,
    Divide,
    Power,
    Modulo,
    Less,
    LessOrEqual,
    Equal,
    Unequal,
    And,
    Or,
}

impl Pair {
    /// As it is written.
    pub fn name(self) -> &'static str {
        match self {
            Self::Add => "+",
            Self::Subtract => "-",
            Self::Multiply => "*",
            Self::Divide => "/",
            Self::Power => "^",
            Self::Modulo => "%",
            Self::Less => "<",
            Self::LessOrEqual => "<=",
            Self::Equal => "==",
            Self::Unequal => "!=",
            Self::And => "&&",
            Self::Or => "||",
        }
    }

    /// The function.
    pub fn of(self) -> fn(f64, f64) -> f64 {
        match self {
            Self::Add => |a, b| a + b,
            Self::Subtract => |a, b| a - b,
            Self::Multiply => |a, b| a * b,
            Self::Divide => |a, b| a / b,
            Self::Power => power,
            Self::Modulo => modulo,
            Self::Less => |a, b| f64::from(a < b),
            Self::LessOrEqual => |a, b| f64::from(a <= b),
            Self::Equal => |a, b| f64::from(a == b),
            Self::Unequal => |a, b| f64::from(a != b),
            Self::And => |a, b| f64::from(a != 0.0 && b != 0.0),
            Self::Or => |a, b| f64::from(a != 0.0 || b != 0.0),
        }
    }
}

/// What a step does.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Act {
    /// Variables whose indices are the numbers in the list from here on.
    Gather(usize),
    /// A function of one number.
    One(Named<fn(f64) -> f64>, From),
    Add(From, From),
    Subtract(From, From),
    Multiply(From, From),
    Divide(From, From),
    /// Another function of two.
    Two(Named<fn(f64, f64) -> f64>, From, From),
    /// The first where the condition is not 0, else the second.
    Choose(From, From, From),
    /// The sum of so many.
    Sum(From, usize),
    /// The product of so many.
    Product(From, usize),
}

/// A function that is the same as another one by its name.
#[derive(Clone, Copy)]
pub(super) struct Named<F> {
    pub name: &'static str,
    pub of: F,
}

impl<F> std::fmt::Debug for Named<F> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name)
    }
}

impl<F> PartialEq for Named<F> {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}

/// A step, and where its results go.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Step {
    pub act: Act,
    /// The place of its first result: behind all that it works on.
    pub at: usize,
    /// How many results it has.
    pub count: usize,
}

/// All steps of a formula.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Program {
    pub steps: Vec<Step>,
    pub constants: Vec<f64>,
    /// Indices of variables that are not one after the other.
    pub indices: Vec<usize>,
    /// How many results all steps have.
    pub room: usize,
    pub value: From,
}

/// Numbers to work on: results are of so many terms, each of so many positions (`lanes`).
#[derive(Clone, Copy)]
enum Operand<'a> {
    /// One number for all.
    One(f64),
    /// One for each position, the same for all terms.
    Lanes(&'a [f64]),
    /// One for each term, the same for all positions.
    Terms(&'a [f64]),
    /// One for each position of each term.
    All(&'a [f64]),
}

/// So many numbers are worked on before the next positions are: what fits into the fastest memory.
const AT_ONCE: usize = 3000;
/// The most positions that are worked on at once.
const MOST_LANES: usize = 128;

/// What a program works in.
struct Desk<'a> {
    lanes: usize,
    /// The variables, each of all positions.
    x: &'a [f64],
}

impl Program {
    /// The values at positions of `dimension` numbers, one after the other in `xs`, which `out` is given in their order.
    pub fn values(&self, xs: &[f64], dimension: usize, room: &mut Vec<f64>, mut out: impl FnMut(f64)) {
        let most = (AT_ONCE / (self.room + dimension)).clamp(1, MOST_LANES);
        let most = most.min(xs.len() / dimension).max(1);
        let needed = most * (self.room + dimension);
        if room.len() < needed {
            room.resize(needed, 0.0);
        }
        for xs in xs.chunks(most * dimension) {
            let lanes = xs.len() / dimension;
            let (x, results) = room.split_at_mut(lanes * dimension);
            for (lane, position) in xs.chunks_exact(dimension).enumerate() {
                for (x, &at) in x[lane..].iter_mut().step_by(lanes).zip(position) {
                    *x = at;
                }
            }
            let desk = Desk { lanes, x };
            for step in &self.steps {
                let (before, out) = results.split_at_mut(step.at * lanes);
                self.carry_out(step, &desk, before, &mut out[..step.count * lanes]);
            }
            let value = self.operand(self.value, &desk, results, 1);
            (0..lanes).for_each(|lane| out(value.at(0, lane, lanes)));
        }
    }

    fn operand<'a>(&'a self, from: From, desk: &Desk<'a>, results: &'a [f64], count: usize) -> Operand<'a> {
        let lanes = desk.lanes;
        match from {
            From::Constant(value) => Operand::One(value),
            From::Variable(at) => Operand::Lanes(&desk.x[at * lanes..(at + 1) * lanes]),
            From::Result(at) => Operand::Lanes(&results[at * lanes..(at + 1) * lanes]),
            From::Constants(at) => Operand::Terms(&self.constants[at..at + count]),
            From::Variables(at) => Operand::All(&desk.x[at * lanes..(at + count) * lanes]),
            From::Results(at) => Operand::All(&results[at * lanes..(at + count) * lanes]),
        }
    }

    fn carry_out(&self, step: &Step, desk: &Desk<'_>, before: &[f64], out: &mut [f64]) {
        let lanes = desk.lanes;
        let operand = |from| self.operand(from, desk, before, step.count);
        match step.act {
            Act::Gather(at) => {
                for (out, &index) in out.chunks_exact_mut(lanes).zip(&self.indices[at..]) {
                    out.copy_from_slice(&desk.x[index * lanes..(index + 1) * lanes]);
                }
            }
            Act::One(of, a) => one(out, lanes, operand(a), of.of),
            Act::Add(a, b) => two(out, lanes, operand(a), operand(b), |a, b| a + b),
            Act::Subtract(a, b) => two(out, lanes, operand(a), operand(b), |a, b| a - b),
            Act::Multiply(a, b) => two(out, lanes, operand(a), operand(b), |a, b| a * b),
            Act::Divide(a, b) => two(out, lanes, operand(a), operand(b), |a, b| a / b),
            Act::Two(of, a, b) => two(out, lanes, operand(a), operand(b), of.of),
            Act::Choose(condition, a, b) => {
                let (condition, a, b) = (operand(condition), operand(a), operand(b));
                for (term, out) in out.chunks_exact_mut(lanes).enumerate() {
                    for (lane, out) in out.iter_mut().enumerate() {
                        *out = if condition.at(term, lane, lanes) == 0.0 { b.at(term, lane, lanes) } else { a.at(term, lane, lanes) };
                    }
                }
            }
            Act::Sum(from, count) => fold(out, self.operand(from, desk, before, count), count, 0.0, |sum, term| sum + term),
            Act::Product(from, count) => fold(out, self.operand(from, desk, before, count), count, 1.0, |product, factor| product * factor),
        }
    }
}

impl<'a> Operand<'a> {
    fn at(self, term: usize, lane: usize, lanes: usize) -> f64 {
        match self {
            Self::One(value) => value,
            Self::Lanes(values) => values[lane],
            Self::Terms(values) => values[term],
            Self::All(values) => values[term * lanes + lane],
        }
    }

    /// The numbers of one term: one number, or one for each position.
    fn of_term(self, term: usize, lanes: usize) -> Row<'a> {
        match self {
            Self::One(value) => Row::One(value),
            Self::Terms(values) => Row::One(values[term]),
            Self::Lanes(values) => Row::Many(values),
            Self::All(values) => Row::Many(&values[term * lanes..(term + 1) * lanes]),
        }
    }

    /// The numbers of all terms, where they lie like the results.
    fn flat(self, terms: usize, lanes: usize) -> Option<Row<'a>> {
        match self {
            Self::One(value) => Some(Row::One(value)),
            Self::All(values) => Some(Row::Many(values)),
            Self::Lanes(values) if terms == 1 => Some(Row::Many(values)),
            Self::Terms(values) if lanes == 1 => Some(Row::Many(values)),
            Self::Lanes(values) if lanes == 1 => Some(Row::One(values[0])),
            Self::Lanes(_) | Self::Terms(_) => None,
        }
    }
}

/// One number, or one for each result.
#[derive(Clone, Copy)]
enum Row<'a> {
    One(f64),
    Many(&'a [f64]),
}

/// The results of each term, joined for each position. From the first term to the last: the order decides the bits.
#[inline]
fn fold(out: &mut [f64], terms: Operand<'_>, count: usize, begin: f64, join: impl Fn(f64, f64) -> f64) {
    let lanes = out.len();
    if lanes == 1
        && let Some(Row::Many(values)) = terms.flat(count, 1)
    {
        out[0] = values.iter().fold(begin, |all, &value| join(all, value));
        return;
    }
    out.fill(begin);
    for term in 0..count {
        match terms.of_term(term, lanes) {
            Row::One(value) => out.iter_mut().for_each(|out| *out = join(*out, value)),
            Row::Many(values) => out.iter_mut().zip(values).for_each(|(out, &value)| *out = join(*out, value)),
        }
    }
}

fn one(out: &mut [f64], lanes: usize, a: Operand<'_>, of: fn(f64) -> f64) {
    let row = |out: &mut [f64], a: Row<'_>| match a {
        Row::One(a) => out.fill(of(a)),
        Row::Many(a) => out.iter_mut().zip(a).for_each(|(out, &a)| *out = of(a)),
    };
    match a.flat(out.len() / lanes, lanes) {
        Some(a) => row(out, a),
        None => out.chunks_exact_mut(lanes).enumerate().for_each(|(term, out)| row(out, a.of_term(term, lanes))),
    }
}

#[inline]
fn two(out: &mut [f64], lanes: usize, a: Operand<'_>, b: Operand<'_>, of: impl Fn(f64, f64) -> f64) {
    let row = |out: &mut [f64], a: Row<'_>, b: Row<'_>| match (a, b) {
        (Row::One(a), Row::One(b)) => out.fill(of(a, b)),
        (Row::One(a), Row::Many(b)) => out.iter_mut().zip(b).for_each(|(out, &b)| *out = of(a, b)),
        (Row::Many(a), Row::One(b)) => out.iter_mut().zip(a).for_each(|(out, &a)| *out = of(a, b)),
        (Row::Many(a), Row::Many(b)) => out.iter_mut().zip(a.iter().zip(b)).for_each(|(out, (&a, &b))| *out = of(a, b)),
    };
    let terms = out.len() / lanes;
    match (a.flat(terms, lanes), b.flat(terms, lanes)) {
        (Some(a), Some(b)) => row(out, a, b),
        _ => out.chunks_exact_mut(lanes).enumerate().for_each(|(term, out)| row(out, a.of_term(term, lanes), b.of_term(term, lanes))),
    }
}
