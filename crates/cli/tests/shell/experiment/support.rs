//! What the tests have in common: sweeps, the program, its files.

use std::{
    fs,
    path::{Path, PathBuf},
    process::{Child, Stdio},
    sync::atomic::AtomicBool,
    time::Duration,
};

use forage::shipped;
use forage_study::{
    failure::Failure,
    runner::Control,
    sweep::{self, Kept, Part, Sweep, read},
};

use crate::support::{command, empty_folder};

pub(crate) const SMALL: &str = r#"
name = "inertia"
scenes = ["sphere", "wcpso-discs"]
seeds = { from = 1, count = 3 }
iterations = 20

[[planner]]
name = "pso"
params = { w = [0.8, 0.4], c1 = 2.0 }

[[planner]]
name = "wcpso"
params = { population = 20 }
"#;

/// About two seconds of one core.
pub(crate) const LONG: &str = r#"
scenes = ["wcpso-discs"]
seeds = { from = 10, count = 24 }
[[planner]]
name = "wcpso"
"#;

pub(crate) use crate::support::{forage, text};

pub(crate) fn begin(args: &[&str]) -> Child {
    command(args).stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap()
}

/// An empty folder of this test's own, with a sweep in it.
pub(crate) fn folder(name: &str, sweep: &str) -> PathBuf {
    let folder = empty_folder(&format!("experiment/{name}"));
    fs::write(folder.join("sweep.toml"), sweep).unwrap();
    folder
}

/// Carries out the folder's sweep, and says what it printed.
pub(crate) fn carry_out(folder: &Path, args: &[&str]) -> String {
    let file = folder.join("sweep.toml");
    let output = forage(&[&["experiment", file.to_str().unwrap()], args].concat());
    assert_eq!(output.status.code(), Some(0), "{args:?}: {}", text(&output.stderr));
    text(&output.stdout)
}

/// The message with which the folder's sweep is refused.
pub(crate) fn refused(folder: &Path, args: &[&str]) -> String {
    let file = folder.join("sweep.toml");
    let output = forage(&[&["experiment", file.to_str().unwrap()], args].concat());
    assert_eq!(output.status.code(), Some(2), "{args:?}: {}", text(&output.stdout));
    assert!(output.stdout.is_empty(), "{args:?}");
    text(&output.stderr)
}

/// The message with which the folder's sweep fails, where trying again later may help.
pub(crate) fn fails(folder: &Path, args: &[&str]) -> String {
    let file = folder.join("sweep.toml");
    let output = forage(&[&["experiment", file.to_str().unwrap()], args].concat());
    assert_eq!(output.status.code(), Some(3), "{args:?}: {}", text(&output.stdout));
    assert!(output.stdout.is_empty(), "{args:?}");
    text(&output.stderr)
}

pub(crate) fn rows(path: &Path) -> Vec<csv::StringRecord> {
    csv::Reader::from_path(path).unwrap().records().map(Result::unwrap).collect()
}

pub(crate) fn column(path: &Path, name: &str) -> usize {
    csv::Reader::from_path(path).unwrap().headers().unwrap().iter().position(|known| known == name).unwrap()
}

/// A sweep that is done in no time, without the shell.
pub(crate) fn trivial(seeds: &str, more: &str) -> Sweep {
    let text = format!(
        "scenes = ['sphere', 'matyas']\nseeds = {seeds}\niterations = 1\n{more}\n[[planner]]\nname = 'pso'\nparams = {{ population = [2, 3] }}"
    );
    let load = |name: &str| Ok(shipped(name)?);
    read::read(forage::standard(), "sweep.toml", "sweep", &text, &load).unwrap().sweep
}

pub(crate) fn in_process(sweep: &Sweep, path: &Path) -> Result<(), Failure> {
    go_on(sweep, &mut open(sweep, path)?)
}

/// Opens a file of rows. A program that another test is just starting has its lock, too, until it runs.
pub(crate) fn open<'a>(sweep: &'a Sweep, path: &Path) -> Result<Kept<'a>, Failure> {
    for _ in 0..200 {
        match Kept::open(sweep, Part::WHOLE, path, false) {
            Err(Failure::File(_, error)) if error.kind() == std::io::ErrorKind::WouldBlock => std::thread::sleep(Duration::from_millis(10)),
            opened => return opened,
        }
    }
    Kept::open(sweep, Part::WHOLE, path, false)
}

pub(crate) fn go_on(sweep: &Sweep, kept: &mut Kept) -> Result<(), Failure> {
    sweep::carry_out(sweep, kept, None, Some(1), None, &Control { stop: &AtomicBool::new(false), progress: &|_, _| {} })
}

/// Waits until so many rows are there; says how many were.
pub(crate) fn wait_for(rows: usize, path: &Path, child: &mut Child) -> usize {
    loop {
        let there = fs::read_to_string(path).unwrap_or_default().matches('\n').count();
        if there > rows {
            return there - 1;
        }
        assert!(child.try_wait().unwrap().is_none(), "it was done before {rows} rows were seen");
        std::thread::sleep(Duration::from_millis(2));
    }
}
