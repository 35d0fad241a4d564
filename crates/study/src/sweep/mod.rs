//! Sweeps: planners × scenes × parameter values × seeds, one row a run. `forage experiment`.
//!
//! [`read`] makes a [`Sweep`] of its file and checks all of it. The runs are numbers: [`plan`] finds a run's setup, and
//! the number of a row. [`line`](mod@line) writes a row with its `digest` and reads it; [`kept`] is the file, in which it is known where each row stands and
//! little else. [`summary`] says what the rows have in common.
//!
//! Nothing takes time that grows faster than n log n with the number of runs (the heaviest begin first), and of each run
//! only where its row stands and a few numbers are in memory, not the row.

pub mod curves;
pub mod kept;
pub mod line;
pub mod pictures;
pub mod plan;
pub mod read;
pub mod summary;
mod text;
mod titles;

use std::{
    path::PathBuf,
    sync::atomic::{AtomicBool, Ordering},
};

use rayon::iter::{IntoParallelIterator, ParallelIterator};

use forage::{
    Setup,
    kernel::{
        Error, Stepped,
        rng::{Stream, fresh_seed},
    },
    message,
    run::{
        Improvement,
        trial::{Record, Trial},
    },
};

use super::{
    failure::Failure,
    runner::{self, Control, Work},
    within::{RunEnd, run_within_budget},
};

pub use curves::Curves;
pub use kept::Kept;
pub use line::Format;
pub use plan::{Budget, Part, Sweep};
pub use summary::SweepStatistics;

impl Work for Sweep {
    type Found = (Record, Vec<Improvement>);

    fn weight(&self, job: usize) -> u64 {
        self.weight_of(self.cell(job))
    }

    fn run(&self, job: usize, stop: &AtomicBool) -> Result<Option<Self::Found>, Error> {
        Ok(self.carry_out(job, stop)?.map(|mut trial| (trial.record(), trial.curve().to_vec())))
    }
}

impl Sweep {
    /// Carries out a run until its planner or the budget comes to its end; an iteration that was begun is finished. `None` if it was
    /// stopped.
    fn carry_out(&self, job: usize, stop: &AtomicBool) -> Result<Option<Trial>, Error> {
        let Some(budget) = self.allowance(job) else {
            return self.attempt(self.setup(job), u64::MAX, stop);
        };
        run_within_budget(&self.registry, self.setup(job), budget, |setup| {
            let trial = self.attempt(setup, budget, stop)?;
            Ok(trial.map(|mut trial| {
                let reached = RunEnd::of(trial.run());
                (trial, reached)
            }))
        })
    }

    fn attempt(&self, setup: Setup, budget: u64, stop: &AtomicBool) -> Result<Option<Trial>, Error> {
        let mut trial = Trial::new(&self.registry, setup, self.within)?;
        while trial.run().evaluations() < budget {
            match trial.step_until(&|| stop.load(Ordering::Relaxed))? {
                Stepped::Whole => {}
                Stepped::Partly => return Ok(None),
                Stepped::Not => break,
            }
        }
        Ok(Some(trial))
    }
}

