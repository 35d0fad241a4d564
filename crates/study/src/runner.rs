//! Carries out keyed jobs on all cores, keeps each row as it comes, and goes on after an interruption.

use std::{
    collections::BTreeMap,
    path::Path,
    sync::{
        Mutex, PoisonError,
        atomic::{AtomicBool, Ordering},
    },
};

use rayon::iter::{ParallelBridge, ParallelIterator};

use forage::{
    kernel::{Error, Message},
    message,
};

use super::{
    failure::Failure,
    rows::{KeyedRow, Rows},
};

/// One row's worth of work. The row depends on nothing but the job.
pub trait Job: Sync {
    /// What it finds out.
    type Row: KeyedRow;
    /// What tells it from all other jobs of the experiment.
    fn key(&self) -> String;
    /// About how much work it is, beside the others: heavy ones begin first, and the progress counts in it.
    fn weight(&self) -> u64 {
        1
    }
    /// Does it; `None` if `stop` said to give up.
    ///
    /// # Errors
    /// What the planner refuses.
    fn run(&self, stop: &AtomicBool) -> Result<Option<Self::Row>, Error>;
}

/// How the outside steers and watches an experiment.
pub struct Control<'a> {
    /// Set it, and the experiment stops as soon as it can.
    pub stop: &'a AtomicBool,
    /// Called with the work that is done, and all of it.
    pub progress: &'a (dyn Fn(u64, u64) + Sync),
}

/// Work that is known by numbers: what a list of jobs is, or a sweep that need not be written down job by job.
pub trait Work: Sync {
    /// What a job finds out.
    type Found: Send;
    /// See [`Job::weight`].
    fn weight(&self, job: usize) -> u64;
    /// See [`Job::run`].
    ///
    /// # Errors
    /// What the planner refuses.
    fn run(&self, job: usize, stop: &AtomicBool) -> Result<Option<Self::Found>, Error>;
}

impl<J: Job> Work for [J] {
    type Found = J::Row;

    fn weight(&self, job: usize) -> u64 {
        self[job].weight()
    }

    fn run(&self, job: usize, stop: &AtomicBool) -> Result<Option<J::Row>, Error> {
        self[job].run(stop)
    }
}

/// So many threads; all cores, if it is not said how many.
///
/// # Errors
/// The system gives none.
pub fn pool(threads: Option<usize>) -> Result<rayon::ThreadPool, Failure> {
    let built = rayon::ThreadPoolBuilder::new().num_threads(threads.unwrap_or(0)).build();
    built.map_err(|problem| Error::malformed("jobs", Message::verbatim(problem.to_string())).into())
}

/// Carries out the jobs that are `left` of `total` work, and hands each finding to `keep`, one after the other. It
/// returns early when it is asked to stop, and then not everything is kept.
///
/// # Errors
/// What a job refuses, or `keep` reports; nothing is handed over after that.
pub fn carry_out<W: Work + ?Sized>(
    work: &W,
    mut left: Vec<usize>,
    total: u64,
    pool: &rayon::ThreadPool,
    control: &Control,
    keep: impl FnMut(usize, W::Found) -> Result<(), Failure> + Send,
) -> Result<(), Failure> {
    let begun = total - left.iter().map(|&job| work.weight(job)).sum::<u64>();
    (control.progress)(begun, total);
    left.sort_by_cached_key(|&job| std::cmp::Reverse(work.weight(job)));
    let shared = Mutex::new((Some(keep), begun));
    // One after the other from the front, whoever is free: heavy jobs do not wait behind each other at the end.
    pool.install(|| {
        left.into_iter().par_bridge().try_for_each(|job| {
            if control.stop.load(Ordering::Relaxed) {
                return Ok(());
            }
            let Some(found) = work.run(job, control.stop)? else { return Ok(()) };
            let mut shared = shared.lock().unwrap_or_else(PoisonError::into_inner);
            let (keep, done) = &mut *shared;
            // Behind half a row on a full disk there is no room for another one's.
            let Some(kept) = keep.as_mut().map(|keep| keep(job, found)) else { return Ok(()) };
            if kept.is_err() {
                *keep = None;
            }
            kept?;
            *done += work.weight(job);
            (control.progress)(*done, total);
            Ok::<(), Failure>(())
        })
    })
}

