//! Faults of the disk, for tests.
//!
//! A test [`begin`]s with a fault at the n-th call and, when the program has come to its end or to the fault, [`end`]s it: after a
//! loss of power what was not on the disk is gone, in part or as a whole.

use std::{
    collections::BTreeMap,
    fs::{self, File, OpenOptions},
    io::{self, Seek, SeekFrom, Write},
    path::{Path, PathBuf},
    sync::{
        Mutex, MutexGuard, PoisonError,
        atomic::{AtomicU64, Ordering},
    },
};

use forage::kernel::rng::Stream;

use super::{super::failure::Failure, Call};

/// What happens at a call.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Fault {
    /// It fails, and nothing is done.
    Fail,
    /// It is not allowed, and nothing is done.
    Denied,
    /// The disk is full: half of what is to be written is there.
    Short,
    /// The program is killed: half of what is to be written is there, and nothing is called after it.
    Kill,
    /// The power fails: what was not put on the disk is there in part, the rest of it is zeros or missing.
    PowerLoss,
    /// From this call on nothing may be written.
    ReadOnly,
}

#[derive(Default)]
struct Disk {
    armed: Option<(u64, Fault)>,
    calls: u64,
    dead: bool,
    /// How much of a file is on the disk.
    synced: BTreeMap<PathBuf, u64>,
    /// What was made or replaced, as long as the folder is not on the disk: the file, and what was in it.
    replaced: BTreeMap<PathBuf, Option<Vec<u8>>>,
}

static DISK: Mutex<Option<Disk>> = Mutex::new(None);

fn disk() -> MutexGuard<'static, Option<Disk>> {
    DISK.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Tests that interfere with the disk come one after the other: each holds this.
pub(crate) fn alone() -> MutexGuard<'static, ()> {
    static ONE: Mutex<()> = Mutex::new(());
    ONE.lock().unwrap_or_else(PoisonError::into_inner)
}

/// From now on calls are counted, from 1; `fault`: what happens at which.
pub(crate) fn begin(fault: Option<(u64, Fault)>) {
    *disk() = Some(Disk { armed: fault, ..Disk::default() });
}

/// How many calls there were. After a loss of power files are as they would be.
pub(crate) fn end() -> u64 {
    let Some(disk) = disk().take() else { return 0 };
    if let (true, Some((at, Fault::PowerLoss))) = (disk.dead, disk.armed) {
        lose(&disk, &mut Stream::new(at, 0));
    }
    disk.calls
}

/// The power fails now: as at the end of [`Fault::PowerLoss`].
fn lose_power() {
    if let Some(disk) = disk().as_mut() {
        disk.dead = true;
        disk.armed = Some((disk.calls, Fault::PowerLoss));
    }
}

/// What was not on the disk is lost.
fn lose(disk: &Disk, rng: &mut Stream) {
    for (path, &synced) in disk.synced.iter().filter(|(path, _)| path.is_file()) {
        let mut file = OpenOptions::new().write(true).open(path).unwrap();
        let length = file.metadata().unwrap().len();
        if length > synced {
            let kept = synced + rng.below((length - synced) as usize + 1) as u64;
            file.set_len(kept).unwrap();
            // Sectors come to the disk in any order.
            for start in (synced..kept).step_by(512).filter(|_| rng.below(4) == 0).collect::<Vec<_>>() {
                file.seek(SeekFrom::Start(start)).unwrap();
                file.write_all(&vec![0; 512.min(kept - start) as usize]).unwrap();
            }
        }
    }
    for (path, before) in &disk.replaced {
        // Which files are in a folder was not on the disk yet, or it was.
        if rng.below(2) == 0 {
            match before {
                Some(bytes) => fs::write(path, bytes).unwrap(),
                None => fs::remove_file(path).unwrap(),
            }
        }
    }
}

fn no_space() -> io::Error {
    io::Error::from(io::ErrorKind::StorageFull)
}

pub(super) fn allow(call: Call, path: &Path) -> io::Result<()> {
    let mut guard = disk();
    let Some(disk) = guard.as_mut() else { return Ok(()) };
    if disk.dead {
        return Err(no_space());
    }
    disk.calls += 1;
    if disk.armed.is_some_and(|(at, fault)| fault == Fault::ReadOnly && disk.calls >= at) {
        return Err(io::ErrorKind::ReadOnlyFilesystem.into());
    }
    if let Some((_, fault)) = disk.armed.filter(|(at, _)| *at == disk.calls) {
        if let (Call::Write(file, bytes), true) = (call, !matches!(fault, Fault::Fail | Fault::Denied)) {
            file.write_all(&bytes[..bytes.len() / 2])?;
        }
        disk.dead = matches!(fault, Fault::Kill | Fault::PowerLoss);
        return Err(if fault == Fault::Denied { io::ErrorKind::PermissionDenied.into() } else { no_space() });
    }
    remember(disk, &call, path);
    Ok(())
}

