//! Planners from cell to cell on a grid that ships, over many seeds: what `antbat-paths` and `wolf-ant` share.

use std::{
    path::Path,
    sync::{Arc, atomic::AtomicBool},
};

use serde::{Deserialize, Serialize};

use forage::{
    Overrides, Setup,
    kernel::{Error, ReferenceOptimum, Status},
    scene::{GridScene, Scene},
    standard,
    statistics::Summary,
};

use super::{
    compared::{ComparedFigure, Computed, Published},
    failure::Failure,
    figure::Figure,
    marks::Basis,
    options::Options,
    report::Report,
    rows::KeyedRow,
    runner::{self, Control, Job},
    study::Study,
    table::{Cell, Table, Title},
};

/// Seeds a planner if no other number is given. The papers do not say how many runs their figures stand for.
pub(super) const RUNS: u64 = 30;

/// A run. What is measured of a way is missing where no feasible one was found.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct Run {
    pub planner: String,
    /// Those that are not the defaults.
    pub parameters: String,
    pub seed: u64,
    pub feasible: bool,
    /// From cell to cell.
    pub length: Option<f64>,
    pub turns: Option<f64>,
    pub turning: Option<f64>,
    /// How long the scene's robot takes, if it has a speed.
    pub seconds: Option<f64>,
    /// Without redundant nodes.
    pub smooth_length: Option<f64>,
    pub smooth_turns: Option<f64>,
    pub smooth_turning: Option<f64>,
    /// The iteration in which the result was found.
    pub converged: Option<f64>,
    /// The iteration from which the mean stays within 1 % of the best.
    pub settled: Option<f64>,
    pub evaluations: u64,
    /// The iterations in which something better was found, with its length: `1:44.5 7:42.1`.
    pub improved: String,
}

impl KeyedRow for Run {
    fn key(&self) -> String {
        key(&self.planner, &self.parameters, self.seed)
    }
}

fn key(planner: &str, parameters: &str, seed: u64) -> String {
    format!("{planner}, {parameters}, seed {seed}")
}

fn parameters(setup: &Setup) -> String {
    setup.params.iter().map(|(name, value)| format!("{name}={value}")).collect::<Vec<_>>().join(" ")
}

impl Run {
    /// The best length after each of so many iterations; `None` as long as there is none.
    pub fn curve(&self, iterations: u64) -> Vec<Option<f64>> {
        let pair = |text: &str| text.split_once(':').and_then(|(at, length)| Some((at.parse::<u64>().ok()?, length.parse::<f64>().ok()?)));
        let improved: Vec<_> = self.improved.split_whitespace().filter_map(pair).collect();
        (1..=iterations).map(|k| improved.iter().rev().find(|(at, _)| *at <= k).map(|(_, length)| *length)).collect()
    }
}

/// How long the scene's robot takes for a way, [WOLF-ANT](forage#papers) §5.3: at its speed, and for each turn on the spot.
pub(super) fn seconds(scene: &Scene, length: f64, turns: f64) -> Option<f64> {
    let robot = scene.get::<GridScene>().ok()?.robot?;
    Some(length / robot.speed? + turns * robot.turn_time.unwrap_or(0.0))
}

pub(super) struct Task(Setup);

impl Job for Task {
    type Row = Run;

    fn key(&self) -> String {
        key(&self.0.planner, &parameters(&self.0), self.0.seed)
    }

