//! A fingerprint of each row of the published experiments, stored in [`FILE`]: so a sample of the rows can be checked in a
//! minute or two, where running all of them takes much longer.

use std::{
    collections::BTreeMap,
    fs,
    path::Path,
    sync::{
        Mutex, PoisonError,
        atomic::{AtomicBool, AtomicUsize, Ordering},
    },
    time::Duration,
};

use forage::{
    kernel::{Digest, Error, Message},
    message,
};
use serde::{Deserialize, Serialize};

use super::{
    failure::{Failure, at},
    rows::{KeyedRow, Rows, line},
    runner::{self, Control, Job},
};

/// The name of the file.
pub const FILE: &str = "REPRODUCTION.rows.json";
/// Rows in a line of the file, so that a change shows where it is.
const IN_A_LINE: usize = 16;

/// The fingerprint of a row: of what is computed, not of what is measured.
///
/// # Errors
/// None that is known: the row is written to memory.
pub fn fingerprint<R: KeyedRow>(row: &R) -> Result<u32, Failure> {
    let mut digest = Digest::default();
    digest.bytes(&line(&row.computed()).map_err(at(Path::new(FILE)))?);
    // The first half of the hash.
    Ok(u32::from_str_radix(&digest.hex()[..8], 16).unwrap_or_default())
}

/// Jobs of any kind of row.
pub trait AnyJobs: Sync {
    /// How many jobs there are.
    fn count(&self) -> usize;
    /// See [`Job::key`].
    fn key(&self, job: usize) -> String;
    /// Runs a job; `None` if `stop` said to give up.
    ///
    /// # Errors
    /// What the planner refuses.
    fn run(&self, job: usize, stop: &AtomicBool) -> Result<Option<u32>, Failure>;
    /// The fingerprints of all jobs' rows, from a file of rows.
    ///
    /// # Errors
    /// A file that cannot be read, or lacks a row.
    fn kept(&self, file: &Path) -> Result<Vec<u32>, Failure>;
}

impl<J: Job> AnyJobs for Vec<J> {
    fn count(&self) -> usize {
        self.len()
    }

    fn key(&self, job: usize) -> String {
        self[job].key()
    }

    fn run(&self, job: usize, stop: &AtomicBool) -> Result<Option<u32>, Failure> {
        self[job].run(stop)?.as_ref().map(fingerprint).transpose()
    }

    fn kept(&self, file: &Path) -> Result<Vec<u32>, Failure> {
        let rows = Rows::<J::Row>::open(file, false)?.take();
        let rows: BTreeMap<String, J::Row> = rows.into_iter().map(|row| (row.key(), row)).collect();
        let of = |job: &J| match rows.get(&job.key()) {
            Some(row) => fingerprint(row),
            None => Err(Error::malformed(
                &file.display().to_string(),
                message!("study-row-missing", "the row `{row}` is missing", row = job.key()),
            )
            .into()),
        };
        self.iter().map(of).collect()
    }
}

/// The jobs whose rows are in one file.
pub struct JobList {
    /// The file of rows, in the folder of [`Options::out`](super::options::Options::out).
    pub file: &'static str,
    /// What fills it.
    pub jobs: Box<dyn AnyJobs>,
}

impl JobList {
    /// The jobs of a file.
    pub fn new<J: Job + 'static>(file: &'static str, jobs: Vec<J>) -> Self {
        Self { file, jobs: Box::new(jobs) }
    }
}

/// The fingerprints of the rows of each file, in the order of the jobs.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(transparent)]
pub struct Fingerprints(BTreeMap<String, Vec<String>>);

impl Fingerprints {
    /// Those of these jobs' rows, from the files of rows in a folder.
    ///
    /// # Errors
    /// A file that cannot be read, or lacks a row.
    pub fn of_kept(lists: &[JobList], folder: &Path) -> Result<Self, Failure> {
        let mut all = BTreeMap::new();
        for list in lists {
            let rows = list.jobs.kept(&folder.join(list.file))?;
            let line = |rows: &[u32]| rows.iter().map(|row| format!("{row:08x}")).collect::<Vec<_>>().concat();
            all.insert(list.file.to_owned(), rows.chunks(IN_A_LINE).map(line).collect());
        }
        Ok(Self(all))
    }

