//! Why an experiment did not come to its end.

use std::{
    fmt, io,
    path::{Path, PathBuf},
};

use forage::{
    kernel::{Error, Message},
    message,
};

use super::escape::path_text;

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

impl Failure {
    /// What it says.
    pub fn message(&self) -> Message {
        match self {
            Self::Refused(error) => error.message(),
            Self::File(path, error) => {
                message!("study-file", "{file}: {problem}", file = path_text(path), problem = error.to_string())
            }
            Self::ComparisonInterrupted(rows) => {
                message!("study-comparison-interrupted", "interrupted after {rows} rows were compared; nothing is kept", rows)
            }
            Self::Interrupted { done, total, rows } => message!(
                "study-interrupted",
                "interrupted; {done} of {total} rows are kept in {rows}, the same command goes on from there",
                done,
                total,
                rows = path_text(rows)
            ),
        }
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.message().fmt(f)
    }
}

impl std::error::Error for Failure {}

/// Names the file in an input or output error.
pub(crate) fn at(path: &Path) -> impl Fn(io::Error) -> Failure + '_ {
    move |error| Failure::File(path.to_owned(), error)
}
