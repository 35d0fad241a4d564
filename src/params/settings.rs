//! Given values checked against a planner's parameters, and the defaults filled in.

use crate::kernel::{Error, SceneKindId};

use super::{Given, Parameter, Value, When};

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
    pub fn new(parameters: &[Parameter], kind: SceneKindId, given: &Given) -> Result<Self, Error> {
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
fn unmet(parameters: &[Parameter], kind: SceneKindId, given: &Given, parameter: &Parameter) -> Option<When> {
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
    use crate::{
        params::{Choice, Fixed},
        scene::{DISCS, FUNCTION},
    };

    const ALL: [Parameter; 3] = [
        Parameter::integer("population", "N", "Population", [1, 100, 60], "").defaults_on(&[(DISCS, Fixed::Number(80.0))]),
        Parameter::number("w", "\\omega", "Inertia weight", [0.0, 1.5, 0.7], ""),
        Parameter::choice("penalty", "", "Penalty", &[Choice { value: "segments", title: "", help: "" }], "").only_on(&[DISCS]),
    ];

    fn given(name: &str, value: &str) -> Given {
        Given::from_iter([(name, Value::from(value))])
    }

    #[test]
    fn defaults_depend_on_the_kind_and_only_changes_are_kept() {
        let on_discs = Settings::new(&ALL, DISCS, &given("w", "0.7")).unwrap();
        assert_eq!((on_discs.integer("population"), on_discs.number("w"), on_discs.choice("penalty")), (80, 0.7, "segments"));
        assert!(on_discs.changed().is_empty(), "0.7 is the default");
        let on_function = Settings::new(&ALL, FUNCTION, &given("population", "7")).unwrap();
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
            Parameter::choice("first", "", "", &OPTIONS, "").defaults_on(&[(DISCS, Fixed::Text("b"))]),
            Parameter::flag("second", "", false, "").when("first", "b"),
            Parameter::number("third", "", "", [0.0, 1.0, 0.5], "").when("second", "true"),
        ];
        let names =
            |kind, given: &Given| Settings::new(&CHAIN, kind, given).map(|s| s.all().iter().map(|(name, _)| *name).collect::<Vec<_>>());
        assert_eq!(names(FUNCTION, &Given::new()).unwrap(), ["first"]);
        assert_eq!(names(DISCS, &Given::new()).unwrap(), ["first", "second"]);
        assert_eq!(names(DISCS, &given("second", "true")).unwrap(), ["first", "second", "third"]);
        let refused = names(DISCS, &given("third", "0.1")).unwrap_err();
        assert_eq!((refused.field(), refused.allowed()), ("third", "left out unless second is true"));
        let both: Given =
            [("first", Value::from("a")), ("second", Value::from("true")), ("third", Value::from("0.1"))].into_iter().collect();
        assert_eq!(names(DISCS, &both).unwrap_err().allowed(), "left out unless first is b");
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
            let error = Settings::new(&ALL, DISCS, &given(name, value)).unwrap_err();
            assert_eq!((error.field(), error.value()), (name, value));
            assert!(!error.allowed().is_empty());
        }
        let unknown = Settings::new(&ALL, FUNCTION, &given("penalty", "segments")).unwrap_err();
        assert_eq!((unknown.field(), unknown.allowed()), ("parameter", "population, w"));
    }
}
