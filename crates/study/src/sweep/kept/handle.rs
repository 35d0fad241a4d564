//! The file of rows, which may be on a disk that is only read.

use std::{fs::File, io, path::Path};

use super::{super::super::disk::clear_beside, Failure, Out, at, locked};
use forage::kernel::Message;

/// The file of the rows.
#[derive(Debug)]
pub(super) enum Handle {
    Writable(Out),
    /// A file that may not be written, and what the system says of it: where nothing is missing its statistics can be printed.
    ReadOnly(File, io::ErrorKind),
}

impl Handle {
    pub(super) fn open(path: &Path) -> Result<Self, Failure> {
        let refused = |kind| matches!(kind, io::ErrorKind::ReadOnlyFilesystem | io::ErrorKind::PermissionDenied);
        match Out::append(path) {
            Ok(out) => Ok(Self::Writable(out)),
            Err(problem) if refused(problem.kind()) && path.is_file() => {
                Ok(Self::ReadOnly(File::open(path).map_err(at(path))?, problem.kind()))
            }
            Err(problem) => Err(at(path)(problem)),
        }
    }

    /// Opens and locks a file. One that another program replaced between the two is opened again.
    pub(super) fn open_locked(path: &Path) -> Result<(Self, Option<Message>), Failure> {
        loop {
            let handle = Self::open(path)?;
            let note = locked(handle.file().try_lock(), path)?;
            if is_still(handle.file(), path) {
                if matches!(handle, Self::Writable(_)) {
                    clear_beside(path);
                }
                return Ok((handle, note));
            }
        }
    }

    pub(super) fn file(&self) -> &File {
        match self {
            Self::Writable(out) => out.file(),
            Self::ReadOnly(file, _) => file,
        }
    }

    /// The file to write it.
    pub(super) fn out(&mut self) -> io::Result<&mut Out> {
        match self {
            Self::Writable(out) => Ok(out),
            Self::ReadOnly(_, kind) => Err((*kind).into()),
        }
    }
}

/// Whether a file is what its name leads to.
#[cfg(unix)]
fn is_still(file: &File, path: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    let number = |metadata: io::Result<std::fs::Metadata>| metadata.ok().map(|there| (there.dev(), there.ino()));
    number(file.metadata()) == number(std::fs::metadata(path))
}

#[cfg(not(unix))]
fn is_still(_: &File, _: &Path) -> bool {
    true
}
