//! `forage run`.

mod summary;

use std::{
    io::{self, Write},
    path::{Path, PathBuf},
    process::ExitCode,
    sync::atomic::Ordering,
    time::Duration,
};

use crate::registry::registry;

use forage::{
    Outcome, Run, Status,
    describe::{Column, Shown, layers},
    kernel::{Message, Stepped, message::in_english},
    message, picture,
    run::{csv_heading, csv_line, csv_row},
};
use forage_study::disk::Out;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use serde::Serialize;

use forage_formats::{stem_of, tour_file};

use super::{
    args::RunArgs,
    exact,
    failure::{self, Failure},
    files::{self, Role},
    interrupt,
    language::say,
    load::{self, Following},
    output::{note, print, print_json},
    text::{escape, quoted},
};

/// The outcome, and how long the run took.
#[derive(Serialize)]
struct Report {
    #[serde(flatten)]
    outcome: Outcome,
    elapsed_ms: f64,
}

pub(super) fn run(args: &RunArgs) -> failure::Outcome {
    let task = load::task(args)?;
    check_outputs(args, &task.files)?;
    let following = load::following(args, &task.setup.scene)?;
    let mut run = Run::with_keyframes(registry(), task.setup.clone(), 0).map_err(|error| load::in_setup(&task.setup, &error))?;
    if args.tour.is_some() && !run.entry().stops {
        let name = run.entry().name;
        return Err(Failure::Refused(message!(
            "shell-needs-tours",
            "--tour needs a planner of tours; `{name}` looks for a path (`forage list` shows which do)",
            name
        )));
    }
    let elapsed_ms = run_to_end(&mut run, task.stop_at, args.trace.as_deref())?;
    let mut outcome = run.outcome();
    if run.is_partly() {
        // It would be the hash of no iteration: nobody could compare it.
        outcome.hash.clear();
    }
    for following in following.iter().filter(|following| following.is_asked()) {
        follow(following, &run, &mut outcome)?;
    }
    if let Some(path) = &args.tour {
        write_tour(path, &outcome)?;
    }
    if let Some(path) = &args.svg {
        let shown = run.entry().layers.iter().filter(|layer| layer.shown == Shown::On);
        let layers: Vec<_> = shown.map(|layer| layer.key).chain([layers::EXACT.key]).collect();
        files::write(path, in_english(|| picture::svg(&run, false, &layers)))?;
    }
    let expected = task.expected_hash.filter(|_| !args.ignore_hash);
    let difference = expected.and_then(|expected| hash_difference(&expected, task.stop_at, &outcome));
    let succeeded = outcome.feasible && outcome.status != Status::Failed && difference.is_none();
    if args.json {
        print_json(&Report { outcome, elapsed_ms })?;
    } else {
        let unit = say(exact::unit(run.scene()), &format!("scenes.{}.units", run.scene().name()));
        print(&summary::summary(&outcome, unit, elapsed_ms))?;
    }
    if let Some(difference) = difference {
        note(difference);
    }
    Ok(ExitCode::from(u8::from(!succeeded)))
}

/// What is not as the link says, if its hash does not come out again.
fn hash_difference(expected: &str, iteration: Option<u64>, outcome: &Outcome) -> Option<Message> {
    if outcome.hash == *expected {
        return None;
    }
    if outcome.hash.is_empty() {
        return Some(message!("shell-hash-of-no-iteration", "the link's hash cannot be compared: the run was interrupted within a step"));
    }
    let here = outcome.iterations;
    let (hash, expected) = (&outcome.hash, quoted(expected));
    let what = match iteration.filter(|&iteration| iteration != here) {
        Some(iteration) => message!(
            "shell-hash-of-another-iteration",
            "the link shows iteration {iteration} with the hash {expected}; this run stopped at iteration {here} with {hash}",
            iteration,
            expected,
            here,
            hash
        ),
        None => {
            message!("shell-hash-differs", "at iteration {here} the link's hash is {expected}; this run's is {hash}", here, expected, hash)
        }
    };
    Some(message!(
        "shell-hash-why",
        "{what}. The planner, one of its defaults or the scene is not what it was when the link was made; --ignore-hash accepts that",
        what
    ))
}

/// Refuses, before anything is run, to write over the scene or over another output, or where nothing can be written.
fn check_outputs(args: &RunArgs, read: &[PathBuf]) -> Result<(), Failure> {
    let mut others: Vec<(Role, &Path)> = read.iter().map(|path| (Role::Read, path.as_path())).collect();
    let written =
        [("--svg", &args.svg), ("--trace", &args.trace), ("--drive", &args.drive), ("--tour", &args.tour), ("--motion", &args.motion)];
    for (option, path) in written {
        let Some(path) = path else { continue };
        files::check_target(path)?;
        files::check_apart(option, path, &others)?;
        others.push((Role::Option(option), path));
    }
    Ok(())
}

