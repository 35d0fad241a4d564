//! The only place that reads files. What is too large or no regular file is refused before it is read.

use std::{
    fs::{self, File, FileType, Metadata},
    io::{self, Read},
    path::Path,
};

use forage::{
    Error,
    kernel::{Message, limits},
    message,
};
use forage_study::{
    disk,
    files::{is_same, place},
};

use super::{
    failure::{Failure, cannot_be_written, is_folder, no_folder},
    text::quoted,
};

/// The largest scene, map, image, TSPLIB or CSV file.
pub(super) const LARGEST_SCENE: Limit = Limit { bytes: limits::FILE_BYTES as u64, of: Input::Scene };
/// The largest description of an experiment.
pub(super) const LARGEST_EXPERIMENT: Limit = Limit { bytes: 4 << 20, of: Input::Experiment };
/// The largest list of links: a thousand with scenes of their own.
pub(super) const LARGEST_LIST: Limit = Limit { bytes: 256 << 20, of: Input::List };
/// The longest code of a planner.
pub(super) const LONGEST_CODE: Limit = Limit { bytes: 1 << 20, of: Input::Code };
/// The longest link.
pub(super) const LONGEST_LINK: Limit = Limit { bytes: limits::LINK_BYTES as u64, of: Input::Link };

/// How large an input may be.
#[derive(Clone, Copy)]
pub(super) struct Limit {
    bytes: u64,
    of: Input,
}

/// What is read.
#[derive(Clone, Copy)]
enum Input {
    Scene,
    Experiment,
    List,
    Code,
    Link,
}

impl Input {
    fn has_at_most(self, most: f64) -> Message {
        match self {
            Self::Scene => message!("shell-scene-file-bytes", "a scene file may have at most {most} MiB", most),
            Self::Experiment => message!("shell-experiment-bytes", "an experiment’s file may have at most {most} MiB", most),
            Self::List => message!("shell-list-bytes", "a list of links may have at most {most} MiB", most),
            Self::Code => message!("shell-code-bytes", "a planner’s code may have at most {most} MiB", most),
            Self::Link => message!("shell-link-bytes", "a link may have at most {most} MiB", most),
        }
    }
}

/// What another file is for.
#[derive(Clone, Copy)]
pub(super) enum Role {
    /// It is read.
    Read,
    /// It is written, too.
    Written,
    /// An option writes it.
    Option(&'static str),
    /// It has the rows of an experiment.
    Rows,
    /// It would keep damaged rows.
    Damaged,
    /// It has curves.
    Curves,
    /// It keeps what curves are made of.
    KeptCurves,
    /// It is the report.
    Report,
}

impl Role {
    /// What is allowed instead of the file with this role.
    fn another(self, file: &Path) -> Message {
        let file = file.display().to_string();
        match self {
            Self::Read => message!("shell-not-read", "another file than {file}, which is read", file),
            Self::Written => message!("shell-not-written-too", "another file than {file}, which is written, too", file),
            Self::Option(option) => message!("shell-not-of-option", "another file than {file}, which {option} writes", file, option),
            Self::Rows => message!("shell-not-the-rows", "another file than {file}, which holds the rows", file),
            Self::Damaged => message!("shell-not-damaged-rows", "another file than {file}, which would keep damaged rows", file),
            Self::Curves => message!("shell-not-the-curves", "another file than {file}, which has the curves", file),
            Self::KeptCurves => message!("shell-not-kept-curves", "another file than {file}, which keeps the curves", file),
            Self::Report => message!("shell-not-the-report", "another file than {file}, which is the report", file),
        }
    }
}

impl Limit {
    /// Refuses what is larger; `name` is what a message calls it.
    pub(super) fn check(self, name: &str, bytes: u64) -> Result<(), Failure> {
        if bytes <= self.bytes {
            return Ok(());
        }
        let size = |bytes: u64| bytes as f64 / f64::from(1 << 20);
        let (found, most) = (size(bytes), size(self.bytes));
        let at_most = self.of.has_at_most(most);
        Err(Failure::Refused(message!("shell-too-large", "{name} has {found:.1} MiB; {at_most}", name, found, at_most)))
    }
}

/// Reads a whole file.
pub(super) fn read(path: &Path, limit: Limit) -> Result<Vec<u8>, Failure> {
    let name = quoted_path(path);
    let failed = |error: io::Error| Failure::read(path, error);
    check_kind(&name, &fs::metadata(path).map_err(failed)?)?;
    let file = File::open(path).map_err(failed)?;
    // Another file may have taken its place, and some files do not know their size.
    let metadata = file.metadata().map_err(failed)?;
    check_kind(&name, &metadata)?;
    limit.check(&name, metadata.len())?;
    let mut bytes = Vec::with_capacity(usize::try_from(metadata.len()).unwrap_or(0));
    file.take(limit.bytes + 1).read_to_end(&mut bytes).map_err(failed)?;
    limit.check(&name, bytes.len() as u64)?;
    Ok(bytes)
}

/// Refuses a file that other code will read if it is missing, no regular file, or larger than `limit`.
pub(super) fn check(path: &Path, limit: Option<Limit>) -> Result<(), Failure> {
    let name = quoted_path(path);
    let metadata = fs::metadata(path).map_err(|error| Failure::read(path, error))?;
    check_kind(&name, &metadata)?;
    limit.map_or(Ok(()), |limit| limit.check(&name, metadata.len()))
}

/// Refuses a file that is to be written later and cannot be: it is a folder, its folder is missing, or the system does not let it
/// be opened for writing. What is there stays as it is.
pub(super) fn check_target(path: &Path) -> Result<(), Failure> {
    let failed = |error: io::Error| Failure::write(path, error);
    match fs::metadata(path) {
        Ok(metadata) if metadata.is_dir() => return Err(cannot_be_written(path, &is_folder())),
        Ok(metadata) if !metadata.is_file() => return Ok(()),
        Ok(_) => return File::options().append(true).open(path).map(drop).map_err(failed),
        Err(_) => {}
    }
    let Some(place) = place(path) else {
        return Err(cannot_be_written(path, &message!("shell-circle-of-links", "its links lead in a circle")));
    };
    let is_folder = path.to_string_lossy().ends_with(std::path::is_separator);
    let folder = if is_folder { Some(path) } else { place.parent() };
    if let Some(folder) = folder.filter(|folder| !folder.is_dir()) {
        // Said with the folder that was given, if it is that.
        let folder = path.parent().filter(|given| !given.as_os_str().is_empty() && !given.is_dir()).unwrap_or(folder);
        let why = in_the_way(folder).map_or_else(|| no_folder(folder), |(file, obstacle)| obstacle.is(&quoted_path(file)));
        return Err(cannot_be_written(path, &why));
    }
    // A link is not replaced: the file that it leads to is made, and goes again.
    File::options().write(true).create_new(true).open(&place).map_err(failed)?;
    disk::remove(&place).map_err(failed)
}

pub(super) fn quoted_path(path: &Path) -> String {
    quoted(&path.to_string_lossy())
}

/// What keeps a folder from being made.
#[derive(Clone, Copy)]
enum Obstacle {
    File,
    BrokenLink,
}

impl Obstacle {
    /// That a file is this.
    fn is(self, file: &str) -> Message {
        match self {
            Self::File => message!("shell-is-a-file", "{file} is a file", file),
            Self::BrokenLink => message!("shell-is-a-broken-link", "{file} is a link to what does not exist", file),
        }
    }

