//! Which file a name is that of, whether or not it exists yet, and whether somebody else writes it.

use std::{
    ffi::OsString,
    fs::{self, TryLockError},
    io,
    path::{Path, PathBuf},
};

use forage::{kernel::Message, message};

use super::failure::{Failure, at};

/// So many links are followed, as the system does.
const MOST_LINKS: usize = 40;

/// Whether two names are those of one file, which need not exist yet. Writing to a device harms nothing: two names of one are
/// not the same.
pub fn is_same(a: &Path, b: &Path) -> bool {
    if fs::metadata(a).is_ok_and(|metadata| !metadata.is_file()) {
        return false;
    }
    a == b || place(a).is_some_and(|place_a| place(b) == Some(place_a)) || is_linked(a, b)
}

/// Where writing to this name would make a file: links are followed, also to what does not exist yet. `None` if they lead
/// nowhere.
pub fn place(path: &Path) -> Option<PathBuf> {
    follow(path, &mut 0)
}

fn follow(path: &Path, links: &mut usize) -> Option<PathBuf> {
    if let Ok(place) = fs::canonicalize(path) {
        return Some(place);
    }
    let folder = match path.parent()? {
        folder if folder.as_os_str().is_empty() => fs::canonicalize(".").ok()?,
        folder => follow(folder, links)?,
    };
    let here = folder.join(path.file_name()?);
    let Ok(target) = fs::read_link(&here) else { return Some(here) };
    *links += 1;
    if *links > MOST_LINKS { None } else { follow(&folder.join(target), links) }
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

/// Refuses what somebody else is writing. Where files cannot be locked at all, that should be known.
pub(crate) fn locked(outcome: Result<(), TryLockError>, path: &Path) -> Result<Option<Message>, Failure> {
    match outcome {
        Ok(()) => Ok(None),
        Err(TryLockError::WouldBlock) => {
            let said = message!("study-locked", "another `forage` is writing it; nobody else can meanwhile");
            Err(at(path)(io::Error::new(io::ErrorKind::WouldBlock, said.to_string())))
        }
        Err(TryLockError::Error(problem)) => {
            let (file, problem) = (path.display().to_string(), problem.to_string());
            Ok(Some(message!(
                "study-not-lockable",
                "{file}: it cannot be locked ({problem}); let nothing else write it meanwhile",
                file,
                problem
            )))
        }
    }
}

/// The file's name with something behind it.
pub(crate) fn with_suffix(path: &Path, ending: &str) -> PathBuf {
    let mut name = OsString::from(path);
    name.push(ending);
    name.into()
}

/// The name under which a file of rows with damaged lines is kept as it was: the first free one of `rows.csv.bad`,
/// `rows.csv.2.bad`, …
pub fn damaged(rows: &Path) -> PathBuf {
    let first = with_suffix(rows, ".bad");
    let more = (2_u64..).map(|number| with_suffix(rows, &format!(".{number}.bad")));
    // The numbers end after the names of any folder.
    std::iter::once(first.clone()).chain(more).find(|path| fs::symlink_metadata(path).is_err()).unwrap_or(first)
}

#[cfg(test)]
mod tests {
    #[cfg(unix)]
    use std::os::unix::fs::symlink;

    use super::*;

    #[test]
    fn what_cannot_be_locked_is_told_and_what_is_locked_is_refused() {
        let path = Path::new("rows.csv");
        assert!(matches!(locked(Ok(()), path), Ok(None)));
        let none = io::Error::from(io::ErrorKind::Unsupported);
        let note = locked(Err(TryLockError::Error(none)), path).unwrap().unwrap().to_string();
        assert!(note.starts_with("rows.csv: it cannot be locked") && note.contains("let nothing else write"), "{note}");
        let refused = locked(Err(TryLockError::WouldBlock), path).unwrap_err().to_string();
        assert!(refused.contains("another `forage` is writing it"), "{refused}");
    }

    #[cfg(unix)]
    #[test]
    fn links_are_followed_to_files_that_do_not_exist_yet() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        fs::create_dir(at("sub")).unwrap();
        for (target, link) in [("rows.csv", "a"), ("sub/../b", "c"), ("a", "d"), ("new", "folder"), ("x", "y"), ("y", "x")] {
            symlink(target, at(link)).unwrap();
        }
        for (one, other) in
            [("a", "rows.csv"), ("d", "rows.csv"), ("d", "sub/../a"), ("c", "b"), ("folder/f", "new/f"), ("no/./g", "no/g"), ("x", "x")]
        {
            assert!(is_same(&at(one), &at(other)) && is_same(&at(other), &at(one)), "{one} {other}");
        }
        for (one, other) in [("a", "c"), ("rows.csv", "sub/rows.csv"), ("x", "z"), ("folder/f", "new/g")] {
            assert!(!is_same(&at(one), &at(other)), "{one} {other}");
        }
        assert_eq!(place(&at("x")), None, "a circle");
    }
}
