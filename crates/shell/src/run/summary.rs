//! The result of a run for people. `--json` has all digits.

use std::fmt::{Display, Write as _};

use forage::{
    Outcome, Status,
    follow::{drive::DriveOutcome, motion::MotionOutcome},
    kernel::{Message, ReferenceOptimum},
    message,
};

use forage_languages::speaker;

use crate::{
    language::say,
    registry::registry,
    text::{escape, measured, number, padded, point, wide},
};

/// Lines with a label each.
struct Lines {
    text: String,
    unit: String,
}

impl Lines {
    fn add(&mut self, label: &Message, value: impl Display) {
        // Writing to a string cannot fail.
        let _ = writeln!(self.text, "  {} {value}", padded(&label.text(), 10));
    }

    fn length(&self, length: f64) -> String {
        measured(length, &self.unit)
    }
}

/// The result in lines; `unit` is that of lengths.
pub(super) fn summary(outcome: &Outcome, unit: &str, elapsed_ms: f64) -> String {
    let time = if elapsed_ms < 1e3 { measured(elapsed_ms, "ms") } else { measured(elapsed_ms / 1e3, "s") };
    let heading = message!(
        "shell-run",
        "{planner} on {scene}, seed {seed}: {status} after {iterations} iterations, {evaluations} evaluations, {time}",
        planner = outcome.planner,
        scene = escape(&outcome.scene),
        // All digits.
        seed = outcome.seed.to_string(),
        status = status(outcome.status),
        iterations = outcome.iterations,
        evaluations = outcome.evaluations,
        time
    );
    let mut lines = Lines { text: format!("{heading}\n"), unit: escape(unit).into_owned() };
    cost(outcome, &mut lines);
    optimum(outcome, &mut lines);
    feasibility(outcome, &mut lines);
    if let Some(drive) = outcome.followed.get::<DriveOutcome>() {
        let value = drive_line(drive, &lines);
        lines.add(&message!("shell-label-drive", "drive"), value);
    }
    if let Some(motion) = outcome.followed.get::<MotionOutcome>() {
        lines.add(&message!("shell-label-motion", "motion"), motion_line(motion));
        if let Some(failure) = &motion.failure {
            lines.add(&Message::default(), escape(&failure.text()));
        }
    }
    events(outcome, &mut lines);
    solution(outcome, &mut lines);
    if !outcome.hash.is_empty() {
        lines.add(&message!("shell-label-hash", "hash"), &outcome.hash);
    }
    lines.text
}

/// A status for people.
fn status(status: Status) -> Message {
    match status {
        Status::Running => message!("shell-status-running", "running"),
        Status::Solved => message!("shell-status-solved", "solved"),
        Status::Exhausted => message!("shell-status-completed", "completed"),
        Status::Infeasible => message!("shell-status-infeasible", "infeasible"),
        Status::Failed => message!("shell-status-failed", "failed"),
    }
}

fn reading(outcome: &Outcome, name: &str) -> Option<f64> {
    outcome.readings.iter().find(|(known, _)| *known == name).map(|(_, value)| *value)
}

fn degrees(radians: f64) -> String {
    format!("{}°", number(radians.to_degrees()))
}

fn cost(outcome: &Outcome, lines: &mut Lines) {
    match (outcome.length, outcome.cost) {
        (Some(length), _) => {
            // The same pieces added in another order differ in the last digits only.
            let raw = reading(outcome, "length").filter(|raw| (raw - length).abs() > 1e-12 * length);
            let length = lines.length(length);
            let length = match raw.map(|raw| lines.length(raw)) {
                Some(raw) => message!("shell-length-before", "{length} ({raw} before smoothing)", length, raw),
                None => Message::verbatim(length),
            };
            lines.add(&message!("shell-label-length", "length"), length);
            if let (Some(turns), Some(turning)) = (outcome.turns, outcome.turning) {
                let turns = message!("shell-turns", "{turns}, {turning} in total", turns = turns.to_string(), turning = degrees(turning));
                lines.add(&message!("shell-label-turns", "turns"), turns);
            }
            smoothed(outcome, lines);
            if let Some(converged) = reading(outcome, "converged") {
                // The mean of several colonies need not be whole.
                let iteration = if converged.fract() == 0.0 { converged.to_string() } else { number(converged) };
                lines.add(
                    &message!("shell-label-converged", "converged"),
                    message!("shell-in-iteration", "in iteration {iteration}", iteration),
                );
            }
        }
        (None, Some(cost)) => lines.add(&message!("shell-label-cost", "cost"), number(cost)),
        (None, None) => lines.add(&message!("shell-label-result", "result"), message!("shell-nothing-found", "nothing found")),
    }
}

