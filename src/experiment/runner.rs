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

use crate::error::Error;

use super::{
    Failure,
    rows::{Row, Rows},
};

/// One row's worth of work. The row depends on nothing but the job.
pub trait Job: Sync {
    /// What it finds out.
    type Row: Row;
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
    /// Is told the work that is done, and all of it.
    pub progress: &'a (dyn Fn(u64, u64) + Sync),
}

/// The rows of all jobs, in their order. Those already in the file are taken from there, the others carried out and
/// appended. In the end the file holds the rows in the order of the jobs, and then those of other jobs that were there.
///
/// # Errors
/// [`Failure::Interrupted`] when it was stopped; a file that cannot be written, or whose rows come from another
/// version of this program; whatever a job refuses.
pub fn run<J: Job>(jobs: &[J], file: &Path, fresh: bool, threads: Option<usize>, control: &Control) -> Result<Vec<J::Row>, Failure> {
    let pool =
        rayon::ThreadPoolBuilder::new().num_threads(threads.unwrap_or(0)).build().map_err(|problem| Error::malformed("jobs", problem))?;
    let mut rows = Rows::<J::Row>::open(file, fresh)?;
    let mut done: BTreeMap<String, J::Row> = BTreeMap::new();
    let mut others = Vec::new();
    for row in rows.take() {
        if jobs.iter().any(|job| job.key() == row.key()) {
            done.insert(row.key(), row);
        } else {
            others.push(row);
        }
    }
    pool.install(|| check(jobs, &done, file, control.stop))?;

    let mut left: Vec<&J> = jobs.iter().filter(|job| !done.contains_key(&job.key())).collect();
    left.sort_by_key(|job| std::cmp::Reverse(job.weight()));
    let total: u64 = jobs.iter().map(Job::weight).sum();
    let begun = total - left.iter().map(|job| job.weight()).sum::<u64>();
    (control.progress)(begun, total);
    let shared = Mutex::new((rows, done, begun));
    // One after the other from the front, whoever is free: heavy jobs do not wait behind each other at the end.
    let outcome = pool.install(|| {
        left.into_iter().par_bridge().try_for_each(|job| {
            if control.stop.load(Ordering::Relaxed) {
                return Ok(());
            }
            let Some(row) = job.run(control.stop)? else { return Ok(()) };
            let mut shared = shared.lock().unwrap_or_else(PoisonError::into_inner);
            let (rows, done, work) = &mut *shared;
            rows.append(&row)?;
            *work += job.weight();
            (control.progress)(*work, total);
            done.insert(job.key(), row);
            Ok::<(), Failure>(())
        })
    });
    let (rows, mut done, _) = shared.into_inner().unwrap_or_else(PoisonError::into_inner);
    outcome?;
    if done.len() < jobs.len() {
        return Err(Failure::Interrupted { done: done.len(), total: jobs.len(), rows: file.to_owned() });
    }
    let ordered: Vec<_> = jobs.iter().filter_map(|job| done.remove(&job.key())).collect();
    rows.settle(ordered.iter().chain(&others))?;
    Ok(ordered)
}

/// A row that is kept must be what the job gives now; the lightest one is carried out again to see. Otherwise rows of
/// two versions of the program would end up in one table.
fn check<J: Job>(jobs: &[J], done: &BTreeMap<String, J::Row>, file: &Path, stop: &AtomicBool) -> Result<(), Failure> {
    let kept = jobs.iter().filter_map(|job| Some((job, done.get(&job.key())?)));
    let Some((job, row)) = kept.min_by_key(|(job, _)| job.weight()) else { return Ok(()) };
    match job.run(stop)? {
        Some(again) if !row.agrees(&again) => {
            let problem = format!("the row `{}` comes from another version of forage; --fresh begins anew", job.key());
            Err(Error::malformed(&file.display().to_string(), problem).into())
        }
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use std::{fs, path::PathBuf};

    use serde::{Deserialize, Serialize};

    use super::*;

    #[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
    struct Square {
        name: String,
        number: u64,
        root: f64,
        odd: Option<bool>,
    }

    impl Row for Square {
        fn key(&self) -> String {
            self.name.clone()
        }
        fn agrees(&self, again: &Self) -> bool {
            self == again
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

    /// An empty file name of this test's own.
    fn file(name: &str) -> PathBuf {
        let path = std::env::temp_dir().join(format!("forage-{}-{name}", std::process::id())).join("rows.csv");
        let _ = fs::remove_file(&path);
        path
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
        let whole = file("whole");
        let expected = carry_out(&tasks(), &whole, 1).unwrap();
        let text = fs::read_to_string(&whole).unwrap();
        assert!(text.starts_with("name,number,root,odd\n\"number, 0\",0,0.0,\n"), "{text}");
        for (threads, last) in [(1, 11), (2, 10)] {
            for after in 0..last {
                let path = file("interrupted");
                interrupted(&path, threads, after);
                assert_eq!(carry_out(&tasks(), &path, threads).unwrap(), expected);
                assert_eq!(fs::read_to_string(&path).unwrap(), text, "after {after} rows");
            }
        }
    }

    /// Killed in the middle of a write: wherever the file is cut off, the rest is done again.
    #[test]
    fn a_torn_last_line_is_dropped() {
        let path = file("torn");
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
        let (one, four) = (file("one"), file("four"));
        assert_eq!(carry_out(&tasks(), &one, 1).unwrap(), carry_out(&tasks(), &four, 4).unwrap());
        assert_eq!(fs::read(one).unwrap(), fs::read(four).unwrap());
    }

    #[test]
    fn rows_of_other_jobs_are_kept_and_finished_ones_are_not_carried_out_again() {
        let path = file("others");
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
        let path = file("version");
        carry_out(&tasks(), &path, 1).unwrap();
        let changed: Vec<_> = (0..12).map(|number| Task { number: number + 1, version: 2.0 }).collect();
        let message = carry_out(&changed, &path, 1).unwrap_err().to_string();
        assert!(message.contains("another version") && message.contains("number, 3"), "{message}");
        fs::write(&path, "a,b\n1,2\n").unwrap();
        assert!(carry_out(&changed, &path, 1).unwrap_err().to_string().contains("--fresh"));
    }

    #[test]
    fn two_at_once_are_refused() {
        let path = file("lock");
        let _first = Rows::<Square>::open(&path, false).unwrap();
        assert!(carry_out(&tasks(), &path, 1).unwrap_err().to_string().contains("no other"));
    }
}
