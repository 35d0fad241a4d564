//! Experiments: many runs, kept as they finish, and what they say of published figures. Native only.
//!
//! [`runner`] carries out keyed jobs on all cores and appends each finished one to [`rows`], so that an interruption
//! loses nothing. [`forage::statistics`] and [`fit`] sum the rows up, [`table`] and [`chart`] show them, and [`report`] holds a
//! reproduction's tables, claims and commands together. A reproduction is one file ([`ltqpso`], [`regression`],
//! [`antbat`], [`antbat_tours`], [`antbat_time`], [`wolf`],
//! [`wolf_dynamic`], [`arm_rrt`]) and one line in [`REPRODUCTIONS`]; nothing else lists them. What
//! papers say in words is in [`claims`]. Studies of our own are made
//! the same way and listed in [`STUDIES`]. Sweeps are in [`sweep`].
#![cfg(not(target_arch = "wasm32"))]

pub mod antbat;
pub mod antbat_time;
pub mod antbat_tours;
pub mod arm_rrt;
pub mod chart;
pub mod claims;
mod colonies;
pub mod compared;
pub mod document;
pub mod escape;
pub mod figure;
pub mod files;
pub mod fingerprints;
pub mod fit;
pub mod forensics;
pub mod inference;
pub mod ltqpso;
pub mod marks;
pub mod papers;
pub mod published;
pub mod regression;
pub mod report;
pub mod robustness;
pub mod rows;
pub mod runner;
pub mod search;
pub mod sweep;
pub mod table;
mod tours;
mod tuned;
pub mod wcpso;
pub mod wolf;
pub mod wolf_dynamic;

use std::{
    fmt, io,
    path::{Path, PathBuf},
};

use forage::{Setup, kernel::Error, statistics};

use escape::path_text;
use fingerprints::JobList;
use report::Report;
use runner::Control;

/// Every published experiment that is repeated here, in the order in which they are carried out.
pub const REPRODUCTIONS: &[Study] = &[
    wcpso::FUNCTIONS,
    wcpso::FITTED,
    wcpso::PATHS,
    ltqpso::REPRODUCTION,
    regression::REPRODUCTION,
    antbat::REPRODUCTION,
    antbat_tours::REPRODUCTION,
    antbat_time::REPRODUCTION,
    wolf::REPRODUCTION,
    wolf_dynamic::REPRODUCTION,
    arm_rrt::REPRODUCTION,
    claims::STUDIES[0],
    claims::STUDIES[1],
    claims::STUDIES[2],
    claims::STUDIES[3],
    claims::STUDIES[4],
];

/// Studies of our own, on what no paper has.
pub const STUDIES: &[Study] = &[forensics::STUDY, robustness::STUDY];

/// All of both, in the order in which they are carried out.
pub fn all() -> Vec<Study> {
    [REPRODUCTIONS, STUDIES].concat()
}

/// A published experiment, or one of our own.
#[derive(Debug, Clone, Copy)]
pub struct Study {
    /// The name on the command line and of its files.
    pub name: &'static str,
    /// A line for people.
    pub title: &'static str,
    /// Where it was published: `[WCPSO] Table 2`; `our own` of [`STUDIES`].
    pub source: &'static str,
    /// Whether all that it says of its figures is computed; otherwise it is measured, and comes out a little different each time.
    pub repeatable: bool,
    /// The jobs whose rows it rests on; of those that depend on other jobs' rows only the first.
    pub jobs: fn(&Options) -> Result<Vec<JobList>, Failure>,
    /// Runs it and reports.
    pub run: fn(&Options, &Control) -> Result<Report, Failure>,
}

/// The study of this name among `studies`; `field` names the argument in the error.
///
/// # Errors
/// [`Error::Unknown`] with the names that exist.
pub fn find(studies: &'static [Study], field: &str, name: &str) -> Result<&'static Study, Error> {
    let known = || studies.iter().map(|study| study.name);
    studies.iter().find(|study| study.name == name).ok_or_else(|| Error::unknown(field, name, known()))
}

/// How an experiment is carried out.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Options {
    /// The folder for rows, tables and pictures.
    pub out: PathBuf,
    /// How many threads; `None`: all cores. The rows do not depend on it.
    pub threads: Option<usize>,
    /// How many runs a cell; `None`: as many as the paper.
    pub runs: Option<u64>,
    /// Carry out anew what is already there.
    pub fresh: bool,
}

impl Options {
    /// Runs a cell, where the paper has `published`.
    ///
    /// # Errors
    /// Fewer than two, which have no standard deviation, or more than there is time for.
    pub fn runs_or(&self, published: u64) -> Result<u64, Error> {
        let runs = self.runs.unwrap_or(published);
        if (2..=1_000_000).contains(&runs) { Ok(runs) } else { Err(Error::refused("runs", runs, "from 2 to 1000000")) }
    }
}

/// Why an experiment did not come to its end.
#[derive(Debug)]
pub enum Failure {
    /// The input was refused.
    Refused(Error),
    /// A file could not be read or written.
    File(PathBuf, io::Error),
    /// Somebody asked it to stop. What is finished is kept.
    Interrupted {
        /// Jobs that are finished.
        done: usize,
        /// All jobs.
        total: usize,
        /// Where they are kept.
        rows: PathBuf,
    },
    /// Somebody asked it to stop, and nothing is kept: so many rows were compared.
    ComparisonInterrupted(usize),
}

impl From<Error> for Failure {
    fn from(error: Error) -> Self {
        Self::Refused(error)
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Refused(error) => error.fmt(f),
            Self::File(path, error) => write!(f, "{}: {error}", path_text(path)),
            Self::ComparisonInterrupted(rows) => write!(f, "interrupted after {rows} rows were compared; nothing is kept"),
            Self::Interrupted { done, total, rows } => {
                write!(f, "interrupted; {done} of {total} rows are kept in {}, the same command goes on from there", path_text(rows))
            }
        }
    }
}

impl std::error::Error for Failure {}

/// Names the file in an input or output error.
fn at(path: &Path) -> impl Fn(io::Error) -> Failure + '_ {
    move |error| Failure::File(path.to_owned(), error)
}

/// The command line that repeats this very run.
pub fn command(setup: &Setup) -> String {
    let mut text = format!("forage run {} --scene {} --seed {}", setup.planner, setup.scene.name(), setup.seed);
    setup.params.iter().for_each(|(name, value)| text.extend([" --set ", name, "=", &value.to_string()]));
    text
}
