//! What a run reports as its result, and how it ends.

use crate::{
    arm::ArmScene,
    kernel::{Candidate, ReferenceOptimum, Scene, Solution, Status},
    run::Run,
    scene::FunctionScene,
};

use super::{
    fault::{Checked, Fault, ensure},
    findings::Findings,
    subject::{Subject, goes_on},
};

const KEEP_BEST: &str =
    "Keep the best solution in the state, and replace it only by one with a lower cost, or an infeasible one by a feasible one.";
const COUNT: &str = "Count every evaluation in the state, and never take one back.";
const COST: &str = "Report a finite cost, or no solution yet: `best` returns `None`.";
const KIND: &str =
    "Report a solution of the scene's kind: a path where there is a goal, a tour where there are stops, a position on a function.";
const FINITE: &str = "Report finite coordinates only.";
const ENDS: &str = "Let a path have at least two corners, the scene's start first and its goal last, to the last bit.";
const TOUR: &str = "Let a tour's order have each stop once, with the ends that it declares, and its path lead through them.";
const INSIDE: &str = "Report a position with one coordinate for each variable, within the function's box.";
const FEASIBLE: &str = "End with `Status::Solved` only if the best solution is feasible (`scene.judge`), and with `Status::Infeasible` only if it is not; with `Status::Failed` give the reason.";
const EXACT: &str = "Declare the optimum that results are measured against by `Started::measured_by`: none can be shorter.";
const OPTIMAL: &str = "Declare by `Entry::exact` only those parameters with which a run that ends by itself has the exact optimum.";
const LIMIT: &str = "Use the value of `iterations` as the limit in `Started::new`, and never return `Progress::Done(Status::Running)`.";
const OPEN: &str = "Declare by `Started::open_ended` that a run may end before its limit.";
const FAILURE: &str = "Give the reason for having no result as a sentence without a full stop.";

/// So much shorter than the optimum a result may be by rounding.
const ROUNDING: f64 = 1e-9;

/// Steps through a run, and looks at it before the first step and after each.
fn each_step(run: &mut Run, mut look: impl FnMut(&mut Run) -> Checked) -> Checked {
    loop {
        look(run).map_err(|fault| fault.at(run.iteration()))?;
        if !goes_on(run) {
            return Ok(());
        }
        run.step(1);
    }
}

pub fn only_better(subject: &Subject, findings: &mut Findings) {
    findings.watch_random(subject, 40, |setup, _| {
        let mut run = subject.start(setup)?;
        let (mut least, mut most): (Option<Candidate>, _) = (None, 0);
        each_step(&mut run, |run| {
            let now = run.best();
            if let Some(now) = &now {
                ensure(now.cost.is_finite(), COST, || format!("the best cost is {}", now.cost))?;
            }
            ensure(now.is_some() || least.is_none(), KEEP_BEST, || "the best solution is gone".to_owned())?;
            if let (Some(now), Some(before)) = (&now, &least) {
                let feasible = |candidate: &Candidate| run.scene().judge(&candidate.solution).feasible;
                let better = now.cost <= before.cost || (feasible(now) && !feasible(before));
                ensure(better, KEEP_BEST, || format!("the best cost rises from {} to {}", before.cost, now.cost))?;
            }
            let evaluations = run.evaluations();
            ensure(evaluations >= most, COUNT, || format!("evaluations fall from {most} to {evaluations}"))?;
            (least, most) = (now, evaluations);
            Ok(())
        })
    });
}

pub fn honest(subject: &Subject, findings: &mut Findings) {
    findings.watch_random(subject, 40, |setup, _| {
        let mut run = subject.start(setup)?;
        let mut judged = None;
        each_step(&mut run, |run| {
            let Some(best) = run.best() else { return Ok(()) };
            if judged == Some(best.cost) {
                return Ok(());
            }
            judged = Some(best.cost);
            solution(subject.entry.stops, run.scene(), &best)
        })?;
        end(&mut run).map_err(|fault| fault.at(run.iteration()))
    });
}

/// A solution is one of the scene.
fn solution(stops: bool, scene: &Scene, best: &Candidate) -> Checked {
    let wrong = |what: &str| Err(Fault::new(KIND, format!("on a scene of kind {} the solution is {what}", scene.kind().name())));
    if let Ok(function) = scene.get::<FunctionScene>() {
        let Solution::Position(position) = &best.solution else { return wrong("no position") };
        let (low, high) = (function.search_box().low(), function.search_box().high());
        let inside =
            position.len() == low.len() && position.iter().zip(low.iter().zip(high)).all(|(x, (low, high))| (low..=high).contains(&x));
        return ensure(inside, INSIDE, || format!("the position is {position:?}, in a box from {low:?} to {high:?}"));
    }
    if let Ok(arm) = scene.get::<ArmScene>() {
        let Solution::Reach { path, .. } = &best.solution else { return wrong("no path of the tip") };
        ensure(path.iter().flatten().all(|x| x.is_finite()), FINITE, || "a corner of the path is not finite".to_owned())?;
        let near = |a: Option<&[f64; 3]>, b: [f64; 3]| a.is_some_and(|a| (0..3).all(|axis| (a[axis] - b[axis]).abs() < 1e-6));
        return ensure(near(path.first(), arm.start) && near(path.last(), arm.goal), ENDS, || {
            format!("the tip's path goes from {:?} to {:?}", path.first(), path.last())
        });
    }
    if stops {
        return tour(scene, &best.solution).unwrap_or_else(|| wrong("no tour"));
    }
    let Some((start, goal)) = scene.ends() else { return Ok(()) };
    let (Solution::Path(_) | Solution::Drive(_), Some(path)) = (&best.solution, best.solution.path()) else { return wrong("no path") };
    ensure(path.iter().flatten().all(|x| x.is_finite()), FINITE, || "a corner of the path is not finite".to_owned())?;
    ensure(path.len() > 1 && path[0] == start && path[path.len() - 1] == goal, ENDS, || match path {
        [] => "the path is empty".to_owned(),
        [first, .., last] => format!("the path goes from {first:?} to {last:?}, the scene's from {start:?} to {goal:?}"),
        [only] => format!("the path is one point, {only:?}"),
    })
}

