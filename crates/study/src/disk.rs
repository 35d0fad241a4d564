//! All that this program writes goes through here: files that grow, files that are replaced at once, folders.
//!
//! Tests inject faults: in `faults` any of these calls can fail, write only a part, or be the last one before the program or the machine
//! dies.

#[cfg(test)]
pub(crate) mod faults;

use std::{
    ffi::OsString,
    fs::{self, File, OpenOptions},
    io::{self, BufWriter, Write},
    path::{Path, PathBuf},
};

use super::files::place;

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
    fs::create_dir_all(path)?;
    sync_folder(path)
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

/// Writes a file whole: until it is, the one that was there stays. Where nothing can be written beside it, or take its place, it is
/// written as it is.
///
/// # Errors
/// A disk that is full, and the like.
pub fn write(path: &Path, bytes: impl AsRef<[u8]>) -> io::Result<()> {
    let replaced = Replacement::of(path).and_then(|mut new| {
        new.write_all(bytes.as_ref())?;
        new.commit().map(drop)
    });
    match replaced {
        Err(problem) if path.is_file() && problem.kind() != io::ErrorKind::StorageFull => {
            let mut out = Out::create(path)?;
            out.write_all(bytes.as_ref())?;
            out.sync()
        }
        other => other,
    }
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

    /// Whether it was made by this program.
    pub fn is_new(&self) -> bool {
        self.is_new
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

/// What takes the place of a file at once, when all of it is there: a file of another name beside it. Behind a link it is the file that
/// the link leads to. What is no file, such as `/dev/stdout`, is written as it is.
#[derive(Debug)]
pub struct Replacement {
    /// None once it has taken the place.
    out: Option<BufWriter<Out>>,
    path: PathBuf,
}

/// Behind the name of a file that is to take the place of another one.
const BESIDE: &str = ".forage-new";

/// What is written in place of a file until it is whole: hidden, and with the number of the program.
fn beside(path: &Path) -> PathBuf {
    let mut name = OsString::from(".");
    name.push(path.file_name().unwrap_or_default());
    name.push(format!(".{}{BESIDE}", std::process::id()));
    path.with_file_name(name)
}

/// Removes what programs that were killed have left beside a file. Nobody else may be writing it.
pub fn clear_beside(path: &Path) {
    let path = place(path).unwrap_or_else(|| path.to_owned());
    let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let is_left = |found: &Path| {
        let found = found.file_name().unwrap_or_default().to_string_lossy();
        let number = found.strip_prefix('.').and_then(|rest| rest.strip_prefix(&*name)).and_then(|rest| rest.strip_suffix(BESIDE));
        number.and_then(|rest| rest.strip_prefix('.')).is_some_and(|number| number.parse::<u32>().is_ok())
    };
    for entry in fs::read_dir(folder).into_iter().flatten().flatten().filter(|entry| is_left(&entry.path())) {
        // It does no harm if it stays.
        let _ = remove(&entry.path());
    }
}

impl Replacement {
    /// Begins with an empty file, which may be read and written by the same people as the one that is there.
    ///
    /// # Errors
    /// As the system says.
    pub fn of(path: &Path) -> io::Result<Self> {
        let is_device = ["/dev/", "/proc/"].iter().any(|folder| path.starts_with(folder));
        if is_device || fs::metadata(path).is_ok_and(|there| !there.is_file()) {
            return Ok(Self { out: Some(BufWriter::with_capacity(1 << 16, Out::create(path)?)), path: path.to_owned() });
        }
        // A link is followed, also to what does not exist yet.
        let path = place(path).unwrap_or_else(|| path.to_owned());
        let new = beside(&path);
        if fs::symlink_metadata(&new).is_ok() {
            remove(&new)?;
        }
        let out = Out::open(&new, OpenOptions::new().read(true).append(true).create_new(true))?;
        let begun = Self { out: Some(BufWriter::with_capacity(1 << 16, out)), path };
        if let Ok(there) = fs::metadata(&begun.path) {
            begun.file()?.set_permissions(there.permissions())?;
        }
        Ok(begun)
    }

    fn out(&mut self) -> io::Result<&mut BufWriter<Out>> {
        self.out.as_mut().ok_or_else(|| io::ErrorKind::NotFound.into())
    }

    /// What is written until it takes the place.
    pub fn beside(&self) -> &Path {
        self.out.as_ref().map_or(&self.path, |out| &out.get_ref().path)
    }

    /// The file that is written.
    ///
    /// # Errors
    /// None before it has taken the place.
    pub fn file(&self) -> io::Result<&File> {
        self.out.as_ref().map(|out| out.get_ref().file()).ok_or_else(|| io::ErrorKind::NotFound.into())
    }

    /// Takes the place of the file; all of it is on the disk then. The file can be written further.
    ///
    /// # Errors
    /// A disk that is full, and the like: the file that was there is whole.
    pub fn commit(mut self) -> io::Result<Out> {
        self.flush()?;
        let out = self.out.as_mut().ok_or(io::ErrorKind::NotFound)?.get_mut();
        if out.path == self.path {
            return self.out.take().ok_or(io::ErrorKind::NotFound)?.into_inner().map_err(io::IntoInnerError::into_error);
        }
        // Its folder need not know the name beside.
        out.is_new = false;
        out.sync()?;
        let new = out.path.clone();
        allow(Call::Rename(&self.path), &new)?;
        fs::rename(&new, &self.path)?;
        sync_folder(&self.path)?;
        let out = self.out.take().ok_or(io::ErrorKind::NotFound)?.into_inner().map_err(io::IntoInnerError::into_error)?;
        Ok(Out { path: self.path.clone(), ..out })
    }
}

impl Drop for Replacement {
    fn drop(&mut self) {
        // What did not take the place is of no use to anybody, and does no harm if it stays.
        if let Some(out) = self.out.take().filter(|out| out.get_ref().path != self.path) {
            let _ = remove(&out.into_parts().0.path);
        }
    }
}

impl Write for Replacement {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.out()?.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.out()?.flush()
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
