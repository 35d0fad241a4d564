//! `forage grade`.

use std::{
    num::NonZeroUsize,
    path::Path,
    process::ExitCode,
    sync::{
        Arc, Mutex, PoisonError,
        atomic::{AtomicUsize, Ordering},
    },
    thread::{self, ThreadId},
};

use forage::{
    Error, Link, Registry,
    run::{Judgement, Task},
};
use serde::Serialize;

use super::{
    args::GradeArgs,
    failure::{self, Failure, in_file},
    files::{self, LARGEST_LIST, LARGEST_SCENE, LONGEST_LINK, Limit},
    load::own_planner,
    output::{note, print_raw},
    registry::registry,
};

/// What was handed in: what stands before a link says whose it is.
struct Handed<'a> {
    line: usize,
    name: &'a str,
    link: &'a str,
}

/// A row of the result. The first four say what a link is worth, the others what it is of.
#[derive(Default, Serialize)]
struct Row {
    reached: bool,
    evaluations: Option<u64>,
    verified: bool,
    reason: String,
    line: usize,
    name: String,
    planner: String,
    scene: String,
    seed: Option<u64>,
    iteration: Option<u64>,
    cost: Option<f64>,
    length: Option<f64>,
    gap: Option<f64>,
}

pub(super) fn grade(args: &GradeArgs) -> failure::Outcome {
    let task = Task::read(registry(), &read(&args.task, LARGEST_SCENE)?).map_err(|error| in_file(&args.task, &error))?;
    let text = read(&args.links, LARGEST_LIST)?;
    let all: Vec<_> = text.lines().enumerate().filter_map(|(k, line)| handed(k + 1, line)).collect();
    if all.is_empty() {
        return Err(Failure::Refused("there is no link to grade: each line has one, and whose it is may stand before it".to_owned()));
    }
    let rows = graded(&task, &all, args.jobs);
    let good = rows.iter().filter(|row| row.reached && row.verified).count();
    print_raw(csv_of(&rows)?.trim_ascii_end())?;
    note(&format!("{good} of {} reached the goal, with a hash that came out again", rows.len()));
    Ok(ExitCode::from(u8::from(good < rows.len())))
}

fn read(path: &Path, limit: Limit) -> Result<String, Failure> {
    let bytes = files::read(path, limit)?;
    String::from_utf8(bytes).map_err(|_| Failure::Refused(format!("{}: this is no text", files::quoted_path(path))))
}

/// What a line has; nothing where it is empty or a comment.
fn handed(line: usize, text: &str) -> Option<Handed<'_>> {
    let text = text.trim();
    if text.is_empty() || text.starts_with("# ") {
        return None;
    }
    let Some(fragment) = text.find("#v=") else { return Some(Handed { line, name: "", link: text }) };
    // An address has no spaces and no quotes; before it, commas and semicolons part it from a name.
    let parts = |c: char| c.is_whitespace() || ['"', ',', ';'].contains(&c);
    let begin = text[..fragment].rfind(parts).map_or(0, |at| at + 1);
    let end = text[fragment..].find(|c: char| c.is_whitespace() || c == '"').map_or(text.len(), |at| fragment + at);
    Some(Handed { line, name: text[..begin].trim_matches(|c| parts(c) || c == ':'), link: &text[begin..end] })
}

/// What each thread judges now: the line.
static GRADED: Mutex<Vec<(ThreadId, usize)>> = Mutex::new(Vec::new());

fn locked<T>(mutex: &Mutex<T>) -> std::sync::MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Says that the code which a thread runs does not stop, and whose it is.
pub(super) fn unstoppable(thread: ThreadId) -> String {
    let line = locked(&GRADED).iter().find(|(other, _)| *other == thread).map(|(_, line)| *line);
    let place = line.map_or_else(|| "code".to_owned(), |line| format!("line {line}"));
    format!(
        "{place}: it took longer than 900 ms and could not be stopped: something built in took several seconds; without it the others can be graded"
    )
}

/// All of them, in their order; several at a time.
fn graded(task: &Task, all: &[Handed<'_>], jobs: Option<NonZeroUsize>) -> Vec<Row> {
    let threads = jobs.or(thread::available_parallelism().ok()).map_or(1, NonZeroUsize::get).min(all.len());
    let (next, rows) = (AtomicUsize::new(0), Mutex::new(Vec::with_capacity(all.len())));
    thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(|| {
                while let Some(one) = all.get(next.fetch_add(1, Ordering::Relaxed)) {
                    let thread = thread::current().id();
                    locked(&GRADED).push((thread, one.line));
                    let row = row(task, one);
                    locked(&GRADED).retain(|(other, _)| *other != thread);
                    locked(&rows).push(row);
                }
            });
        }
    });
    let mut rows = rows.into_inner().unwrap_or_else(PoisonError::into_inner);
    rows.sort_by_key(|row| row.line);
    rows
}

fn row(task: &Task, one: &Handed<'_>) -> Row {
    let row = Row { line: one.line, name: one.name.to_owned(), ..Row::default() };
    let opened = LONGEST_LINK.check("the link", one.link.len() as u64).and_then(|()| Ok(opened(one.link)?));
    let (registry, link) = match opened {
        Ok(opened) => opened,
        Err(failure) => return Row { reason: failure.message(), ..row },
    };
    let row = Row {
        planner: link.setup.planner.clone(),
        scene: link.setup.scene.name().to_owned(),
        seed: Some(link.setup.seed),
        iteration: Some(link.iteration),
        ..row
    };
    match task.judge(&registry, &link) {
        Err(error) => Row { reason: Failure::from(error).message(), ..row },
        Ok(Judgement { reached, evaluations, verified, reasons, outcome, .. }) => Row {
            reached,
            evaluations: Some(evaluations),
            verified,
            reason: reasons.iter().map(ToString::to_string).collect::<Vec<_>>().join(" "),
            cost: outcome.cost,
            length: outcome.length,
            gap: outcome.gap,
            ..row
        },
    }
}

/// What a link says, and the planners that there are for it: with that of a code of its own.
fn opened(link: &str) -> Result<(Arc<Registry>, Link), Error> {
    let mut known = Arc::clone(registry());
    if let Some(code) = forage_isolate::code_in(link)? {
        let entry = own_planner(&code, &known)?;
        known = Arc::new(Registry::clone(&known).with(entry));
    }
    let link = Link::parse(&known, link)?;
    Ok((known, link))
}

fn csv_of(rows: &[Row]) -> Result<Vec<u8>, Failure> {
    let failed = |error: csv::Error| Failure::File("standard output".to_owned(), error.into());
    let mut out = csv::Writer::from_writer(Vec::new());
    rows.iter().try_for_each(|row| out.serialize(row)).map_err(failed)?;
    out.into_inner().map_err(|error| Failure::File("standard output".to_owned(), error.into_error()))
}
