//! Parameters declared once: what lists a parameter also reads it.
#![expect(
    clippy::inline_always,
    reason = "only so does a reading need the name alone, and no copy of the declaration in the program's data"
)]

use std::ops::Index;

use crate::kernel::{SceneKindId, words};

use super::{Choice, Domain, Fixed, Parameter, Parameters, When};

/// A parameter and the type of its values: declared once, listed by [`Param::entry`], read by `parameters[POPULATION]`.
///
/// It is read by name. So a planner may list a variant of a shared parameter (another default, another help text), and
/// the code that planners share reads the shared one.
///
/// ```
/// use forage::{Overrides, Value, params::{Param, Parameter, Parameters}, scene::GRID};
///
/// const POPULATION: Param<u64> = Param::integer("population", "m", "Population", [1, 1000, 60], "How many particles.");
/// const PARAMETERS: &[&[Parameter]] = &[&[POPULATION.default_to(20).entry()]];
///
/// assert_eq!(Parameters::new(PARAMETERS, GRID, &Overrides::new())?[POPULATION], 20);
/// let given = Overrides::from_iter([("population", Value::from(7.0))]);
/// assert_eq!(Parameters::new(PARAMETERS, GRID, &given)?[POPULATION], 7);
/// # Ok::<(), forage::Error>(())
/// ```
#[derive(Debug, Clone, Copy)]
pub struct Param<T: 'static> {
    parameter: Parameter,
    /// What the options of a choice mean. The first is also what it reads as where it is not listed.
    meanings: &'static [T],
}

/// The values of a parameter that is any of a few options: text with commas between.
#[derive(Debug, Clone, Copy)]
pub enum Selection {}

/// A type of parameter values: `f64`, `u64`, `bool`, `&'static str` for names, and what the options of a choice mean.
pub trait ParamValue: Sized + 'static {
    /// The value of a parameter: what its chosen option means, unless it is a number, a flag or a name.
    #[inline(always)]
    fn read<'a>(parameters: &'a Parameters, param: &Param<Self>) -> &'a Self {
        param.chosen(parameters)
    }
}

impl ParamValue for f64 {
    #[inline(always)]
    fn read<'a>(parameters: &'a Parameters, param: &Param<Self>) -> &'a Self {
        match param.parameter.domain {
            Domain::Choice { .. } => param.chosen(parameters),
            _ => parameters.number(param.parameter.name),
        }
    }
}

impl ParamValue for u64 {
    #[inline(always)]
    fn read<'a>(parameters: &'a Parameters, param: &Param<Self>) -> &'a Self {
        parameters.whole(param.parameter.name)
    }
}

impl ParamValue for bool {
    #[inline(always)]
    fn read<'a>(parameters: &'a Parameters, param: &Param<Self>) -> &'a Self {
        match param.parameter.domain {
            Domain::Choice { .. } => param.chosen(parameters),
            _ => parameters.flag(param.parameter.name),
        }
    }
}

impl ParamValue for &'static str {
    #[inline(always)]
    fn read<'a>(parameters: &'a Parameters, param: &Param<Self>) -> &'a Self {
        &parameters.option(param.parameter.name, param.parameter.options()).1.value
    }
}

impl<T: 'static> ParamValue for Option<T> {}

impl<T: ParamValue> Index<Param<T>> for Parameters {
    type Output = T;

    /// The value of a parameter on this kind of scene. A parameter that does not apply there or is not listed reads as NaN, 0,
    /// false, the empty text or the meaning of the first option. In debug builds, reading one that is not listed panics.
    #[inline(always)]
    fn index(&self, param: Param<T>) -> &T {
        T::read(self, &param)
    }
}

impl Index<Param<Selection>> for Parameters {
    type Output = str;

    fn index(&self, param: Param<Selection>) -> &str {
        self.text(param.parameter.name)
    }
}

impl<T> Param<T> {
    const fn new(
        name: &'static str,
        symbol: &'static str,
        title: &'static str,
        domain: Domain,
        meanings: &'static [T],
        help: &'static str,
    ) -> Self {
        let (kinds, defaults, when, slider) = (&[] as &[_], &[] as &[_], None, None);
        let (symbol, title, help) = (words(symbol), words(title), words(help));
        let parameter = Parameter { name, symbol, title, help, domain, kinds, defaults, when, slider, logarithmic: false };
        Self { parameter, meanings }
    }

