//! Trees for an arm's tip with and without a cuboid in the way, and the arm that follows their paths: [ARM-RRT](forage#papers)
//! §4.

mod run;

use std::sync::Arc;

use forage::{
    Overrides, Setup, Value, arm::ArmScene, geometry::length_in_space, kernel::Error, scene::Scene, shipped, statistics::Summary,
};

use super::{
    compared::{ComparedFigure, Computed, Published},
    failure::Failure,
    fingerprints::JobList,
    marks::Basis,
    options::{Options, command},
    report::Report,
    runner::{self, Control},
    study::Study,
    table::{Cell, Table},
};

pub(crate) use run::aside;
use run::{Run, Task};

/// See the module.
pub const REPRODUCTION: Study = Study {
    name: "arm-rrt",
    title: "trees for an arm’s tip, with and without a cuboid",
    source: "[ARM-RRT] §4",
    repeatable: true,
    jobs: |options| Ok(vec![JobList::new(FILE, tasks(options)?)]),
    run,
};

/// A measure and what of a run it is.
type Measured = (&'static str, &'static str, fn(&Run) -> Option<f64>);
/// What the paper shows in pictures, as figures: the table, the measure, the number.
const MEASURES: [Measured; 5] = [
    ("Success", "feasible runs, %", |run| Some(if run.found { 100.0 } else { 0.0 })),
    ("Success", "length, m", |run| run.length),
    ("Nodes", "nodes", |run| run.found.then_some(run.nodes as f64)),
    ("Straightness", "length of the tree’s own path, m", |run| run.raw_length),
    ("Straightness", "its largest sideways deviation, m", |run| run.raw_aside),
];

/// Seeds a cell; how many runs the paper has is not said.
const SEEDS: u64 = 100;
/// With the cuboid and without.
const SCENES: [&str; 2] = ["arm-cuboid", "arm-free"];
/// In the order in which they are shown: basic and guided first, as in the paper.
const PLANNERS: [&str; 5] = ["rrt", "rrt-guided", "rrt-connect", "rrt-star", "rrt-joint"];
const BASIC: &str = PLANNERS[0];
const JOINT: &str = PLANNERS[4];
/// Published steps of the tip, in metres.
const STEPS: [f64; 2] = [0.03, 0.05];

const FILE: &str = "arm-rrt-runs.csv";

fn tasks(options: &Options) -> Result<Vec<Task>, Error> {
    let runs = options.runs_or(SEEDS)?;
    Ok(setups()?.iter().flat_map(|setup| (1..=runs).map(|seed| Task(Setup { seed, ..setup.clone() }))).collect())
}

fn run(options: &Options, control: &Control) -> Result<Report, Failure> {
    let runs = options.runs_or(SEEDS)?;
    let setups = setups()?;
    let path = options.out.join(FILE);
    let rows = runner::run(&tasks(options)?, &path, options.fresh, options.threads, control)?;

    let mut report = REPRODUCTION.report(runs, SEEDS);
    report.shortened = (runs != SEEDS).then(|| format!("{runs} seeds a cell instead of {SEEDS}"));
    report.files.push(path);
    let free = shipped(SCENES[1])?;
    for (name, title) in SCENES.into_iter().zip(["Past the cuboid", "Without an obstacle"]) {
        let scene = shipped(name)?;
        report.tables.push(trees(&scene, title, &rows)?);
        report.tables.push(arms(&scene, title, &rows));
    }
    report.tables.push(straight(&free, &rows)?);
    report.figures = figures(&setups, &rows);
    report.notes = notes(&rows);
    report.commands = setups.iter().map(command).collect();
    report.write(options)?;
    Ok(report)
}

/// Pictures of the paper as numbers. It prints none, so there is nothing to compare them with.
fn figures(setups: &[Setup], rows: &[Run]) -> Vec<ComparedFigure> {
    let open = "the paper shows pictures; the cuboid and where the base is are reconstructions";
    let mut figures = Vec::new();
    for (table, measure, of) in MEASURES {
        for (scene, place) in SCENES.into_iter().zip(["past the cuboid", "without an obstacle"]) {
            for runs in cells(scene, rows) {
                let step = runs[0].step.map_or(String::new(), |step| format!(", step {step} m"));
                let is_it =
                    |setup: &&Setup| setup.planner == runs[0].planner && setup.scene.name() == scene && run::step(setup) == runs[0].step;
                figures.push(ComparedFigure {
                    table: format!("{table} ({place})"),
                    group: String::new(),
                    row: format!("{}{step}", runs[0].planner),
                    measure: measure.to_owned(),
                    lower_is_better: !measure.starts_with("feasible"),
                    published: Published::default(),
                    computed: Computed::runs(runs.iter().filter_map(|run| of(run))),
                    basis: Basis::Reconstruction(open),
                    source: None,
                    command: setups.iter().find(is_it).map(command).unwrap_or_default(),
                });
            }
        }
    }
    figures
}

