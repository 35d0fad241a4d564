//! The program, called from the repository's root, and files of a test's own.

use std::{
    fs,
    path::{Path, PathBuf},
    process::{Command, Output},
};

/// The repository: where `scenes/` is.
pub(crate) fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").canonicalize().unwrap()
}

/// A call of the program.
pub(crate) fn command(args: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_forage"));
    command.args(args).current_dir(root());
    command
}

/// What a call of the program did.
pub(crate) fn forage(args: &[&str]) -> Output {
    command(args).output().unwrap()
}

/// An empty folder of a test's own.
pub(crate) fn empty_folder(name: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    folder
}

/// What was printed.
pub(crate) fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}
