//! What a suite found.

use std::fmt;

/// A promise that a planner breaks.
#[derive(Debug, Clone, PartialEq, Eq)]
#[non_exhaustive]
pub struct Finding {
    /// The planner's name.
    pub planner: String,
    /// The name of the check that found it.
    pub check: &'static str,
    /// The run that shows it: scene, seed, parameters and iteration, in words. Empty if no run is needed to see it.
    pub setup: String,
    /// The same run as a link, which `forage run LINK` of a shell with this planner opens.
    pub link: String,
    /// What was found.
    pub found: String,
    /// What to change: a sentence.
    pub remedy: &'static str,
}

impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}\n  found:  {}\n  remedy: {}", self.planner, self.check, self.found, self.remedy)?;
        if !self.setup.is_empty() {
            write!(f, "\n  run:    {}\n  again:  forage run '{}'", self.setup, self.link)?;
        }
        Ok(())
    }
}

/// All findings about a planner. Prints as a text with a paragraph for each.
#[derive(Debug, Clone, PartialEq, Eq)]
#[must_use]
#[non_exhaustive]
pub struct Report {
    /// The planner's name.
    pub planner: String,
    /// The number of checks made.
    pub checks: usize,
    /// The promises that it breaks, each once; empty if it keeps all of them.
    pub findings: Vec<Finding>,
}

impl Report {
    /// Whether nothing was found.
    pub fn conforms(&self) -> bool {
        self.findings.is_empty()
    }

    /// Panics if there are findings, and prints them.
    ///
    /// # Panics
    /// If the planner breaks a promise.
    #[track_caller]
    pub fn assert(&self) {
        assert!(self.conforms(), "{self}");
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { planner, checks, findings } = self;
        if findings.is_empty() {
            return write!(f, "{planner} conforms: {checks} checks");
        }
        write!(f, "{planner} does not conform: {} findings by {checks} checks", findings.len())?;
        findings.iter().try_for_each(|finding| write!(f, "\n\n{finding}"))
    }
}