/// A tour visits each stop once; `None` for another kind of solution.
fn tour(scene: &Scene, solution: &Solution) -> Option<Checked> {
    let Solution::Tour { order, ends, path } = solution else { return None };
    let stops = scene.stops();
    Some(ensure(ends.allows(order, stops.len()), TOUR, || format!("the order of {} stops is {order:?}, {ends:?}", stops.len())).and_then(
        |()| {
            let first = order.first().map(|&stop| stops[stop]);
            let last = if ends.closes() { first } else { order.last().map(|&stop| stops[stop]) };
            ensure(path.first().copied() == first && path.last().copied() == last, TOUR, || {
                format!("the tour's path goes from {:?} to {:?}, its stops from {first:?} to {last:?}", path.first(), path.last())
            })
        },
    ))
}

/// What a run says of its result at its end.
fn end(run: &mut Run) -> Checked {
    let outcome = run.outcome();
    let found = outcome.feasible && outcome.cost.is_some();
    // A drive is over when the robot is there, whatever it touched.
    let drives = run.best().is_some_and(|best| matches!(best.solution, Solution::Drive(_)));
    let right = match outcome.status {
        Status::Solved => found || drives,
        Status::Infeasible => !found,
        Status::Running | Status::Exhausted => true,
        Status::Failed => outcome.failure.is_some(),
    };
    ensure(right, FEASIBLE, || {
        format!("the run ends as {:?}, and its result is {}feasible", outcome.status, if found { "" } else { "not " })
    })?;
    let gap = outcome.gap.filter(|_| found && outcome.exact_by != ReferenceOptimum::Refuted).unwrap_or(0.0);
    ensure(gap > -ROUNDING, EXACT, || {
        format!("the length is {}, below the exact optimum {}", outcome.length.unwrap_or(f64::NAN), outcome.exact.unwrap_or(f64::NAN))
    })?;
    let failure = outcome.failure.as_ref().map_or("none".into(), |failure| failure.text());
    ensure(!failure.is_empty() && !failure.ends_with('.'), FAILURE, || format!("the reason is \"{failure}\""))
}

pub fn ends(subject: &Subject, findings: &mut Findings) {
    const ITERATIONS: u64 = 40;
    findings.watch_random(subject, ITERATIONS, |setup, _| {
        let mut run = subject.start(setup)?;
        let (limit, staged, known) = (run.limit(), !run.stages().is_empty(), run.end());
        // What has stages counts its iterations in one of them; what cannot need as many has a lower limit.
        ensure(limit <= ITERATIONS || staged, LIMIT, || format!("the limit is {limit} where `iterations` is {ITERATIONS}"))?;
        for _ in 0..=limit {
            run.step(1);
        }
        let (at, status) = (run.iteration(), run.status());
        ensure(at <= limit && status != Status::Running, LIMIT, || format!("after {at} steps it is {status:?}, with a limit of {limit}"))
            .and_then(|()| ensure(known.is_none_or(|end| end == at), OPEN, || format!("it ends at iteration {at} of {limit}")))
            .map_err(|fault| fault.at(at))
    });
}

/// Where the entry says that the optimum is found, a run that ends by itself has it.
pub fn exact(subject: &Subject, findings: &mut Findings) {
    findings.watch_random(subject, 2_000, |setup, _| {
        let mut run = subject.start(setup)?;
        if !(subject.entry.exact)(run.parameters()) {
            return Ok(());
        }
        while goes_on(&run) {
            run.step(1);
        }
        if run.status() == Status::Exhausted {
            return Ok(());
        }
        let optimum = run.exact().map(|exact| exact.length);
        let found = run.outcome().length;
        let is_it = match (found, optimum) {
            (Some(found), Some(optimum)) => (found - optimum).abs() <= ROUNDING * optimum.max(1.0),
            (None, optimum) => optimum.is_none(),
            // Larger than what is solved exactly.
            (Some(_), None) => true,
        };
        ensure(is_it, OPTIMAL, || format!("it ends with {found:?}, the optimum is {optimum:?}")).map_err(|fault| fault.at(run.iteration()))
    });
}
