//! `forage grade`.

use std::{
    env,
    io::{self, Read as _, Write as _},
    num::NonZeroUsize,
    path::Path,
    process::{Command, ExitCode, Output, Stdio},
    sync::{
        Arc, Mutex, PoisonError,
        atomic::{AtomicUsize, Ordering},
    },
    thread,
};

use forage::{
    Error, Link, Registry,
    kernel::message::in_english,
    message,
    run::{Handed, Judgement, Task, handed_in},
};
use forage_study::spreadsheet;
use serde::{Deserialize, Serialize};

use super::{
    args::GradeArgs,
    failure::{self, Failure, in_file},
    files::{self, LARGEST_LIST, LARGEST_SCENE, LONGEST_LINK, Limit},
    load::own_planner,
    output::{note, print_raw},
    registry::registry,
    text::shorten,
};

/// So long is what is said of a link that could not be graded.
const LONGEST_REASON: usize = 500;

/// A row of the result, in English. The first four say what a link is worth, the others what it is of.
#[derive(Default, Serialize, Deserialize)]
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
    if args.alone {
        return alone(args);
    }
    let given = read(&args.task, LARGEST_SCENE)?;
    let task = task_of(args, &given)?;
    let text = read(&args.links, LARGEST_LIST)?;
    let all: Vec<_> = handed_in(&text).collect();
    if all.is_empty() {
        return Err(Failure::Refused(message!(
            "shell-no-link-to-grade",
            "there is no link to grade: each line has one, and whose it is may stand before it"
        )));
    }
    let rows = graded(&given, &task, &all, args.jobs)?;
    let good = rows.iter().filter(|row| row.reached && row.verified).count();
    print_raw(spreadsheet::safe_table(&csv_of(&rows)?).map_err(Failure::output)?.trim_ascii_end())?;
    let all = rows.len();
    note(message!("shell-graded", "{good} of {all} reached the goal, with a hash that came out again", good, all));
    Ok(ExitCode::from(u8::from(good < rows.len())))
}

fn task_of(args: &GradeArgs, text: &str) -> Result<Task, Failure> {
    Task::read(registry(), text).map_err(|error| in_file(&args.task, &error))
}

fn read(path: &Path, limit: Limit) -> Result<String, Failure> {
    let bytes = files::read(path, limit)?;
    String::from_utf8(bytes).map_err(|_| Failure::no_text(path))
}

/// All of them, in their order; several at a time.
fn graded(given: &str, task: &Task, all: &[Handed<'_>], jobs: Option<NonZeroUsize>) -> Result<Vec<Row>, Failure> {
    let threads = jobs.or(thread::available_parallelism().ok()).map_or(1, NonZeroUsize::get).min(all.len());
    let (next, rows) = (AtomicUsize::new(0), Mutex::new(Vec::with_capacity(all.len())));
    thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(|| {
                while let Some(one) = all.get(next.fetch_add(1, Ordering::Relaxed)) {
                    let row = if forage_isolate::carries_code(one.link) { apart(given, one) } else { Ok(in_english(|| row(task, one))) };
                    rows.lock().unwrap_or_else(PoisonError::into_inner).push(row);
                }
            });
        }
    });
    let rows = rows.into_inner().unwrap_or_else(PoisonError::into_inner);
    let mut rows = rows.into_iter().collect::<Result<Vec<Row>, Failure>>()?;
    rows.sort_by_key(|row| row.line);
    Ok(rows)
}

/// What parts the task from the link where another program reads them.
const END: char = '\0';

/// Grades a link in a program of its own: what somebody wrote may not end, and the others are to be graded all the same. `given`: the
/// task.
fn apart(given: &str, one: &Handed<'_>) -> Result<Row, Failure> {
    let failed = |error| Failure::File(message!("shell-program-for-code", "a program for somebody's code").to_string(), error);
    let begun = env::current_exe().and_then(|program| {
        let of = ["--lang", "en", "grade", "--alone", "--task", "task", "links"];
        Command::new(program).args(of).stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn()
    });
    let mut program = begun.map_err(failed)?;
    // It may have ended before it has read all.
    let _ = program.stdin.take().map(|mut input| write!(input, "{given}{END}{}", one.link));
    let Output { status, stdout, stderr } = program.wait_with_output().map_err(failed)?;
    let said = String::from_utf8_lossy(&stderr);
    let said = said.trim();
    let said = said.strip_prefix("forage: ").unwrap_or(said);
    let row = match (csv::Reader::from_reader(&*stdout).deserialize().next(), status.code()) {
        (Some(Ok(row)), Some(0)) => row,
        (_, Some(2)) if !said.is_empty() => Row { reason: shorten(said, LONGEST_REASON), ..Row::default() },
        // The machine's failure is nobody's mark.
        (_, Some(3)) => return Err(failed(io::Error::other(said.to_owned()))),
        _ => Row { reason: format!("its code broke the program that ran it ({status})"), ..Row::default() },
    };
    Ok(Row { line: one.line, name: one.name.to_owned(), ..row })
}

/// The other program's part: one link.
fn alone(args: &GradeArgs) -> failure::Outcome {
    let mut text = String::new();
    io::stdin().read_to_string(&mut text).map_err(|error| {
        let input = message!("shell-standard-input", "standard input");
        Failure::File(input.to_string(), error)
    })?;
    let (given, link) = text.split_once(END).unwrap_or_default();
    let row = row(&task_of(args, given)?, &Handed { line: 1, name: "", link });
    print_raw(csv_of(&[row])?.trim_ascii_end())?;
    Ok(ExitCode::SUCCESS)
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
    let failed = |error: csv::Error| Failure::output(error.into());
    let mut out = csv::Writer::from_writer(Vec::new());
    rows.iter().try_for_each(|row| out.serialize(row)).map_err(failed)?;
    out.into_inner().map_err(|error| Failure::output(error.into_error()))
}