fn smoothed(outcome: &Outcome, lines: &mut Lines) {
    let smooth = ["smooth_length", "smooth_turns", "smooth_turning"].map(|name| reading(outcome, name));
    let [Some(length), Some(turns), Some(turning)] = smooth else { return };
    let said = message!(
        "shell-smoothed",
        "{length}, {turns} turns, {turning} in total, without redundant nodes",
        length = lines.length(length),
        turns = turns.to_string(),
        turning = degrees(turning)
    );
    lines.add(&message!("shell-label-smoothed", "smoothed"), said);
}

/// A gap in percent.
fn percent(gap: f64) -> Message {
    // No more than rounding: the same pieces added in another order.
    let gap = if gap.abs() < 1e-12 { 0.0 } else { gap };
    let sign = if gap > 0.0 { "+" } else { "" };
    message!("shell-gap", "gap {gap} %", gap = format!("{sign}{}", number(gap * 100.0)))
}

fn optimum(outcome: &Outcome, lines: &mut Lines) {
    let label = || message!("shell-label-optimum", "optimum");
    if let Some(exact) = outcome.exact {
        let exact = if outcome.length.is_some() { lines.length(exact) } else { number(exact) };
        let exact = match outcome.exact_by {
            ReferenceOptimum::Cells => message!("shell-optimum-cells", "{exact}, from cell to cell", exact),
            ReferenceOptimum::Stored => message!("shell-optimum-stated", "{exact}, stated in the scene file", exact),
            ReferenceOptimum::AnyAngle | ReferenceOptimum::Matrix | ReferenceOptimum::Refuted => Message::verbatim(exact),
        };
        let exact = match outcome.gap {
            Some(gap) => message!("shell-with-gap", "{value} ({gap})", value = exact, gap = percent(gap)),
            None => exact,
        };
        lines.add(&label(), exact);
    }
    let by_road = reading(outcome, "by_road").filter(|by_road| by_road.is_finite());
    if let (Some(by_road), Some(length)) = (by_road, outcome.length) {
        let (gap, best) = (percent((length - by_road) / by_road), lines.length(by_road));
        let best = message!("shell-best-tour", "{best} with these paths between stops ({gap})", best, gap);
        lines.add(&message!("shell-label-best-tour", "best tour"), best);
    }
    if outcome.exact_by == ReferenceOptimum::Refuted {
        lines.add(&label(), message!("shell-optimum-refuted", "this result is better than the optimum stated in the scene file"));
    }
}

fn feasibility(outcome: &Outcome, lines: &mut Lines) {
    if let Some(failure) = &outcome.failure {
        lines.add(&message!("shell-label-failure", "failure"), escape(&failure.text()));
    }
    let clearance = outcome.clearance.map(|clearance| lines.length(clearance.abs()));
    let feasible = match (outcome.clearance, clearance) {
        (Some(_), Some(distance)) if outcome.feasible => message!("shell-feasible-clear", "yes, clearance {distance}", distance),
        (Some(clearance), Some(depth)) if clearance < 0.0 => {
            message!("shell-infeasible-cuts", "NO, it cuts {depth} into an obstacle", depth)
        }
        _ if outcome.tip_path.is_some() && !outcome.feasible => {
            message!("shell-infeasible-arm", "NO, it collides, leaves the workspace or does not join start and goal")
        }
        _ if outcome.path.is_some() && !outcome.feasible => {
            message!("shell-infeasible-path", "NO, it leaves the scene or does not join start and goal")
        }
        // There is nothing to keep clear of.
        _ if outcome.feasible && outcome.length.is_some() => message!("shell-feasible", "yes"),
        _ => return,
    };
    lines.add(&message!("shell-label-feasible", "feasible"), feasible);
}

/// What happened in simulated time, one line per event, and how the time was spent.
fn events(outcome: &Outcome, lines: &mut Lines) {
    if outcome.events.is_empty() {
        return;
    }
    // Sums of many steps: what is far below a microsecond is rounding.
    let seconds = |time: f64| if time.abs() < 1e-9 { number(0.0) } else { number(time) };
    let value = |name: &str| reading(outcome, name).map_or_else(|| "?".to_owned(), seconds);
    let [time, driving, turning, waited] = ["time", "driving", "turning_time", "waited"].map(value);
    let spent =
        message!("shell-time", "{time} s: {driving} s driving, {turning} s turning, {waited} s waiting", time, driving, turning, waited);
    lines.add(&message!("shell-label-time", "time"), spent);
    let collisions = reading(outcome, "collisions").map_or_else(|| "?".to_owned(), |count| count.to_string());
    lines.add(&message!("shell-label-collisions", "collisions"), collisions);
    let kinds: Vec<&str> = outcome.events.iter().map(|event| say_event(outcome.planner, event.kind)).collect();
    let columns = if speaker().is_none() { 9 } else { kinds.iter().map(|kind| wide(kind)).max().unwrap_or(0) };
    for (k, (event, kind)) in outcome.events.iter().zip(kinds).enumerate() {
        let label = if k == 0 { message!("shell-label-events", "events") } else { Message::default() };
        let kind = padded(kind, columns);
        let (time, place) = (number(event.time), point(event.place));
        lines.add(&label, format!("{time:>8} s  {place:<16}  {kind}  {}", escape(&event.reason.text())));
    }
}

