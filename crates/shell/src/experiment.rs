//! `forage experiment`.

use std::{
    cell::RefCell,
    path::{Path, PathBuf},
    process::ExitCode,
    sync::Arc,
};

use forage::{
    Error, Link, Scene,
    kernel::{Message, message::in_english},
    message,
};
use forage_study::{
    failure::Failure as StudyFailure,
    runner::Control,
    sweep::{self, Curves, Kept, Part, Sweep, SweepStatistics, pictures, read},
};
use serde_json::json;

use super::{
    args::ExperimentArgs,
    examples::EXPERIMENT_FILE,
    failure::{Failure, Outcome},
    files::{self, LARGEST_EXPERIMENT, Role},
    interrupt,
    language::said,
    load, names,
    output::{notes, print, print_json, print_raw},
    progress,
    registry::registry,
    text::{self, escape, quoted},
};

pub(super) fn experiment(args: &ExperimentArgs) -> Outcome {
    let Some(file) = args.file.as_deref() else {
        print_raw(EXPERIMENT_FILE.trim_end().as_bytes())?;
        return Ok(ExitCode::SUCCESS);
    };
    let (read::Experiment { sweep, out }, sources) = read_file(file)?;
    let part = args.shard.as_deref().map_or(Ok(Part::WHOLE), str::parse)?;
    let rows = args.out.clone().unwrap_or_else(|| default_out(file, out.as_deref(), part));
    check_outputs(args, part, &rows, &sources)?;
    let existing = args.merge.iter().chain([&rows].into_iter().filter(|rows| rows.exists()));
    existing.into_iter().try_for_each(|rows| files::check(rows, None))?;
    let mut curves = args.curves.as_ref().map(|path| Curves::open(path, part, args.fresh)).transpose()?;
    let mut kept = Kept::open(&sweep, part, &rows, args.fresh)?;
    let outcome = if args.merge.is_empty() {
        run_missing(&sweep, &mut kept, curves.as_mut(), args)
    } else {
        with_progress(&sweep, |control| sweep::merge(&sweep, &mut kept, curves.as_mut(), &args.merge, args.verify, control))
    };
    notes(curves.as_ref().map_or(&[], Curves::notes));
    notes(kept.notes());
    outcome?;
    print_result(args, &kept)?;
    Ok(ExitCode::SUCCESS)
}

/// Prints the statistics, or where a part's rows are.
fn print_result(args: &ExperimentArgs, kept: &Kept) -> Result<(), Failure> {
    let (sweep, part) = (kept.sweep(), kept.part());
    if part == Part::WHOLE {
        let summary = SweepStatistics::of(kept);
        if let Some(path) = &args.report {
            let shown = in_english(|| pictures::draw(kept, &summary, path))?;
            files::write(path, summary.markdown() + &shown)?;
        }
        return if args.json { print_json(&summary) } else { print(&summary.text(&said)) };
    }
    let (runs, _) = kept.counts();
    let rows = kept.path();
    if args.json {
        return print_json(&json!({ "name": sweep.name, "rows": rows.to_string_lossy(), "runs": runs, "shard": part.to_string() }));
    }
    let [name, path] = [escape(&sweep.name).into_owned(), quoted(&rows.to_string_lossy())];
    let (part, all) = (part.to_string(), sweep.len());
    print(&message!("shell-part-of-experiment", "{name}, part {part}: {runs} of {all} runs in {path}", name, part, runs, all, path).text())
}

/// Carries out the runs whose rows are missing.
fn run_missing(sweep: &Sweep, kept: &mut Kept, curves: Option<&mut Curves>, args: &ExperimentArgs) -> Result<(), Failure> {
    let threads = args.jobs.map(usize::from);
    with_progress(sweep, |control| sweep::carry_out(sweep, kept, curves, threads, args.verify, control))
}

/// Lets Ctrl-C stop something, and shows how far it is.
fn with_progress(sweep: &Sweep, work: impl FnOnce(&Control) -> Result<(), StudyFailure>) -> Result<(), Failure> {
    let stop = interrupt::flag();
    let bar = progress::bar(&sweep.name);
    let show = |done, total| progress::show(&bar, done, total);
    let outcome = work(&Control { stop: &stop, progress: &show });
    bar.finish_and_clear();
    Ok(outcome?)
}

