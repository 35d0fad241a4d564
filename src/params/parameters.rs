//! Given values, checked against a planner's parameters and completed by defaults.

use crate::{
    kernel::{Error, SceneKindId},
    message,
};

use super::{Choice, Overrides, Parameter, Value, When};

/// What is said of the name of a parameter that is read and not listed.
pub(crate) const UNLISTED: &str = "is read, and the entry does not list it";

/// A valid value for every parameter of a planner on a kind of scene. Read by `settings[POPULATION]`, see
/// [`Param`](super::Param).
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Parameters {
    declared: &'static [&'static [Parameter]],
    values: Vec<(&'static str, Value)>,
    /// The values as whole numbers, in their order; 0 for what is no number.
    whole: Vec<u64>,
    changed: Overrides,
}

impl Parameters {
    /// Checks what was given and fills in the defaults.
    ///
    /// # Errors
    /// [`Error::Unknown`] for a name that is not a parameter on this kind of scene, [`Error::Refused`] for a value that is not allowed.
    pub fn new(parameters: &'static [&'static [Parameter]], kind: SceneKindId, given: &Overrides) -> Result<Self, Error> {
        let of_kind = || flat(parameters).filter(|p| p.applies_to(kind));
        for (name, value) in given.iter() {
            let parameter =
                of_kind().find(|p| p.name == name).ok_or_else(|| Error::unknown("parameter", name, of_kind().map(|p| p.name)))?;
            parameter.check(value)?;
            if let Some(When { parameter: other, value: needed }) = unmet(parameters, kind, given, parameter) {
                let allowed = message!("error-left-out-unless", "left out unless {other} is {needed}", other, needed);
                return Err(Error::refused(name, value, allowed));
            }
        }
        let applicable = || of_kind().filter(|p| unmet(parameters, kind, given, p).is_none());
        let values: Vec<_> = applicable().map(|p| (p.name, given.get(p.name).cloned().unwrap_or_else(|| p.default_on(kind)))).collect();
        let whole = values.iter().map(|(_, value)| if let Value::Number(number) = value { *number as u64 } else { 0 }).collect();
        let changed =
            applicable().filter_map(|p| given.get(p.name).filter(|&v| *v != p.default_on(kind)).map(|v| (p.name, v.clone()))).collect();
        Ok(Self { declared: parameters, values, whole, changed })
    }

    /// Every parameter with its value.
    pub fn all(&self) -> &[(&'static str, Value)] {
        &self.values
    }

    /// The values that differ from the defaults.
    pub fn changed(&self) -> &Overrides {
        &self.changed
    }

    #[inline(never)]
    pub(super) fn number(&self, name: &str) -> &f64 {
        if let Some(Value::Number(number)) = self.get(name) { number } else { &f64::NAN }
    }

    #[inline(never)]
    pub(super) fn whole(&self, name: &str) -> &u64 {
        self.place(name).map_or(&0, |place| &self.whole[place])
    }

    #[inline(never)]
    pub(super) fn flag(&self, name: &str) -> &bool {
        if let Some(Value::Flag(flag)) = self.get(name) { flag } else { &false }
    }

    #[inline(never)]
    pub(super) fn text(&self, name: &str) -> &str {
        if let Some(Value::Text(text)) = self.get(name) { text } else { "" }
    }

    /// The option of a choice that is chosen, and its place among them; the first one where none is.
    #[inline(never)]
    pub(super) fn option(&self, name: &str, options: &'static [Choice]) -> (usize, &'static Choice) {
        const NONE: Choice = Choice::new("", "", "");
        let text = self.text(name);
        let found = options.iter().enumerate().find(|(_, option)| option.value == text);
        debug_assert!(found.is_some() || text.is_empty(), "`{name}` is {text}, which what reads it does not know");
        found.unwrap_or((0, &NONE))
    }

    fn get(&self, name: &str) -> Option<&Value> {
        self.place(name).map(|place| &self.values[place].1)
    }

    fn place(&self, name: &str) -> Option<usize> {
        let place = self.values.iter().position(|(known, _)| *known == name);
        let listed = || flat(self.declared).any(|parameter| parameter.name == name);
        debug_assert!(place.is_some() || listed(), "`{name}` {UNLISTED}");
        place
    }
}

/// All parameters of some lists.
fn flat(parameters: &'static [&'static [Parameter]]) -> impl Iterator<Item = &'static Parameter> {
    parameters.iter().copied().flatten()
}