/// An event's name; in another language than English its title.
fn say_event<'a>(planner: &str, kind: &'a str) -> &'a str {
    let Ok(entry) = registry().planner(planner) else { return kind };
    let Some(known) = entry.events.iter().find(|known| known.name == kind) else { return kind };
    let said = say(known.title, &format!("planners.{planner}.events.{kind}.title"));
    if said == known.title { kind } else { said }
}

fn solution(outcome: &Outcome, lines: &mut Lines) {
    if let Some(tuned) = &outcome.tuned {
        // A command to repeat: all digits.
        let pairs: Vec<_> = tuned.params.iter().map(|(name, value)| format!("--set {name}={value}")).collect();
        let scene = escape(&outcome.scene);
        let command = format!("forage run {} --scene {scene} {}", tuned.planner, pairs.join(" "));
        lines.add(&message!("shell-label-tuned", "tuned"), command);
    }
    if let Some(order) = &outcome.order {
        let stops: Vec<_> = order.iter().map(usize::to_string).collect();
        lines.add(&message!("shell-label-order", "order"), stops.join(" "));
    }
    if let Some(path) = &outcome.path {
        let points: Vec<_> = path.iter().map(|&place| point(place)).collect();
        lines.add(&message!("shell-label-path", "path"), points.join(" → "));
    }
    if let Some(position) = &outcome.position {
        let numbers: Vec<_> = position.iter().map(|&x| number(x)).collect();
        lines.add(&message!("shell-label-position", "position"), format!("({})", numbers.join(", ")));
    }
}

/// Parts of a line with commas between.
fn line(parts: impl IntoIterator<Item = Message>) -> String {
    let joined = |first: Message, second: Message| message!("shell-then", "{first}, {second}", first, second);
    parts.into_iter().reduce(joined).unwrap_or_default().to_string()
}

/// That what was to arrive does not.
fn does_not_arrive() -> Message {
    message!("shell-does-not-arrive", "does NOT arrive")
}

/// How a drive went.
fn drive_line(drive: &DriveOutcome, lines: &Lines) -> String {
    let [distance, error] = [drive.distance, drive.max_error].map(|length| lines.length(length));
    let time = number(drive.time);
    let driven = message!("shell-driven", "{time} s, {distance}, cross-track error at most {error}", time, distance, error);
    let clear = match (drive.touched_at, drive.clearance) {
        (Some(place), clearance) => {
            let (place, depth) = (point(place), lines.length(-clearance.unwrap_or(0.0)));
            Some(message!("shell-drive-collides", "COLLIDES with an obstacle at {place}, at most {depth} deep", place, depth))
        }
        (None, Some(clearance)) => Some(message!("shell-clearance", "clearance {clearance}", clearance = lines.length(clearance))),
        (None, None) => None,
    };
    let arrives = (!drive.arrived).then(does_not_arrive);
    let [left, right] = drive.counts.map(|count| count.to_string());
    let counts = message!("shell-encoder-counts", "{left} / {right} encoder counts", left, right);
    line([Some(driven), clear, arrives, Some(counts)].into_iter().flatten())
}

/// How an arm's motion went.
fn motion_line(motion: &MotionOutcome) -> String {
    let MotionOutcome { time, length, largest_step, max_error, .. } = motion;
    let [time, length, step, error] = [time, length, largest_step, max_error].map(|&value| number(value));
    let moved =
        message!("shell-moved", "{time} s, {length} m, joint steps of at most {step}°, error at most {error} m", time, length, step, error);
    let free = match (motion.touched_at, motion.clearance) {
        (Some(seconds), _) => {
            let seconds = number(seconds);
            Some(message!("shell-arm-collides", "COLLIDES with a cuboid or the column after {seconds} s", seconds))
        }
        (None, Some(clearance)) => {
            let clearance = number(clearance);
            Some(message!("shell-arm-clear", "the whole arm is free, clearance {clearance} m", clearance))
        }
        (None, None) if motion.free => Some(message!("shell-arm-free", "the whole arm is free")),
        (None, None) => None,
    };
    let mirrored = (motion.mirrored > 0).then(|| message!("shell-mirrored", "{n} mirrored", n = motion.mirrored.to_string()));
    let drawn = (motion.drawn > 0).then(|| message!("shell-drawn", "{n} sampled at random", n = motion.drawn.to_string()));
    line([Some(moved), free, mirrored, drawn, (!motion.arrived).then(does_not_arrive)].into_iter().flatten())
}
