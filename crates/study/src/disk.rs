//! All that this program writes goes through here: files that grow, files that are replaced at once, folders.
//!
//! What a test wants to know is what happens when the disk does not do as it is told: `faults` makes any of these calls fail,
//! write only a part, be the last before the program or the machine dies.

#[cfg(test)]
pub(crate) mod faults;

use std::{
    fs::{self, File, OpenOptions},
    io::{self, BufWriter, Write},
    path::{Path, PathBuf},
};

use super::files::{place, with_suffix};

/// What a call does to the disk.
#[cfg_attr(not(test), expect(dead_code, reason = "only tests look at it"))]
enum Call<'a> {
    /// Makes a file, or opens one to write.
    Open,
    /// Writes behind what is there.
    Write(&'a mut File, &'a [u8]),
    /// Cuts a file off, or makes it longer.
    Resize(&'a File, u64),
    /// Puts what was written of a file on the disk.
    Sync,
    Rename(&'a Path),
    Remove,
    MakeFolder,
}

/// Lets a test interfere with a call.
#[cfg(not(test))]
#[expect(clippy::unnecessary_wraps, reason = "in tests it fails")]
fn allow(_: Call, _: &Path) -> io::Result<()> {
    Ok(())
}

#[cfg(test)]
use faults::allow;

/// Makes a folder and those it is in, as far as they are missing.
///
/// # Errors
/// A folder that cannot be made.
pub fn make_folder(path: &Path) -> io::Result<()> {
    if path.as_os_str().is_empty() || path.is_dir() {
        return Ok(());
    }
    allow(Call::MakeFolder, path)?;
    fs::create_dir_all(path)
}

/// Removes a folder with all that is in it.
///
/// # Errors
/// As the system says.
pub fn remove_folder(path: &Path) -> io::Result<()> {
    allow(Call::Remove, path)?;
    fs::remove_dir_all(path)
}

/// Removes a file.
///
/// # Errors
/// A file that is not there, and the like.
pub fn remove(path: &Path) -> io::Result<()> {
    allow(Call::Remove, path)?;
    fs::remove_file(path)
}

/// Writes a file whole: until it is, the one that was there stays.
///
/// # Errors
/// A disk that is full, and the like.
pub fn write(path: &Path, bytes: impl AsRef<[u8]>) -> io::Result<()> {
    let mut new = Replacement::of(path)?;
    new.write_all(bytes.as_ref())?;
    new.commit().map(drop)
}

/// A file that is written.
#[derive(Debug)]
pub struct Out {
    file: File,
    path: PathBuf,
    /// It was made, and its folder does not know of it on the disk yet.
    is_new: bool,
}

impl Out {
    fn open(path: &Path, options: &OpenOptions) -> io::Result<Self> {
        allow(Call::Open, path)?;
        let is_new = !path.exists();
        Ok(Self { file: options.open(path)?, path: path.to_owned(), is_new })
    }

    /// Opens a file to read it and to write behind what is there; it is made if it is missing.
    ///
    /// # Errors
    /// As the system says.
    pub fn append(path: &Path) -> io::Result<Self> {
        Self::open(path, OpenOptions::new().read(true).append(true).create(true))
    }

    /// Opens a file, empty whatever was in it.
    ///
    /// # Errors
    /// As the system says.
    pub fn create(path: &Path) -> io::Result<Self> {
        Self::open(path, OpenOptions::new().read(true).write(true).create(true).truncate(true))
    }

    /// Makes a file that must not be there.
    ///
    /// # Errors
    /// As the system says.
    pub fn create_new(path: &Path) -> io::Result<Self> {
        Self::open(path, OpenOptions::new().read(true).write(true).create_new(true))
    }

    /// The file, to read it and to lock it.
    pub fn file(&self) -> &File {
        &self.file
    }

    /// Cuts it off.
    ///
    /// # Errors
    /// As the system says.
    pub fn set_len(&mut self, length: u64) -> io::Result<()> {
        allow(Call::Resize(&self.file, length), &self.path)?;
        self.file.set_len(length)
    }

    /// Puts all that was written on the disk.
    ///
    /// # Errors
    /// As the system says.
    pub fn sync(&mut self) -> io::Result<()> {
        allow(Call::Sync, &self.path)?;
        self.file.sync_all()?;
        if std::mem::take(&mut self.is_new) { sync_folder(&self.path) } else { Ok(()) }
    }
}

impl Write for Out {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        allow(Call::Write(&mut self.file, bytes), &self.path)?;
        self.file.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}

/// What takes the place of a file at once, when all of it is there: `rows.csv.new` beside `rows.csv`. Behind a link it is the file
/// that the link leads to.
#[derive(Debug)]
pub struct Replacement {
    out: BufWriter<Out>,
    new: PathBuf,
    path: PathBuf,
}

impl Replacement {
    /// Begins with an empty file beside `path`, which may be read and written by the same people. What is no file, such as
    /// `/dev/stdout`, is written as it is, and so is a file in a folder that may not be written.
    ///
    /// # Errors
    /// As the system says.
    pub fn of(path: &Path) -> io::Result<Self> {
        // A link is followed, also to what does not exist yet.
        let path = place(path).unwrap_or_else(|| path.to_owned());
        let there = fs::metadata(&path).ok();
        let mut new = path.clone();
        if there.as_ref().is_none_or(fs::Metadata::is_file) {
            new = with_suffix(&path, ".new");
        }
        let out = match Out::create(&new) {
            Err(problem) if problem.kind() == io::ErrorKind::PermissionDenied && there.is_some() && new != path => {
                new.clone_from(&path);
                Out::create(&path)?
            }
            out => out?,
        };
        if let Some(there) = there.filter(|_| new != path) {
            out.file.set_permissions(there.permissions())?;
        }
        Ok(Self { out: BufWriter::with_capacity(1 << 16, out), new, path })
    }

    /// What is written until it takes the place.
    pub fn beside(&self) -> &Path {
        &self.new
    }

    /// The file that is written.
    pub fn file(&self) -> &File {
        self.out.get_ref().file()
    }

    /// Takes the place of the file; all of it is on the disk then. The file can be written further.
    ///
    /// # Errors
    /// A disk that is full, and the like: the file that was there is whole.
    pub fn commit(self) -> io::Result<Out> {
        let Self { out, new, path } = self;
        let mut out = out.into_inner().map_err(io::IntoInnerError::into_error)?;
        if new != path {
            // Its folder need not know of the name beside.
            out.is_new = false;
            out.sync()?;
            allow(Call::Rename(&path), &new)?;
            fs::rename(&new, &path)?;
            sync_folder(&path)?;
        }
        Ok(Out { path, ..out })
    }
}

impl Write for Replacement {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.out.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.out.flush()
    }
}

/// Puts on the disk which files are in a folder. Where folders cannot be opened there is nothing to do.
#[cfg(unix)]
fn sync_folder(path: &Path) -> io::Result<()> {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    allow(Call::Sync, folder)?;
    // Some file systems refuse this; nothing else can be done there.
    let _ = File::open(folder).and_then(|folder| folder.sync_all());
    Ok(())
}

#[cfg(not(unix))]
fn sync_folder(path: &Path) -> io::Result<()> {
    allow(Call::Sync, path)
}
