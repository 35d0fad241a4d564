//! The numbers that a planner tells after each iteration.

use serde::Serialize;

use crate::kernel::ReadingName;

/// A number that a planner tells after each iteration.
#[derive(Debug, Clone, Copy, Serialize)]
pub struct Reading {
    /// Its name in readings, traces and formulas.
    pub name: &'static str,
    /// TeX.
    pub symbol: &'static str,
    /// A few words.
    pub title: &'static str,
    /// What it says.
    pub help: &'static str,
    /// Where it belongs.
    pub group: Group,
}

/// The iteration in which the best solution was found: the reading that planners use of runs of others. Each planner says
/// in its own words what it counts, by [`Reading::told`].
pub const CONVERGED: Reading = Reading::new("converged", "t^*", "Converged", Group::Count, "The iteration in which the result was found.");

impl ReadingName for Reading {
    fn name(self) -> &'static str {
        self.name
    }
}

impl Reading {
    /// A number by its name, TeX, title, group and help.
    pub const fn new(name: &'static str, symbol: &'static str, title: &'static str, group: Group, help: &'static str) -> Self {
        Self { name, symbol, title, help, group }
    }

    /// The same number, told otherwise: TeX, title and help.
    #[must_use]
    pub const fn told(self, symbol: &'static str, title: &'static str, help: &'static str) -> Self {
        Self { symbol, title, help, ..self }
    }
}

/// What a reading belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Group {
    /// A cost: drawn in the convergence chart.
    Cost,
    /// A parameter that changes over the iterations.
    Schedule,
    /// A length in the scene's unit: drawn beside the exact optimum.
    Length,
    /// Something else that the result measures.
    Measure,
    /// How many of something.
    Count,
}