    /// One of a few options, each with its meaning; the first is the default.
    pub const fn choice<const N: usize>(
        name: &'static str,
        symbol: &'static str,
        title: &'static str,
        options: &'static [Choice; N],
        meanings: &'static [T; N],
        help: &'static str,
    ) -> Self {
        const { assert!(N > 0, "a choice has an option") };
        Self::new(name, symbol, title, Domain::Choice { options }, meanings, help)
    }

    /// What the chosen option means.
    #[inline(always)]
    fn chosen(&self, parameters: &Parameters) -> &'static T {
        &self.meanings[parameters.option(self.parameter.name, self.parameter.options()).0]
    }

    /// Its name, as in `--set name=value`.
    pub const fn name(&self) -> &'static str {
        self.parameter.name
    }

    /// Its description, for a list of parameters.
    pub const fn entry(self) -> Parameter {
        self.parameter
    }

    /// The same with another help text.
    #[must_use]
    pub const fn help(mut self, help: &'static str) -> Self {
        self.parameter.help = words(help);
        self
    }

    /// The same with another title.
    #[must_use]
    pub const fn title(mut self, title: &'static str) -> Self {
        self.parameter.title = words(title);
        self
    }

    /// The same, applying to these kinds of scene only.
    #[must_use]
    pub const fn only_on(mut self, kinds: &'static [SceneKindId]) -> Self {
        self.parameter.kinds = kinds;
        self
    }

    /// The same with defaults that differ by kind of scene.
    #[must_use]
    pub const fn defaults_on(mut self, defaults: &'static [(SceneKindId, Fixed)]) -> Self {
        self.parameter.defaults = defaults;
        self
    }

    /// The same, applying only while another parameter has this value.
    #[must_use]
    pub const fn when<U: Copy>(mut self, other: Param<U>, value: &'static str) -> Self {
        self.parameter.when = Some(When { parameter: other.parameter.name, value });
        self
    }

    /// The same with a slider from `low` to `high`.
    #[must_use]
    pub const fn slider(mut self, low: f64, high: f64, logarithmic: bool) -> Self {
        self.parameter.slider = Some((low, high));
        self.parameter.logarithmic = logarithmic;
        self
    }
}

impl Param<f64> {
    /// A real number from `min` to `max`. Not listed, it reads as NaN.
    pub const fn number(
        name: &'static str,
        symbol: &'static str,
        title: &'static str,
        [min, max, default]: [f64; 3],
        help: &'static str,
    ) -> Self {
        Self::new(name, symbol, title, Domain::Number { min, max, default }, &[], help)
    }

    /// The same with another default.
    #[must_use]
    pub const fn default_to(mut self, value: f64) -> Self {
        if let Domain::Number { default, .. } = &mut self.parameter.domain {
            *default = value;
        }
        self
    }
}

impl Param<u64> {
    /// A whole number from `min` to `max`. Not listed, it reads as 0.
    pub const fn integer(
        name: &'static str,
        symbol: &'static str,
        title: &'static str,
        [min, max, default]: [u64; 3],
        help: &'static str,
    ) -> Self {
        Self::new(name, symbol, title, Domain::Integer { min, max, default }, &[], help)
    }

    /// The same with another default.
    #[must_use]
    pub const fn default_to(mut self, value: u64) -> Self {
        if let Domain::Integer { default, .. } = &mut self.parameter.domain {
            *default = value;
        }
        self
    }
}

impl Param<&'static str> {
    /// One of a few names, e.g. of planners; the first is the default.
    pub const fn name_of(
        name: &'static str,
        symbol: &'static str,
        title: &'static str,
        options: &'static [Choice],
        help: &'static str,
    ) -> Self {
        Self::new(name, symbol, title, Domain::Choice { options }, &[], help)
    }
}

impl Param<bool> {
    /// Yes or no. Not listed, it reads as no.
    pub const fn flag(name: &'static str, title: &'static str, default: bool, help: &'static str) -> Self {
        Self::new(name, "", title, Domain::Flag { default }, &[], help)
    }
}

impl Param<Selection> {
    /// Any of a few options, at least one: text with commas between. Not listed, it reads as none.
    pub const fn subset(
        name: &'static str,
        title: &'static str,
        options: &'static [Choice],
        default: &'static str,
        help: &'static str,
    ) -> Self {
        Self::new(name, "", title, Domain::Subset { options, default }, &[], help)
    }
}
