//! `forage run`.

use std::{
    fmt::Write as _,
    fs::File,
    io::{self, Write},
    path::Path,
    process::ExitCode,
    sync::atomic::{AtomicBool, Ordering},
    time::Duration,
};

use forage::{
    DriveOutcome, Error, Outcome, Session, Status,
    arm::{self, MotionOutcome},
    drive::{COLUMNS, Column},
    frame::Role,
    picture,
    planner::{Finding, Yardstick},
    scene::formats::tour_file,
    session::{carry_out_all, csv_heading, csv_line, csv_row},
};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use serde::Serialize;

use super::{Failure, args::RunArgs, interrupt, load, print, print_json};

/// The outcome and what only the shell knows.
#[derive(Serialize)]
struct Report {
    #[serde(flatten)]
    outcome: Outcome,
    elapsed_ms: f64,
}

pub(super) fn run(args: &RunArgs) -> super::Outcome {
    let task = load::task(args)?;
    let given = load::drive(args, &task.setup.scene)?;
    let of_motion = load::motion(args, &task.setup.scene)?;
    let mut session = Session::with_keyframes(task.setup, 0)?;
    if args.tour.is_some() && !session.entry().stops {
        return Err(Error::refused("--tour", session.entry().name, "left out, or the planner one that looks for tours").into());
    }
    let elapsed_ms = carry_out(&mut session, task.stop_at, args.trace.as_deref())?;
    let mut outcome = session.outcome();
    if args.drive.is_some() || !given.is_empty() {
        let drive = session.drive(&given)?;
        match (&args.drive, &drive) {
            (Some(path), Some(drive)) => write_rows(path, COLUMNS, &drive.rows).map_err(|error| file(path, error))?,
            (Some(path), None) => eprintln!("forage: no path was found to drive along; {} is not written", path.display()),
            (None, _) => {}
        }
        outcome.drive = drive.map(|drive| drive.outcome);
    }
    if args.motion.is_some() || !of_motion.is_empty() {
        let motion = session.motion(&of_motion)?;
        match (&args.motion, &motion) {
            (Some(path), Some(motion)) => write_rows(path, arm::MOTION.columns, &motion.rows).map_err(|error| file(path, error))?,
            (Some(path), None) => eprintln!("forage: no path was found to follow; {} is not written", path.display()),
            (None, _) => {}
        }
        outcome.motion = motion.map(|motion| motion.outcome);
    }
    if let Some(path) = &args.tour {
        match &outcome.order {
            Some(order) => {
                write_tour(path, order).map_err(|error| file(path, error))?;
                if outcome.path.as_ref().is_some_and(|way| way.first() != way.last()) {
                    eprintln!(
                        "forage: the tour does not go back to its beginning; who reads {} takes it for one that does",
                        path.display()
                    );
                }
            }
            None => eprintln!("forage: no tour was found; {} is not written", path.display()),
        }
    }
    if let Some(path) = &args.svg {
        let roles: Vec<_> = session.entry().layers.iter().filter(|layer| layer.on).map(|layer| layer.role).chain([Role::Exact]).collect();
        std::fs::write(path, picture::svg(&session, false, &roles)).map_err(|error| file(path, error))?;
    }
    if let Some(promised) = task.promised.filter(|promised| *promised != outcome.hash) {
        eprintln!("forage: the link promises the hash {promised}, this run has {}", outcome.hash);
    }
    let feasible = outcome.feasible;
    if args.json {
        print_json(&Report { outcome, elapsed_ms });
    } else {
        print(&summary(&outcome, elapsed_ms));
    }
    Ok(ExitCode::from(u8::from(!feasible)))
}

