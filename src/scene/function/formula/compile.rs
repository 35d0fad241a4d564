//! From code to a program, with the number of variables known.

use std::f64::consts::{E, PI, TAU};

use crate::{kernel::Message, math, message};

use super::{
    functions::{Call, FUNCTIONS, find},
    grammar::{Code, Fault, Token, What},
    program::{Act, From, Named, Pair, Program, Step},
};

/// How many operations one evaluation may take: more would be a scene that nobody waits for.
const MOST_WORK: usize = 300_000;

/// Names of single variables.
const VARIABLES: [&str; 3] = ["x", "y", "z"];
/// What sums and products go over, unless they name it.
const INDEX: &str = "i";

/// Compiles code for `dimension` variables.
pub(super) fn compile(code: &Code<'_>, dimension: usize) -> Result<Program, Fault> {
    let program = Program { steps: Vec::new(), constants: Vec::new(), indices: Vec::new(), room: 0, value: From::Constant(0.0) };
    let mut compiler = Compiler { program, dimension, work: 0 };
    compiler.program.value = compiler.value(code, &Scope::default())?;
    Ok(compiler.program)
}

/// The names of the sums and products that an operand lies in, outermost first.
#[derive(Clone, Default)]
struct Scope<'a> {
    names: Vec<(&'a str, Bound)>,
    /// How many terms are computed at once.
    terms: Option<usize>,
}

/// What a name of a sum stands for.
#[derive(Clone, Copy)]
enum Bound {
    /// One term.
    One(i64),
    /// All terms at once, from this one on.
    From(i64),
}

impl<'a> Scope<'a> {
    fn with(&self, name: &'a str, bound: Bound, terms: Option<usize>) -> Self {
        let mut names = self.names.clone();
        names.push((name, bound));
        Self { names, terms }
    }

    fn find(&self, name: &str) -> Option<Bound> {
        self.names.iter().rev().find(|(known, _)| *known == name).map(|(_, bound)| *bound)
    }
}

struct Compiler {
    program: Program,
    dimension: usize,
    work: usize,
}