/// Refuses, before anything is run, to write over what is read or over the rows, and a report that cannot be written. Its folder is
/// made if it is missing, as that of the rows is.
fn check_outputs(args: &ExperimentArgs, part: Part, rows: &Path, sources: &[PathBuf]) -> Result<(), Failure> {
    let field = if args.out.is_some() { "--out" } else { "out" };
    let mut others: Vec<(Role, &Path)> = sources.iter().map(|path| (Role::Read, path.as_path())).collect();
    files::check_apart(field, rows, &others)?;
    files::make_folder_of(field, rows)?;
    let damaged = forage_study::files::damaged(rows);
    others.extend([(Role::Rows, rows), (Role::Damaged, &damaged)]);
    others.extend(args.merge.iter().map(|path| (Role::Read, path.as_path())));
    let kept = args.curves.as_ref().map(|curves| sweep::curves::kept_at(curves, part));
    if let (Some(curves), Some(kept)) = (&args.curves, &kept) {
        files::check_apart("--curves", curves, &others)?;
        files::check_apart("--curves", kept, &others)?;
        files::make_folder_of("--curves", curves)?;
        files::check_target(curves)?;
        others.extend([(Role::Curves, curves.as_path()), (Role::KeptCurves, kept)]);
    }
    let Some(report) = &args.report else { return Ok(()) };
    files::check_apart("--report", report, &others)?;
    files::make_folder_of("--report", report)?;
    files::check_target(report)?;
    others.push((Role::Report, report));
    for picture in pictures::paths_of(report).into_iter().filter(|_| pictures::has_pictures(report)) {
        files::check_apart("--report", &picture, &others)?;
        files::check_target(&picture)?;
    }
    Ok(())
}

/// Reads the experiment's file; returns it with the files that were read.
fn read_file(path: &Path) -> Result<(read::Experiment, Vec<PathBuf>), Failure> {
    let name = path.to_string_lossy();
    let text = String::from_utf8(files::read(path, LARGEST_EXPERIMENT)?)
        .map_err(|problem| Failure::Refused(text::at(&quoted(&name), &Message::verbatim(problem.to_string()))))?;
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    let folder = path.parent().unwrap_or(Path::new(""));
    let sources = RefCell::new(vec![path.to_owned()]);
    let load = |text: &str| {
        let (scene, files) = scene(folder, text)?;
        sources.borrow_mut().extend(files);
        Ok(scene)
    };
    let given = read::read(registry(), &name, &stem, &text, &load)?;
    Ok((given, sources.into_inner()))
}

/// As with `forage run --scene`, but relative to the folder of the experiment's file.
fn scene(folder: &Path, text: &str) -> Result<(Arc<Scene>, Vec<PathBuf>), StudyFailure> {
    let file = folder.join(text);
    let found = if Link::is_link(text) || !file.exists() && names::scenes().contains(&text) {
        load::scene_and_files(text)
    } else if file.exists() {
        load::scene_and_files(&file.to_string_lossy())
    } else {
        Err(load::no_scene(text))
    };
    found.map_err(|failure| match failure {
        Failure::File(path, error) => StudyFailure::File(PathBuf::from(path), error),
        Failure::Refused(problem) | Failure::Interrupted(problem) => Error::malformed("scene", problem).into(),
    })
}

/// Where the rows go: next to the experiment's file, as it says or with its name. A part has its number before the ending.
fn default_out(file: &Path, out: Option<&Path>, part: Part) -> PathBuf {
    let whole = out.map_or_else(|| file.with_extension("csv"), |out| file.parent().unwrap_or(Path::new("")).join(out));
    if part == Part::WHOLE {
        return whole;
    }
    let ending = whole.extension().unwrap_or_default().to_string_lossy().into_owned();
    whole.with_extension(format!("{}-of-{}.{ending}", part.index, part.of))
}
