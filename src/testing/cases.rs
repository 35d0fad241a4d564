//! Cases show something: a run in which there is something to find, and in which it is not found at once.

use crate::{
    describe::Case,
    kernel::Exact,
    run::{Run, Setup},
    scene::grid::GridScene,
};

use super::{
    entry::{placeholders, wrong_values},
    fault::{Checked, Fault, ensure},
    findings::Findings,
    subject::Subject,
};

const CASES: &str =
    "Let a case name a shipped scene that the planner runs on, and parameters with allowed values that differ from the defaults.";
const STRAIGHT: &str = "Show a case on a scene that the straight line does not solve.";
const AT_ONCE: &str = "Show a case in which the optimum is not there after the first iteration.";
const WORDS: &str = "Give each case its own name, a title and what there is to see.";
const PSEUDOCODE: &str =
    "In pseudocode name readings or parameters by `@name@`, close each `$`, and indent by two spaces a level, one level at a time.";

pub fn show_something(subject: &Subject, findings: &mut Findings) {
    findings.look(pseudocode(subject));
    let cases = subject.entry.cases;
    for (at, case) in cases.iter().enumerate() {
        let own = cases[..at].iter().all(|other| other.name != case.name);
        findings.look(ensure(own && !case.title.is_empty() && !case.help.is_empty(), WORDS, || format!("the case `{}`", case.name)));
        let scene = match subject.registry.scene(case.scene) {
            Ok(scene) => scene,
            Err(error) => {
                findings.look(Err(Fault::new(CASES, format!("the case `{}`: {error}", case.name))));
                continue;
            }
        };
        for problem in wrong_values(subject.entry, &case.given()) {
            findings.look(Err(Fault::new(CASES, format!("the case `{}`: {problem}", case.name))));
        }
        let setup = Setup { planner: subject.entry.name.to_owned(), scene, params: case.given(), seed: case.seed };
        findings.watch(&setup, || shows(case, &mut subject.start(&setup)?));
    }
}

fn shows(case: &Case, run: &mut Run) -> Checked {
    // Where obstacles move, the way is one thing and the time another.
    let still = run.scene().get::<GridScene>().map_or(true, |grid| grid.moving.is_empty());
    ensure(!still || !run.exact().is_some_and(is_straight), STRAIGHT, || {
        format!("the case `{}`: the shortest path is a straight line", case.name)
    })?;
    run.step(1);
    let outcome = run.outcome();
    let there = match run.scene().minimum() {
        Some(minimum) => outcome.cost.is_some_and(|cost| cost - minimum.value < 1e-9),
        None => outcome.feasible && outcome.gap.is_some_and(|gap| gap < 1e-9),
    };
    ensure(!there, AT_ONCE, || format!("the case `{}`: iteration 1 has the optimum", case.name))
}

/// Whether it is as long as the straight line between its ends. A tour that comes back is not.
fn is_straight(exact: &Exact) -> bool {
    let flat = || exact.path.iter().map(|&[x, y]| [x, y, 0.0]);
    let corners: Vec<_> = if exact.tip_path.is_empty() { flat().collect() } else { exact.tip_path.clone() };
    let [Some(from), Some(to)] = [corners.first(), corners.last()] else { return false };
    let apart = from.iter().zip(to).map(|(from, to)| (to - from) * (to - from)).sum::<f64>().sqrt();
    exact.length <= apart * (1.0 + 1e-9)
}

fn pseudocode(subject: &Subject) -> Checked {
    let entry = subject.entry;
    let mut level = 0;
    for line in entry.pseudocode {
        let spaces = line.len() - line.trim_start().len();
        let named = placeholders(line).all(|name| entry.parameter(name).is_some() || entry.readings.iter().any(|of| of.name == name));
        let closed = line.matches('$').count() % 2 == 0 && line.matches('@').count() % 2 == 0;
        ensure(named && closed && spaces % 2 == 0 && spaces / 2 <= level + 1, PSEUDOCODE, || format!("the line `{line}`"))?;
        level = spaces / 2;
    }
    Ok(())
}