/// What of this is on the disk.
fn remember(disk: &mut Disk, call: &Call, path: &Path) {
    let length = |file: &File| file.metadata().map_or(0, |there| there.len());
    match call {
        Call::Open => {
            if !path.exists() {
                disk.replaced.insert(path.to_owned(), None);
            }
            disk.synced.entry(path.to_owned()).or_insert_with(|| fs::metadata(path).map_or(0, |there| there.len()));
        }
        Call::Resize(file, to) => {
            let synced = disk.synced.entry(path.to_owned()).or_insert_with(|| length(file));
            *synced = (*synced).min(*to);
        }
        Call::Sync if path.is_dir() => disk.replaced.retain(|replaced, _| replaced.parent() != Some(path)),
        Call::Sync => {
            disk.synced.insert(path.to_owned(), fs::metadata(path).map_or(0, |there| there.len()));
        }
        Call::Rename(target) => {
            let synced = disk.synced.remove(path).unwrap_or(0);
            disk.replaced.remove(path);
            disk.replaced.insert((*target).to_owned(), fs::read(target).ok());
            disk.synced.insert((*target).to_owned(), synced);
        }
        Call::Remove => {
            disk.synced.remove(path);
            disk.replaced.remove(path);
        }
        Call::Write(..) | Call::MakeFolder => {}
    }
}

const FAULTS: [Fault; 5] = [Fault::Fail, Fault::Denied, Fault::Short, Fault::Kill, Fault::PowerLoss];

/// What a program does in a folder; it reports how much of it is done.
pub(crate) type Program<'a> = &'a dyn Fn(&Path, &(dyn Fn(u64) + Sync)) -> Result<(), Failure>;

/// The files of a folder with their bytes, but for what is kept of damaged ones and beside others.
fn files(folder: &Path) -> Vec<(String, Vec<u8>)> {
    let mut found: Vec<_> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        // What is kept of each run is in the order in which they finished.
        .filter(|path| !path.to_string_lossy().ends_with(".bad") && !path.to_string_lossy().ends_with(".runs.csv"))
        .map(|path| (path.file_name().unwrap().to_string_lossy().into_owned(), fs::read(path).unwrap()))
        .collect();
    found.sort();
    found
}

fn shown(folder: &Path) -> String {
    let shown: Vec<String> = files(folder).iter().map(|(name, bytes)| format!("{name}:\n{}", String::from_utf8_lossy(bytes))).collect();
    shown.join("\n")
}

/// Lets the program meet each fault at each of its calls, and then start again. `rows`: how many rows are in a folder.
pub(crate) fn meets_every_fault(prepare: &dyn Fn(&Path), program: Program, rows: &dyn Fn(&Path) -> u64) {
    let _alone = alone();
    let fresh = || {
        let folder = tempfile::tempdir().unwrap();
        prepare(folder.path());
        folder
    };
    let whole = fresh();
    begin(None);
    program(whole.path(), &|_| {}).unwrap();
    let calls = end();
    let expected = files(whole.path());
    assert!(calls > 7, "{calls} calls");
    for fault in FAULTS {
        for at in 1..=calls {
            let folder = fresh();
            let reported = AtomicU64::new(0);
            begin(Some((at, fault)));
            let outcome = program(folder.path(), &|done| {
                reported.fetch_max(done, Ordering::Relaxed);
            });
            end();
            // What nothing can be written beside is written as it is.
            assert!(outcome.is_err() || fault == Fault::Denied, "{fault:?} at call {at} is not said");
            if fault != Fault::PowerLoss {
                assert!(rows(folder.path()) >= reported.load(Ordering::Relaxed), "{fault:?} at call {at}: what was done is gone");
            }
            program(folder.path(), &|_| {}).unwrap_or_else(|problem| panic!("{fault:?} at call {at}: {problem}"));
            assert!(files(folder.path()) == expected, "{fault:?} at call {at}: {}", shown(folder.path()));
        }
    }
    // When all is said to be done it is on the disk.
    let folder = fresh();
    begin(None);
    program(folder.path(), &|_| {}).unwrap();
    lose_power();
    end();
    assert!(files(folder.path()) == expected, "after a loss of power: {}", shown(folder.path()));
}
