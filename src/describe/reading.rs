//! The numbers that a planner reports after each iteration.

use serde::Serialize;

use crate::kernel::{ReadingName, words};

/// A number that a planner reports after each iteration.
#[derive(Debug, Clone, Copy, Serialize)]
#[non_exhaustive]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Reading {
    /// Its name in readings, traces and formulas.
    pub name: &'static str,
    /// The symbol, in TeX.
    pub symbol: &'static str,
    /// The title, a few words.
    pub title: &'static str,
    /// What it says.
    pub help: &'static str,
    /// The group that it is shown in.
    #[cfg_attr(feature = "types", ts(inline))]
    pub group: Group,
}

/// The iteration in which the best solution was found. Planners read it of their subtasks. Each planner says in its own words
/// what it counts, by [`Reading::described`].
pub const CONVERGED: Reading = Reading::new("converged", "t^*", "Converged", Group::Count, "The iteration in which the result was found.");

impl ReadingName for Reading {
    fn name(self) -> &'static str {
        self.name
    }
}

impl Reading {
    /// A number with its name, symbol, title, group and help text.
    pub const fn new(name: &'static str, symbol: &'static str, title: &'static str, group: Group, help: &'static str) -> Self {
        Self { name, symbol: words(symbol), title: words(title), help: words(help), group }
    }

    /// The same number with another symbol, title and help text.
    #[must_use]
    pub const fn described(self, symbol: &'static str, title: &'static str, help: &'static str) -> Self {
        Self { symbol: words(symbol), title: words(title), help: words(help), ..self }
    }
}

/// The group of a reading.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
#[non_exhaustive]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub enum Group {
    /// A cost: drawn in the convergence chart.
    Cost,
    /// A parameter that changes over the iterations.
    Schedule,
    /// A length in the scene's unit: drawn with the exact optimum.
    Length,
    /// Another measure of the result.
    Measure,
    /// A number of things.
    Count,
}