/// Every cell, with seed 1.
fn setups() -> Result<Vec<Setup>, Error> {
    let mut setups = Vec::new();
    for scene in SCENES {
        let scene = shipped(scene)?;
        for planner in PLANNERS {
            // The paper's trees ask the tip alone.
            let given = |step: f64| Overrides::from_iter([("step_size", Value::from(step)), ("reachable", Value::Flag(false))]);
            let params = if planner == JOINT { vec![Overrides::new()] } else { STEPS.map(given).to_vec() };
            setups.extend(params.into_iter().map(|params| Setup {
                planner: planner.to_owned(),
                scene: Arc::clone(&scene),
                params,
                seed: 1,
            }));
        }
    }
    Ok(setups)
}

/// The runs of each planner and step on a scene.
fn cells<'a>(scene: &str, rows: &'a [Run]) -> Vec<Vec<&'a Run>> {
    let of = |planner: &str, step: Option<f64>| -> Vec<&Run> {
        rows.iter().filter(|run| run.scene == scene && run.planner == planner && run.step == step).collect()
    };
    let steps = |planner: &str| if planner == JOINT { vec![None] } else { STEPS.map(Some).to_vec() };
    PLANNERS.iter().flat_map(|planner| steps(planner).into_iter().map(|step| of(planner, step))).filter(|runs| !runs.is_empty()).collect()
}

fn summary(runs: &[&Run], of: impl Fn(&Run) -> Option<f64>) -> Option<Summary> {
    Summary::of(runs.iter().filter_map(|run| of(run)))
}

fn share(runs: &[&Run], of: impl Fn(&Run) -> bool) -> Cell {
    Cell::Text(format!("{} of {}", runs.iter().filter(|run| of(run)).count(), runs.len()))
}

/// The planner and its step, the first two cells of each line.
fn label(runs: &[&Run]) -> [Cell; 2] {
    [Cell::Text(runs[0].planner.clone()), Cell::maybe(runs[0].step, 2)]
}

fn straight_line(arm: &ArmScene) -> f64 {
    length_in_space(&[arm.start, arm.goal])
}

fn trees(scene: &Scene, title: &str, rows: &[Run]) -> Result<Table, Error> {
    let columns = [
        "planner",
        "step m",
        "found",
        "nodes, median",
        "nodes, mean",
        "extensions, median",
        "extensions, mean",
        "ms, median (measured)",
        "tree’s path m, mean",
        "final m, mean",
        "best",
        "worst",
        "over straight %",
        "over exact %",
    ];
    let line = straight_line(scene.get::<ArmScene>()?);
    let exact = scene.exact().map(|exact| exact.length);
    let optimum = exact.map_or(String::new(), |exact| format!(", exact optimum {exact:.4} m"));
    let mut table = Table::new(scene.name(), format!("{title}: straight line {line:.4} m{optimum}"), &columns);
    for runs in cells(scene.name(), rows) {
        let nodes = summary(&runs, |run| run.found.then_some(run.nodes as f64));
        let extensions = summary(&runs, |run| run.found.then_some(run.extensions as f64));
        let ms = summary(&runs, |run| run.found.then_some(run.measured_ms));
        let raw = summary(&runs, |run| run.raw_length);
        let length = summary(&runs, |run| run.length);
        let over = |to: f64| length.map(|length| 100.0 * (length.mean / to - 1.0));
        table.rows.push(
            label(&runs)
                .into_iter()
                .chain([
                    share(&runs, |run| run.found),
                    Cell::maybe(nodes.map(|s| s.median), 1),
                    Cell::maybe(nodes.map(|s| s.mean), 1),
                    Cell::maybe(extensions.map(|s| s.median), 1),
                    Cell::maybe(extensions.map(|s| s.mean), 1),
                    Cell::maybe(ms.map(|s| s.median), 3),
                    Cell::maybe(raw.map(|s| s.mean), 4),
                    Cell::maybe(length.map(|s| s.mean), 4),
                    Cell::maybe(length.map(|s| s.min), 4),
                    Cell::maybe(length.map(|s| s.max), 4),
                    Cell::maybe(over(line), 2),
                    Cell::maybe(exact.and_then(over), 2),
                ])
                .collect(),
        );
    }
    Ok(table)
}

