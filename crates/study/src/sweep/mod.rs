//! Sweeps: planners × scenes × parameter values × seeds, one row a run. `forage experiment`.
//!
//! [`read`] makes a [`Sweep`] of its file and checks all of it. The runs are numbers: [`plan`] finds a run's setup, and
//! the number of a row. [`line`](mod@line) writes a row and reads it; [`kept`] is the file, in which it is known where each row stands and
//! little else. [`summary`] says what the rows have in common.
//!
//! Nothing takes time that grows faster than n log n with the number of runs (the heaviest begin first), and of each run
//! only where its row stands and a few numbers are in memory, not the row.

pub mod kept;
pub mod line;
pub mod plan;
pub mod read;
pub mod summary;
mod text;

use std::{
    path::PathBuf,
    sync::atomic::{AtomicBool, Ordering},
};

use rayon::iter::{IntoParallelIterator, ParallelIterator};

use forage::{
    kernel::{Error, Stepped},
    run::trial::{Record, Trial},
};

use super::{
    failure::Failure,
    runner::{self, Control, Work},
};

pub use kept::{Kept, damaged};
pub use line::Format;
pub use plan::{Part, Sweep};
pub use summary::Summary;

impl Work for Sweep {
    type Found = Record;

    fn weight(&self, job: usize) -> u64 {
        self.weight_of(self.cell(job))
    }

    fn run(&self, job: usize, stop: &AtomicBool) -> Result<Option<Record>, Error> {
        let mut trial = Trial::new(&self.registry, self.setup(job), self.within)?;
        loop {
            match trial.step_until(&|| stop.load(Ordering::Relaxed))? {
                Stepped::Whole => {}
                Stepped::Partly => return Ok(None),
                Stepped::Not => return Ok(Some(trial.record())),
            }
        }
    }
}

/// Carries out the runs that are not kept yet, and puts the file in order.
///
/// # Errors
/// [`Failure::Interrupted`] when it was stopped; a planner that refuses to start, before anything is run or written; a file that
/// cannot be written, or whose rows come from another version of this program.
pub fn carry_out(sweep: &Sweep, kept: &mut Kept, threads: Option<usize>, control: &Control) -> Result<(), Failure> {
    let left = kept.missing().collect::<Vec<_>>();
    let pool = runner::pool(threads)?;
    pool.install(|| check_start(sweep, &left, control.stop)).inspect_err(|_| kept.leave())?;
    check_rows(sweep, kept, &pool, control.stop)?;
    kept.begin()?;
    if !left.is_empty() {
        let total = sweep.work(kept.part());
        runner::carry_out(sweep, left, total, &pool, control, |job, record| kept.append(job, &record))?;
        if let Some(failure) = kept.unfinished() {
            return Err(failure);
        }
    }
    kept.settle()
}

/// Makes one file of parts and what is there already.
///
/// # Errors
/// Parts that are not complete or belong to something else, before anything is written; and as [`carry_out`].
pub fn merge(sweep: &Sweep, kept: &mut Kept, parts: &[PathBuf], stop: &AtomicBool) -> Result<(), Failure> {
    let pool = runner::pool(None)?;
    let checked = kept.gather(parts).and_then(|()| check_rows(sweep, kept, &pool, stop));
    checked.inspect_err(|_| kept.leave())?;
    kept.begin()?;
    kept.settle()
}

/// Lets each planner begin once with all its parameters on every scene: what it refuses then is known before the first run.
fn check_start(sweep: &Sweep, left: &[usize], stop: &AtomicBool) -> Result<(), Failure> {
    let mut firsts = left.to_vec();
    firsts.dedup_by_key(|job| sweep.cell(*job));
    let refused = firsts.into_par_iter().find_map_first(|job| {
        if stop.load(Ordering::Relaxed) {
            return None;
        }
        forage::Run::with_keyframes(&sweep.registry, sweep.setup(job), 0).err().map(|error| (job, error))
    });
    match refused {
        Some((job, error)) => Err(sweep.placed(sweep.cell(job), error).into()),
        None => Ok(()),
    }
}

/// Of each scene the lightest run that is kept is carried out again: it must give the row that is there. Otherwise rows of two
/// versions of the program, or of a scene, would end up in one file.
fn check_rows(sweep: &Sweep, kept: &Kept, pool: &rayon::ThreadPool, stop: &AtomicBool) -> Result<(), Failure> {
    let mut lightest = vec![None; sweep.scenes.len()];
    for job in kept.jobs() {
        let best = &mut lightest[sweep.place(sweep.cell(job)).scene];
        if best.is_none_or(|known| sweep.weight(job) < sweep.weight(known)) {
            *best = Some(job);
        }
    }
    let again = pool.install(|| {
        let jobs: Vec<usize> = lightest.into_iter().flatten().collect();
        jobs.into_par_iter().map(|job| Ok(sweep.run(job, stop)?.map(|record| (job, record)))).collect::<Result<Vec<_>, Error>>()
    })?;
    for found in again {
        let Some((job, record)) = found else {
            let (done, total) = kept.counts();
            return Err(Failure::Interrupted { done, total, rows: kept.path().to_owned() });
        };
        kept.compare(job, &record)?;
    }
    Ok(())
}