/// Steps to the end, to `stop_at`, or to Ctrl-C, whichever comes first. Returns the milliseconds it took.
#[expect(clippy::disallowed_types, reason = "the shell tells how long a run took; no planner sees it")]
fn carry_out(session: &mut Session, stop_at: Option<u64>, trace: Option<&Path>) -> Result<f64, Failure> {
    let interrupted = interrupt::flag();
    let end = stop_at.unwrap_or(u64::MAX).min(session.limit());
    let (bar, mut shown) = (progress(end), false);
    let mut rows = trace.map(|path| File::create(path).map(io::BufWriter::new).map_err(|error| file(path, error))).transpose()?;
    let begun = std::time::Instant::now();
    loop {
        if let (Some(rows), Some(path)) = (&mut rows, trace) {
            write_row(rows, session).map_err(|error| file(path, error))?;
        }
        bar.set_position(session.iteration());
        if !shown && begun.elapsed() > LONG {
            shown = true;
            bar.set_draw_target(ProgressDrawTarget::stderr());
        }
        let done = session.iteration() >= end || session.status() != Status::Running;
        if done || interrupted.load(Ordering::Relaxed) {
            break;
        }
        if let Some(found) = runs(session, &interrupted)? {
            session.supply(found);
        }
        if !interrupted.load(Ordering::Relaxed) {
            session.step(1);
        }
    }
    let elapsed = begun.elapsed();
    bar.finish_and_clear();
    if let (Some(rows), Some(path)) = (&mut rows, trace) {
        rows.flush().map_err(|error| file(path, error))?;
    }
    if interrupted.load(Ordering::Relaxed) {
        eprintln!("forage: interrupted at iteration {}; this is the best so far", session.iteration());
    }
    Ok(elapsed.as_secs_f64() * 1e3)
}

/// The runs of other planners that the next step needs, side by side, a few at a time so that Ctrl-C is heard. `None`: it
/// needs none.
fn runs(session: &Session, interrupted: &AtomicBool) -> Result<Option<Vec<Finding>>, Failure> {
    let jobs = session.jobs();
    let mut found = Vec::with_capacity(jobs.len());
    for some in jobs.chunks(64) {
        if interrupted.load(Ordering::Relaxed) {
            break;
        }
        found.extend(carry_out_all(session.scene(), some)?);
    }
    Ok((!jobs.is_empty()).then_some(found))
}

/// After this long a run is long enough for a progress bar.
const LONG: Duration = Duration::from_millis(500);

/// A bar for standard error (which shows it only on a terminal), hidden until the run has proved to be long.
fn progress(end: u64) -> ProgressBar {
    let bar = ProgressBar::with_draw_target(Some(end), ProgressDrawTarget::hidden());
    if let Ok(style) = ProgressStyle::with_template("{wide_bar} {pos}/{len} iterations, {eta} left") {
        bar.set_style(style);
    }
    bar
}

fn write_row(rows: &mut impl Write, session: &mut Session) -> io::Result<()> {
    let iteration = session.iteration();
    let readings = session.readings();
    if iteration == 0 {
        csv_heading(rows, readings.iter().map(|(name, _)| name))?;
    }
    csv_row(rows, iteration, readings.iter().map(|(_, value)| value))
}

fn write_rows(path: &Path, columns: &[Column], rows: &[f64]) -> io::Result<()> {
    let mut out = io::BufWriter::new(File::create(path)?);
    csv_line(&mut out, columns.iter().map(|column| column.name))?;
    for row in rows.chunks_exact(columns.len()) {
        csv_line(&mut out, row.iter())?;
    }
    out.flush()
}

fn write_tour(path: &Path, order: &[usize]) -> io::Result<()> {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    std::fs::write(path, tour_file(&name, order).bytes)
}

fn file(path: &Path, error: io::Error) -> Failure {
    Failure::File(path.display().to_string(), error)
}