    fn run(&self, _stop: &AtomicBool) -> Result<Option<Run>, Error> {
        let mut run = forage::Run::with_keyframes(standard(), self.0.clone(), 0)?;
        let (mut best, mut improved) = (f64::INFINITY, Vec::new());
        while run.status() == Status::Running {
            run.step(1);
            let now = run.readings().get("best").unwrap_or(f64::INFINITY);
            if now < best {
                best = now;
                improved.push(format!("{}:{best}", run.iteration()));
            }
        }
        let outcome = run.outcome();
        let reading = |name: &str| outcome.readings.iter().find(|(n, _)| *n == name).map(|(_, value)| *value).filter(|_| outcome.feasible);
        let length = outcome.length.filter(|_| outcome.feasible);
        let turns = outcome.turns.filter(|_| outcome.feasible).map(|turns| turns as f64);
        Ok(Some(Run {
            planner: self.0.planner.clone(),
            parameters: parameters(&self.0),
            seed: self.0.seed,
            feasible: outcome.feasible,
            length,
            turns,
            turning: outcome.turning.filter(|_| outcome.feasible),
            seconds: length.zip(turns).and_then(|(length, turns)| seconds(&self.0.scene, length, turns)),
            smooth_length: reading("smooth_length"),
            smooth_turns: reading("smooth_turns"),
            smooth_turning: reading("smooth_turning"),
            converged: reading("converged"),
            settled: reading("settled").filter(|iteration| iteration.is_finite()),
            evaluations: outcome.evaluations,
            improved: improved.join(" "),
        }))
    }
}

/// A planner with the parameters that its paper prints, and these.
pub(super) fn published(planner: &str, scene: &Arc<Scene>, params: &Overrides) -> Result<Setup, Error> {
    let entry = standard().planner(planner)?;
    let mut all = if entry.presets.is_empty() { Overrides::new() } else { entry.preset("paper", scene.kind())? };
    params.iter().for_each(|(name, value)| all.insert(name, value.clone()));
    Ok(Setup { planner: planner.to_owned(), scene: Arc::clone(scene), params: all, seed: 1 })
}

/// Each setup with the seeds 1 to `runs`.
pub(super) fn tasks(setups: &[Setup], runs: u64) -> Vec<Task> {
    setups.iter().flat_map(|setup| (1..=runs).map(|seed| Task(Setup { seed, ..setup.clone() }))).collect()
}

/// The runs of [`tasks`], a list for each setup.
pub(super) fn carry_out(setups: &[Setup], runs: u64, file: &Path, options: &Options, control: &Control) -> Result<Vec<Vec<Run>>, Failure> {
    let rows = runner::run(&tasks(setups, runs), file, options.fresh, options.threads, control)?;
    Ok(rows.chunks(runs as usize).map(<[Run]>::to_vec).collect())
}

/// What is measured of a run.
#[derive(Clone, Copy)]
pub(super) struct Measure {
    pub name: &'static str,
    pub digits: usize,
    pub of: fn(&Run) -> Option<f64>,
    /// The optimum that it can reach.
    pub optimum: Option<ReferenceOptimum>,
}

pub(super) const LENGTH: Measure = Measure { name: "length", digits: 4, of: |run| run.length, optimum: Some(ReferenceOptimum::Cells) };
pub(super) const TURNS: Measure = Measure { name: "turns", digits: 2, of: |run| run.turns, optimum: None };
pub(super) const TURNING: Measure = Measure { name: "turning", digits: 3, of: |run| run.turning, optimum: None };
pub(super) const CONVERGED: Measure = Measure { name: "converged", digits: 2, of: |run| run.converged, optimum: None };
pub(super) const SETTLED: Measure = Measure { name: "settled", digits: 2, of: |run| run.settled, optimum: None };
pub(super) const SECONDS: Measure = Measure { name: "seconds", digits: 4, of: |run| run.seconds, optimum: None };
pub(super) const SMOOTH_LENGTH: Measure =
    Measure { name: "length, smoothed", digits: 4, of: |run| run.smooth_length, optimum: Some(ReferenceOptimum::AnyAngle) };
pub(super) const SMOOTH_TURNS: Measure = Measure { name: "turns, smoothed", digits: 2, of: |run| run.smooth_turns, optimum: None };
pub(super) const SMOOTH_TURNING: Measure = Measure { name: "turning, smoothed", digits: 3, of: |run| run.smooth_turning, optimum: None };