/// The rows of all jobs, in their order. Those already in the file are taken from there, the others carried out and
/// appended. In the end the file holds the rows in the order of the jobs, and then those of other jobs that were there.
///
/// # Errors
/// [`Failure::Interrupted`] when it was stopped; a file that cannot be written, or whose rows come from another
/// version of this program; whatever a job refuses.
pub fn run<J: Job>(jobs: &[J], file: &Path, fresh: bool, threads: Option<usize>, control: &Control) -> Result<Vec<J::Row>, Failure> {
    let pool = pool(threads)?;
    let mut rows = Rows::<J::Row>::open(file, fresh)?;
    let places: BTreeMap<String, usize> = jobs.iter().enumerate().map(|(place, job)| (job.key(), place)).collect();
    let mut done: Vec<Option<J::Row>> = jobs.iter().map(|_| None).collect();
    let mut others = Vec::new();
    for row in rows.take() {
        match places.get(&row.key()) {
            Some(&place) => done[place] = Some(row),
            None => others.push(row),
        }
    }
    pool.install(|| check(jobs, &done, file, control.stop))?;

    let left = (0..jobs.len()).filter(|&place| done[place].is_none()).collect();
    let total = jobs.iter().map(Job::weight).sum();
    carry_out(jobs, left, total, &pool, control, |place, row| {
        rows.append(&row)?;
        done[place] = Some(row);
        Ok(())
    })?;
    let ordered: Vec<J::Row> = done.into_iter().flatten().collect();
    if ordered.len() < jobs.len() {
        return Err(Failure::Interrupted { done: ordered.len(), total: jobs.len(), rows: file.to_owned() });
    }
    rows.settle(ordered.iter().chain(&others))?;
    Ok(ordered)
}