fn arms(scene: &Scene, title: &str, rows: &[Run]) -> Table {
    let columns = [
        "planner",
        "step m",
        "arm reaches the goal",
        "and touches nothing",
        "largest joint step °, median",
        "largest",
        "s, mean",
        "points mirrored",
        "points drawn",
    ];
    let name = format!("{}-motion", scene.name());
    let mut table = Table::new(name, format!("{title}: the whole arm along the final path"), &columns);
    for runs in cells(scene.name(), rows) {
        let found: Vec<&Run> = runs.iter().copied().filter(|run| run.followed.is_some()).collect();
        if found.is_empty() {
            continue;
        }
        let step = summary(&found, |run| run.largest_step);
        let sum = |of: fn(&Run) -> Option<u64>| Cell::whole(found.iter().filter_map(|run| of(run)).sum());
        table.rows.push(
            label(&runs)
                .into_iter()
                .chain([
                    share(&runs, |run| run.followed == Some(true)),
                    share(&runs, |run| run.free == Some(true)),
                    Cell::maybe(step.map(|s| s.median), 2),
                    Cell::maybe(step.map(|s| s.max), 2),
                    Cell::maybe(summary(&found, |run| run.seconds).map(|s| s.mean), 2),
                    sum(|run| run.mirrored),
                    sum(|run| run.drawn),
                ])
                .collect(),
        );
    }
    table
}

/// The paper's claim, in numbers: the tree's own path, before anything is made of it.
fn straight(scene: &Scene, rows: &[Run]) -> Result<Table, Error> {
    let columns = ["planner", "step m", "length over straight %, mean", "worst", "aside m, mean", "worst", "in steps, mean"];
    let title = "Without an obstacle: how straight the tree’s own path is, and how far it is from the straight line at most";
    let mut table = Table::new("straight", title, &columns);
    let line = straight_line(scene.get::<ArmScene>()?);
    for runs in cells(scene.name(), rows) {
        let over = summary(&runs, |run| Some(100.0 * (run.raw_length? / line - 1.0)));
        let aside = summary(&runs, |run| run.raw_aside);
        let in_steps = summary(&runs, |run| Some(run.raw_aside? / run.step?));
        table.rows.push(
            label(&runs)
                .into_iter()
                .chain([
                    Cell::maybe(over.map(|s| s.mean), 2),
                    Cell::maybe(over.map(|s| s.max), 2),
                    Cell::maybe(aside.map(|s| s.mean), 4),
                    Cell::maybe(aside.map(|s| s.max), 4),
                    Cell::maybe(in_steps.map(|s| s.mean), 2),
                ])
                .collect(),
        );
    }
    Ok(table)
}

fn notes(rows: &[Run]) -> Vec<String> {
    let mut notes = vec![
        "The paper prints pictures and no numbers: no nodes, times or lengths of its own. Its workspace, start, goal and steps are used; the cuboid and where the base stands are reconstructions.".to_owned(),
        format!("All planners with their default parameters but for the step: {BASIC} without goal bias, as in the paper. Nodes, extensions and times are of runs that found a way. rrt-star goes on for all its extensions, and what it tells is of its last path; {JOINT} grows in the joints, with a step of its own in radians and the whole arm tested at each, so that only its nodes and the tip’s lengths can be compared."),
        "`over exact`: the optimum is that of the tip alone, without the arm behind it and without the column under the base, so it is a lower bound for the arm. What is handed over is shortened, fitted and smoothed: none of it in the time, which is that of the tree alone.".to_owned(),
        "How straight a guided tree can be follows from its numbers: of 20 directions drawn evenly over the sphere the 4 nearest to the goal’s have cosines of 0.90, 0.81, 0.71 and 0.62 with it in the mean (1 − 2k/21), 0.76 together, so that a way of such steps is some 1/0.76 times as long as the straight line if all 4 are as likely. More samples and fewer kept make it straighter; shortening makes it straight.".to_owned(),
        "Times are not reproducible: in the rows `measured_ms` differs from run to run and from machine to machine, the rest is computed and does not. Runs go on side by side and take each other’s time; `cargo bench --bench trees` measures well.".to_owned(),
    ];
    if cfg!(debug_assertions) {
        notes.push("This is NOT A RELEASE BUILD: one takes far less time.".to_owned());
    }
    notes.extend(failures(rows));
    notes
}

/// Every run in which something was not reached or not free, by its seed.
fn failures(rows: &[Run]) -> Vec<String> {
    let mut notes = Vec::new();
    for runs in SCENES.iter().flat_map(|scene| cells(scene, rows)) {
        let cell = format!("{}, {}{}", runs[0].scene, runs[0].planner, runs[0].step.map_or(String::new(), |step| format!(", step {step}")));
        let seeds =
            |of: &dyn Fn(&Run) -> bool| runs.iter().filter(|run| of(run)).map(|run| run.seed.to_string()).collect::<Vec<_>>().join(" ");
        for (what, seeds) in [
            ("NO WAY FOUND", seeds(&|run| !run.found)),
            ("THE ARM CANNOT FOLLOW", seeds(&|run| run.followed == Some(false))),
            ("THE ARM TOUCHES SOMETHING", seeds(&|run| run.followed == Some(true) && run.free == Some(false))),
        ] {
            if !seeds.is_empty() {
                notes.push(format!("{cell}: {what} with the seeds {seeds}."));
            }
        }
    }
    notes
}
