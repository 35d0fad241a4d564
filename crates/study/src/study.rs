//! What a study is: a published experiment that is repeated here, or one of our own.

use forage::kernel::Error;

use super::{failure::Failure, fingerprints::JobList, options::Options, report::Report, runner::Control};

/// A published experiment, or one of our own.
#[derive(Debug, Clone, Copy)]
pub struct Study {
    /// The name on the command line and of its files.
    pub name: &'static str,
    /// A line for people.
    pub title: &'static str,
    /// Where it was published: `[WCPSO] Table 2`; `our own` of [`STUDIES`](super::registry::STUDIES).
    pub source: &'static str,
    /// Whether all that it says of its figures is computed; otherwise it is measured, and comes out a little different each time.
    pub repeatable: bool,
    /// The jobs whose rows it rests on; of those that depend on other jobs' rows only the first.
    pub jobs: fn(&Options) -> Result<Vec<JobList>, Failure>,
    /// Runs it and reports.
    pub run: fn(&Options, &Control) -> Result<Report, Failure>,
}

impl Study {
    /// A report on it with nothing to say yet.
    pub fn report(&self, runs: u64, published: u64) -> Report {
        let shortened = (runs != published).then(|| format!("{runs} runs a cell, published: {published}"));
        let Self { name, title, source, repeatable, .. } = *self;
        let (figures, tables, claims, notes, commands, files) = Default::default();
        Report { name, title, source, repeatable, shortened, figures, tables, claims, notes, commands, files }
    }
}

/// The jobs of all repeatable ones of these studies.
///
/// # Errors
/// What a study refuses of the options.
pub fn jobs(studies: &[Study], options: &Options) -> Result<Vec<JobList>, Failure> {
    let mut lists = Vec::new();
    for study in studies.iter().filter(|study| study.repeatable) {
        lists.extend((study.jobs)(options)?);
    }
    Ok(lists)
}

/// The study of this name among `studies`; `field` names the argument in the error.
///
/// # Errors
/// [`Error::Unknown`] with the names that exist.
pub fn find(studies: &'static [Study], field: &str, name: &str) -> Result<&'static Study, Error> {
    let known = || studies.iter().map(|study| study.name);
    studies.iter().find(|study| study.name == name).ok_or_else(|| Error::unknown(field, name, known()))
}