/// The first condition that keeps a parameter from meaning anything: its own, or one of the parameter it depends on.
fn unmet(parameters: &'static [&'static [Parameter]], kind: SceneKindId, given: &Overrides, parameter: &Parameter) -> Option<When> {
    let when = parameter.when?;
    let Some(other) = flat(parameters).find(|p| p.name == when.parameter && p.applies_to(kind)) else {
        return Some(when);
    };
    let value = given.get(other.name).cloned().unwrap_or_else(|| other.default_on(kind));
    if value.to_string() == when.value { unmet(parameters, kind, given, other) } else { Some(when) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        params::{Fixed, Param, Selection},
        scene::{DISCS, FUNCTION, GRID},
    };

    const POPULATION: Param<u64> =
        Param::integer("population", "N", "Population", [1, 100, 60], "").defaults_on(&[(DISCS, Fixed::Number(80.0))]);
    const W: Param<f64> = Param::number("w", "\\omega", "Inertia weight", [0.0, 1.5, 0.7], "");
    const PENALTY: Param<&str> = Param::name_of("penalty", "", "Penalty", &[Choice::new("segments", "", "")], "").only_on(&[DISCS]);
    const ALL: &[&[Parameter]] = &[&[POPULATION.entry()], &[W.entry(), PENALTY.entry()]];

    fn given(name: &str, value: &str) -> Overrides {
        Overrides::from_iter([(name, Value::from(value))])
    }

    #[test]
    fn defaults_depend_on_the_kind_and_only_changes_are_kept() {
        let on_discs = Parameters::new(ALL, DISCS, &given("w", "0.7")).unwrap();
        assert_eq!((on_discs[POPULATION], on_discs[W], on_discs[PENALTY]), (80, 0.7, "segments"));
        assert!(on_discs.changed().is_empty(), "0.7 is the default");
        let on_function = Parameters::new(ALL, FUNCTION, &given("population", "7")).unwrap();
        assert_eq!(on_function.changed().iter().collect::<Vec<_>>(), [("population", &Value::from(7.0))]);
        assert_eq!(on_function.all().len(), 2, "the penalty means nothing on functions");
        assert_eq!((on_function[POPULATION], on_function[PENALTY]), (7, ""));
    }

    #[test]
    fn a_subset_has_known_names_each_once() {
        const OPTIONS: [Choice; 2] = [Choice::new("a", "", ""), Choice::new("b", "", "")];
        const SOME: Param<Selection> = Param::subset("some", "", &OPTIONS, "a", "");
        const SOME_ONLY: &[&[Parameter]] = &[&[SOME.entry()]];
        let parameter = SOME.entry();
        for good in ["a", "b,a"] {
            parameter.check(&Value::from(good)).unwrap();
        }
        let parameters = Parameters::new(SOME_ONLY, GRID, &given("some", "b,a")).unwrap();
        assert_eq!(&parameters[SOME], "b,a");
        for bad in ["", "c", "a,a", "a,", "a b"] {
            assert_eq!(parameter.check(&Value::from(bad)).unwrap_err().allowed(), "some of a, b, each once, with commas between");
        }
    }

    /// A parameter that hangs on another's value, which hangs on a third's.
    #[test]
    fn a_parameter_means_something_only_while_what_it_depends_on_has_its_value() {
        const OPTIONS: [Choice; 2] = [Choice::new("a", "", ""), Choice::new("b", "", "")];
        const FIRST: Param<bool> = Param::choice("first", "", "", &OPTIONS, &[false, true], "").defaults_on(&[(DISCS, Fixed::Text("b"))]);
        const SECOND: Param<bool> = Param::flag("second", "", false, "").when(FIRST, "b");
        const THIRD: Param<f64> = Param::number("third", "", "", [0.0, 1.0, 0.5], "").when(SECOND, "true");
        const CHAIN: &[&[Parameter]] = &[&[FIRST.entry(), SECOND.entry(), THIRD.entry()]];
        let names = |kind, given: &Overrides| {
            Parameters::new(CHAIN, kind, given).map(|s| s.all().iter().map(|(name, _)| *name).collect::<Vec<_>>())
        };
        assert_eq!(names(FUNCTION, &Overrides::new()).unwrap(), ["first"]);
        assert_eq!(names(DISCS, &Overrides::new()).unwrap(), ["first", "second"]);
        assert_eq!(names(DISCS, &given("second", "true")).unwrap(), ["first", "second", "third"]);
        let [on_function, on_discs] = [FUNCTION, DISCS].map(|kind| Parameters::new(CHAIN, kind, &Overrides::new()).unwrap());
        assert_eq!((on_function[FIRST], on_discs[FIRST], on_discs[SECOND]), (false, true, false));
        assert!(on_discs[THIRD].is_nan(), "it means nothing there");
        let refused = names(DISCS, &given("third", "0.1")).unwrap_err();
        assert_eq!((refused.field(), &*refused.allowed()), ("third", "left out unless second is true"));
        let both: Overrides =
            [("first", Value::from("a")), ("second", Value::from("true")), ("third", Value::from("0.1"))].into_iter().collect();
        assert_eq!(names(DISCS, &both).unwrap_err().allowed(), "left out unless first is b");
    }

    #[test]
    #[should_panic(expected = "`speed` is read, and the entry does not list it")]
    fn a_parameter_that_is_not_listed_is_noticed_in_debug_builds() {
        const SPEED: Param<f64> = Param::number("speed", "", "", [0.0, 1.0, 0.5], "");
        let _ = Parameters::new(ALL, DISCS, &Overrides::new()).unwrap()[SPEED];
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
            let error = Parameters::new(ALL, DISCS, &given(name, value)).unwrap_err();
            assert_eq!((error.field(), error.value()), (name, value));
            assert!(!error.allowed().is_empty());
        }
        let unknown = Parameters::new(ALL, FUNCTION, &given("penalty", "segments")).unwrap_err();
        assert_eq!((unknown.field(), &*unknown.allowed()), ("parameter", "population, w"));
    }
}
