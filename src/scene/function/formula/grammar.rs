//! From a text to code: operands before their operators.

use winnow::{
    LocatingSlice, Parser, Stateful,
    ascii::multispace0,
    combinator::{Infix, expression, opt},
    error::ParserError,
    stream::{Location, Stream},
    token::{one_of, take_while},
};

use crate::{
    kernel::{Error, Message, json},
    message,
};

use super::{super::read::EXPRESSION, program::Pair};

/// How deep brackets, calls and choices may lie within each other.
const DEEPEST: usize = 40;

/// Operands before their operators: nothing in it is nested but what is in brackets of its own.
pub(super) type Code<'a> = Vec<Token<'a>>;

/// An operand or an operator.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Token<'a> {
    /// The byte of the text that it begins at.
    pub at: usize,
    pub what: What<'a>,
}

#[derive(Debug, Clone, PartialEq)]
pub(super) enum What<'a> {
    Number(f64),
    Name(&'a str),
    /// `name[index]`
    Index(&'a str, Code<'a>),
    /// A call with its arguments.
    Call(&'a str, Vec<Code<'a>>),
    Negate,
    Not,
    Pair(Pair),
    /// Of a condition and two values.
    Choose,
}

/// What is wrong with a formula, and where.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Fault {
    pub at: usize,
    pub problem: Message,
    /// Whether something else could stand there, and may be tried.
    open: bool,
}

impl Fault {
    pub fn new(at: usize, problem: Message) -> Self {
        Self { at, problem, open: false }
    }

    /// The error for the text. It counts characters from 1, not bytes.
    pub fn of(self, text: &str) -> Error {
        let place = text.get(..self.at).unwrap_or(text).chars().count() + 1;
        let problem = self.problem;
        Error::malformed(EXPRESSION, message!("formula-at", "character {place}: {problem}", place, problem))
    }
}

type Input<'a> = Stateful<LocatingSlice<&'a str>, usize>;
type Read<'a, T = Code<'a>> = Result<T, Fault>;

impl<'a> ParserError<Input<'a>> for Fault {
    type Inner = Self;

    fn from_input(input: &Input<'a>) -> Self {
        Self { open: true, ..unexpected(input, &operand_expected()) }
    }

    fn is_backtrack(&self) -> bool {
        self.open
    }

    fn into_inner(self) -> Result<Self::Inner, Self> {
        Ok(self)
    }
}

fn operand_expected() -> Message {
    message!("formula-operand", "a number, a name or (")
}

/// The fault that something else was expected here.
fn unexpected(input: &Input<'_>, expected: &Message) -> Fault {
    let at = input.current_token_start();
    let problem = if let Some(found) = input.chars().next() {
        message!("formula-unexpected", "`{found}` can’t stand here; expected: {expected}", found = found.to_string(), expected)
    } else {
        message!("formula-unended", "the formula ends here; expected: {expected}", expected)
    };
    Fault::new(at, problem)
}

/// Reads a whole text.
pub(super) fn read(text: &str) -> Read<'_> {
    let mut input = Stateful { input: LocatingSlice::new(text), state: 0 };
    let code = choice(&mut input)?;
    space(&mut input)?;
    if input.is_empty() { Ok(code) } else { Err(unexpected(&input, &message!("formula-operator", "an operator, or the end"))) }
}

fn space(input: &mut Input<'_>) -> Read<'static, ()> {
    multispace0.void().parse_next(input)
}

/// Whether these characters are next, which are then taken.
fn taken(input: &mut Input<'_>, wanted: &'static str) -> Read<'static, bool> {
    space(input)?;
    Ok(opt(wanted).parse_next(input)?.is_some())
}

fn expect(input: &mut Input<'_>, wanted: &'static str) -> Read<'static, ()> {
    if taken(input, wanted)? { Ok(()) } else { Err(unexpected(input, &Message::verbatim(wanted))) }
}

/// `condition ? one : other`, or what has no condition.
fn choice<'a>(input: &mut Input<'a>) -> Read<'a> {
    if input.state == DEEPEST {
        let problem = message!("formula-deep", "brackets and choices lie within each other more than {most} deep", most = DEEPEST);
        return Err(Fault::new(input.current_token_start(), problem));
    }
    input.state += 1;
    let mut code = pairs(input)?;
    let at = input.current_token_start();
    if taken(input, "?")? {
        code.extend(choice(input)?);
        expect(input, ":")?;
        code.extend(choice(input)?);
        code.push(Token { at, what: What::Choose });
    }
    input.state -= 1;
    Ok(code)
}

/// Operators between operands; those that bind more tightly first.
fn pairs<'a>(input: &mut Input<'a>) -> Read<'a> {
    let code = expression(signed).infix(infix).parse_next(input);
    // Where no operand stands, the parser has tried all it knows.
    code.map_err(|fault| Fault { open: false, ..fault })
}

