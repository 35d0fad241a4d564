//! The numbers that a planner tells after each iteration.

use serde::Serialize;

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

impl Reading {
    /// A number by its name, TeX, title, group and help.
    pub const fn new(name: &'static str, symbol: &'static str, title: &'static str, group: Group, help: &'static str) -> Self {
        Self { name, symbol, title, help, group }
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