impl Measure {
    /// A published figure and the computed one.
    pub fn compared(&self, table: &str, row: &str, figure: Figure, runs: &[Run], open: &'static str, command: String) -> ComparedFigure {
        ComparedFigure {
            table: table.to_owned(),
            group: String::new(),
            row: row.to_owned(),
            measure: self.name.to_owned(),
            lower_is_better: true,
            published: Published::figure(figure),
            computed: Computed::runs(runs.iter().filter_map(self.of)),
            basis: Basis::Reconstruction(open),
            source: None,
            command,
        }
    }

    pub fn summary(&self, runs: &[Run]) -> Option<Summary> {
        Summary::of(runs.iter().filter_map(self.of))
    }
}

/// How many of the runs have a length that is the optimum, up to the order in which steps are added.
pub(super) fn hits(runs: &[Run], of: fn(&Run) -> Option<f64>, optimum: f64) -> usize {
    runs.iter().filter_map(of).filter(|length| (length - optimum).abs() < 1e-12 * optimum).count()
}

const COLUMNS: [&str; 10] = ["planner", "of", "published", "mean", "std", "best", "worst", "exact", "hits", "gap %"];

/// A table with a line for every planner and measure.
pub(super) struct Lines<'a> {
    pub scene: &'a Arc<Scene>,
    pub table: Table,
}

impl<'a> Lines<'a> {
    pub fn new(scene: &'a Arc<Scene>, name: &str, title: impl Title) -> Self {
        Self { scene, table: Table::new(name, title, &COLUMNS) }
    }

    /// A line.
    pub fn push(&mut self, label: &str, measure: &Measure, published: Option<Figure>, runs: &[Run]) {
        let summary = measure.summary(runs);
        let exact = measure.optimum.and_then(|reference| self.scene.optimum(reference));
        let number = |of: fn(&Summary) -> f64| Cell::maybe(summary.as_ref().map(of), measure.digits);
        let gap = summary.zip(exact).map(|(summary, exact)| 100.0 * (summary.mean - exact) / exact);
        self.table.rows.push(vec![
            label.into(),
            measure.name.into(),
            published.map_or(Cell::Empty, |figure| Cell::Number(figure.value, figure.digits)),
            number(|s| s.mean),
            Cell::maybe(summary.and_then(|s| s.std), measure.digits),
            number(|s| s.min),
            number(|s| s.max),
            Cell::maybe(exact, measure.digits),
            exact.map_or(Cell::Empty, |exact| Cell::Text(format!("{} of {}", hits(runs, measure.of, exact), runs.len()))),
            // A sum in another order is no gap, and no negative zero.
            Cell::maybe(gap.map(|gap| if gap.abs() < 1e-10 { 0.0 } else { gap }), 2),
        ]);
    }
}

/// What both reports say of their tables.
pub(super) fn notes(runs: &[Vec<Run>]) -> Vec<String> {
    let all = || runs.iter().flatten();
    let failed = all().filter(|run| !run.feasible).count();
    vec![
        "The published turns and iterations are whole numbers, so the figures seem to be of single runs; how many runs there were is not said.".to_owned(),
        "`converged`: the iteration in which the result was found, by one lucky ant perhaps. `settled`: the iteration from which the mean of the ants stays within 1 % of their best; runs that never settle are left out. The paper does not say which it means, so the published figure is compared with both; statements about convergence use `settled` too.".to_owned(),
        "The layout of the obstacles is a reconstruction: the paper prints none. `hits`: runs whose result is as long as the exact optimum, over cells for `length`, at any angle for `length, smoothed`; the gap is that of the mean. Smoothed means without the nodes whose neighbours see each other.".to_owned(),
        match failed {
            0 => "All runs are feasible.".to_owned(),
            failed => format!("{failed} of {} runs FOUND NO FEASIBLE WAY; the tables leave them out.", all().count()),
        },
    ]
}

/// A report over so many seeds.
pub(super) fn report(reproduction: &Study, runs: u64) -> Report {
    let mut report = reproduction.report(runs, RUNS);
    report.shortened = (runs != RUNS).then(|| format!("{runs} seeds a planner instead of {RUNS}"));
    report
}
