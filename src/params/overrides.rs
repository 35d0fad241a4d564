//! Parameter values by name, as they are given.

use std::fmt;

use serde::{Serialize, Serializer};

use crate::kernel::{digits::Digits, error::Shown, json};

/// A parameter's value as it is given.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(untagged)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename = "ParameterValue"))]
pub enum Value {
    /// A flag.
    Flag(bool),
    /// A number; whole numbers too.
    Number(f64),
    /// A choice.
    Text(String),
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Flag(flag) => flag.fmt(f),
            Self::Number(number) => Digits(*number).fmt(f),
            Self::Text(text) => text.fmt(f),
        }
    }
}

impl Shown for &Value {
    fn shown(self) -> String {
        self.to_string()
    }
}

impl From<f64> for Value {
    fn from(number: f64) -> Self {
        Self::Number(number)
    }
}

impl From<&str> for Value {
    /// As it is typed in a shell: `0.5`, `true`, `segments`.
    fn from(text: &str) -> Self {
        match text.trim() {
            "true" => Self::Flag(true),
            "false" => Self::Flag(false),
            text => json::number(text).map_or_else(|| Self::Text(text.to_owned()), Self::Number),
        }
    }
}

/// Parameter values by name, in the order of names. A parameter that is not given has its default.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Overrides(Vec<(String, Value)>);

impl Overrides {
    /// Nothing given: all defaults.
    pub fn new() -> Self {
        Self::default()
    }

    /// Gives a parameter a value, replacing an earlier one.
    pub fn insert(&mut self, name: impl Into<String>, value: Value) {
        let name = name.into();
        match self.0.binary_search_by(|(known, _)| known.cmp(&name)) {
            Ok(at) => self.0[at].1 = value,
            Err(at) => self.0.insert(at, (name, value)),
        }
    }

    /// The value given for a name.
    pub fn get(&self, name: &str) -> Option<&Value> {
        self.iter().find(|(known, _)| *known == name).map(|(_, value)| value)
    }

    /// Names and values, in the order of the names.
    pub fn iter(&self) -> impl Iterator<Item = (&str, &Value)> {
        self.0.iter().map(|(name, value)| (name.as_str(), value))
    }

    /// Whether nothing is given.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }
}

impl<'a> FromIterator<(&'a str, Value)> for Overrides {
    fn from_iter<I: IntoIterator<Item = (&'a str, Value)>>(pairs: I) -> Self {
        let mut given = Self::new();
        pairs.into_iter().for_each(|(name, value)| given.insert(name, value));
        given
    }
}

impl Serialize for Overrides {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.iter())
    }
}

/// Pairs, to be serialised as an object.
pub struct Object<'a, V>(pub &'a [(&'static str, V)]);

impl<V: Serialize> Serialize for Object<'_, V> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|(name, value)| (name, value)))
    }
}
