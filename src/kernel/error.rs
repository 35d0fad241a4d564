//! One error type: the field, the value and what is allowed.

use std::{borrow::Cow, fmt};

use crate::message;

use super::{Message, digits::Digits};

/// Why an input was refused. Every variant says what to change.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Error {
    /// A field's value is outside what is allowed.
    Refused {
        /// The field's path, e.g. `population` or `discs[2].radius`.
        field: String,
        /// What was given.
        value: String,
        /// What would be accepted.
        allowed: Message,
    },
    /// An unknown name, e.g. of a planner, a parameter or a shipped scene.
    Unknown {
        /// What the name should be one of, e.g. `planner`.
        field: String,
        /// What was given.
        value: String,
        /// The names that exist.
        known: String,
    },
    /// The planner does not run on this kind of scene.
    Unsupported {
        /// The planner's name.
        planner: String,
        /// The scene's kind.
        kind: String,
        /// The kinds it runs on.
        kinds: String,
    },
    /// A text that cannot be read, e.g. as JSON or as a link.
    Malformed {
        /// What was read, e.g. `scene` or `link`.
        field: String,
        /// What is wrong with it, and where.
        problem: Message,
    },
}

impl Error {
    /// The error for a field's value that is not allowed.
    pub fn refused<'a>(field: impl Into<Cow<'a, str>>, value: impl Shown, allowed: impl Into<Message>) -> Self {
        Self::refuse(field.into(), value.shown(), allowed.into())
    }

    /// The same, compiled once: what is borrowed is copied here, not where it is refused.
    #[cold]
    #[inline(never)]
    fn refuse(field: Cow<'_, str>, value: String, allowed: Message) -> Self {
        Self::Refused { field: field.into_owned(), value, allowed }
    }

    /// The error for a name that is not one of `known`.
    pub fn unknown<'a>(field: &str, value: &str, known: impl IntoIterator<Item = &'a str>) -> Self {
        Self::unknown_among(field, value, &known.into_iter().collect::<Vec<_>>())
    }

    /// The same, compiled once.
    #[cold]
    #[inline(never)]
    fn unknown_among(field: &str, value: &str, known: &[&str]) -> Self {
        Self::Unknown { field: field.to_owned(), value: value.to_owned(), known: known.join(", ") }
    }

    /// The error for a text that cannot be read.
    #[cold]
    pub fn malformed(field: &str, problem: impl Into<Message>) -> Self {
        Self::Malformed { field: field.to_owned(), problem: problem.into() }
    }

    /// The field that is wrong.
    pub fn field(&self) -> &str {
        match self {
            Self::Refused { field, .. } | Self::Unknown { field, .. } | Self::Malformed { field, .. } => field,
            Self::Unsupported { .. } => "planner",
        }
    }

    /// The value that was given, as text; empty for a text that cannot be read.
    pub fn value(&self) -> &str {
        match self {
            Self::Refused { value, .. } | Self::Unknown { value, .. } => value,
            Self::Unsupported { planner, .. } => planner,
            Self::Malformed { .. } => "",
        }
    }

    /// What would be accepted; for a text that cannot be read, what is wrong with it.
    pub fn allowed(&self) -> Cow<'_, str> {
        match self {
            Self::Refused { allowed, .. } => allowed.text(),
            Self::Unknown { known, .. } => Cow::Borrowed(known),
            Self::Unsupported { kinds, .. } => Cow::Borrowed(kinds),
            Self::Malformed { problem, .. } => problem.text(),
        }
    }

    /// What kind of error it is, in a word: `refused`, `unknown`, `unsupported` or `malformed`.
    pub fn code(&self) -> &'static str {
        match self {
            Self::Refused { .. } => "refused",
            Self::Unknown { .. } => "unknown",
            Self::Unsupported { .. } => "unsupported",
            Self::Malformed { .. } => "malformed",
        }
    }

    /// The whole of it, in a sentence without a full stop.
    pub fn message(&self) -> Message {
        match self {
            Self::Refused { field, value, allowed } => {
                message!("error-refused", "{field}: {value} is not allowed; it must be {allowed}", field, value, allowed)
            }
            Self::Unknown { field, value, known } => {
                message!("error-unknown", "{field}: there is no `{value}`; known: {known}", field, value, known)
            }
            Self::Unsupported { planner, kind, kinds } => message!(
                "error-unsupported",
                "planner: {planner} does not run on scenes of kind {kind}, only on: {kinds}",
                planner,
                kind,
                kinds
            ),
            Self::Malformed { field, problem } => {
                message!("error-malformed", "{field}: {problem}", field, problem)
            }
        }
    }

    /// The same error, its field prefixed: `radius` becomes `discs[2].radius`.
    #[must_use]
    pub fn within(mut self, prefix: &str) -> Self {
        if let Self::Refused { field, .. } | Self::Unknown { field, .. } | Self::Malformed { field, .. } = &mut self {
            *field = if field.is_empty() { prefix.to_owned() } else { format!("{prefix}.{field}") };
        }
        self
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message().text())
    }
}

impl std::error::Error for Error {}

/// What is said of a list that is not allowed.
pub fn list_of(n: usize) -> Message {
    match n {
        0 => message!("error-empty-list", "an empty list"),
        n => message!("error-list-of", "a list of {n}", n),
    }
}

/// What is said of a name that must be one of some.
pub fn one_of(names: &[&str]) -> Message {
    message!("error-one-of", "one of {names}", names = names.join(", "))
}

/// What is said of numbers that must be finite.
pub fn finite() -> Message {
    message!("error-finite", "a finite number")
}

/// A value as an error shows it.
pub trait Shown {
    /// Its text.
    fn shown(self) -> String;
}

impl Shown for f64 {
    fn shown(self) -> String {
        Digits(self).to_string()
    }
}

impl Shown for i64 {
    fn shown(self) -> String {
        self.to_string()
    }
}

impl Shown for u64 {
    fn shown(self) -> String {
        self.to_string()
    }
}

impl Shown for usize {
    fn shown(self) -> String {
        (self as u64).shown()
    }
}

impl Shown for String {
    fn shown(self) -> String {
        self
    }
}

impl Shown for &str {
    fn shown(self) -> String {
        self.to_owned()
    }
}

impl Shown for &String {
    fn shown(self) -> String {
        self.clone()
    }
}

impl Shown for Message {
    fn shown(self) -> String {
        self.to_string()
    }
}
