//! The only place that reads files. What is too large or no regular file is refused before it is read.

use std::{
    fs::{self, File, FileType, Metadata},
    io::{self, Read},
    path::{Path, PathBuf},
};

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

/// Refuses a file that is to be written later, if its folder is missing.
pub(super) fn check_folder(path: &Path) -> Result<(), Failure> {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty());
    match folder.map(fs::metadata) {
        Some(Err(error)) => Err(Failure::write(path, error)),
        _ => Ok(()),
    }
}

/// The file that is read along with a scene's.
fn partner(scene: &Path) -> Option<PathBuf> {
    let ending = match scene.extension()?.to_str()? {
        "scen" => "map",
        "yaml" | "yml" => "pgm",
        "tour" => "tsp",
        _ => return None,
    };
    Some(scene.with_extension(ending))
}

/// Refuses files that are to be written later, if one of them is a folder, has none, is another one of them, or is a file that
/// the scene is read from.
pub(super) fn check_outputs(paths: &[&Path], scene: Option<&str>) -> Result<(), Failure> {
    // A file that is not there yet is known by its folder's real path.
    let real = |path: &Path| {
        let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
        fs::canonicalize(path).ok().or_else(|| Some(fs::canonicalize(folder).ok()?.join(path.file_name()?)))
    };
    let sources = scene.map(PathBuf::from).into_iter().flat_map(|scene| [partner(&scene), Some(scene)]);
    let sources: Vec<_> = sources.flatten().filter_map(|source| fs::canonicalize(source).ok()).collect();
    for (k, path) in paths.iter().enumerate() {
        check_folder(path)?;
        let name = quoted(&path.to_string_lossy());
        if path.is_dir() {
            return Err(Failure::Refused(format!("{name} cannot be written: it is a folder")));
        }
        // Devices may be written to several times.
        let Some(place) = real(path).filter(|place| place.is_file() || !place.exists()) else { continue };
        if sources.contains(&place) {
            return Err(Failure::Refused(format!("{name} is not written: the scene is read from it")));
        }
        if paths[..k].iter().any(|other| real(other).as_ref() == Some(&place)) {
            return Err(Failure::Refused(format!("{name} is to be written twice; choose another name for one of the two")));
        }
    }
    Ok(())
}

/// Refuses a folder that is to be written to later, if there is something else of that name.
pub(super) fn check_is_folder(path: &Path) -> Result<(), Failure> {
    if path.is_dir() || !path.exists() {
        return Ok(());
    }
    Err(Failure::Refused(format!("{} is no folder", quoted(&path.to_string_lossy()))))
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
