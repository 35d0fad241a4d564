//! The result of a run for people. `--json` has all digits.

use std::fmt::{Display, Write as _};

use forage::{
    Outcome, Status,
    follow::{drive::DriveOutcome, motion::MotionOutcome},
    kernel::ReferenceOptimum,
};

use crate::text::{escape, measured, number, point};

/// Lines with a label each.
struct Lines {
    text: String,
    unit: String,
}

impl Lines {
    fn add(&mut self, label: &str, value: impl Display) {
        // Writing to a string cannot fail.
        let _ = writeln!(self.text, "  {label:<10} {value}");
    }

    fn length(&self, length: f64) -> String {
        measured(length, &self.unit)
    }
}

/// The result in lines; `unit` is that of lengths.
pub(super) fn summary(outcome: &Outcome, unit: &str, elapsed_ms: f64) -> String {
    let time = if elapsed_ms < 1e3 { measured(elapsed_ms, "ms") } else { measured(elapsed_ms / 1e3, "s") };
    let heading = format!(
        "{} on {}, seed {}: {} after {} iterations, {} evaluations, {time}\n",
        outcome.planner,
        escape(&outcome.scene),
        outcome.seed,
        status(outcome.status),
        outcome.iterations,
        outcome.evaluations
    );
    let mut lines = Lines { text: heading, unit: escape(unit).into_owned() };
    cost(outcome, &mut lines);
    optimum(outcome, &mut lines);
    feasibility(outcome, &mut lines);
    if let Some(drive) = outcome.followed.get::<DriveOutcome>() {
        lines.add("drive", drive_line(drive, &lines));
    }
    if let Some(motion) = outcome.followed.get::<MotionOutcome>() {
        lines.add("motion", motion_line(motion));
        if let Some(failure) = &motion.failure {
            lines.add("", escape(&failure.text()));
        }
    }
    events(outcome, &mut lines);
    solution(outcome, &mut lines);
    if !outcome.hash.is_empty() {
        lines.add("hash", &outcome.hash);
    }
    lines.text
}

/// A status for people.
fn status(status: Status) -> &'static str {
    match status {
        Status::Running => "running",
        Status::Solved => "solved",
        Status::Exhausted => "completed",
        Status::Infeasible => "infeasible",
        Status::Failed => "failed",
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
            let raw = raw.map_or(String::new(), |raw| format!(" ({} before smoothing)", lines.length(raw)));
            lines.add("length", format!("{}{raw}", lines.length(length)));
            if let (Some(turns), Some(turning)) = (outcome.turns, outcome.turning) {
                lines.add("turns", format!("{turns}, {} in total", degrees(turning)));
            }
            let smooth = ["smooth_length", "smooth_turns", "smooth_turning"].map(|name| reading(outcome, name));
            if let [Some(length), Some(turns), Some(turning)] = smooth {
                let length = lines.length(length);
                lines.add("smoothed", format!("{length}, {turns} turns, {} in total, without redundant nodes", degrees(turning)));
            }
            if let Some(converged) = reading(outcome, "converged") {
                // The mean of several colonies need not be whole.
                let iteration = if converged.fract() == 0.0 { converged.to_string() } else { number(converged) };
                lines.add("converged", format!("in iteration {iteration}"));
            }
        }
        (None, Some(cost)) => lines.add("cost", number(cost)),
        (None, None) => lines.add("result", "nothing found"),
    }
}

fn optimum(outcome: &Outcome, lines: &mut Lines) {
    // No more than rounding: the same pieces added in another order.
    let percent = |gap: f64| {
        let gap = if gap.abs() < 1e-12 { 0.0 } else { gap };
        let sign = if gap > 0.0 { "+" } else { "" };
        format!("gap {sign}{} %", number(gap * 100.0))
    };
    if let Some(exact) = outcome.exact {
        let gap = outcome.gap.map_or(String::new(), |gap| format!(" ({})", percent(gap)));
        let by = match outcome.exact_by {
            ReferenceOptimum::Cells => ", from cell to cell",
            ReferenceOptimum::Stored => ", stated in the scene file",
            ReferenceOptimum::AnyAngle | ReferenceOptimum::Matrix | ReferenceOptimum::Refuted => "",
        };
        let exact = if outcome.length.is_some() { lines.length(exact) } else { number(exact) };
        lines.add("optimum", format!("{exact}{by}{gap}"));
    }
    let by_road = reading(outcome, "by_road").filter(|by_road| by_road.is_finite());
    if let (Some(by_road), Some(length)) = (by_road, outcome.length) {
        let gap = percent((length - by_road) / by_road);
        lines.add("best tour", format!("{} with these paths between stops ({gap})", lines.length(by_road)));
    }
    if outcome.exact_by == ReferenceOptimum::Refuted {
        lines.add("optimum", "this result is better than the optimum stated in the scene file");
    }
}