fn summary(outcome: &Outcome, elapsed_ms: f64) -> String {
    let status = format!("{:?}", outcome.status).to_lowercase();
    let mut text = format!(
        "{} on {}, seed {}: {status} after {} iterations, {} evaluations, {elapsed_ms:.1} ms\n",
        outcome.planner, outcome.scene, outcome.seed, outcome.iterations, outcome.evaluations
    );
    match (outcome.length, outcome.cost) {
        (Some(length), _) => {
            // The same pieces added in another order are no other length.
            let differs = |raw: f64| (raw - length).abs() > 1e-12 * length;
            let before = outcome.readings.iter().find(|(name, raw)| *name == "length" && differs(*raw));
            let before = before.map_or(String::new(), |(_, raw)| format!(" ({raw} before smoothing)"));
            let _ = writeln!(text, "  length     {length}{before}");
            if let (Some(turns), Some(turning)) = (outcome.turns, outcome.turning) {
                let _ = writeln!(text, "  turns      {turns}, {:.1}° in all", turning.to_degrees());
            }
            let reading = |name: &str| outcome.readings.iter().find(|(known, _)| *known == name).map(|(_, value)| *value);
            if let (Some(length), Some(turns), Some(turning)) =
                (reading("smooth_length"), reading("smooth_turns"), reading("smooth_turning"))
            {
                let what = "without redundant nodes";
                let _ = writeln!(text, "  smoothed   {length}, {turns} turns, {:.1}° in all, {what}", turning.to_degrees());
            }
            if let Some(converged) = reading("converged") {
                let _ = writeln!(text, "  converged  in iteration {converged}");
            }
        }
        (None, Some(cost)) => {
            let _ = writeln!(text, "  cost       {cost:e}");
        }
        (None, None) => text.push_str("  nothing found\n"),
    }
    if let Some(exact) = outcome.exact {
        let gap = outcome.gap.map_or(String::new(), |gap| format!(" ({:+.4} %)", gap * 100.0));
        let by = match outcome.exact_by {
            Yardstick::Cells => ", from cell to cell",
            Yardstick::Stored => ", as the scene’s file says",
            Yardstick::AnyAngle | Yardstick::Matrix | Yardstick::Refuted => "",
        };
        let _ = writeln!(text, "  optimum    {exact}{by}{gap}");
    }
    let by_road = outcome.readings.iter().find(|(name, length)| *name == "by_road" && length.is_finite());
    if let (Some((_, by_road)), Some(length)) = (by_road, outcome.length) {
        let gap = (length - by_road) / by_road * 100.0;
        // The same roads added in another order.
        let gap = if gap.abs() < 1e-10 { 0.0 } else { gap };
        let _ = writeln!(text, "  by road    {by_road} is the shortest tour by these roads ({gap:+.4} %)");
    }
    if outcome.exact_by == Yardstick::Refuted {
        text.push_str("  optimum    the scene’s file gives one, and this is shorter: it was none\n");
    }
    if let Some(trouble) = &outcome.trouble {
        let _ = writeln!(text, "  trouble    {trouble}");
    }
    match outcome.clearance {
        Some(clearance) if outcome.feasible => {
            let _ = writeln!(text, "  free       yes, clearance {clearance:.6}");
        }
        Some(clearance) if clearance < 0.0 => {
            let _ = writeln!(text, "  free       NO, it cuts {:.6} deep into an obstacle", -clearance);
        }
        _ if outcome.tip_path.is_some() && !outcome.feasible => {
            text.push_str("  free       NO, it touches something, leaves the workspace or does not join the ends\n");
        }
        _ if outcome.path.is_some() && !outcome.feasible => {
            text.push_str("  free       NO, it leaves the scene or does not join the ends\n");
        }
        _ => {}
    }
    if let Some(drive) = &outcome.drive {
        let _ = writeln!(text, "  drive      {}", driven(drive));
    }
    if let Some(motion) = &outcome.motion {
        let _ = writeln!(text, "  motion     {}", moved(motion));
        if let Some(trouble) = &motion.trouble {
            let _ = writeln!(text, "             {trouble}");
        }
    }
    text += &log(outcome);
    if let Some(tuned) = &outcome.tuned {
        let pairs: Vec<_> = tuned.params.iter().map(|(name, value)| format!("--set {name}={value}")).collect();
        let _ = writeln!(text, "  tuned      forage run {} --scene {} {}", tuned.planner, outcome.scene, pairs.join(" "));
    }
    if let Some(order) = &outcome.order {
        let stops: Vec<_> = order.iter().map(usize::to_string).collect();
        let _ = writeln!(text, "  order      {}", stops.join(" "));
    }
    if let Some(path) = &outcome.path {
        let points: Vec<_> = path.iter().map(|[x, y]| format!("({x:.4}, {y:.4})")).collect();
        let _ = writeln!(text, "  path       {}", points.join(" → "));
    }
    if let Some(position) = &outcome.position {
        let numbers: Vec<_> = position.iter().map(|x| format!("{x:.6e}")).collect();
        let _ = writeln!(text, "  position   ({})", numbers.join(", "));
    }
    let _ = writeln!(text, "  hash       {}", outcome.hash);
    text
}

