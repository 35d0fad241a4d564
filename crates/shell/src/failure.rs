//! Why a command did not do what it was asked, in at most 300 characters.

use std::{io, path::Path, process::ExitCode};

use forage::{
    Error,
    kernel::{Argument, Message},
    message,
};
use forage_study::failure::Failure as StudyFailure;

use super::{
    kinds,
    names::{self, Subject},
    text::{self, cut_list, quoted, shorten},
};

/// The longest message on standard error, in characters.
const LONGEST: usize = 300;

/// Why a command did not do what it was asked.
#[derive(Debug)]
pub(super) enum Failure {
    /// The input was refused: exit code 2.
    Refused(Message),
    /// A file (or standard output) could not be read or written.
    File(String, io::Error),
    /// Ctrl-C ended an experiment: exit code 130, as shells have it.
    Interrupted(Message),
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
            io::ErrorKind::NotFound => {
                Self::Refused(message!("shell-no-such-file", "{file}: no such file", file = quoted(&path.to_string_lossy())))
            }
            _ => Self::File(path.to_string_lossy().into_owned(), error),
        }
    }

    /// A file that cannot be written.
    pub(super) fn write(path: &Path, error: io::Error) -> Self {
        let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty() && !folder.exists());
        match (error.kind(), folder) {
            (io::ErrorKind::NotFound, Some(folder)) => cannot_be_written(path, &no_folder(folder)),
            _ => Self::File(path.to_string_lossy().into_owned(), error),
        }
    }

    /// Standard output that cannot be written.
    pub(super) fn output(error: io::Error) -> Self {
        Self::File(message!("shell-standard-output", "standard output").to_string(), error)
    }

    /// A file that should be text, and is not.
    pub(super) fn no_text(path: &Path) -> Self {
        Self::Refused(text::at(&quoted(&path.to_string_lossy()), &message!("shell-no-text", "this is no text")))
    }

    /// An error of the library about `subject`'s parameters.
    pub(super) fn about(subject: Subject<'_>, error: &Error) -> Self {
        Self::Refused(message(error, subject))
    }

    /// What is printed on standard error.
    pub(super) fn message(&self) -> String {
        let message = match self {
            Self::Refused(message) | Self::Interrupted(message) => message.to_string(),
            Self::File(path, error) => text::at(&quoted(path), &problem(error)).to_string(),
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
                Self::Interrupted(interrupted.message())
            }
        }
    }
}

/// A file that cannot be written, and why.
pub(super) fn cannot_be_written(path: &Path, why: &Message) -> Failure {
    let file = quoted(&path.to_string_lossy());
    Failure::Refused(message!("shell-cannot-be-written", "{file} cannot be written: {why}", file, why))
}

/// A folder that is missing.
pub(super) fn no_folder(folder: &Path) -> Message {
    message!("shell-no-folder", "there is no folder {folder}", folder = quoted(&folder.to_string_lossy()))
}

/// That a file is a folder.
pub(super) fn is_folder() -> Message {
    message!("shell-is-folder", "it is a folder")
}

/// What the system says about a file, without its number.
fn problem(error: &io::Error) -> Message {
    match (error.kind(), error.raw_os_error()) {
        (io::ErrorKind::NotFound, _) => message!("shell-no-such-file-or-folder", "no such file or folder"),
        (io::ErrorKind::PermissionDenied, _) => message!("shell-permission-denied", "permission denied"),
        (io::ErrorKind::IsADirectory, _) => is_folder(),
        (kind, Some(_)) if forage_languages::speaker().is_some() => of_system(kind).unwrap_or_else(|| said(error)),
        _ => said(error),
    }
}

fn said(error: &io::Error) -> Message {
    Message::verbatim(error.to_string().split(" (os error").next().unwrap_or_default())
}