impl Compiler {
    /// Where the value of some code comes from.
    fn value<'a>(&mut self, code: &Code<'a>, scope: &Scope<'a>) -> Result<From, Fault> {
        let mut stack: Vec<From> = Vec::new();
        let pop = |stack: &mut Vec<From>| stack.pop().unwrap_or(From::Constant(f64::NAN));
        for token in code {
            self.work += scope.terms.unwrap_or(1);
            if self.work > MOST_WORK {
                let problem = message!("formula-work", "one value would take more than {most} operations", most = MOST_WORK);
                return Err(Fault::new(token.at, problem));
            }
            let value = match &token.what {
                What::Number(number) => From::Constant(*number),
                What::Name(name) => self.named(name, token.at, scope)?,
                What::Index(name, index) => self.variable(name, index, token.at, scope)?,
                What::Call(name, arguments) => self.call(name, arguments, token.at, scope)?,
                What::Negate => {
                    let a = pop(&mut stack);
                    self.pair(Pair::Subtract, From::Constant(-0.0), a, scope)
                }
                What::Not => {
                    let a = pop(&mut stack);
                    self.pair(Pair::Equal, a, From::Constant(0.0), scope)
                }
                What::Pair(pair) => {
                    let b = pop(&mut stack);
                    let a = pop(&mut stack);
                    self.pair(*pair, a, b, scope)
                }
                What::Choose => {
                    let b = pop(&mut stack);
                    let a = pop(&mut stack);
                    let condition = pop(&mut stack);
                    self.choose([condition, a, b], scope)
                }
            };
            stack.push(value);
        }
        Ok(pop(&mut stack))
    }

    fn named(&mut self, name: &str, at: usize, scope: &Scope<'_>) -> Result<From, Fault> {
        if let Some(bound) = scope.find(name) {
            return Ok(match bound {
                Bound::One(value) => From::Constant(value as f64),
                Bound::From(first) => {
                    let place = self.program.constants.len();
                    self.program.constants.extend((first..).take(scope.terms.unwrap_or(1)).map(|value| value as f64));
                    From::Constants(place)
                }
            });
        }
        if let Some(variable) = VARIABLES.iter().position(|known| *known == name) {
            return if variable < self.dimension {
                Ok(From::Variable(variable))
            } else {
                let n = self.dimension;
                Err(Fault::new(
                    at,
                    message!(
                        "formula-variable",
                        "`{name}` is variable {at}, and there are {n}",
                        name = name.to_owned(),
                        at = variable + 1,
                        n
                    ),
                ))
            };
        }
        match constant(name, self.dimension) {
            Some(value) => Ok(From::Constant(value)),
            None if find(name).is_some() => {
                Err(Fault::new(at, message!("formula-called", "`{name}` is a function: it needs brackets", name = name.to_owned())))
            }
            None => {
                let known = ["x[i]", "x", "y", "z", "n", "pi", "tau", "e"].into_iter().map(str::to_owned);
                let known = known.chain(scope.names.iter().map(|(name, _)| (*name).to_owned())).collect::<Vec<_>>().join(", ");
                Err(Fault::new(at, message!("formula-name", "there is no `{name}`; known: {known}", name = name.to_owned(), known)))
            }
        }
    }

    /// `x[index]`
    fn variable<'a>(&mut self, name: &str, index: &Code<'a>, at: usize, scope: &Scope<'a>) -> Result<From, Fault> {
        if name != VARIABLES[0] {
            return Err(Fault::new(at, message!("formula-indexed", "only x has an index, not `{name}`", name = name.to_owned())));
        }
        let mut places = Vec::with_capacity(scope.terms.unwrap_or(1));
        for term in 0..scope.terms.unwrap_or(1) {
            let index = whole(index, at, self.dimension, scope, term as i64)?;
            let Some(place) = usize::try_from(index).ok().filter(|index| (1..=self.dimension).contains(index)) else {
                let n = self.dimension;
                return Err(Fault::new(at, message!("formula-index", "x[{index}] is none of x[1] to x[{n}]", index = index as f64, n)));
            };
            places.push(place - 1);
        }
        let first = places[0];
        if scope.terms.is_none() || places.iter().all(|place| *place == first) {
            return Ok(From::Variable(first));
        }
        if places.iter().enumerate().all(|(term, place)| *place == first + term) {
            return Ok(From::Variables(first));
        }
        let begin = self.program.indices.len();
        self.program.indices.extend(places);
        Ok(self.step(Act::Gather(begin), scope.terms))
    }

    fn call<'a>(&mut self, name: &'a str, arguments: &[Code<'a>], at: usize, scope: &Scope<'a>) -> Result<From, Fault> {
        let Some(function) = find(name) else {
            let known = FUNCTIONS.iter().map(|function| function.name).collect::<Vec<_>>().join(", ");
            return Err(Fault::new(
                at,
                message!("formula-function", "there is no function `{name}`; known: {known}", name = name.to_owned(), known),
            ));
        };
        let needs = |arguments: Message| {
            Fault::new(at, message!("formula-arguments", "{name}(…) is given {arguments}", name = name.to_owned(), arguments))
        };
        if let Call::Sum | Call::Product = function.of {
            let product = matches!(function.of, Call::Product);
            let fault = || {
                needs(message!(
                    "formula-repeat",
                    "a body, or a body, a name and from where to where: {name}(…, k, 1, n)",
                    name = name.to_owned()
                ))
            };
            return self.repeat(product, arguments, at, scope, fault);
        }
        let values = arguments.iter().map(|argument| self.value(argument, scope)).collect::<Result<Vec<_>, _>>()?;
        match (function.of, &values[..]) {
            (Call::One(of), &[a]) => Ok(self.one(function.name, of, a, scope)),
            (Call::Two(of), &[a, b]) => Ok(self.two(function.name, of, a, b, scope)),
            (Call::Many(of), &[first, ref others @ ..]) if !others.is_empty() => {
                Ok(others.iter().fold(first, |a, &b| self.two(function.name, of, a, b, scope)))
            }
            (Call::Choice, &[condition, a, b]) => Ok(self.choose([condition, a, b], scope)),
            (Call::One(_), _) => Err(needs(message!("formula-one", "one number"))),
            (Call::Two(_), _) => Err(needs(message!("formula-two", "two numbers"))),
            (Call::Many(_), _) => Err(needs(message!("formula-many", "two numbers or more"))),
            _ => Err(needs(message!("formula-if", "a condition and two numbers"))),
        }
    }

    /// A sum or a product. Where another one is in its body, its terms are written out, one after the other; else they are computed all at once.
    fn repeat<'a>(
        &mut self,
        product: bool,
        arguments: &[Code<'a>],
        at: usize,
        scope: &Scope<'a>,
        fault: impl Fn() -> Fault,
    ) -> Result<From, Fault> {
        let (body, name, range) = match arguments {
            [body] => (body, INDEX, None),
            [body, name] => (body, self.new_name(name, &fault)?, None),
            [body, name, from, to] => (body, self.new_name(name, &fault)?, Some((from, to))),
            _ => return Err(fault()),
        };
        let (first, last) = match range {
            Some((from, to)) => (whole(from, at, self.dimension, scope, 0)?, whole(to, at, self.dimension, scope, 0)?),
            None => (1, self.dimension as i64),
        };
        let count = usize::try_from(last - first + 1).unwrap_or(0);
        let begin = From::Constant(if product { 1.0 } else { 0.0 });
        let join = if product { Pair::Multiply } else { Pair::Add };
        if count == 0 {
            return Ok(begin);
        }
        if count > MOST_WORK {
            return Err(Fault::new(at, message!("formula-terms", "{count} terms are too many", count)));
        }
        if repeats(body) {
            let outer = Scope { terms: None, ..scope.clone() };
            return (first..=last).try_fold(begin, |all, term| {
                let value = self.value(body, &outer.with(name, Bound::One(term), None))?;
                Ok(self.pair(join, all, value, &outer))
            });
        }
        let terms = self.value(body, &scope.with(name, Bound::From(first), Some(count)))?;
        Ok(self.step(if product { Act::Product(terms, count) } else { Act::Sum(terms, count) }, None))
    }

    /// The name that a sum goes over: one that means nothing else.
    fn new_name<'a>(&self, code: &Code<'a>, fault: &impl Fn() -> Fault) -> Result<&'a str, Fault> {
        let [Token { at: place, what: What::Name(name) }] = code[..] else { return Err(fault()) };
        if VARIABLES.contains(&name) || constant(name, self.dimension).is_some() {
            return Err(Fault::new(
                place,
                message!("formula-taken", "`{name}` means something else; a sum needs another name, such as k", name = name.to_owned()),
            ));
        }
        Ok(name)
    }

    fn pair(&mut self, pair: Pair, a: From, b: From, scope: &Scope<'_>) -> From {
        if let (From::Constant(a), From::Constant(b)) = (a, b) {
            return From::Constant(pair.of()(a, b));
        }
        let act = match pair {
            Pair::Add => Act::Add(a, b),
            Pair::Subtract => Act::Subtract(a, b),
            Pair::Multiply => Act::Multiply(a, b),
            Pair::Divide => Act::Divide(a, b),
            // A small whole power is multiplied out, which is what one would write by hand.
            Pair::Power => match b {
                From::Constant(1.0) => return a,
                From::Constant(2.0) => Act::Multiply(a, a),
                From::Constant(3.0) => {
                    let square = self.pair(Pair::Multiply, a, a, scope);
                    Act::Multiply(square, a)
                }
                From::Constant(4.0) => {
                    let square = self.pair(Pair::Multiply, a, a, scope);
                    Act::Multiply(square, square)
                }
                _ => Act::Two(Named { name: "^", of: pair.of() }, a, b),
            },
            _ => Act::Two(Named { name: pair.name(), of: pair.of() }, a, b),
        };
        self.step(act, terms_of(scope, &[a, b]))
    }

    fn one(&mut self, name: &'static str, of: fn(f64) -> f64, a: From, scope: &Scope<'_>) -> From {
        if let From::Constant(a) = a {
            return From::Constant(of(a));
        }
        if name == "cos"
            && let Some(turns) = self.turns(a)
        {
            return self.step(Act::One(Named { name: "cos 2π", of: cos_turns }, turns), terms_of(scope, &[turns]));
        }
        self.step(Act::One(Named { name, of }, a), terms_of(scope, &[a]))
    }

    /// What is multiplied by 2π, if the last step did that, which is then gone.
    fn turns(&mut self, a: From) -> Option<From> {
        let step = *self.program.steps.last()?;
        let (From::Result(at) | From::Results(at)) = a else { return None };
        match step.act {
            Act::Multiply(From::Constant(TAU), turns) | Act::Multiply(turns, From::Constant(TAU)) if step.at == at => {
                self.program.steps.pop();
                self.program.room = at;
                Some(turns)
            }
            _ => None,
        }
    }

    fn two(&mut self, name: &'static str, of: fn(f64, f64) -> f64, a: From, b: From, scope: &Scope<'_>) -> From {
        match (a, b) {
            (From::Constant(a), From::Constant(b)) => From::Constant(of(a, b)),
            _ => self.step(Act::Two(Named { name, of }, a, b), terms_of(scope, &[a, b])),
        }
    }

    fn choose(&mut self, [condition, a, b]: [From; 3], scope: &Scope<'_>) -> From {
        match condition {
            From::Constant(0.0) => b,
            From::Constant(_) => a,
            _ => self.step(Act::Choose(condition, a, b), terms_of(scope, &[condition, a, b])),
        }
    }

    /// Adds a step of so many results, one without.
    fn step(&mut self, act: Act, terms: Option<usize>) -> From {
        let (at, count) = (self.program.room, terms.unwrap_or(1));
        self.program.steps.push(Step { act, at, count });
        self.program.room += count;
        if terms.is_some() { From::Results(at) } else { From::Result(at) }
    }
}