    /// The same of a file that is spoken of already.
    fn it_is(self) -> Message {
        match self {
            Self::File => message!("shell-it-is-a-file", "it is a file"),
            Self::BrokenLink => message!("shell-it-is-a-broken-link", "it is a link to what does not exist"),
        }
    }
}

/// What is no folder and keeps one from being made, and what it is.
fn in_the_way(folder: &Path) -> Option<(&Path, Obstacle)> {
    let existing = folder.ancestors().find(|path| fs::symlink_metadata(path).is_ok())?;
    match fs::metadata(existing) {
        Ok(metadata) if metadata.is_dir() => None,
        Ok(_) => Some((existing, Obstacle::File)),
        Err(_) => Some((existing, Obstacle::BrokenLink)),
    }
}

/// Refuses a folder that cannot be made, because it is a file or in one.
pub(super) fn check_folder(field: &str, folder: &Path) -> Result<(), Failure> {
    let Some((file, obstacle)) = in_the_way(folder) else { return Ok(()) };
    let why = if file == folder { obstacle.it_is() } else { obstacle.is(&quoted_path(file)) };
    let allowed = message!("shell-a-folder-but", "a folder, but {why}", why);
    Err(Error::refused(field, folder.display().to_string(), allowed).into())
}

/// Makes the folder of a file that an option writes, if it is missing.
pub(super) fn make_folder_of(field: &str, path: &Path) -> Result<(), Failure> {
    let Some(folder) = path.parent().filter(|folder| !folder.as_os_str().is_empty()) else { return Ok(()) };
    check_folder(field, folder)?;
    disk::make_folder(folder).map_err(|error| Failure::write(folder, error))
}

/// Refuses to write the file of an option over another one.
pub(super) fn check_apart(field: &str, path: &Path, others: &[(Role, &Path)]) -> Result<(), Failure> {
    match others.iter().find(|(_, other)| is_same(path, other)) {
        Some((role, other)) => Err(Error::refused(field, path.display().to_string(), role.another(other)).into()),
        None => Ok(()),
    }
}

/// Writes a whole file.
pub(super) fn write(path: &Path, bytes: impl AsRef<[u8]>) -> Result<(), Failure> {
    disk::write(path, bytes).map_err(|error| Failure::write(path, error))
}

fn check_kind(name: &str, metadata: &Metadata) -> Result<(), Failure> {
    let found = metadata.file_type();
    if found.is_file() {
        return Ok(());
    }
    Err(Failure::Refused(if found.is_dir() {
        message!("shell-file-is-folder", "{name} is not a regular file but a folder", name)
    } else {
        special(name, found)
    }))
}

#[cfg(unix)]
fn special(name: &str, found: FileType) -> Message {
    use std::os::unix::fs::FileTypeExt;
    if found.is_fifo() {
        message!("shell-file-is-pipe", "{name} is not a regular file but a named pipe", name)
    } else if found.is_socket() {
        message!("shell-file-is-socket", "{name} is not a regular file but a socket", name)
    } else if found.is_char_device() || found.is_block_device() {
        message!("shell-file-is-device", "{name} is not a regular file but a device", name)
    } else {
        not_regular(name)
    }
}

#[cfg(not(unix))]
fn special(name: &str, _: FileType) -> Message {
    not_regular(name)
}

fn not_regular(name: &str) -> Message {
    message!("shell-file-not-regular", "{name} is not a regular file", name)
}