/// What happened in simulated time, a line each, and where the time went.
fn log(outcome: &Outcome) -> String {
    let mut text = String::new();
    if outcome.events.is_empty() {
        return text;
    }
    let reading = |name: &str| outcome.readings.iter().find(|(known, _)| *known == name).map_or(f64::NAN, |(_, value)| *value);
    let [time, driving, turning, waited] = ["time", "driving", "turning_time", "waited"].map(reading);
    let _ = writeln!(text, "  time       {time:.4} s: {driving:.4} driving, {turning:.4} turning, {waited:.4} waiting");
    let _ = writeln!(text, "  collisions {}", reading("collisions"));
    for (i, event) in outcome.events.iter().enumerate() {
        let ([x, y], title) = (event.place, if i == 0 { "events" } else { "" });
        let _ = writeln!(text, "  {title:<10} {:8.2} s  ({x:.2}, {y:.2})  {:<9}  {}", event.time, event.kind, event.reason);
    }
    text
}

/// How a drive went, in a line.
fn driven(drive: &DriveOutcome) -> String {
    let mut text = format!("{:.1} s, {:.3} m, error at most {:.4}", drive.time, drive.distance, drive.max_error);
    match (drive.touched_at, drive.clearance) {
        (Some([x, y]), clearance) => {
            let depth = -clearance.unwrap_or(0.0);
            let _ = write!(text, ", TOUCHES an obstacle at ({x:.4}, {y:.4}), {depth:.4} deep at most");
        }
        (None, Some(clearance)) => {
            let _ = write!(text, ", clearance {clearance:.4}");
        }
        (None, None) => {}
    }
    if !drive.arrived {
        text.push_str(", did NOT arrive");
    }
    let [left, right] = drive.counts;
    let _ = write!(text, ", {left} / {right} counts");
    text
}

/// How an arm's motion went, in a line.
fn moved(motion: &MotionOutcome) -> String {
    let MotionOutcome { time, length, largest_step, max_error, .. } = motion;
    let mut text = format!("{time:.2} s, {length:.4} m, steps of at most {largest_step:.2}°, error at most {max_error:.6}");
    match (motion.touched_at, motion.clearance) {
        (Some(seconds), _) => {
            let _ = write!(text, ", TOUCHES a cuboid or the column after {seconds:.2} s");
        }
        (None, Some(clearance)) => {
            let _ = write!(text, ", the whole arm free, clearance {clearance:.4}");
        }
        (None, None) if motion.free => text.push_str(", the whole arm free"),
        (None, None) => {}
    }
    for (replaced, how) in [(motion.mirrored, "mirrored"), (motion.drawn, "drawn at random")] {
        if replaced > 0 {
            let _ = write!(text, ", {replaced} {how}");
        }
    }
    if !motion.arrived {
        text.push_str(", did NOT arrive");
    }
    text
}
