//! What all suites have in common: planners and their parameters, rows of parts that are merged, folders for the field's tools.

use std::{
    collections::{BTreeMap, BTreeSet},
    fs,
    path::{Path, PathBuf},
    sync::{
        Arc,
        atomic::{AtomicBool, Ordering},
    },
};

use forage::{Error, Overrides, Registry, kernel::Message, message};
use forage_formats::NamedFile;

use super::super::{
    disk,
    failure::{Failure, at},
    rows::{KeyedRow, Rows},
    runner::Job,
    table::Table,
};

/// A planner with its overrides.
#[derive(Debug, Clone)]
pub struct Contender {
    /// The planner's name.
    pub planner: String,
    /// Parameters that differ from the defaults.
    pub params: Overrides,
}

impl Contender {
    /// A planner with its defaults.
    pub fn new(planner: &str) -> Self {
        Self { planner: planner.to_owned(), params: Overrides::default() }
    }

    /// The overrides as a text: `w=0.7 c1=2`.
    pub fn overrides_text(&self) -> String {
        self.params.iter().map(|(name, value)| format!("{name}={value}")).collect::<Vec<_>>().join(" ")
    }

    /// The planner with its overrides, as tables name it.
    pub fn name(&self) -> String {
        planner_label(&self.planner, &self.overrides_text())
    }
}

/// A planner with its overrides, as tables name it.
pub(super) fn planner_label(planner: &str, set: &str) -> String {
    if set.is_empty() { planner.to_owned() } else { format!("{planner} {set}") }
}

/// A job of a suite: a planner on one of its problems.
pub trait SuiteJob: Job + Clone {
    /// The planner with its overrides.
    fn contender(&self) -> &Contender;
}

/// A suite: its jobs, and what is made of their rows.
pub trait Suite {
    /// A job.
    type Task: SuiteJob;

    /// Its name in commands, and that of its folder.
    const NAME: &'static str;

    /// All planners that can take part.
    fn all_planners(registry: &Registry) -> Vec<Contender>;

    /// The planners that take part by default.
    fn default_planners(registry: &Registry) -> Vec<Contender> {
        Self::all_planners(registry)
    }

    /// The jobs, in the order of their rows; what can be refused without running it is.
    ///
    /// # Errors
    /// Too many runs; a parameter that a planner does not have, or a value that it does not allow.
    fn jobs(&self, registry: &Arc<Registry>, contenders: &[Contender]) -> Result<Vec<Self::Task>, Error>;

    /// Writes what others' tools read, and a report with pictures, into a folder; returns the files to look at.
    ///
    /// # Errors
    /// Files that cannot be written.
    fn write(&self, rows: &[<Self::Task as Job>::Row], folder: &Path) -> Result<Vec<PathBuf>, Failure>;

    /// The table that is printed in the end, and kept as CSV.
    fn table(&self, rows: &[<Self::Task as Job>::Row]) -> Table;

    /// Results that contradict a known optimum: an exact planner that misses it, a tour that is shorter.
    fn faults(&self, _rows: &[<Self::Task as Job>::Row]) -> Vec<Message> {
        Vec::new()
    }

    /// What the user should know before it begins: problems that cannot be run, …
    fn notes(&self) -> &[Message] {
        &[]
    }
}

/// So many runs at most: each is known before the first begins.
pub const MOST_RUNS: usize = 1_000_000;

/// Refuses more runs than there may be.
pub(super) fn check_count(runs: usize) -> Result<(), Error> {
    if runs > MOST_RUNS { Err(Error::refused("runs", runs, message!("study-at-most", "at most {most}", most = MOST_RUNS))) } else { Ok(()) }
}