/// What a system says in English of the commoner problems.
fn of_system(kind: io::ErrorKind) -> Option<Message> {
    Some(match kind {
        io::ErrorKind::StorageFull => message!("shell-storage-full", "No space left on device"),
        io::ErrorKind::QuotaExceeded => message!("shell-quota-exceeded", "Disk quota exceeded"),
        io::ErrorKind::ReadOnlyFilesystem => message!("shell-read-only", "Read-only file system"),
        io::ErrorKind::NotADirectory => message!("shell-not-a-folder", "Not a directory"),
        io::ErrorKind::AlreadyExists => message!("shell-exists", "File exists"),
        io::ErrorKind::InvalidFilename => message!("shell-name-too-long", "File name too long"),
        _ => return None,
    })
}

/// What is wrong with the content of a file.
pub(super) fn in_file(path: &Path, error: &Error) -> Failure {
    let problem = match error {
        Error::Malformed { field, problem } if field == "scene" => problem.clone(),
        other => message(other, Subject::Unknown),
    };
    Failure::Refused(text::at(&quoted(&path.to_string_lossy()), &Message::verbatim(shorten(&problem.text(), 210))))
}

/// An error of the library as a sentence.
fn message(error: &Error, subject: Subject<'_>) -> Message {
    match error {
        Error::Unknown { field, value, known } => {
            let known: Vec<&str> = known.split(", ").collect();
            names::unknown(field, value, &known, subject)
        }
        Error::Refused { field, value, allowed } => refused(field, value, allowed),
        Error::Unsupported { planner, kind, kinds } => {
            let kinds = text::listed(&kinds.split(", ").map(kinds::name).collect::<Vec<_>>());
            let kind = kinds::name(kind);
            message!(
                "shell-unsupported",
                "`{planner}` does not run on scenes of kind {kind}; it runs on scenes of kind {kinds}",
                planner,
                kind,
                kinds
            )
        }
        Error::Malformed { field, problem } => {
            let problem = unknown_field(&problem.text()).unwrap_or_else(|| Message::verbatim(shorten(&problem.text(), 190)));
            text::at(&shorten(field, 100), &problem)
        }
        other => other.message(),
    }
}

/// What may have been meant by a field that TOML does not have, as in ``line 1, column 1: unknown field `scene`, expected one of
/// `name`, `scenes` ``; `None` for other problems, and where nothing is near. The reader of TOML says it in English whatever the
/// language.
fn unknown_field(problem: &str) -> Option<Message> {
    let (place, rest) = problem.split_once("unknown field `")?;
    let (typed, rest) = rest.split_once("`, expected ")?;
    let known: Vec<&str> = rest.split('`').skip(1).step_by(2).collect();
    let near = names::nearest(typed, &known);
    if near.is_empty() {
        return None;
    }
    let said = message!("shell-no-known-field", "{field} is not a known field", field = quoted(typed));
    let said = names::meant(&said, &near);
    let place = shorten(place.trim_end().trim_end_matches([':', '：']), 60);
    Some(if place.is_empty() { said } else { text::at(&place, &said) })
}

/// What is wrong with a field. By the key of what is allowed it is known that there is no such field; nothing is said in the language
/// that is spoken.
fn refused(field: &str, value: &str, allowed: &Message) -> Message {
    let field = quoted(field);
    if let ("error-left-out-or-one-of", [(_, Argument::Text(known))]) = (allowed.key(), allowed.arguments()) {
        let known: Vec<&str> = known.split(", ").collect();
        let known = cut_list(&known, 110);
        return message!("shell-unknown-field", "{field} is not a known field; leave it out, or use one of {known}", field, known);
    }
    let allowed = allowed_text(&allowed.text());
    if value == message!("error-nothing", "nothing").text() {
        return message!("shell-missing-field", "{field} is missing; it must be {allowed}", field, allowed);
    }
    if value.is_empty() {
        return message!("shell-empty-field", "{field} is empty; it must be {allowed}", field, allowed);
    }
    message!("shell-refused", "{field} is {value}; it must be {allowed}", field, value = shorten(value, 60), allowed)
}

/// What is allowed, at most 150 characters of it.
fn allowed_text(allowed: &str) -> String {
    let items: Vec<&str> = allowed.split(", ").collect();
    let fits = allowed.chars().count() <= 150;
    if fits { text::escape(allowed).into_owned() } else { shorten(&cut_list(&items, 110), 130) }
}