macro_rules! infix {
    ($input:ident, $operator:expr, $($text:literal $power:literal $pair:ident $($swap:ident)?,)+) => {
        match $operator {
            $($text => Infix::Left($power, |input, a, b| Ok(infix!(@join input a b $pair $($swap)?))),)+
            _ => return Err(Fault::from_input($input)),
        }
    };
    (@join $input:ident $a:ident $b:ident $pair:ident swap) => { joined($input, $b, $a, Pair::$pair) };
    (@join $input:ident $a:ident $b:ident $pair:ident) => { joined($input, $a, $b, Pair::$pair) };
}

fn infix<'a>(input: &mut Input<'a>) -> Read<'a, Infix<Input<'a>, Code<'a>, Fault>> {
    space(input)?;
    let two = ["<=", ">=", "==", "!=", "&&", "||"];
    let next = input.get(..2).filter(|next| two.contains(next)).or_else(|| input.get(..1)).unwrap_or_default();
    input.next_slice(next.len());
    let found = infix!(input, next,
        "||" 1 Or,
        "&&" 2 And,
        "==" 3 Equal,
        "!=" 3 Unequal,
        "<" 4 Less,
        "<=" 4 LessOrEqual,
        ">" 4 Less swap,
        ">=" 4 LessOrEqual swap,
        "+" 5 Add,
        "-" 5 Subtract,
        "*" 6 Multiply,
        "/" 6 Divide,
        "%" 6 Modulo,
    );
    Ok(found)
}

fn joined<'a>(input: &Input<'a>, mut a: Code<'a>, b: Code<'a>, pair: Pair) -> Code<'a> {
    a.extend(b);
    a.push(Token { at: input.current_token_start(), what: What::Pair(pair) });
    a
}

/// Signs before a power: `-x^2` is −(x²).
fn signed<'a>(input: &mut Input<'a>) -> Read<'a> {
    space(input)?;
    let at = input.current_token_start();
    let signs: &str = take_while(0.., ['-', '+', '!', ' ', '\t', '\n', '\r']).parse_next(input)?;
    let mut code = power(input)?;
    for sign in signs.chars().rev() {
        match sign {
            '-' => code.push(Token { at, what: What::Negate }),
            '!' => code.push(Token { at, what: What::Not }),
            _ => {}
        }
    }
    Ok(code)
}

/// `a^b^c` is `a^(b^c)`; an exponent may have a sign.
fn power<'a>(input: &mut Input<'a>) -> Read<'a> {
    let mut code = operand(input)?;
    let mut powers = 0;
    let at = input.current_token_start();
    let mut negated = Vec::new();
    while taken(input, "^")? || taken(input, "**")? {
        negated.push(taken(input, "-")?);
        code.extend(operand(input)?);
        powers += 1;
    }
    for power in (0..powers).rev() {
        if negated[power] {
            code.push(Token { at, what: What::Negate });
        }
        code.push(Token { at, what: What::Pair(Pair::Power) });
    }
    Ok(code)
}

fn operand<'a>(input: &mut Input<'a>) -> Read<'a> {
    space(input)?;
    let at = input.current_token_start();
    match input.chars().next() {
        Some('0'..='9' | '.') => Ok(vec![Token { at, what: What::Number(number(input)?) }]),
        Some('a'..='z' | 'A'..='Z' | '_') => Ok(vec![Token { at, what: named(input)? }]),
        Some('(') => {
            input.next_slice(1);
            let code = choice(input)?;
            expect(input, ")")?;
            Ok(code)
        }
        _ => Err(unexpected(input, &operand_expected())),
    }
}

fn number(input: &mut Input<'_>) -> Read<'static, f64> {
    let digits = |input: &mut Input<'_>| -> Read<'static, ()> { take_while(0.., '0'..='9').void().parse_next(input) };
    let start = input.checkpoint();
    let at = input.current_token_start();
    digits(input)?;
    if input.starts_with('.') {
        input.next_slice(1);
        digits(input)?;
    }
    let before = input.checkpoint();
    if opt(one_of(['e', 'E'])).parse_next(input)?.is_some() {
        opt(one_of(['+', '-'])).parse_next(input)?;
        if input.starts_with(|next: char| next.is_ascii_digit()) {
            digits(input)?;
        } else {
            // `2e` is a number and a name: the error is about the name.
            input.reset(&before);
        }
    }
    let end = input.current_token_start();
    input.reset(&start);
    let text = input.next_slice(end - at);
    match json::number(text) {
        Some(number) if number.is_finite() => Ok(number),
        _ => Err(Fault::new(at, message!("formula-number", "`{text}` is no finite number", text))),
    }
}

/// A name, a call or a variable with an index.
fn named<'a>(input: &mut Input<'a>) -> Read<'a, What<'a>> {
    let name = take_while(1.., ('a'..='z', 'A'..='Z', '0'..='9', '_')).parse_next(input)?;
    if taken(input, "[")? {
        let index = choice(input)?;
        expect(input, "]")?;
        return Ok(What::Index(name, index));
    }
    if !taken(input, "(")? {
        return Ok(What::Name(name));
    }
    let mut arguments = vec![choice(input)?];
    while taken(input, ",")? {
        arguments.push(choice(input)?);
    }
    expect(input, ")")?;
    Ok(What::Call(name, arguments))
}