/// Merges the rows of `parts` into `file`. For each file and planner the cheapest run is repeated; rows that it does not reproduce are
/// refused, since they come from another version of the program.
///
/// # Errors
/// As [`Rows::open`]; a row that is not what the run gives now; [`Failure::Interrupted`] when it was stopped.
pub fn merge_parts<A: SuiteJob>(file: &Path, parts: &[PathBuf], attempts: &[A], stop: &AtomicBool) -> Result<(), Failure> {
    let mut rows = Rows::<A::Row>::open(file, false)?;
    let kept = rows.take();
    check(file, &kept, attempts, stop)?;
    let mut known: BTreeSet<String> = kept.iter().map(KeyedRow::key).collect();
    for part in parts {
        let others = Rows::<A::Row>::open(part, false)?.take();
        check(part, &others, attempts, stop)?;
        for row in others {
            if known.insert(row.key()) {
                rows.append(&row)?;
            }
        }
    }
    if stop.load(Ordering::Relaxed) {
        let done = attempts.iter().filter(|attempt| known.contains(&attempt.key())).count();
        return Err(Failure::Interrupted { done, total: attempts.len(), rows: file.to_owned() });
    }
    Ok(())
}

fn check<A: SuiteJob>(file: &Path, kept: &[A::Row], attempts: &[A], stop: &AtomicBool) -> Result<(), Failure> {
    let known: BTreeMap<String, &A::Row> = kept.iter().map(|row| (row.key(), row)).collect();
    let mut lightest: BTreeMap<String, &A> = BTreeMap::new();
    for attempt in attempts.iter().filter(|attempt| known.contains_key(&attempt.key())) {
        let known = lightest.entry(attempt.contender().name()).or_insert(attempt);
        if attempt.weight() < known.weight() {
            *known = attempt;
        }
    }
    for attempt in lightest.into_values() {
        let again = attempt.run(stop)?.map(|row| row.computed());
        if again.is_some() && known.get(&attempt.key()).map(|row| row.computed()) != again {
            let problem = message!(
                "study-row-of-another-version",
                "the row `{row}` comes from another version of forage; --fresh starts over",
                row = attempt.key()
            );
            return Err(Error::malformed(&file.display().to_string(), problem).into());
        }
    }
    Ok(())
}

/// A name as part of a file's name.
pub(super) fn safe_file_name(name: &str) -> String {
    name.chars().map(|c| if c.is_alphanumeric() || ".-_=".contains(c) { c } else { '_' }).collect()
}

/// A file with its name, as the readers of formats take it.
pub(super) fn read_named(path: &Path) -> Result<NamedFile, Failure> {
    Ok(NamedFile::new(path.to_string_lossy(), fs::read(path).map_err(at(path))?))
}

/// By this file a folder is known as one that was written here.
const MARKER: &str = "written-by-forage.txt";

/// Makes a folder without what was written there before: tools would read both together.
pub(super) fn recreate_folder(folder: &Path) -> Result<(), Failure> {
    if folder.join(MARKER).exists() {
        disk::remove_folder(folder).map_err(at(folder))?;
    } else if folder.exists() {
        let problem = message!("study-not-by-bench", "it was not written by forage bench; choose another --out");
        return Err(Error::malformed(&folder.display().to_string(), problem).into());
    }
    disk::make_folder(folder).map_err(at(folder))?;
    let mark = folder.join(MARKER);
    disk::write(&mark, "forage bench writes this folder, and removes it before it writes it again.\n").map_err(at(&mark))
}

/// The files with an ending in a folder and the folders in it, by name.
pub(super) fn files_in(folder: &Path, ending: &str) -> Result<Vec<PathBuf>, Failure> {
    let mut found = Vec::new();
    let mut folders = vec![folder.to_owned()];
    while let Some(folder) = folders.pop() {
        let entries = fs::read_dir(&folder).and_then(Iterator::collect::<Result<Vec<_>, _>>).map_err(at(&folder))?;
        for path in entries.iter().map(fs::DirEntry::path) {
            // A link back up would never end.
            if path.is_dir() && !path.is_symlink() {
                folders.push(path);
            } else if path.extension().is_some_and(|found| found.eq_ignore_ascii_case(ending)) {
                found.push(path);
            }
        }
    }
    found.sort();
    Ok(found)
}

/// Each once, in the order in which they come.
pub(super) fn distinct(of: impl Iterator<Item = String>) -> Vec<String> {
    let mut all: Vec<String> = Vec::new();
    let mut known = BTreeSet::new();
    for one in of {
        if known.insert(one.clone()) {
            all.push(one);
        }
    }
    all
}
