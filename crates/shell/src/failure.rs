//! Why a command did not do what it was asked, in at most 300 characters.

use std::{io, path::Path, process::ExitCode};

use forage::Error;
use forage_study::failure::Failure as StudyFailure;

use super::{
    names::{self, Subject},
    text::{self, cut_list, quoted, shorten},
};

/// The longest message on standard error, in characters.
const LONGEST: usize = 300;

/// Why a command did not do what it was asked.
#[derive(Debug)]
pub(super) enum Failure {
    /// The input was refused: exit code 2.
    Refused(String),
    /// A file (or standard output) could not be read or written.
    File(String, io::Error),
    /// Ctrl-C ended an experiment: exit code 130, as shells have it.
    Interrupted(String),
}

/// What a command ended with.
pub(super) type Outcome = Result<ExitCode, Failure>;

impl Failure {
    /// The exit code.
    pub(super) fn code(&self) -> u8 {
        use io::ErrorKind::{AlreadyExists, InvalidFilename, InvalidInput, IsADirectory, NotADirectory, NotFound, PermissionDenied};
        match self {
            Self::Refused(_) => 2,
            // The same command would fail again.
            Self::File(_, error) => match error.kind() {
                NotFound | PermissionDenied | IsADirectory | NotADirectory | AlreadyExists | InvalidInput | InvalidFilename => 2,
                _ => 3,
            },
            Self::Interrupted(_) => 130,
        }
    }

    /// A file that cannot be read.
    pub(super) fn read(path: &Path, error: io::Error) -> Self {
        match error.kind() {
            io::ErrorKind::NotFound => Self::Refused(format!("{}: no such file", quoted(&path.to_string_lossy()))),
            _ => Self::File(path.to_string_lossy().into_owned(), error),
        }
    }

    /// A file that cannot be written.
    pub(super) fn write(path: &Path, error: io::Error) -> Self {
        let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty() && !folder.exists());
        match (error.kind(), folder) {
            (io::ErrorKind::NotFound, Some(folder)) => {
                let [path, folder] = [path, folder].map(|path| quoted(&path.to_string_lossy()));
                Self::Refused(format!("{path} cannot be written: there is no folder {folder}"))
            }
            _ => Self::File(path.to_string_lossy().into_owned(), error),
        }
    }

    /// An error of the library about `subject`'s parameters.
    pub(super) fn about(subject: Subject<'_>, error: &Error) -> Self {
        Self::Refused(message(error, subject))
    }

    /// What is printed on standard error.
    pub(super) fn message(&self) -> String {
        let message = match self {
            Self::Refused(message) | Self::Interrupted(message) => message.clone(),
            Self::File(path, error) => format!("{}: {}", quoted(path), problem(error)),
        };
        shorten(&message, LONGEST)
    }
}

impl From<Error> for Failure {
    fn from(error: Error) -> Self {
        Self::about(Subject::Unknown, &error)
    }
}

impl From<StudyFailure> for Failure {
    fn from(failure: StudyFailure) -> Self {
        match failure {
            StudyFailure::Refused(error) => error.into(),
            StudyFailure::File(path, error) => Self::File(path.to_string_lossy().into_owned(), error),
            interrupted @ (StudyFailure::Interrupted { .. } | StudyFailure::ComparisonInterrupted(_)) => {
                Self::Interrupted(interrupted.to_string())
            }
        }
    }
}

/// What the system says about a file, without its number.
fn problem(error: &io::Error) -> String {
    match error.kind() {
        io::ErrorKind::NotFound => "no such file or folder".to_owned(),
        io::ErrorKind::PermissionDenied => "permission denied".to_owned(),
        io::ErrorKind::IsADirectory => "it is a folder".to_owned(),
        _ => error.to_string().split(" (os error").next().unwrap_or_default().to_owned(),
    }
}

/// What is wrong with the content of a file.
pub(super) fn in_file(path: &Path, error: &Error) -> Failure {
    let problem = match error {
        Error::Malformed { field, problem } if field == "scene" => problem.to_string(),
        other => message(other, Subject::Unknown),
    };
    Failure::Refused(format!("{}: {}", quoted(&path.to_string_lossy()), shorten(&problem, 210)))
}

/// An error of the library as a sentence.
fn message(error: &Error, subject: Subject<'_>) -> String {
    match error {
        Error::Unknown { field, value, known } => {
            let known: Vec<&str> = known.split(", ").collect();
            names::unknown(field, value, &known, subject)
        }
        Error::Refused { field, value, allowed } => refused(field, value, &allowed.text()),
        Error::Unsupported { planner, kind, kinds } => {
            format!("`{planner}` does not run on scenes of kind {kind}; it runs on scenes of kind {kinds}")
        }
        Error::Malformed { field, problem } => {
            let problem = unknown_field(&problem.text()).unwrap_or_else(|| shorten(&problem.text(), 190));
            format!("{}: {problem}", shorten(field, 100))
        }
        other => other.to_string(),
    }
}

/// What may have been meant by a field that TOML does not have, as in ``line 1, column 1: unknown field `scene`, expected one of
/// `name`, `scenes` ``; `None` for other problems, and where nothing is near.
fn unknown_field(problem: &str) -> Option<String> {
    let (place, rest) = problem.split_once("unknown field `")?;
    let (typed, rest) = rest.split_once("`, expected ")?;
    let known: Vec<&str> = rest.split('`').skip(1).step_by(2).collect();
    let near: Vec<String> = names::nearest(typed, &known).iter().map(|name| format!("`{name}`")).collect();
    let place = shorten(place, 60);
    (!near.is_empty()).then(|| format!("{place}{} is not a known field; did you mean {}?", quoted(typed), near.join(" or ")))
}

fn refused(field: &str, value: &str, allowed: &str) -> String {
    let field = quoted(field);
    match (value, allowed.strip_prefix("left out, or one of ")) {
        ("this field", Some(known)) => {
            let known: Vec<&str> = known.split(", ").collect();
            format!("{field} is not a known field; leave it out, or use one of {}", cut_list(&known, 110))
        }
        ("nothing", _) => format!("{field} is missing; it must be {}", allowed_text(allowed)),
        ("", _) => format!("{field} is empty; it must be {}", allowed_text(allowed)),
        _ => format!("{field} is {}; it must be {}", shorten(value, 60), allowed_text(allowed)),
    }
}

/// What is allowed, at most 150 characters of it.
fn allowed_text(allowed: &str) -> String {
    let items: Vec<&str> = allowed.split(", ").collect();
    let fits = allowed.chars().count() <= 150;
    if fits { text::escape(allowed).into_owned() } else { shorten(&cut_list(&items, 110), 130) }
}