/// How many results follow from these numbers: as many as there are terms, if one of them has so many.
fn terms_of(scope: &Scope<'_>, of: &[From]) -> Option<usize> {
    scope.terms.filter(|_| of.iter().any(|from| !from.is_one()))
}

/// cos(2π t), by the quicker of two ways where it is exact enough.
fn cos_turns(t: f64) -> f64 {
    if t.abs() < 1e15 { math::cos_turns(t) } else { math::cos(TAU * t) }
}

fn constant(name: &str, dimension: usize) -> Option<f64> {
    Some(match name {
        "n" => dimension as f64,
        "pi" => PI,
        "tau" => TAU,
        "e" => E,
        _ => return None,
    })
}

/// Whether a sum or a product is in some code.
fn repeats(code: &Code<'_>) -> bool {
    code.iter().any(|token| match &token.what {
        What::Call(name, arguments) => {
            matches!(find(name).map(|function| function.of), Some(Call::Sum | Call::Product)) || arguments.iter().any(repeats)
        }
        _ => false,
    })
}

/// The whole number that an index is, in a term of those that are computed at once.
fn whole(code: &Code<'_>, at: usize, dimension: usize, scope: &Scope<'_>, term: i64) -> Result<i64, Fault> {
    let fault = |at| Fault::new(at, message!("formula-whole", "an index is a whole number, of numbers, n and names of sums by + - * /"));
    let mut stack: Vec<f64> = Vec::new();
    for token in code {
        let value = match &token.what {
            What::Number(number) => *number,
            What::Name("n") => dimension as f64,
            What::Name(name) => match scope.find(name) {
                Some(Bound::One(value)) => value as f64,
                Some(Bound::From(first)) => (first + term) as f64,
                None => return Err(fault(token.at)),
            },
            What::Negate => -stack.pop().ok_or_else(|| fault(token.at))?,
            What::Pair(pair @ (Pair::Add | Pair::Subtract | Pair::Multiply | Pair::Divide)) => match (stack.pop(), stack.pop()) {
                (Some(b), Some(a)) => pair.of()(a, b),
                _ => return Err(fault(token.at)),
            },
            _ => return Err(fault(token.at)),
        };
        stack.push(value);
    }
    match stack.pop() {
        Some(value) if value.fract() == 0.0 && value.abs() < 1e9 => Ok(value as i64),
        _ => Err(fault(code.first().map_or(at, |token| token.at))),
    }
}
