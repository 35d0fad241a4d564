//! The only place that reads files. What is too large or no regular file is refused before it is read.

use std::{
    fs::{self, File, FileType, Metadata},
    io::{self, Read},
    path::Path,
};

use forage::Error;

use super::{Failure, text::quoted};

/// The largest scene, map, image, TSPLIB or CSV file.
pub(super) const LARGEST_SCENE: Limit = Limit { bytes: 64 << 20, what: "a scene file" };
/// The largest description of an experiment.
pub(super) const LARGEST_EXPERIMENT: Limit = Limit { bytes: 4 << 20, what: "an experiment’s file" };
/// The longest link.
pub(super) const LONGEST_LINK: Limit = Limit { bytes: 4 << 20, what: "a link" };

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
    let name = quoted(&path.to_string_lossy());
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
    let name = quoted(&path.to_string_lossy());
    let metadata = fs::metadata(path).map_err(|error| Failure::read(path, error))?;
    check_kind(&name, &metadata)?;
    limit.map_or(Ok(()), |limit| limit.check(&name, metadata.len()))
}

/// Refuses a file that is to be written later, if it is a directory or its folder is missing.
pub(super) fn check_target(path: &Path) -> Result<(), Failure> {
    check_no_directory(path)?;
    let Some(folder) = path.parent().filter(|folder| !folder.as_os_str().is_empty()) else { return Ok(()) };
    match fs::metadata(folder) {
        Err(error) => Err(Failure::write(path, error)),
        Ok(metadata) if !metadata.is_dir() => {
            Err(cannot_be_written(path, &format!("{} is not a folder", quoted(&folder.to_string_lossy()))))
        }
        Ok(_) => Ok(()),
    }
}

/// Refuses a file that is to be written later, if it is a directory.
pub(super) fn check_no_directory(path: &Path) -> Result<(), Failure> {
    if path.is_dir() { Err(cannot_be_written(path, "it is a directory")) } else { Ok(()) }
}

fn cannot_be_written(path: &Path, why: &str) -> Failure {
    Failure::Refused(format!("{} cannot be written: {why}", quoted(&path.to_string_lossy())))
}

/// Refuses a folder that cannot be made, because it is a file or in one.
pub(super) fn check_folder(field: &str, folder: &Path) -> Result<(), Failure> {
    let existing = folder.ancestors().find_map(|path| fs::metadata(path).ok().map(|metadata| (path, metadata)));
    match existing {
        Some((path, metadata)) if !metadata.is_dir() => {
            Err(Error::refused(field, folder.display(), format!("a folder; {} is a file", path.display())).into())
        }
        _ => Ok(()),
    }
}

/// Refuses to write the file of an option over another one. Of the others it is known what they are for, such as `is read`.
pub(super) fn check_apart(field: &str, path: &Path, others: &[(&str, &Path)]) -> Result<(), Failure> {
    match others.iter().find(|(_, other)| is_same(path, other)) {
        Some((role, other)) => {
            Err(Error::refused(field, path.display(), format!("another file than {}, which {role}", other.display())).into())
        }
        None => Ok(()),
    }
}

/// Whether two names are those of one file, which need not exist yet. Writing to a device harms nothing.
pub(super) fn is_same(a: &Path, b: &Path) -> bool {
    if fs::metadata(a).is_ok_and(|metadata| !metadata.is_file()) {
        return false;
    }
    let place = |path: &Path| {
        let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
        fs::canonicalize(path).or_else(|_| Ok::<_, io::Error>(fs::canonicalize(folder)?.join(path.file_name().unwrap_or_default()))).ok()
    };
    a == b || place(a).is_some_and(|place_a| place(b) == Some(place_a)) || is_linked(a, b)
}

/// Whether two files that exist are one with two names.
#[cfg(unix)]
fn is_linked(a: &Path, b: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    let number = |path| fs::metadata(path).ok().map(|metadata| (metadata.dev(), metadata.ino()));
    number(a).is_some_and(|number_a| number(b) == Some(number_a))
}

#[cfg(not(unix))]
fn is_linked(_: &Path, _: &Path) -> bool {
    false
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
        return " but a directory";
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
