//! The only place that reads files. What is too large or no regular file is refused before it is read.

use std::{
    fs::{self, File, FileType, Metadata},
    io::{self, Read},
    path::Path,
};

use forage::{
    Error,
    kernel::{Message, limits},
};
use forage_study::files::{is_same, place};

use super::{failure::Failure, text::quoted};

/// The largest scene, map, image, TSPLIB or CSV file.
pub(super) const LARGEST_SCENE: Limit = Limit { bytes: limits::FILE_BYTES as u64, what: "a scene file" };
/// The largest description of an experiment.
pub(super) const LARGEST_EXPERIMENT: Limit = Limit { bytes: 4 << 20, what: "an experiment’s file" };
/// The largest list of links: a thousand with scenes of their own.
pub(super) const LARGEST_LIST: Limit = Limit { bytes: 256 << 20, what: "a list of links" };
/// The longest code of a planner.
pub(super) const LONGEST_CODE: Limit = Limit { bytes: 1 << 20, what: "a planner’s code" };
/// The longest link.
pub(super) const LONGEST_LINK: Limit = Limit { bytes: limits::LINK_BYTES as u64, what: "a link" };

/// How large an input may be.
#[derive(Clone, Copy)]
pub(super) struct Limit {
    bytes: u64,
    what: &'static str,
}

impl Limit {
    /// Refuses what is larger; `name` is what a message calls it.
    pub(super) fn check(self, name: &str, bytes: u64) -> Result<(), Failure> {
        if bytes <= self.bytes {
            return Ok(());
        }
        let size = |bytes: u64| bytes as f64 / f64::from(1 << 20);
        let (found, most) = (size(bytes), size(self.bytes));
        Err(Failure::Refused(format!("{name} has {found:.1} MiB; {} may have at most {most} MiB", self.what)))
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
        Ok(metadata) if metadata.is_dir() => return Err(cannot_be_written(path, "it is a folder")),
        Ok(metadata) if !metadata.is_file() => return Ok(()),
        Ok(_) => return File::options().append(true).open(path).map(drop).map_err(failed),
        Err(_) => {}
    }
    let Some(place) = place(path) else { return Err(cannot_be_written(path, "its links lead in a circle")) };
    let is_folder = path.to_string_lossy().ends_with(std::path::is_separator);
    let folder = if is_folder { Some(path) } else { place.parent() };
    if let Some(folder) = folder.filter(|folder| !folder.is_dir()) {
        // Said with the folder that was given, if it is that.
        let folder = path.parent().filter(|given| !given.as_os_str().is_empty() && !given.is_dir()).unwrap_or(folder);
        let none = || format!("there is no folder {}", quoted_path(folder));
        return Err(cannot_be_written(
            path,
            &in_the_way(folder).map_or_else(none, |(file, what)| format!("{} is {what}", quoted_path(file))),
        ));
    }
    // A link is not replaced: the file that it leads to is made, and goes again.
    File::options().write(true).create_new(true).open(&place).map_err(failed)?;
    fs::remove_file(&place).map_err(failed)
}

fn cannot_be_written(path: &Path, why: &str) -> Failure {
    Failure::Refused(format!("{} cannot be written: {why}", quoted_path(path)))
}

pub(super) fn quoted_path(path: &Path) -> String {
    quoted(&path.to_string_lossy())
}

/// What is no folder and keeps one from being made, and what it is.
fn in_the_way(folder: &Path) -> Option<(&Path, &'static str)> {
    let existing = folder.ancestors().find(|path| fs::symlink_metadata(path).is_ok())?;
    match fs::metadata(existing) {
        Ok(metadata) if metadata.is_dir() => None,
        Ok(_) => Some((existing, "a file")),
        Err(_) => Some((existing, "a link to what does not exist")),
    }
}

/// Refuses a folder that cannot be made, because it is a file or in one.
pub(super) fn check_folder(field: &str, folder: &Path) -> Result<(), Failure> {
    let Some((file, what)) = in_the_way(folder) else { return Ok(()) };
    let file = if file == folder { "it".to_owned() } else { quoted_path(file) };
    Err(Error::refused(field, folder.display().to_string(), Message::verbatim(format!("a folder, but {file} is {what}"))).into())
}

/// Makes the folder of a file that an option writes, if it is missing.
pub(super) fn make_folder_of(field: &str, path: &Path) -> Result<(), Failure> {
    let Some(folder) = path.parent().filter(|folder| !folder.as_os_str().is_empty()) else { return Ok(()) };
    check_folder(field, folder)?;
    fs::create_dir_all(folder).map_err(|error| Failure::write(folder, error))
}

/// Refuses to write the file of an option over another one. Of the others it is known what they are for, such as `is read`.
pub(super) fn check_apart(field: &str, path: &Path, others: &[(&str, &Path)]) -> Result<(), Failure> {
    match others.iter().find(|(_, other)| is_same(path, other)) {
        Some((role, other)) => Err(Error::refused(
            field,
            path.display().to_string(),
            Message::verbatim(format!("another file than {}, which {role}", other.display())),
        )
        .into()),
        None => Ok(()),
    }
}

/// Writes a whole file.
pub(super) fn write(path: &Path, bytes: impl AsRef<[u8]>) -> Result<(), Failure> {
    fs::write(path, bytes).map_err(|error| Failure::write(path, error))
}

fn check_kind(name: &str, metadata: &Metadata) -> Result<(), Failure> {
    let found = metadata.file_type();
    if found.is_file() {
        return Ok(());
    }
    Err(Failure::Refused(format!("{name} is not a regular file{}", kind(found))))
}

fn kind(found: FileType) -> &'static str {
    if found.is_dir() {
        return " but a folder";
    }
    special(found)
}

#[cfg(unix)]
fn special(found: FileType) -> &'static str {
    use std::os::unix::fs::FileTypeExt;
    if found.is_fifo() {
        " but a named pipe"
    } else if found.is_socket() {
        " but a socket"
    } else if found.is_char_device() || found.is_block_device() {
        " but a device"
    } else {
        ""
    }
}

#[cfg(not(unix))]
fn special(_: FileType) -> &'static str {
    ""
}
