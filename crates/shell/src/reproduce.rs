//! `forage reproduce` and `forage study`.

use std::{fs, path::Path, process::ExitCode, sync::atomic::AtomicBool, time::Duration};

use forage::{kernel::message::in_english, message};
use forage_study::{
    document,
    fingerprints::{self, Fingerprints},
    options::Options,
    registry::{REPRODUCTIONS, STUDIES, all},
    report::Report,
    runner::Control,
    study::{Study, find, jobs},
};

use super::{
    args::{ReproduceArgs, StudyArgs, StudyOptions},
    failure::{Failure, Outcome},
    files::{self, LARGEST_SCENE},
    interrupt,
    language::said,
    output::{note, print, print_json},
    progress,
    text::all_of,
};

pub(super) fn reproduce(args: ReproduceArgs) -> Outcome {
    let chosen: Vec<Study> = match &args.name {
        Some(name) => vec![*find(REPRODUCTIONS, "NAME", name)?],
        None => all(),
    };
    check_files(&args)?;
    let json = args.options.json;
    let options = options(args.options);
    let stop = interrupt::flag();
    if let (Some(seed), Some(folder)) = (&args.sample, &args.check) {
        return sample(seed, folder, Duration::from_secs(args.seconds), &options, &stop, json);
    }
    let mut reports = Vec::new();
    for study in chosen {
        if args.check.is_some() && !study.repeatable {
            // The documents hold none of its figures.
            reports.push(study.report(0, 0));
            continue;
        }
        reports.push(carry_out(&study, &options, &stop, json)?);
    }
    if json {
        print_json(&reports)?;
    }
    if args.name.is_some() {
        return Ok(ExitCode::SUCCESS);
    }
    // The two folders may be the same: compare before writing.
    let rows = Fingerprints::of_kept(&jobs(&all(), &options)?, &options.out)?;
    let differences = args.check.map(|folder| document::differences(&reports, &rows, &folder)).transpose()?;
    in_english(|| document::write(&reports, &rows, &options))?;
    let Some(differences) = differences else { return Ok(ExitCode::SUCCESS) };
    differences.iter().for_each(|difference| difference.lines().for_each(note));
    if differences.is_empty() {
        note(message!("shell-unchanged", "{files} are unchanged", files = all_of(&document::FILES)));
    }
    Ok(if differences.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

pub(super) fn study(args: StudyArgs) -> Outcome {
    let study = find(STUDIES, "STUDY", &args.study)?;
    check_rows(&args.options.out)?;
    let json = args.options.json;
    let report = carry_out(study, &options(args.options), &interrupt::flag(), json)?;
    if json {
        print_json(&[report])?;
    }
    Ok(ExitCode::SUCCESS)
}

fn options(args: StudyOptions) -> Options {
    Options { out: args.out, threads: args.jobs.map(usize::from), runs: args.runs, fresh: args.fresh }
}

/// Runs a study, and prints its report unless it is to be printed as JSON.
fn carry_out(study: &Study, options: &Options, stop: &AtomicBool, json: bool) -> Result<Report, Failure> {
    let bar = progress::bar(study.name);
    let show = |done, total| progress::show(&bar, done, total);
    let report = in_english(|| (study.run)(options, &Control { stop, progress: &show }));
    bar.finish_and_clear();
    let report = report?;
    if !json {
        print(&format!("{}\n", report.text(&said)))?;
    }
    Ok(report)
}

/// Refuses, before anything is run, files that are read later and are missing, too large or no regular files.
fn check_files(args: &ReproduceArgs) -> Result<(), Failure> {
    check_rows(&args.options.out)?;
    let documents = document::FILES.into_iter().filter(|&name| args.sample.is_none() || name == fingerprints::FILE);
    let mut paths = documents.flat_map(|name| args.check.iter().map(move |folder| folder.join(name)));
    paths.try_for_each(|path| files::check(&path, Some(LARGEST_SCENE)))
}

/// The folder, and the files of rows in it.
fn check_rows(folder: &Path) -> Result<(), Failure> {
    files::check_folder("--out", folder)?;
    let files = fs::read_dir(folder).into_iter().flatten().flatten().map(|file| file.path());
    files.filter(|path| path.extension().is_some_and(|ending| ending == "csv")).try_for_each(|path| files::check(&path, None))
}

/// Compares the rows of some jobs with the stored fingerprints.
fn sample(seed: &str, folder: &Path, time: Duration, options: &Options, stop: &AtomicBool, json: bool) -> Outcome {
    let stored = Fingerprints::read(folder)?;
    let lists = jobs(&all(), options)?;
    let bar = progress::bar(&message!("shell-sample", "sample").text());
    let show = |done, total| progress::show(&bar, done, total);
    let sampled = fingerprints::sample(&lists, options.threads, &stored, seed, time, &Control { stop, progress: &show });
    bar.finish_and_clear();
    let sampled = sampled?;
    if json {
        print_json(&sampled)?;
    } else {
        let count = |compared: usize| format!("{compared:>6}");
        let of_file = |(&file, &compared): (&&str, &usize)| {
            message!("shell-rows-compared", "{count} rows of {file}", count = count(compared), file).to_string()
        };
        let mut lines: Vec<String> = sampled.compared.iter().map(of_file).collect();
        let compared: usize = sampled.compared.values().sum();
        let all = message!(
            "shell-all-rows-compared",
            "{count} rows of {total} compared with {file}, {different} differ",
            count = count(compared),
            total = sampled.total,
            file = fingerprints::FILE,
            different = sampled.differences.len()
        );
        lines.push(all.to_string());
        print(&lines.join("\n"))?;
    }
    for difference in &sampled.differences {
        let (row, file) = (&difference.key, &difference.file);
        note(message!("shell-row-differs", "the row `{row}` of {file} differs from the stored one", row, file));
    }
    Ok(if sampled.differences.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}
