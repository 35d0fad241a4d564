//! The file of rows, which may be on a disk that is only read.

use std::{fs::File, io, path::Path};

use super::{Failure, Out, at};

/// The file of the rows.
#[derive(Debug)]
pub(super) enum Handle {
    Writable(Out),
    /// A file that may not be written, and what the system says of it: where nothing is missing its statistics can be told.
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
