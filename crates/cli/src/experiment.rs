//! `forage experiment`.

use std::{
    cell::RefCell,
    fs,
    path::{Path, PathBuf},
    process::ExitCode,
    slice,
    sync::Arc,
};

use forage::{Link, Scene, shipped, shipped_names};
use forage_study::{
    runner::Control,
    sweep::{self, Kept, Part, Summary, Sweep, read},
};
use serde_json::json;

use super::{Failure, args::ExperimentArgs, interrupt, load, print, print_json, progress};

pub(super) fn experiment(args: &ExperimentArgs) -> super::Outcome {
    let (read::Given { sweep, out }, sources) = read_file(&args.file)?;
    let part = args.shard.as_deref().map_or(Ok(Part::WHOLE), str::parse)?;
    let rows = args.out.clone().unwrap_or_else(|| default_out(&args.file, out.as_deref(), part));
    check_apart("out", &rows, &sources)?;
    if let Some(report) = &args.report {
        check_apart("--report", report, &[&sources[..], slice::from_ref(&rows)].concat())?;
    }
    let mut kept = Kept::open(&sweep, part, &rows, args.fresh)?;
    let outcome = if args.merge.is_empty() {
        carry_out(&sweep, &mut kept, args)
    } else {
        sweep::merge(&sweep, &mut kept, &args.merge, &interrupt::flag()).map_err(Failure::from)
    };
    load::tell(kept.notes());
    outcome?;
    if part == Part::WHOLE {
        let summary = Summary::of(&kept);
        if let Some(path) = &args.report {
            fs::write(path, summary.markdown()).map_err(|error| Failure::File(path.display().to_string(), error))?;
        }
        if args.json {
            print_json(&summary);
        } else {
            print(&summary.text());
        }
    } else {
        let (runs, _) = kept.counts();
        if args.json {
            print_json(&json!({ "name": sweep.name, "rows": rows, "runs": runs, "shard": part.to_string() }));
        } else {
            print(&format!("{}, part {part}: {runs} of {} runs in {}", sweep.name, sweep.len(), rows.display()));
        }
    }
    Ok(ExitCode::SUCCESS)
}

fn carry_out(sweep: &Sweep, kept: &mut Kept, args: &ExperimentArgs) -> Result<(), Failure> {
    let stop = interrupt::flag();
    let bar = progress::bar(sweep.name.clone());
    let show = |done, total| progress::show(&bar, done, total);
    let outcome = sweep::carry_out(sweep, kept, args.jobs.map(usize::from), &Control { stop: &stop, progress: &show });
    bar.finish_and_clear();
    Ok(outcome?)
}

/// What would be written over what is read is refused.
fn check_apart(field: &str, path: &Path, sources: &[PathBuf]) -> Result<(), Failure> {
    // What is not there yet is nothing else, either; the file of rows may be that.
    let same = |source: &&PathBuf| *source == path || fs::canonicalize(source).is_ok_and(|real| fs::canonicalize(path).ok() == Some(real));
    match sources.iter().find(same) {
        Some(source) => Err(forage::Error::refused(field, path.display(), format!("another file than {}", source.display())).into()),
        None => Ok(()),
    }
}

/// What the file says, and the files that were read.
fn read_file(path: &Path) -> Result<(read::Given, Vec<PathBuf>), Failure> {
    let text = fs::read_to_string(path).map_err(|error| Failure::File(path.display().to_string(), error))?;
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    let folder = path.parent().unwrap_or(Path::new(""));
    let sources = RefCell::new(vec![path.to_owned()]);
    let load = |text: &str| {
        sources.borrow_mut().push(folder.join(text));
        scene(folder, text)
    };
    let given = read::read(&path.display().to_string(), &stem, &text, &load)?;
    Ok((given, sources.into_inner()))
}

/// As with `forage run --scene`, but files are looked for beside the sweep's.
fn scene(folder: &Path, text: &str) -> Result<Arc<Scene>, forage_study::Failure> {
    let beside = folder.join(text);
    if !Link::is_link(text) && !beside.exists() && shipped_names().any(|scene| scene.name() == text) {
        return Ok(shipped(text)?);
    }
    let name = if Link::is_link(text) { text.to_owned() } else { beside.display().to_string() };
    load::scene(&name).map_err(|failure| match failure {
        Failure::Refused(error) => forage_study::Failure::Refused(error),
        Failure::File(path, error) => forage_study::Failure::File(PathBuf::from(path), error),
        Failure::Interrupted(problem) => forage_study::Failure::Refused(forage::Error::malformed("scene", problem)),
    })
}

/// As the sweep's file says, beside it; or called as it is. A part has its number in front of the ending.
fn default_out(file: &Path, out: Option<&Path>, part: Part) -> PathBuf {
    let whole = out.map_or_else(|| file.with_extension("csv"), |out| file.parent().unwrap_or(Path::new("")).join(out));
    if part == Part::WHOLE {
        return whole;
    }
    let ending = whole.extension().unwrap_or_default().to_string_lossy().into_owned();
    whole.with_extension(format!("{}-of-{}.{ending}", part.index, part.of))
}
