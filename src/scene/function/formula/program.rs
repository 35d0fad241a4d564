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

/// Numbers to work on: one for all, or as many as there are results.
#[derive(Clone, Copy)]
enum Operand<'a> {
    One(f64),
    Many(&'a [f64]),
}

impl Program {
    /// The value at `x`.
    pub fn value(&self, x: &[f64], room: &mut Vec<f64>) -> f64 {
        room.resize(self.room.max(room.len()), 0.0);
        for step in &self.steps {
            let (before, out) = room.split_at_mut(step.at);
            self.carry_out(step, x, before, &mut out[..step.count]);
        }
        match self.operand(self.value, x, room, 1) {
            Operand::One(value) => value,
            Operand::Many(values) => values[0],
        }
    }

    fn operand<'a>(&'a self, from: From, x: &'a [f64], results: &'a [f64], count: usize) -> Operand<'a> {
        match from {
            From::Constant(value) => Operand::One(value),
            From::Variable(at) => Operand::One(x[at]),
            From::Result(at) => Operand::One(results[at]),
            From::Constants(at) => Operand::Many(&self.constants[at..at + count]),
            From::Variables(at) => Operand::Many(&x[at..at + count]),
            From::Results(at) => Operand::Many(&results[at..at + count]),
        }
    }

    fn carry_out(&self, step: &Step, x: &[f64], before: &[f64], out: &mut [f64]) {
        let count = out.len();
        let operand = |from| self.operand(from, x, before, count);
        match step.act {
            Act::Gather(at) => {
                for (out, &index) in out.iter_mut().zip(&self.indices[at..]) {
                    *out = x[index];
                }
            }
            Act::One(of, a) => one(out, operand(a), of.of),
            Act::Add(a, b) => two(out, operand(a), operand(b), |a, b| a + b),
            Act::Subtract(a, b) => two(out, operand(a), operand(b), |a, b| a - b),
            Act::Multiply(a, b) => two(out, operand(a), operand(b), |a, b| a * b),
            Act::Divide(a, b) => two(out, operand(a), operand(b), |a, b| a / b),
            Act::Two(of, a, b) => two(out, operand(a), operand(b), of.of),
            Act::Choose(condition, a, b) => {
                let (condition, a, b) = (operand(condition), operand(a), operand(b));
                for (i, out) in out.iter_mut().enumerate() {
                    *out = if condition.at(i) == 0.0 { b.at(i) } else { a.at(i) };
                }
            }
            Act::Sum(from, count) => out[0] = self.operand(from, x, before, count).fold(count, 0.0, |sum, term| sum + term),
            Act::Product(from, count) => out[0] = self.operand(from, x, before, count).fold(count, 1.0, |product, factor| product * factor),
        }
    }
}

impl Operand<'_> {
    fn at(self, i: usize) -> f64 {
        match self {
            Self::One(value) => value,
            Self::Many(values) => values[i],
        }
    }

    fn fold(self, count: usize, begin: f64, join: impl Fn(f64, f64) -> f64) -> f64 {
        match self {
            Self::One(value) => (0..count).fold(begin, |all, _| join(all, value)),
            Self::Many(values) => values.iter().fold(begin, |all, &value| join(all, value)),
        }
    }
}

fn one(out: &mut [f64], a: Operand, of: fn(f64) -> f64) {
    match a {
        Operand::One(a) => out.fill(of(a)),
        Operand::Many(a) => out.iter_mut().zip(a).for_each(|(out, &a)| *out = of(a)),
    }
}

#[inline]
fn two(out: &mut [f64], a: Operand, b: Operand, of: impl Fn(f64, f64) -> f64) {
    match (a, b) {
        (Operand::One(a), Operand::One(b)) => out.fill(of(a, b)),
        (Operand::One(a), Operand::Many(b)) => out.iter_mut().zip(b).for_each(|(out, &b)| *out = of(a, b)),
        (Operand::Many(a), Operand::One(b)) => out.iter_mut().zip(a).for_each(|(out, &a)| *out = of(a, b)),
        (Operand::Many(a), Operand::Many(b)) => out.iter_mut().zip(a.iter().zip(b)).for_each(|(out, (&a, &b))| *out = of(a, b)),
    }
}
