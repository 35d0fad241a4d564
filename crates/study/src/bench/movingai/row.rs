//! The result of a run on a problem.

use serde::{Deserialize, Serialize};

use forage::{kernel::Message, message};

use super::super::{super::rows::KeyedRow, suite::planner_label};

/// How far a length may be from the file's optimum and still be it.
pub(super) const TOLERANCE: f64 = 1e-4;
/// The same as a share of an optimum that is given with six digits, as in older files: half a unit of the last one, or more.
const SIX_DIGITS: f64 = 5e-6;

/// The result of a run.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// The planner.
    pub planner: String,
    /// Parameters that differ from the defaults.
    pub params: String,
    /// The file of problems, within the folder.
    pub file: String,
    /// The problem's number in it, from 0.
    pub problem: usize,
    /// Its bucket: a fourth of its length, as the format has it.
    pub bucket: u64,
    /// The shortest way from cell to cell, as the file gives it.
    pub optimum: f64,
    /// Whether the planner says that it finds the shortest way.
    pub exact: bool,
    /// The length of what was found, if it is a way.
    pub length: Option<f64>,
    /// Iterations taken.
    pub iterations: u64,
    /// Evaluations: cells that were closed, for a search.
    pub evaluations: u64,
    /// How long it took, in seconds; measured.
    pub seconds: f64,
}

impl Row {
    /// How much longer than the optimum, as a share of it. Planners that do not go from cell to cell may be below 0.
    pub(super) fn gap(&self) -> Option<f64> {
        self.length.filter(|_| self.optimum > 0.0).map(|length| length / self.optimum - 1.0)
    }

    /// The planner with its overrides.
    pub(super) fn contender(&self) -> String {
        planner_label(&self.planner, &self.params)
    }

    /// Whether the length is the optimum, as far as the file's digits tell.
    pub(super) fn is_optimal(&self) -> bool {
        let has_six = format!("{:.5e}", self.optimum).parse() == Ok(self.optimum);
        let tolerance = if has_six { TOLERANCE.max(SIX_DIGITS * self.optimum) } else { TOLERANCE };
        self.length.is_some_and(|length| (length - self.optimum).abs() <= tolerance)
    }

    /// Whether it is another length than the optimum though the planner is exact.
    pub(super) fn is_fault(&self) -> bool {
        self.exact && !self.is_optimal()
    }

    /// What is wrong with it.
    pub(super) fn fault(&self) -> Message {
        missed(self)
    }
}

fn missed(run: &Row) -> Message {
    let (row, optimum) = (run.key(), run.optimum);
    if let Some(length) = run.length {
        message!("study-way-no-optimum", "{row}: a way of {length}, the optimum is {optimum}", row, length, optimum)
    } else {
        message!("study-no-way", "{row}: no way, the optimum is {optimum}", row, optimum)
    }
}

impl KeyedRow for Row {
    fn key(&self) -> String {
        key(&self.contender(), &self.file, self.problem)
    }

    fn computed(&self) -> Self {
        Self { seconds: 0.0, ..self.clone() }
    }
}

pub(super) fn key(contender: &str, file: &str, problem: usize) -> String {
    format!("{contender} on {file} problem {problem}")
}
