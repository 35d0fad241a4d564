//! How experiments are carried out, and the command line that repeats one of their runs.

use std::path::PathBuf;

use forage::{Setup, kernel::Error, message};

/// How an experiment is carried out.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Options {
    /// The folder for rows, tables and pictures.
    pub out: PathBuf,
    /// How many threads; `None`: all cores. The rows do not depend on it.
    pub threads: Option<usize>,
    /// How many runs a cell; `None`: as many as the paper.
    pub runs: Option<u64>,
    /// Repeat runs whose rows are already there.
    pub fresh: bool,
}

impl Options {
    /// Runs a cell, where the paper has `published`.
    ///
    /// # Errors
    /// Fewer than two, which have no standard deviation, or more than there is time for.
    pub fn runs_or(&self, published: u64) -> Result<u64, Error> {
        let runs = self.runs.unwrap_or(published);
        if (2..=1_000_000).contains(&runs) {
            Ok(runs)
        } else {
            Err(Error::refused("runs", runs, message!("error-from-to", "from {min} to {max}", min = 2_u64, max = 1_000_000_u64)))
        }
    }
}

/// The command line that repeats this very run.
pub fn command(setup: &Setup) -> String {
    let mut text = format!("forage run {} --scene {} --seed {}", setup.planner, setup.scene.name(), setup.seed);
    setup.params.iter().for_each(|(name, value)| text.extend([" --set ", name, "=", &value.to_string()]));
    text
}
