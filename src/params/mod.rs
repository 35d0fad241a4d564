//! Parameter descriptions, and values checked against them.
//!
//! A planner declares its parameters once, each as a constant [`Param`]. Its entry lists them as [`Parameter`]s; controls,
//! command-line help, the checks and the defaults all follow from that. Its code reads them by `parameters[POPULATION]`, so a
//! misspelt name does not compile.

mod overrides;
mod param;
mod parameters;

use serde::Serialize;

use crate::{
    kernel::{Error, Message, SceneKindId, words},
    message,
};

pub use overrides::{Object, Overrides, Value};
pub use param::{Param, ParamValue, Selection};
pub use parameters::Parameters;
#[cfg(not(target_arch = "wasm32"))]
pub(crate) use parameters::UNLISTED;

/// One of a choice's options.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Choice {
    /// The value.
    pub value: &'static str,
    /// The title.
    pub title: &'static str,
    /// What it does.
    pub help: &'static str,
}

impl Choice {
    /// An option with its value, its title and what it does.
    pub const fn new(value: &'static str, title: &'static str, help: &'static str) -> Self {
        Self { value, title: words(title), help: words(help) }
    }
}

/// The values that a parameter may have.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Domain {
    /// A real number from `min` to `max`.
    Number {
        /// The smallest value allowed.
        min: f64,
        /// The largest value allowed.
        max: f64,
        /// The default.
        default: f64,
    },
    /// A whole number from `min` to `max`.
    Integer {
        /// The smallest value allowed.
        min: u64,
        /// The largest value allowed.
        max: u64,
        /// The default.
        default: u64,
    },
    /// One of a few.
    Choice {
        /// The options; the first is the default.
        options: &'static [Choice],
    },
    /// Any of a few, as text with commas between: `alpha,beta`. At least one.
    Subset {
        /// The options.
        options: &'static [Choice],
        /// The default.
        default: &'static str,
    },
    /// Yes or no.
    Flag {
        /// The default.
        default: bool,
    },
}

/// A value that is known when the crate is built: a default, or one of a preset.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Fixed {
    /// Of a number; whole numbers too.
    Number(f64),
    /// Of a choice.
    Text(&'static str),
    /// Of a flag.
    Flag(bool),
}

impl From<Fixed> for Value {
    fn from(fixed: Fixed) -> Self {
        match fixed {
            Fixed::Number(number) => Self::Number(number),
            Fixed::Text(text) => Self::Text(text.to_owned()),
            Fixed::Flag(flag) => Self::Flag(flag),
        }
    }
}

/// A condition: another parameter and the value that it must have.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct When {
    /// The other parameter.
    pub parameter: &'static str,
    /// Its value as it is typed: `polar`, `true`.
    pub value: &'static str,
}

/// A parameter: its meaning and the values that it may have.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct Parameter {
    /// The name, as in `--set name=value`.
    pub name: &'static str,
    /// The symbol, in TeX.
    pub symbol: &'static str,
    /// The title, a few words.
    pub title: &'static str,
    /// What it does, and where it comes from.
    pub help: &'static str,
    /// The values that it may have.
    pub domain: Domain,
    /// The kinds of scene that it applies to; empty: all that the planner runs on.
    pub kinds: &'static [SceneKindId],
    /// Defaults that differ by kind of scene, mostly published ones.
    pub defaults: &'static [(SceneKindId, Fixed)],
    /// The condition under which it applies; `None`: always.
    pub when: Option<When>,
    /// The range that a slider offers; typing may go beyond.
    pub slider: Option<(f64, f64)>,
    /// Whether a slider should be logarithmic.
    pub logarithmic: bool,
}

impl Parameter {
    /// The options of a choice.
    #[inline]
    pub(crate) const fn options(&self) -> &'static [Choice] {
        if let Domain::Choice { options } = self.domain { options } else { &[] }
    }

    /// Whether it applies to this kind of scene.
    pub fn applies_to(&self, kind: SceneKindId) -> bool {
        self.kinds.is_empty() || self.kinds.contains(&kind)
    }

    /// Its default on this kind of scene.
    pub fn default_on(&self, kind: SceneKindId) -> Value {
        if let Some(&(_, fixed)) = self.defaults.iter().find(|(on, _)| *on == kind) {
            return fixed.into();
        }
        match self.domain {
            Domain::Number { default, .. } => Value::Number(default),
            Domain::Integer { default, .. } => Value::Number(default as f64),
            Domain::Choice { options } => Value::Text(options.first().map_or("", |o| o.value).to_owned()),
            Domain::Subset { default, .. } => Value::Text(default.to_owned()),
            Domain::Flag { default } => Value::Flag(default),
        }
    }

    /// What is allowed, in words.
    pub fn allowed(&self) -> Message {
        match self.domain {
            Domain::Number { min, max, .. } => message!("error-number-from-to", "a number from {low} to {high}", low = min, high = max),
            Domain::Integer { min, max, .. } => message!("error-whole-from-to", "a whole number from {min} to {max}", min, max),
            Domain::Choice { options } => message!("error-one-of", "one of {names}", names = names(options)),
            Domain::Subset { options, .. } => {
                message!("error-some-of", "some of {names}, each once, with commas between", names = names(options))
            }
            Domain::Flag { .. } => message!("error-flag", "true or false"),
        }
    }

    /// Refuses a value outside the domain.
    ///
    /// # Errors
    /// [`Error::Refused`] with this parameter's name, the value and what is allowed.
    pub fn check(&self, value: &Value) -> Result<(), Error> {
        let fits = match (&self.domain, value) {
            (Domain::Number { min, max, .. }, Value::Number(n)) => (*min..=*max).contains(n),
            (Domain::Integer { min, max, .. }, Value::Number(n)) => n.fract() == 0.0 && (*min as f64..=*max as f64).contains(n),
            (Domain::Choice { options }, Value::Text(text)) => options.iter().any(|o| o.value == text),
            (Domain::Subset { options, .. }, Value::Text(text)) => {
                let chosen: Vec<_> = text.split(',').collect();
                let known = |name: &str| options.iter().any(|o| o.value == name);
                chosen.iter().enumerate().all(|(i, name)| known(name) && !chosen[..i].contains(name))
            }
            (Domain::Flag { .. }, Value::Flag(_)) => true,
            _ => false,
        };
        if fits { Ok(()) } else { Err(Error::refused(self.name, value, self.allowed())) }
    }
}

fn names(options: &[Choice]) -> String {
    options.iter().map(|o| o.value).collect::<Vec<_>>().join(", ")
}
