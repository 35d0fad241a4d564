//! Parameter descriptions, and values checked against them.
//!
//! A planner lists its [`Parameter`]s once; controls, command-line help, the checks and the defaults all follow from it.

use std::fmt;

use serde::{Serialize, Serializer};

use crate::{error::Error, json, scene::Kind};

/// A parameter's value as it is given.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(untagged)]
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
            Self::Number(number) => number.fmt(f),
            Self::Text(text) => text.fmt(f),
        }
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

/// Values by name, ordered by name. What is not given has its default.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Given(Vec<(String, Value)>);

impl Given {
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

impl<'a> FromIterator<(&'a str, Value)> for Given {
    fn from_iter<I: IntoIterator<Item = (&'a str, Value)>>(pairs: I) -> Self {
        let mut given = Self::new();
        pairs.into_iter().for_each(|(name, value)| given.insert(name, value));
        given
    }
}

impl Serialize for Given {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.iter())
    }
}

/// Serialises pairs as an object, in their order.
///
/// # Errors
/// Whatever the serializer reports.
pub fn as_object<S: Serializer, V: Serialize>(pairs: &[(&'static str, V)], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_map(pairs.iter().map(|(name, value)| (name, value)))
}

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

/// A default that is known when the crate is built.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Preset {
    /// Of a number; whole numbers too.
    Number(f64),
    /// Of a choice.
    Text(&'static str),
    /// Of a flag.
    Flag(bool),
}

impl From<Preset> for Value {
    fn from(preset: Preset) -> Self {
        match preset {
            Preset::Number(number) => Self::Number(number),
            Preset::Text(text) => Self::Text(text.to_owned()),
            Preset::Flag(flag) => Self::Flag(flag),
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
    pub kinds: &'static [Kind],
    /// Defaults that differ on a kind of scene (published ones, mostly).
    pub defaults: &'static [(Kind, Preset)],
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
    pub const fn only_on(mut self, kinds: &'static [Kind]) -> Self {
        self.kinds = kinds;
        self
    }

    /// The same, with defaults that differ by kind.
    #[must_use]
    pub const fn defaults_on(mut self, defaults: &'static [(Kind, Preset)]) -> Self {
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
    pub fn applies_to(&self, kind: Kind) -> bool {
        self.kinds.is_empty() || self.kinds.contains(&kind)
    }

    /// Its default on this kind of scene.
    pub fn default_on(&self, kind: Kind) -> Value {
        if let Some(&(_, preset)) = self.defaults.iter().find(|(on, _)| *on == kind) {
            return preset.into();
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
                let mut chosen: Vec<_> = text.split(',').collect();
                let known = chosen.iter().all(|name| options.iter().any(|o| o.value == *name));
                chosen.sort_unstable();
                known && chosen.windows(2).all(|w| w[0] != w[1])
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

/// A value for every parameter of a planner on a kind of scene; all of them allowed.
#[derive(Debug, Clone, PartialEq)]
pub struct Settings {
    values: Vec<(&'static str, Value)>,
    changed: Given,
}

impl Settings {
    /// Checks what was given and fills in the defaults.
    ///
    /// # Errors
    /// [`Error::Unknown`] for a name that is not a parameter on this kind of scene, [`Error::Refused`] for a value that is not allowed.
    pub fn new(parameters: &[Parameter], kind: Kind, given: &Given) -> Result<Self, Error> {
        let of_kind = || parameters.iter().filter(|p| p.applies_to(kind));
        for (name, value) in given.iter() {
            let parameter =
                of_kind().find(|p| p.name == name).ok_or_else(|| Error::unknown("parameter", name, of_kind().map(|p| p.name)))?;
            parameter.check(value)?;
            if let Some(When { parameter: other, value: needed }) = unmet(parameters, kind, given, parameter) {
                return Err(Error::refused(name, value, format!("left out unless {other} is {needed}")));
            }
        }
        let applicable = || of_kind().filter(|p| unmet(parameters, kind, given, p).is_none());
        let values: Vec<_> = applicable().map(|p| (p.name, given.get(p.name).cloned().unwrap_or_else(|| p.default_on(kind)))).collect();
        let changed =
            applicable().filter_map(|p| given.get(p.name).filter(|&v| *v != p.default_on(kind)).map(|v| (p.name, v.clone()))).collect();
        Ok(Self { values, changed })
    }

    /// Every parameter with its value.
    pub fn all(&self) -> &[(&'static str, Value)] {
        &self.values
    }

    /// What differs from the defaults.
    pub fn changed(&self) -> &Given {
        &self.changed
    }

    /// A number. A name that the planner did not declare gives NaN, which no test over all planners survives.
    pub fn number(&self, name: &str) -> f64 {
        match self.get(name) {
            Some(Value::Number(number)) => *number,
            _ => f64::NAN,
        }
    }

    /// A whole number.
    pub fn integer(&self, name: &str) -> u64 {
        self.number(name) as u64
    }

    /// A choice, or a subset's text.
    pub fn choice(&self, name: &str) -> &str {
        match self.get(name) {
            Some(Value::Text(text)) => text,
            _ => "",
        }
    }

    /// A flag.
    pub fn flag(&self, name: &str) -> bool {
        self.get(name) == Some(&Value::Flag(true))
    }

    fn get(&self, name: &str) -> Option<&Value> {
        self.values.iter().find(|(n, _)| *n == name).map(|(_, value)| value)
    }
}

/// The first condition that keeps a parameter from meaning anything: its own, or one of the parameter it depends on.
fn unmet(parameters: &[Parameter], kind: Kind, given: &Given, parameter: &Parameter) -> Option<When> {
    let when = parameter.when?;
    let Some(other) = parameters.iter().find(|p| p.name == when.parameter && p.applies_to(kind)) else {
        return Some(when);
    };
    let value = given.get(other.name).cloned().unwrap_or_else(|| other.default_on(kind));
    if value.to_string() == when.value { unmet(parameters, kind, given, other) } else { Some(when) }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ALL: [Parameter; 3] = [
        Parameter::integer("population", "N", "Population", [1, 100, 60], "").defaults_on(&[(Kind::Discs, Preset::Number(80.0))]),
        Parameter::number("w", "\\omega", "Inertia weight", [0.0, 1.5, 0.7], ""),
        Parameter::choice("penalty", "", "Penalty", &[Choice { value: "segments", title: "", help: "" }], "").only_on(&[Kind::Discs]),
    ];

    fn given(name: &str, value: &str) -> Given {
        Given::from_iter([(name, Value::from(value))])
    }

    #[test]
    fn defaults_depend_on_the_kind_and_only_changes_are_kept() {
        let on_discs = Settings::new(&ALL, Kind::Discs, &given("w", "0.7")).unwrap();
        assert_eq!((on_discs.integer("population"), on_discs.number("w"), on_discs.choice("penalty")), (80, 0.7, "segments"));
        assert!(on_discs.changed().is_empty(), "0.7 is the default");
        let on_function = Settings::new(&ALL, Kind::Function, &given("population", "7")).unwrap();
        assert_eq!(on_function.changed().iter().collect::<Vec<_>>(), [("population", &Value::from(7.0))]);
        assert_eq!(on_function.all().len(), 2, "the penalty means nothing on functions");
    }

    #[test]
    fn a_subset_has_known_names_each_once() {
        const OPTIONS: [Choice; 2] = [Choice { value: "a", title: "", help: "" }, Choice { value: "b", title: "", help: "" }];
        let parameter = Parameter::subset("some", "", &OPTIONS, "a", "");
        for good in ["a", "b,a"] {
            parameter.check(&Value::from(good)).unwrap();
        }
        for bad in ["", "c", "a,a", "a,", "a b"] {
            assert_eq!(parameter.check(&Value::from(bad)).unwrap_err().allowed(), "some of a, b, each once, with commas between");
        }
    }

    /// A parameter that hangs on another's value, which hangs on a third's.
    #[test]
    fn a_parameter_means_something_only_while_what_it_depends_on_has_its_value() {
        const OPTIONS: [Choice; 2] = [Choice { value: "a", title: "", help: "" }, Choice { value: "b", title: "", help: "" }];
        const CHAIN: [Parameter; 3] = [
            Parameter::choice("first", "", "", &OPTIONS, "").defaults_on(&[(Kind::Discs, Preset::Text("b"))]),
            Parameter::flag("second", "", false, "").when("first", "b"),
            Parameter::number("third", "", "", [0.0, 1.0, 0.5], "").when("second", "true"),
        ];
        let names =
            |kind, given: &Given| Settings::new(&CHAIN, kind, given).map(|s| s.all().iter().map(|(name, _)| *name).collect::<Vec<_>>());
        assert_eq!(names(Kind::Function, &Given::new()).unwrap(), ["first"]);
        assert_eq!(names(Kind::Discs, &Given::new()).unwrap(), ["first", "second"]);
        assert_eq!(names(Kind::Discs, &given("second", "true")).unwrap(), ["first", "second", "third"]);
        let refused = names(Kind::Discs, &given("third", "0.1")).unwrap_err();
        assert_eq!((refused.field(), refused.allowed()), ("third", "left out unless second is true"));
        let both: Given =
            [("first", Value::from("a")), ("second", Value::from("true")), ("third", Value::from("0.1"))].into_iter().collect();
        assert_eq!(names(Kind::Discs, &both).unwrap_err().allowed(), "left out unless first is b");
    }

    #[test]
    fn what_is_not_allowed_is_named_with_its_value_and_range() {
        for (name, value) in [
            ("population", "0"),
            ("population", "1.5"),
            ("population", "101"),
            ("w", "NaN"),
            ("w", "inf"),
            ("w", "lots"),
            ("w", "-0.1"),
            ("penalty", "x"),
        ] {
            let error = Settings::new(&ALL, Kind::Discs, &given(name, value)).unwrap_err();
            assert_eq!((error.field(), error.value()), (name, value));
            assert!(!error.allowed().is_empty());
        }
        let unknown = Settings::new(&ALL, Kind::Function, &given("penalty", "segments")).unwrap_err();
        assert_eq!((unknown.field(), unknown.allowed()), ("parameter", "population, w"));
    }
}
