//! What all suites have in common: who takes part, rows that are kept and put together, folders that others' tools read.

use std::{
    collections::{BTreeMap, BTreeSet},
    fs,
    path::{Path, PathBuf},
    sync::{
        Arc,
        atomic::{AtomicBool, Ordering},
    },
};

use forage::{Error, Overrides, Registry, kernel::Message};

use super::super::{
    failure::{Failure, at},
    rows::{Row, Rows},
    runner::Job,
    table::Table,
};

/// A planner that takes part, with what is set of it.
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

    /// What is set, as a text: `w=0.7 c1=2`.
    pub fn set(&self) -> String {
        self.params.iter().map(|(name, value)| format!("{name}={value}")).collect::<Vec<_>>().join(" ")
    }

    /// The planner, with what is set of it.
    pub fn name(&self) -> String {
        named(&self.planner, &self.set())
    }
}

/// A planner with what is set of it, as tables have it.
pub(super) fn named(planner: &str, set: &str) -> String {
    if set.is_empty() { planner.to_owned() } else { format!("{planner} {set}") }
}

/// A job of a suite: a planner on one of its problems.
pub trait Attempt: Job + Clone {
    /// Who tries.
    fn contender(&self) -> &Contender;
}

/// A suite: its jobs, and what is made of their rows.
pub trait Suite {
    /// A job.
    type Attempt: Attempt;

    /// Its name in commands, and that of its folder.
    const NAME: &'static str;

    /// All planners that can take part.
    fn everyone(registry: &Registry) -> Vec<Contender>;

    /// Who takes part unless it is said otherwise.
    fn usual(registry: &Registry) -> Vec<Contender> {
        Self::everyone(registry)
    }

    /// The jobs, in the order of their rows; what can be refused without running it is.
    ///
    /// # Errors
    /// Too many runs; a parameter that a planner does not have, or a value that it does not allow.
    fn attempts(&self, registry: &Arc<Registry>, contenders: &[Contender]) -> Result<Vec<Self::Attempt>, Error>;

    /// Writes what others' tools read, and a report with pictures, into a folder; returns the files to look at.
    ///
    /// # Errors
    /// Files that cannot be written.
    fn write(&self, rows: &[<Self::Attempt as Job>::Row], folder: &Path) -> Result<Vec<PathBuf>, Failure>;

    /// The table that is printed in the end, and kept as CSV.
    fn table(&self, rows: &[<Self::Attempt as Job>::Row]) -> Table;

    /// What must not be: results of exact planners that are not the optimum that the suite gives.
    fn faults(&self, _rows: &[<Self::Attempt as Job>::Row]) -> Vec<String> {
        Vec::new()
    }

    /// What the user should know before it begins: problems that cannot be run, …
    fn notes(&self) -> &[String] {
        &[]
    }
}

/// So many runs at most: each is known before the first begins.
pub const MOST: usize = 1_000_000;

/// Refuses more runs than there may be.
pub(super) fn check_count(runs: usize) -> Result<(), Error> {
    if runs > MOST { Err(Error::refused("runs", runs, Message::verbatim(format!("at most {MOST}")))) } else { Ok(()) }
}

/// Takes the rows of parts that are in the same folder into a file of rows: those that it has not. Of each file and planner the lightest
/// run is carried out again: rows of another version of the program are refused.
///
/// # Errors
/// As [`Rows::open`]; a row that is not what the run gives now; [`Failure::Interrupted`] when it was stopped.
pub fn gather<A: Attempt>(file: &Path, parts: &[PathBuf], attempts: &[A], stop: &AtomicBool) -> Result<(), Failure> {
    let mut rows = Rows::<A::Row>::open(file, false)?;
    let kept = rows.take();
    check(file, &kept, attempts, stop)?;
    let mut known: BTreeSet<String> = kept.iter().map(Row::key).collect();
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
        return Err(Failure::Interrupted { done: known.len(), total: attempts.len(), rows: file.to_owned() });
    }
    Ok(())
}

fn check<A: Attempt>(file: &Path, kept: &[A::Row], attempts: &[A], stop: &AtomicBool) -> Result<(), Failure> {
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
            let problem = format!("the row `{}` comes from another version of forage; --fresh starts over", attempt.key());
            return Err(Error::malformed(&file.display().to_string(), Message::verbatim(problem)).into());
        }
    }
    Ok(())
}

/// By this file a folder is known as one that was written here.
const MARK: &str = "written-by-forage.txt";

/// Makes a folder without what was written there before: tools would read both together.
pub(super) fn empty(folder: &Path) -> Result<(), Failure> {
    if folder.join(MARK).exists() {
        fs::remove_dir_all(folder).map_err(at(folder))?;
    } else if folder.exists() {
        let problem = "it was not written by forage bench; choose another --out".to_owned();
        return Err(Error::malformed(&folder.display().to_string(), Message::verbatim(problem)).into());
    }
    fs::create_dir_all(folder).map_err(at(folder))?;
    let mark = folder.join(MARK);
    fs::write(&mark, "forage bench writes this folder, and removes it before it writes it again.\n").map_err(at(&mark))
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
