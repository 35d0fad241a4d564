//! `forage reproduce`.

use std::{path::Path, process::ExitCode, sync::atomic::AtomicBool, time::Duration};

use forage_study::{
    Options, REPRODUCTIONS, Reproduction, document,
    fingerprints::{self, Fingerprints},
    report::Report,
    runner::Control,
};

use super::{Failure, args::ReproduceArgs, interrupt, print, print_json, progress};

pub(super) fn reproduce(args: ReproduceArgs) -> super::Outcome {
    let chosen: Vec<&Reproduction> = match &args.name {
        Some(name) => vec![forage_study::find(name)?],
        None => REPRODUCTIONS.iter().collect(),
    };
    let options = Options { out: args.out, threads: args.jobs.map(usize::from), runs: args.runs, fresh: args.fresh };
    let stop = interrupt::flag();
    if let (Some(seed), Some(folder)) = (&args.sample, &args.check) {
        return sample(seed, folder, Duration::from_secs(args.seconds), &options, &stop, args.json);
    }
    let mut reports = Vec::new();
    for reproduction in chosen {
        if args.check.is_some() && !reproduction.repeatable {
            // Nothing of it is in the documents.
            reports.push(Report::new(reproduction, 0, 0));
            continue;
        }
        let bar = progress::bar(reproduction.name);
        let show = |done, total| progress::show(&bar, done, total);
        let report = (reproduction.run)(&options, &Control { stop: &stop, progress: &show });
        bar.finish_and_clear();
        let report = report?;
        if !args.json {
            print(&format!("{}\n", report.text()));
        }
        reports.push(report);
    }
    if args.json {
        print_json(&reports);
    }
    if args.name.is_some() {
        return Ok(ExitCode::SUCCESS);
    }
    // What is there is read before anything is written: it may be the same folder.
    let rows = Fingerprints::of_kept(REPRODUCTIONS, &options)?;
    let different = args.check.map(|folder| document::differences(&reports, &rows, &folder)).transpose()?;
    document::write(&reports, &rows, &options)?;
    let Some(different) = different else { return Ok(ExitCode::SUCCESS) };
    different.iter().for_each(|problem| eprintln!("forage: {problem}"));
    if different.is_empty() {
        eprintln!("forage: {} are the same again", document::FILES.join(" and "));
    }
    Ok(if different.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// Compares the rows of some jobs with the stored fingerprints.
fn sample(seed: &str, folder: &Path, time: Duration, options: &Options, stop: &AtomicBool, json: bool) -> super::Outcome {
    let stored = Fingerprints::read(folder)?;
    let bar = progress::bar("sample");
    let show = |done, total| progress::show(&bar, done, total);
    let sampled = fingerprints::sample(REPRODUCTIONS, options, &stored, seed, time, &Control { stop, progress: &show });
    bar.finish_and_clear();
    let sampled = sampled?;
    if json {
        print_json(&sampled);
    } else {
        for (file, compared) in &sampled.compared {
            print(&format!("{compared:>6} rows of {file}"));
        }
        let compared: usize = sampled.compared.values().sum();
        print(&format!(
            "{compared:>6} rows of {} compared with {}, {} differ",
            sampled.total,
            fingerprints::FILE,
            sampled.differences.len()
        ));
    }
    for difference in &sampled.differences {
        eprintln!("forage: the row `{}` of {} is another one than stored", difference.key, difference.file);
    }
    Ok(if sampled.differences.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

/// The names and what they stand for, below the options of `forage reproduce --help`.
pub(super) fn after_help() -> String {
    let width = REPRODUCTIONS.iter().map(|reproduction| reproduction.name.len()).max().unwrap_or(0);
    let line = |r: &Reproduction| format!("  {:width$}  {}, {}", r.name, r.title, r.source);
    format!("Names:\n{}", REPRODUCTIONS.iter().map(line).collect::<Vec<_>>().join("\n"))
}

impl From<forage_study::Failure> for Failure {
    fn from(failure: forage_study::Failure) -> Self {
        match failure {
            forage_study::Failure::Refused(error) => Self::Refused(error),
            forage_study::Failure::File(path, error) => Self::File(path.display().to_string(), error),
            interrupted @ forage_study::Failure::Interrupted { .. } => Self::Interrupted(interrupted.to_string()),
        }
    }
}
