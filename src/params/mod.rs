//! Parameter descriptions, and values checked against them.
//!
//! A planner lists its [`Parameter`]s once; controls, command-line help, the checks and the defaults all follow from it.

mod given;
mod settings;

use serde::Serialize;

use crate::kernel::{Error, SceneKindId};

pub use given::{Given, Value, as_object};
pub use settings::Settings;

/// One of a choice's options.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct Choice {
    /// The value.
    pub value: &'static str,
    /// For people.
    pub title: &'static str,
    /// What it does.
    pub help: &'static str,
}

/// What a parameter may be.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Domain {
    /// A real number from `min` to `max`.
    Number {
        /// The least allowed.
        min: f64,
        /// The greatest allowed.
        max: f64,
        /// The value unless another is given.
        default: f64,
    },
    /// A whole number from `min` to `max`.
    Integer {
        /// The least allowed.
        min: u64,
        /// The greatest allowed.
        max: u64,
        /// The value unless another is given.
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
        /// The value unless another is given.
        default: &'static str,
    },
    /// Yes or no.
    Flag {
        /// The value unless another is given.
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

/// Another parameter and the value that it must have for something to mean anything.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct When {
    /// The other parameter.
    pub parameter: &'static str,
    /// Its value as it is typed: `polar`, `true`.
    pub value: &'static str,
}

/// What a parameter means and what it may be.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parameter {
    /// The field's own name, as in `--set name=value`.
    pub name: &'static str,
    /// TeX.
    pub symbol: &'static str,
    /// A few words.
    pub title: &'static str,
    /// What it does, and where it comes from.
    pub help: &'static str,
    /// What it may be.
    pub domain: Domain,
    /// The kinds of scene on which it means something; empty: all that the planner runs on.
    pub kinds: &'static [SceneKindId],
    /// Defaults that differ on a kind of scene (published ones, mostly).
    pub defaults: &'static [(SceneKindId, Fixed)],
    /// Another parameter's value without which it means nothing.
    pub when: Option<When>,
    /// The range that a slider offers; typing may go beyond.
    pub slider: Option<(f64, f64)>,
    /// Whether a slider should be logarithmic.
    pub logarithmic: bool,
}

impl Parameter {
    /// A real number in [`min`, `max`].
    pub const fn number(
        name: &'static str,
        symbol: &'static str,
        title: &'static str,
        [min, max, default]: [f64; 3],
        help: &'static str,
    ) -> Self {
        Self::of(name, symbol, title, Domain::Number { min, max, default }, help)
    }

    /// A whole number in [`min`, `max`].
    pub const fn integer(
        name: &'static str,
        symbol: &'static str,
        title: &'static str,
        [min, max, default]: [u64; 3],
        help: &'static str,
    ) -> Self {
        Self::of(name, symbol, title, Domain::Integer { min, max, default }, help)
    }

    /// One of a few; the first is the default.
    pub const fn choice(
        name: &'static str,
        symbol: &'static str,
        title: &'static str,
        options: &'static [Choice],
        help: &'static str,
    ) -> Self {
        Self::of(name, symbol, title, Domain::Choice { options }, help)
    }

    /// Any of a few, at least one: text with commas between.
    pub const fn subset(
        name: &'static str,
        title: &'static str,
        options: &'static [Choice],
        default: &'static str,
        help: &'static str,
    ) -> Self {
        Self::of(name, "", title, Domain::Subset { options, default }, help)
    }

    /// Yes or no.
    pub const fn flag(name: &'static str, title: &'static str, default: bool, help: &'static str) -> Self {
        Self::of(name, "", title, Domain::Flag { default }, help)
    }

    const fn of(name: &'static str, symbol: &'static str, title: &'static str, domain: Domain, help: &'static str) -> Self {
        Self { name, symbol, title, help, domain, kinds: &[], defaults: &[], when: None, slider: None, logarithmic: false }
    }

    /// The same with another default.
    #[must_use]
    pub const fn default_to(mut self, value: f64) -> Self {
        if let Domain::Number { default, .. } = &mut self.domain {
            *default = value;
        }
        self
    }

    /// The same, meaningful on these kinds only.
    #[must_use]
    pub const fn only_on(mut self, kinds: &'static [SceneKindId]) -> Self {
        self.kinds = kinds;
        self
    }

    /// The same, with defaults that differ by kind.
    #[must_use]
    pub const fn defaults_on(mut self, defaults: &'static [(SceneKindId, Fixed)]) -> Self {
        self.defaults = defaults;
        self
    }

    /// The same, meaningful only while another parameter has this value.
    #[must_use]
    pub const fn when(mut self, parameter: &'static str, value: &'static str) -> Self {
        self.when = Some(When { parameter, value });
        self
    }

    /// The same, its slider from `low` to `high`.
    #[must_use]
    pub const fn slider(mut self, low: f64, high: f64, logarithmic: bool) -> Self {
        self.slider = Some((low, high));
        self.logarithmic = logarithmic;
        self
    }

    /// Whether it means something on this kind of scene.
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
    pub fn allowed(&self) -> String {
        match self.domain {
            Domain::Number { min, max, .. } => format!("a number from {min} to {max}"),
            Domain::Integer { min, max, .. } => format!("a whole number from {min} to {max}"),
            Domain::Choice { options } => format!("one of {}", names(options)),
            Domain::Subset { options, .. } => format!("some of {}, each once, with commas between", names(options)),
            Domain::Flag { .. } => "true or false".to_owned(),
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