    /// Reads the file in a folder.
    ///
    /// # Errors
    /// A file that cannot be read, or holds something else.
    pub fn read(folder: &Path) -> Result<Self, Failure> {
        let path = folder.join(FILE);
        let text = fs::read_to_string(&path).map_err(at(&path))?;
        serde_json::from_str(&text)
            .map_err(|problem| Error::malformed(&path.display().to_string(), Message::verbatim(problem.to_string())).into())
    }

    /// The text of the file.
    pub fn text(&self) -> String {
        // Strings and lists only: this cannot fail.
        serde_json::to_string_pretty(&self.0).unwrap_or_default() + "\n"
    }

    fn of_file(&self, file: &str) -> Vec<u32> {
        let digits = self.0.get(file).map(|lines| lines.concat()).unwrap_or_default();
        digits.as_bytes().chunks(8).filter_map(|chunk| u32::from_str_radix(str::from_utf8(chunk).ok()?, 16).ok()).collect()
    }
}

/// A row that is another one than stored.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Difference {
    /// The file of rows.
    pub file: &'static str,
    /// The job's key.
    pub key: String,
}

/// What a sample found.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize)]
pub struct Sampled {
    /// How many rows were compared, of each file.
    pub compared: BTreeMap<&'static str, usize>,
    /// How many rows there are.
    pub total: usize,
    /// Those that differ.
    pub differences: Vec<Difference>,
}

/// Runs some of these jobs in an order that `seed` chooses, for about so much time, and compares their rows
/// with the stored fingerprints. Each file of rows gets the same share of the time, and at least one job.
///
/// # Errors
/// [`Failure::ComparisonInterrupted`]; whatever a job refuses; fingerprints for another number of jobs.
pub fn sample(
    lists: &[JobList],
    threads: Option<usize>,
    stored: &Fingerprints,
    seed: &str,
    time: Duration,
    control: &Control,
) -> Result<Sampled, Failure> {
    let pool = runner::pool(threads)?;
    let mut sampled = Sampled { total: lists.iter().map(|list| list.jobs.count()).sum(), ..Sampled::default() };
    let share = time / u32::try_from(lists.len()).unwrap_or(1).max(1);
    for (k, list) in lists.iter().enumerate() {
        let expected = stored.of_file(list.file);
        if expected.len() != list.jobs.count() {
            let problem = message!(
                "study-fingerprints",
                "{file} has {found} fingerprints for {rows} rows; `forage reproduce` writes it",
                file = list.file,
                found = expected.len(),
                rows = list.jobs.count()
            );
            return Err(Error::malformed(FILE, problem).into());
        }
        let before: usize = sampled.compared.values().sum();
        let (compared, different) = sample_list(list, &expected, seed, share, &pool, control).map_err(|failure| match failure {
            Failure::ComparisonInterrupted(compared) => Failure::ComparisonInterrupted(before + compared),
            other => other,
        })?;
        sampled.compared.insert(list.file, compared);
        sampled.differences.extend(different.into_iter().map(|job| Difference { file: list.file, key: list.jobs.key(job) }));
        (control.progress)(k as u64 + 1, lists.len() as u64);
    }
    Ok(sampled)
}

/// How many rows of a list were compared within a time, and which jobs gave another one.
#[expect(clippy::disallowed_types, reason = "the time bounds how many rows are compared, and none of their contents")]
fn sample_list(
    list: &JobList,
    expected: &[u32],
    seed: &str,
    time: Duration,
    pool: &rayon::ThreadPool,
    control: &Control,
) -> Result<(usize, Vec<usize>), Failure> {
    let mut order: Vec<usize> = (0..list.jobs.count()).collect();
    order.sort_by_cached_key(|&job| {
        let mut digest = Digest::default();
        digest.bytes(seed.as_bytes());
        digest.bytes(list.jobs.key(job).as_bytes());
        digest.hex()
    });
    let begun = std::time::Instant::now();
    let (next, compared, different) = (AtomicUsize::new(0), AtomicUsize::new(0), Mutex::new(Vec::new()));
    let failed = pool.broadcast(|_| {
        loop {
            let place = next.fetch_add(1, Ordering::Relaxed);
            let Some(&job) = order.get(place) else { return Ok(()) };
            if control.stop.load(Ordering::Relaxed) || (place > 0 && begun.elapsed() >= time) {
                return Ok(());
            }
            let Some(row) = list.jobs.run(job, control.stop)? else { return Ok(()) };
            compared.fetch_add(1, Ordering::Relaxed);
            if row != expected[job] {
                different.lock().unwrap_or_else(PoisonError::into_inner).push(job);
            }
        }
    });
    failed.into_iter().collect::<Result<(), Failure>>()?;
    let compared = compared.into_inner();
    if control.stop.load(Ordering::Relaxed) {
        return Err(Failure::ComparisonInterrupted(compared));
    }
    let mut different = different.into_inner().unwrap_or_else(PoisonError::into_inner);
    different.sort_unstable();
    Ok((compared, different))
}