/// Lets the robot or the arm follow the path, and writes down how.
fn follow(following: &Following<'_>, run: &Run, outcome: &mut Outcome) -> Result<(), Failure> {
    let Following { follower, overrides, out } = following;
    let followed = run.follow(follower.name, overrides)?;
    match (out, &followed) {
        (Some(path), Some(followed)) => write_rows(path, follower.columns, followed.rows())?,
        (Some(path), None) => not_written(path, &message!("shell-no-path-to-follow", "no path was found to follow")),
        (None, _) => {}
    }
    outcome.followed.set(follower.name, followed.map(|followed| followed.outcome()));
    Ok(())
}

fn not_written(path: &Path, why: &Message) {
    note(message!("shell-is-not-written", "{why}; {file} is not written", why, file = quoted(&path.to_string_lossy())));
}

/// Steps to the end, to `stop_at`, or until Ctrl-C, whichever comes first. Returns how many milliseconds it took.
#[expect(clippy::disallowed_types, reason = "the command line measures how long a run takes; no planner uses it")]
fn run_to_end(run: &mut Run, stop_at: Option<u64>, trace: Option<&Path>) -> Result<f64, Failure> {
    let interrupted = interrupt::flag();
    let end = stop_at.unwrap_or(u64::MAX).min(run.limit());
    let (bar, mut shown) = (progress(end), false);
    let mut rows = trace.map(|path| create(path).map(|file| (path, file))).transpose()?;
    let started = std::time::Instant::now();
    loop {
        if let Some((path, rows)) = &mut rows {
            write_row(rows, run).map_err(|error| Failure::write(path, error))?;
        }
        bar.set_position(run.iteration());
        if !shown && started.elapsed() > LONG {
            shown = true;
            bar.set_draw_target(ProgressDrawTarget::stderr());
        }
        let done = run.iteration() >= end || run.status() != Status::Running;
        if done || interrupted.load(Ordering::Relaxed) {
            break;
        }
        // An interrupted step is no iteration: it has no row.
        if run.step_until(&|| interrupted.load(Ordering::Relaxed))? != Stepped::Whole {
            break;
        }
    }
    let elapsed = started.elapsed();
    bar.finish_and_clear();
    if let Some((path, rows)) = &mut rows {
        rows.flush().map_err(|error| Failure::write(path, error))?;
    }
    if interrupted.load(Ordering::Relaxed) {
        let at = run.iteration();
        note(if run.is_partly() {
            message!(
                "shell-interrupted-within",
                "interrupted within the step after iteration {at}; this is the best result so far. Costs, evaluations and readings are those of the unfinished step, which has no hash",
                at
            )
        } else {
            message!("shell-interrupted-at", "interrupted at iteration {at}; this is the best result so far", at)
        });
    }
    Ok(elapsed.as_secs_f64() * 1e3)
}

/// A run that takes longer than this gets a progress bar.
const LONG: Duration = Duration::from_millis(500);

/// A bar on standard error (shown only on a terminal), hidden until the run has taken long.
fn progress(end: u64) -> ProgressBar {
    let bar = ProgressBar::with_draw_target(Some(end), ProgressDrawTarget::hidden());
    let (bar_of, at, of, left) = ("{wide_bar}", "{pos}", "{len}", "{eta}");
    let template = message!("shell-run-progress", "{bar_of} {at}/{of} iterations, {left} left", bar_of, at, of, left);
    if let Ok(style) = ProgressStyle::with_template(&template.text()) {
        bar.set_style(style);
    }
    bar
}

fn create(path: &Path) -> Result<io::BufWriter<Out>, Failure> {
    Out::create(path).map(io::BufWriter::new).map_err(|error| Failure::write(path, error))
}

fn write_row(rows: &mut impl Write, run: &mut Run) -> io::Result<()> {
    let iteration = run.iteration();
    let readings = run.readings();
    if iteration == 0 {
        csv_heading(rows, readings.iter().map(|(name, _)| name))?;
    }
    csv_row(rows, iteration, readings.iter().map(|(_, value)| value))
}

fn write_rows(path: &Path, columns: &[Column], rows: &[f64]) -> Result<(), Failure> {
    let mut out = create(path)?;
    let written = csv_line(&mut out, columns.iter().map(|column| column.name))
        .and_then(|()| rows.chunks_exact(columns.len()).try_for_each(|row| csv_line(&mut out, row.iter())))
        .and_then(|()| out.flush());
    written.map_err(|error| Failure::write(path, error))
}

fn write_tour(path: &Path, outcome: &Outcome) -> Result<(), Failure> {
    let Some(order) = &outcome.order else {
        not_written(path, &message!("shell-no-tour-found", "no tour was found"));
        return Ok(());
    };
    let name = path.to_string_lossy();
    files::write(path, tour_file(&escape(stem_of(&name)), order).bytes)?;
    if outcome.path.as_ref().is_some_and(|path| path.first() != path.last()) {
        let file = quoted(&path.to_string_lossy());
        note(message!("shell-open-tour", "the tour is open, but readers of {file} take it as closed", file));
    }
    Ok(())
}