fn feasibility(outcome: &Outcome, lines: &mut Lines) {
    if let Some(failure) = &outcome.failure {
        lines.add("failure", escape(&failure.text()));
    }
    let clearance = outcome.clearance.map(|clearance| lines.length(clearance.abs()));
    match (outcome.clearance, clearance) {
        (Some(_), Some(distance)) if outcome.feasible => lines.add("feasible", format!("yes, clearance {distance}")),
        (Some(clearance), Some(depth)) if clearance < 0.0 => lines.add("feasible", format!("NO, it cuts {depth} into an obstacle")),
        _ if outcome.tip_path.is_some() && !outcome.feasible => {
            lines.add("feasible", "NO, it collides, leaves the workspace or does not join start and goal");
        }
        _ if outcome.path.is_some() && !outcome.feasible => {
            lines.add("feasible", "NO, it leaves the scene or does not join start and goal");
        }
        // There is nothing to keep clear of.
        _ if outcome.feasible && outcome.length.is_some() => lines.add("feasible", "yes"),
        _ => {}
    }
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
    lines.add("time", format!("{time} s: {driving} s driving, {turning} s turning, {waited} s waiting"));
    lines.add("collisions", reading(outcome, "collisions").map_or_else(|| "?".to_owned(), |count| count.to_string()));
    for (k, event) in outcome.events.iter().enumerate() {
        let (label, time) = (if k == 0 { "events" } else { "" }, number(event.time));
        lines.add(label, format!("{time:>8} s  {:<16}  {:<9}  {}", point(event.place), event.kind, escape(&event.reason.text())));
    }
}

fn solution(outcome: &Outcome, lines: &mut Lines) {
    if let Some(tuned) = &outcome.tuned {
        // A command to repeat: all digits.
        let pairs: Vec<_> = tuned.params.iter().map(|(name, value)| format!("--set {name}={value}")).collect();
        let scene = escape(&outcome.scene);
        lines.add("tuned", format!("forage run {} --scene {scene} {}", tuned.planner, pairs.join(" ")));
    }
    if let Some(order) = &outcome.order {
        let stops: Vec<_> = order.iter().map(usize::to_string).collect();
        lines.add("order", stops.join(" "));
    }
    if let Some(path) = &outcome.path {
        let points: Vec<_> = path.iter().map(|&place| point(place)).collect();
        lines.add("path", points.join(" → "));
    }
    if let Some(position) = &outcome.position {
        let numbers: Vec<_> = position.iter().map(|&x| number(x)).collect();
        lines.add("position", format!("({})", numbers.join(", ")));
    }
}

/// How a drive went.
fn drive_line(drive: &DriveOutcome, lines: &Lines) -> String {
    let [distance, error] = [drive.distance, drive.max_error].map(|length| lines.length(length));
    let mut text = format!("{} s, {distance}, cross-track error at most {error}", number(drive.time));
    match (drive.touched_at, drive.clearance) {
        (Some(place), clearance) => {
            let depth = lines.length(-clearance.unwrap_or(0.0));
            let _ = write!(text, ", COLLIDES with an obstacle at {}, at most {depth} deep", point(place));
        }
        (None, Some(clearance)) => {
            let _ = write!(text, ", clearance {}", lines.length(clearance));
        }
        (None, None) => {}
    }
    if !drive.arrived {
        text.push_str(", does NOT arrive");
    }
    let [left, right] = drive.counts;
    let _ = write!(text, ", {left} / {right} encoder counts");
    text
}

/// How an arm's motion went.
fn motion_line(motion: &MotionOutcome) -> String {
    let MotionOutcome { time, length, largest_step, max_error, .. } = motion;
    let [time, length, step, error] = [time, length, largest_step, max_error].map(|&value| number(value));
    let mut text = format!("{time} s, {length} m, joint steps of at most {step}°, error at most {error} m");
    match (motion.touched_at, motion.clearance) {
        (Some(seconds), _) => {
            let _ = write!(text, ", COLLIDES with a cuboid or the column after {} s", number(seconds));
        }
        (None, Some(clearance)) => {
            let _ = write!(text, ", the whole arm is free, clearance {} m", number(clearance));
        }
        (None, None) if motion.free => text.push_str(", the whole arm is free"),
        (None, None) => {}
    }
    for (replaced, how) in [(motion.mirrored, "mirrored"), (motion.drawn, "sampled at random")] {
        if replaced > 0 {
            let _ = write!(text, ", {replaced} {how}");
        }
    }
    if !motion.arrived {
        text.push_str(", does NOT arrive");
    }
    text
}