/// A row that is kept must be what the job gives now; the lightest one is carried out again to see. Otherwise rows of
/// two versions of the program would end up in one table.
fn check<J: Job>(jobs: &[J], done: &[Option<J::Row>], file: &Path, stop: &AtomicBool) -> Result<(), Failure> {
    let kept = jobs.iter().zip(done).filter_map(|(job, row)| Some((job, row.as_ref()?)));
    let Some((job, row)) = kept.min_by_key(|(job, _)| job.weight()) else { return Ok(()) };
    match job.run(stop)? {
        Some(again) if row.computed() != again.computed() => {
            let problem = message!(
                "study-row-of-another-version",
                "the row `{row}` comes from another version of forage; --fresh starts over",
                row = job.key()
            );
            Err(Error::malformed(&file.display().to_string(), problem).into())
        }
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use std::{fs, path::PathBuf};

    use serde::{Deserialize, Serialize};
    use tempfile::TempDir;

    use super::{super::disk::faults::meets_every_fault, *};

    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    struct Square {
        name: String,
        number: u64,
        root: f64,
        odd: Option<bool>,
    }

    impl KeyedRow for Square {
        fn key(&self) -> String {
            self.name.clone()
        }
    }

    /// `version` stands for a program that has changed.
    struct Task {
        number: u64,
        version: f64,
    }

    impl Job for Task {
        type Row = Square;
        fn key(&self) -> String {
            format!("number, {}", self.number)
        }
        fn weight(&self) -> u64 {
            1 + self.number % 3
        }
        fn run(&self, _stop: &AtomicBool) -> Result<Option<Square>, Error> {
            let root = (self.number as f64).sqrt() / self.version;
            Ok(Some(Square { name: self.key(), number: self.number, root, odd: (self.number > 3).then_some(self.number % 2 == 1) }))
        }
    }

    fn tasks() -> Vec<Task> {
        (0..12).map(|number| Task { number, version: 1.0 }).collect()
    }

    /// An empty folder that is removed in the end, and a file's name in it.
    fn file() -> (TempDir, PathBuf) {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("rows.csv");
        (folder, path)
    }

    fn carry_out(jobs: &[Task], path: &Path, threads: usize) -> Result<Vec<Square>, Failure> {
        run(jobs, path, false, Some(threads), &Control { stop: &AtomicBool::new(false), progress: &|_, _| {} })
    }

    /// Carries jobs out until so many rows have come.
    fn interrupted(path: &Path, threads: usize, after: usize) {
        let stop = AtomicBool::new(after == 0);
        let come = std::sync::atomic::AtomicUsize::new(0);
        let progress = |_, _| {
            // The first call tells where it begins.
            if come.fetch_add(1, Ordering::Relaxed) >= after {
                stop.store(true, Ordering::Relaxed);
            }
        };
        let outcome = run(&tasks(), path, false, Some(threads), &Control { stop: &stop, progress: &progress });
        assert!(matches!(outcome, Err(Failure::Interrupted { done, total: 12, .. }) if done >= after && done < 12), "{outcome:?}");
    }

    #[test]
    fn an_interruption_after_any_row_loses_nothing() {
        let (_whole, whole) = file();
        let expected = carry_out(&tasks(), &whole, 1).unwrap();
        let text = fs::read_to_string(&whole).unwrap();
        assert!(text.starts_with("name,number,root,odd,digest\n\"number, 0\",0,0.0,,"), "{text}");
        for (threads, last) in [(1, 11), (2, 10)] {
            for after in 0..last {
                let (_folder, path) = file();
                interrupted(&path, threads, after);
                assert_eq!(carry_out(&tasks(), &path, threads).unwrap(), expected);
                assert_eq!(fs::read_to_string(&path).unwrap(), text, "after {after} rows");
            }
        }
    }

    #[test]
    fn rows_on_a_faulty_disk_lose_nothing() {
        let jobs: Vec<_> = (0..12).filter(|number| number % 3 == 0).map(|number| Task { number, version: 1.0 }).collect();
        meets_every_fault(
            &|_| {},
            &|folder, on_done| {
                let control = Control { stop: &AtomicBool::new(false), progress: &|done, _| on_done(done) };
                run(&jobs, &folder.join("rows.csv"), false, Some(1), &control).map(drop)
            },
            &|folder| fs::read_to_string(folder.join("rows.csv")).unwrap_or_default().lines().count().saturating_sub(1) as u64,
        );
    }

    /// Killed in the middle of a write: wherever the file is cut off, the rest is done again.
    #[test]
    fn a_torn_last_line_is_dropped() {
        let (_folder, path) = file();
        carry_out(&tasks(), &path, 1).unwrap();
        let text = fs::read_to_string(&path).unwrap();
        for end in 0..text.len() {
            fs::write(&path, &text[..end]).unwrap();
            carry_out(&tasks(), &path, 1).unwrap();
            assert_eq!(fs::read_to_string(&path).unwrap(), text, "cut off after {end} bytes");
        }
    }

    #[test]
    fn rows_are_the_same_whatever_the_number_of_threads() {
        let ((_one, one), (_four, four)) = (file(), file());
        assert_eq!(carry_out(&tasks(), &one, 1).unwrap(), carry_out(&tasks(), &four, 4).unwrap());
        assert_eq!(fs::read(one).unwrap(), fs::read(four).unwrap());
    }

    #[test]
    fn rows_of_other_jobs_are_kept_and_finished_ones_are_not_carried_out_again() {
        let (_folder, path) = file();
        let all = tasks();
        carry_out(&all[4..], &path, 2).unwrap();
        // Only the lightest is carried out again; the others would now give something else.
        let mut few: Vec<_> = (4..8).map(|number| Task { number, version: 2.0 }).collect();
        few[2].version = 1.0;
        assert_eq!(few[2].weight(), 1);
        assert_eq!(carry_out(&few, &path, 2).unwrap()[0].root, 2.0);
        assert_eq!(fs::read_to_string(&path).unwrap().lines().count(), 9);
    }

    #[test]
    fn rows_of_another_version_are_refused() {
        let (_folder, path) = file();
        carry_out(&tasks(), &path, 1).unwrap();
        let changed: Vec<_> = (0..12).map(|number| Task { number: number + 1, version: 2.0 }).collect();
        let message = carry_out(&changed, &path, 1).unwrap_err().to_string();
        assert!(message.contains("another version") && message.contains("number, 3"), "{message}");
        fs::write(&path, "a,b\n1,2\n").unwrap();
        assert!(carry_out(&changed, &path, 1).unwrap_err().to_string().contains("--fresh"));
    }

    #[test]
    fn two_at_once_are_refused() {
        let (_folder, path) = file();
        let _first = Rows::<Square>::open(&path, false).unwrap();
        let refused = carry_out(&tasks(), &path, 1).unwrap_err();
        // Not the same as a wrong input: the same call may succeed later.
        assert!(matches!(&refused, Failure::File(_, error) if error.kind() == std::io::ErrorKind::WouldBlock), "{refused}");
    }
}