/// Carries out the runs that are not kept yet, and puts the file in order; with `curves` also those whose curve is not there. Before
/// that the share `verify` of the runs that are kept is carried out again.
///
/// # Errors
/// [`Failure::Interrupted`] when it was stopped; a planner that refuses to start, before anything is run or written; a file that
/// cannot be written, or whose rows come from another version of this program.
pub fn carry_out(
    sweep: &Sweep,
    kept: &mut Kept,
    mut curves: Option<&mut Curves>,
    threads: Option<usize>,
    verify: Option<f64>,
    control: &Control,
) -> Result<(), Failure> {
    let mut left = kept.missing().collect::<Vec<_>>();
    if let Some(curves) = &curves {
        left.extend(curves.missing(kept)?);
        left.sort_unstable();
    }
    let pool = runner::pool(threads)?;
    pool.install(|| check_start(sweep, &left, control.stop)).inspect_err(|_| kept.leave())?;
    check_rows(sweep, kept, &pool, control.stop)?;
    verify.map_or(Ok(()), |share| verify_share(sweep, kept, share, &pool, control))?;
    kept.say_missing();
    kept.begin()?;
    if let Some(curves) = &mut curves {
        curves.begin()?;
    }
    if !left.is_empty() {
        let total = sweep.work(kept.part());
        let mut done = 0;
        let wanted = left.len();
        runner::carry_out(sweep, left, total, &pool, control, |job, (record, curve)| {
            if let Some(curves) = &mut curves {
                curves.append(sweep, job, &record.hash, &curve)?;
            }
            done += 1;
            if kept.has(job) { kept.compare(job, &record) } else { kept.append(job, &record) }
        })?;
        if done < wanted {
            return Err(kept.interrupted());
        }
    }
    kept.settle()?;
    curves.map_or(Ok(()), |curves| curves.settle(kept))
}

/// Makes one file of parts and what is there already; before that the share `verify` of the runs is carried out again.
///
/// # Errors
/// Parts that are not complete or belong to something else, before anything is written; and as [`carry_out`].
pub fn merge(
    sweep: &Sweep,
    kept: &mut Kept,
    curves: Option<&mut Curves>,
    parts: &[PathBuf],
    verify: Option<f64>,
    control: &Control,
) -> Result<(), Failure> {
    let pool = runner::pool(None)?;
    let checked = kept.gather(parts).and_then(|()| check_rows(sweep, kept, &pool, control.stop));
    let checked = checked.and_then(|()| verify.map_or(Ok(()), |share| verify_share(sweep, kept, share, &pool, control)));
    checked.and_then(|()| check_curves(kept, curves.as_deref())).inspect_err(|_| kept.leave())?;
    kept.begin()?;
    kept.settle()?;
    curves.map_or(Ok(()), |curves| curves.settle(kept))
}

/// Refuses a table of curves to which some are missing.
fn check_curves(kept: &Kept, curves: Option<&Curves>) -> Result<(), Failure> {
    let Some(curves) = curves else { return Ok(()) };
    match curves.missing(kept)?.len() {
        0 => Ok(()),
        missing => {
            let allowed = message!(
                "study-curves-missing",
                "left out: {missing} of {all} runs have no kept curve; without --merge they are run again",
                missing,
                all = kept.counts().1
            );
            Err(Error::refused("--curves", curves.path().display().to_string(), allowed).into())
        }
    }
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
        jobs.into_par_iter().map(|job| Ok(sweep.run(job, stop)?.map(|(record, _)| (job, record)))).collect::<Result<Vec<_>, Error>>()
    })?;
    for found in again {
        let Some((job, record)) = found else {
            return Err(kept.interrupted());
        };
        kept.compare(job, &record)?;
    }
    Ok(())
}

/// Repeats a random share of the kept runs, at least one: each must give the same row again.
fn verify_share(sweep: &Sweep, kept: &mut Kept, share: f64, pool: &rayon::ThreadPool, control: &Control) -> Result<(), Failure> {
    let mut jobs: Vec<usize> = kept.jobs().collect();
    let wanted = ((jobs.len() as f64 * share).ceil() as usize).max(1).min(jobs.len());
    let mut rng = Stream::new(fresh_seed()?, 0);
    // The first ones of a shuffled list.
    for k in 0..wanted {
        let other = k + rng.below(jobs.len() - k);
        jobs.swap(k, other);
    }
    jobs.truncate(wanted);
    let total = jobs.iter().map(|&job| sweep.weight(job)).sum();
    let mut same = 0;
    runner::carry_out(sweep, jobs, total, pool, control, |job, (record, _)| {
        same += 1;
        kept.compare(job, &record)
    })?;
    if same < wanted {
        return Err(kept.interrupted());
    }
    kept.note(&message!("study-verified", "{same} of {all} rows were computed again, and came out the same", same, all = kept.counts().0));
    Ok(())
}
