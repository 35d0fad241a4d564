//! The equations that a planner computes.

use serde::Serialize;

use crate::{
    kernel::words,
    params::{Param, When},
};

/// An equation that a planner computes.
#[derive(Debug, Clone, Copy, Serialize)]
#[non_exhaustive]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Formula {
    /// An identifier within the planner. Equations of which one is computed, depending on `when`, share it.
    pub name: &'static str,
    /// The source, e.g. `[WCPSO] (3)`.
    pub source: &'static str,
    /// The title, a few words.
    pub title: &'static str,
    /// The equation in TeX, as in the paper. `\class{inertia}{…}` is the term that explanations mark by the layer of that name.
    pub tex: &'static str,
    /// The equation in TeX, with `@name@` in place of each current number.
    #[serde(skip_serializing_if = "str::is_empty")]
    #[cfg_attr(feature = "types", ts(optional, as = "Option<String>"))]
    pub live: &'static str,
    /// Where those numbers come from.
    #[cfg_attr(feature = "types", ts(inline))]
    pub scope: Scope,
    /// The parameter value with which the equation is computed; `None`: with any.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "types", ts(optional))]
    pub when: Option<When>,
}

impl Formula {
    /// An equation that is filled in from the readings of the iteration, and the parameters.
    pub const fn new(name: &'static str, source: &'static str, title: &'static str, tex: &'static str, live: &'static str) -> Self {
        Self { name, source: words(source), title: words(title), tex: words(tex), live: words(live), scope: Scope::Iteration, when: None }
    }

    /// An equation that is filled in from an inspection's values.
    pub const fn of_item(name: &'static str, source: &'static str, title: &'static str, tex: &'static str, live: &'static str) -> Self {
        Self { scope: Scope::Item, ..Self::new(name, source, title, tex, live) }
    }

    /// The same, computed only while a parameter has this value.
    #[must_use]
    pub const fn when<T: Copy>(mut self, parameter: Param<T>, value: &'static str) -> Self {
        self.when = Some(When { parameter: parameter.name(), value });
        self
    }
}

/// Where a formula's numbers come from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
#[non_exhaustive]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub enum Scope {
    /// The readings of the iteration, and the parameters.
    Iteration,
    /// An inspection's values.
    Item,
}
