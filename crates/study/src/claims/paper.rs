//! Carries out what one paper claims: its runs, the answers, the report.

use std::{
    collections::{BTreeMap, BTreeSet},
    path::Path,
};

use forage::kernel::Error;

use super::{
    super::{
        failure::Failure,
        fingerprints::JobList,
        options::Options,
        report::Report,
        runner::{self, Control, Job},
        study::Study,
    },
    claim::{Claim, SEEDS},
    judge::judge,
    run::Run,
    task::Task,
};

/// A paper's claims.
pub(super) struct PaperClaims {
    /// The claims; some parts may need the runs of `first`.
    pub(super) claims: fn(&Rows) -> Vec<Claim>,
    /// Runs that tell which others there are: a tuning finds parameters, and a claim asks what they are worth.
    pub(super) first: fn() -> Vec<Task>,
    /// The files of rows.
    pub(super) files: [&'static str; 2],
}

/// Runs by their keys.
pub(super) type Rows = BTreeMap<String, Run>;

impl PaperClaims {
    /// What can be run without rows.
    pub(super) fn jobs(&self, options: &Options) -> Result<Vec<JobList>, Failure> {
        let [first_file, file] = self.files;
        let first = (self.first)();
        let tasks = tasks(&shortened(&(self.claims)(&Rows::new()), options)?);
        let list = (!first.is_empty()).then(|| JobList::new(first_file, first));
        Ok(list.into_iter().chain([JobList::new(file, tasks)]).collect())
    }

    /// Carries out the runs, and answers the claims by them.
    pub(super) fn carry_out(&self, study: &Study, options: &Options, control: &Control) -> Result<Report, Failure> {
        let [first_file, file] = self.files.map(|file| options.out.join(file));
        let run = |tasks: &[Task], file: &Path| -> Result<Rows, Failure> {
            let rows = runner::run(tasks, file, options.fresh, options.threads, control)?;
            Ok(tasks.iter().map(Job::key).zip(rows).collect())
        };
        let runs = options.runs_or(full())?;
        let mut report = study.report(runs, full());
        let first = (self.first)();
        let mut known = Rows::new();
        if !first.is_empty() {
            known = run(&first, &first_file)?;
            report.files.push(first_file);
        }
        let claims = shortened(&(self.claims)(&known), options)?;
        let rows = run(&tasks(&claims), &file)?;
        report.files.push(file);
        report.shortened = (runs < full()).then(|| format!("{runs} seeds instead of {}", full()));
        report.claims = claims.iter().map(|claim| judge(claim, &rows)).collect();
        report.write(options)?;
        Ok(report)
    }
}

/// The runs that claims need, each once.
fn tasks(claims: &[Claim]) -> Vec<Task> {
    let parts = claims.iter().flat_map(|claim| &claim.parts);
    let all = parts.flat_map(|part| (0..part.arms.len()).flat_map(|arm| part.tasks(arm)));
    let mut seen = BTreeSet::new();
    all.filter(|task| seen.insert(task.key())).collect()
}

/// Claims with fewer seeds, where options say so.
fn shortened(claims: &[Claim], options: &Options) -> Result<Vec<Claim>, Error> {
    let mut claims = claims.to_vec();
    if options.runs.is_none() {
        return Ok(claims);
    }
    let runs = options.runs_or(full())?;
    for part in claims.iter_mut().flat_map(|claim| &mut claim.parts) {
        part.seeds[1] = part.seeds[1].min(part.seeds[0] + runs - 1);
    }
    Ok(claims)
}

const fn full() -> u64 {
    SEEDS[1] - SEEDS[0] + 1
}