#[cfg(test)]
mod tests {
    use std::path::PathBuf;

    use super::*;
    use crate::{
        options::Options,
        study::{Study, jobs},
    };

    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    struct Divided {
        number: u64,
        third: f64,
        measured_ms: f64,
    }

    impl KeyedRow for Divided {
        fn key(&self) -> String {
            self.number.to_string()
        }
        fn computed(&self) -> Self {
            Self { measured_ms: 0.0, ..self.clone() }
        }
    }

    /// A job of a version of the program, which gives another row for the number 7.
    struct Task {
        number: u64,
        version: u64,
    }

    impl Job for Task {
        type Row = Divided;
        fn key(&self) -> String {
            self.number.to_string()
        }
        fn run(&self, _stop: &AtomicBool) -> Result<Option<Divided>, Error> {
            let number = if self.number == 7 { self.number + self.version } else { self.number };
            Ok(Some(Divided { number: self.number, third: number as f64 / 3.0, measured_ms: self.version as f64 }))
        }
    }

    const FILE: &str = "roots.csv";

    fn tasks(version: u64) -> Vec<Task> {
        (0..40).map(|number| Task { number, version }).collect()
    }

    /// Options::runs stands for the version of the program.
    const ROOTS: Study = Study {
        name: "roots",
        title: "roots",
        source: "[ROOTS] 1",
        repeatable: true,
        jobs: |options| Ok(vec![JobList::new(FILE, tasks(options.runs.unwrap_or(1)))]),
        run: |_, _| unreachable!("only its jobs are run"),
    };
    /// What is measured is not compared.
    const MEASURED: Study = Study { repeatable: false, ..ROOTS };

    fn lists(version: u64) -> Vec<JobList> {
        let options = Options { out: PathBuf::new(), threads: None, runs: Some(version), fresh: false };
        jobs(&[ROOTS, MEASURED], &options).unwrap()
    }

    #[test]
    fn a_sample_finds_the_row_that_changed_and_ignores_what_is_measured() {
        let folder = tempfile::tempdir().unwrap();
        let out = folder.path();
        let control = Control { stop: &AtomicBool::new(false), progress: &|_, _| {} };
        runner::run(&tasks(1), &out.join(FILE), true, Some(2), &control).unwrap();
        let kept = Fingerprints::of_kept(&lists(1), out).unwrap();
        fs::write(out.join(super::FILE), kept.text()).unwrap();
        let stored = Fingerprints::read(out).unwrap();
        assert_eq!(stored, kept);

        let sample = |version, seconds| sample(&lists(version), Some(2), &stored, "seed", Duration::from_secs(seconds), &control).unwrap();
        let same = sample(1, 60);
        assert_eq!((same.compared[FILE], same.total, same.differences.len()), (40, 40, 0));
        let changed = sample(2, 60);
        assert_eq!(changed.differences, [Difference { file: FILE, key: "7".to_owned() }]);
        assert_eq!(sample(1, 0).compared[FILE], 1, "at least one row, whatever the time");

        let stopped = Control { stop: &AtomicBool::new(true), progress: &|_, _| {} };
        let failure = super::sample(&lists(1), Some(2), &stored, "seed", Duration::ZERO, &stopped).unwrap_err();
        assert_eq!(failure.to_string(), "interrupted after 0 rows were compared; nothing is kept");

        let none = super::sample(&lists(1), Some(2), &Fingerprints::default(), "seed", Duration::ZERO, &control);
        assert!(none.unwrap_err().to_string().contains("roots.csv has 0 fingerprints for 40 rows"));
    }
}
