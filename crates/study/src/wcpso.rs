//! Four swarms on five functions, and two of them among seven discs: [WCPSO](forage#papers) Table 2 and §3.2.

use std::sync::atomic::AtomicBool;

use serde::{Deserialize, Serialize};

use forage::{
    Overrides, Setup, Trial, Value,
    kernel::Error,
    run::trial::WITHIN,
    shipped, standard,
    statistics::{Group, Summary, compare},
};

use super::{
    compared::{ComparedFigure, Computed, Printed, Published},
    failure::Failure,
    fingerprints::JobList,
    marking,
    marks::Basis,
    options::{Options, command},
    published::wcpso::{self as published, PATH_RUNS, PLANNERS, SHORTEST, TABLE_2},
    report::Report,
    rows::KeyedRow,
    runner::{self, Control, Job},
    study::Study,
    table::{Cell, Table},
};

/// See the module.
pub const FUNCTIONS: Study = Study {
    name: "wcpso-functions",
    title: "four swarms on five functions",
    source: "[WCPSO] Table 2",
    repeatable: true,
    jobs: |options| Ok(vec![JobList::new(FUNCTIONS_FILE, function_tasks(options)?)]),
    run: functions,
};

/// The same table with parameters that were chosen by it.
pub const FITTED: Study = Study {
    name: "wcpso-fitted",
    title: "the four swarms with parameters chosen by the table",
    source: "[WCPSO] Table 2",
    repeatable: true,
    jobs: |options| Ok(vec![JobList::new(FITTED_FILE, fitted_tasks(options)?)]),
    run: fitted,
};

/// See the module.
pub const PATHS: Study = Study {
    name: "wcpso-paths",
    title: "wcpso against wpso among seven discs",
    source: "[WCPSO] §3.2",
    repeatable: true,
    jobs: |options| Ok(vec![JobList::new(PATHS_FILE, path_tasks(options)?)]),
    run: paths,
};

/// The planners of the path experiment.
const RIVALS: [&str; 2] = ["wcpso", "wpso"];
/// So near to the exact optimum a path is found.
const NEAR: f64 = 0.005;

/// `pso` as it gives f1 and f2 of the table.
const PSO_FITTED: [(&str, &str); 6] =
    [("w", "1"), ("c1", "1.49445"), ("c2", "1.49445"), ("v_max", "1"), ("v_max_unit", "absolute"), ("random", "particle")];

const OPEN: &str = "the paper prints no coefficients for pso";
/// Below this f5 is rounding: cosines and exponentials of its order of 1 are added and taken from each other.
const ROUNDING: f64 = 1e-14;

/// A run.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct Run {
    scene: String,
    planner: String,
    /// The limit of velocities, as a share of the box.
    v_max: Option<f64>,
    seed: u64,
    value: Option<f64>,
    /// What the planner minimised, whether the result is feasible or not.
    cost: Option<f64>,
    feasible: bool,
    gap: Option<f64>,
    clearance: Option<f64>,
    /// Evaluations until within 1 % of the exact optimum; of a function within 0.01.
    reached: Option<u64>,
    evaluations: u64,
}

impl KeyedRow for Run {
    fn key(&self) -> String {
        key(&self.scene, &self.planner, self.v_max, self.seed)
    }
}

fn key(scene: &str, planner: &str, v_max: Option<f64>, seed: u64) -> String {
    format!("{scene}, {planner}, v_max {v_max:?}, seed {seed}")
}

struct Task {
    setup: Setup,
    v_max: Option<f64>,
}

impl Task {
    fn new(scene: &str, planner: &str, v_max: Option<f64>, seed: u64) -> Result<Self, Error> {
        let params = v_max.map(|v_max| ("v_max", Value::Number(v_max))).into_iter().collect::<Overrides>();
        Ok(Self { setup: Setup { planner: planner.to_owned(), scene: shipped(scene)?, params, seed }, v_max })
    }
}

impl Job for Task {
    type Row = Run;

    fn key(&self) -> String {
        key(self.setup.scene.name(), &self.setup.planner, self.v_max, self.setup.seed)
    }

    fn run(&self, _stop: &AtomicBool) -> Result<Option<Run>, Error> {
        let mut trial = Trial::new(standard(), self.setup.clone(), WITHIN)?;
        trial.step(u64::MAX);
        let record = trial.record();
        Ok(Some(Run {
            scene: record.scene,
            planner: record.planner.to_owned(),
            v_max: self.v_max,
            seed: record.seed,
            value: record.value,
            cost: record.cost,
            feasible: record.feasible,
            gap: record.gap,
            clearance: record.clearance,
            reached: record.reached,
            evaluations: record.evaluations,
        }))
    }
}

/// The limits of velocities that are tried: the default, and none.
const LIMITS: [Option<f64>; 2] = [None, Some(1.0)];

const FUNCTIONS_FILE: &str = "wcpso-functions-runs.csv";
const FITTED_FILE: &str = "wcpso-fitted-runs.csv";
const PATHS_FILE: &str = "wcpso-paths-runs.csv";

fn function_tasks(options: &Options) -> Result<Vec<Task>, Error> {
    let runs = options.runs_or(published::RUNS)?;
    let mut tasks = Vec::new();
    for v_max in LIMITS {
        for row in &TABLE_2 {
            for planner in PLANNERS {
                for seed in 1..=runs {
                    tasks.push(Task::new(row.scene, planner, v_max, seed)?);
                }
            }
        }
    }
    Ok(tasks)
}

/// A planner of the table with parameters that were chosen by some of its figures.
struct Fit {
    /// Its place among the table's planners.
    planner: usize,
    params: Overrides,
    /// By so many figures.
    figures: u64,
}

/// The presets `fitted`, and a setting of `pso` that gives its f1 and f2.
fn fits() -> Result<Vec<Fit>, Error> {
    let mut fits = Vec::new();
    for (planner, name) in PLANNERS.iter().enumerate() {
        match standard().planner(name)?.presets.iter().find(|preset| preset.name == "fitted") {
            Some(preset) => fits.push(Fit { planner, params: preset.given(), figures: 3 }),
            None => fits.push(Fit {
                planner,
                params: PSO_FITTED.map(|(name, value)| (name, Value::from(value))).into_iter().collect(),
                figures: 2,
            }),
        }
    }
    Ok(fits)
}

fn fitted_tasks(options: &Options) -> Result<Vec<Task>, Error> {
    let runs = options.runs_or(published::RUNS)?;
    let mut tasks = Vec::new();
    for row in &TABLE_2 {
        for fit in fits()? {
            for seed in 1..=runs {
                let mut task = Task::new(row.scene, PLANNERS[fit.planner], None, seed)?;
                task.setup.params = fit.params.clone();
                tasks.push(task);
            }
        }
    }
    Ok(tasks)
}

fn fitted(options: &Options, control: &Control) -> Result<Report, Failure> {
    let runs = options.runs_or(published::RUNS)?;
    let path = options.out.join(FITTED_FILE);
    let tasks = fitted_tasks(options)?;
    let rows = runner::run(&tasks, &path, options.fresh, options.threads, control)?;
    let mut report = FITTED.report(runs, published::RUNS);
    report.files.push(path);
    let fits = fits()?;
    let cells = TABLE_2.iter().flat_map(|row| fits.iter().map(move |fit| (row, fit)));
    for ((row, fit), (runs, task)) in cells.zip(rows.chunks(runs as usize).zip(tasks.iter().step_by(runs as usize))) {
        let figure = figure(row, PLANNERS[fit.planner], row.results[fit.planner], runs, &task.setup)?;
        let basis = Basis::Fitted { choices: fit.params.iter().count() as u64, figures: fit.figures };
        report.figures.push(ComparedFigure { table: "Table 2, fitted".to_owned(), basis, ..figure });
    }
    report.notes = vec![
        "Presets `fitted`: the values were chosen because the first three rows (f1 to f3 with 2 variables) then come out; the other rows are what follows from them. They say how the table may have come about, not what the text says.".to_owned(),
        "pso has no such preset. Its row here has ω = 1, c1 = c2 = 1.49445, |v| ≤ 1 and one pair per particle, chosen by f1 and f2; on f3 the table has a value that this setting does not give, so the authors probably changed it between rows.".to_owned(),
    ];
    report.write(options)?;
    Ok(report)
}

fn functions(options: &Options, control: &Control) -> Result<Report, Failure> {
    let runs = options.runs_or(published::RUNS)?;
    let path = options.out.join(FUNCTIONS_FILE);
    let rows = runner::run(&function_tasks(options)?, &path, options.fresh, options.threads, control)?;
    let mut report = FUNCTIONS.report(runs, published::RUNS);
    report.files.push(path);
    let cells: Vec<&[Run]> = rows.chunks(runs as usize).collect();
    let (found, unlimited) = cells.split_at(cells.len() / 2);
    report.figures = figures(found, LIMITS[0])?;
    let unlimited = figures(unlimited, LIMITS[1])?;
    report.tables = vec![differences(found), limits(&report.figures, &unlimited)];
    let mark = |figure: &ComparedFigure| marking::value(figure).map(|marked| marked.mark);
    let changed: Vec<_> = report.figures.iter().zip(&unlimited).filter(|(a, b)| mark(a) != mark(b)).map(|(a, _)| a.row.clone()).collect();
    report.notes = vec![
        "60 particles, 1000 iterations (each planner’s defaults). The paper prints no coefficients for `pso`: 0.7298 and 1.49618 are Clerc and Kennedy’s. Positions are clamped to the box.".to_owned(),
        format!(
            "The paper does not say whether velocities are limited; here they are, to 20 % of the box. Without a limit (`v_max=1`) the mark of the value changes in {} of {} rows{}.",
            changed.len(),
            report.figures.len(),
            if changed.is_empty() { String::new() } else { format!(": {}", changed.join("; ")) }
        ),
        "Means of numbers that differ by powers of ten are those of their largest; the rank-sum tests that `forage reproduce wcpso-functions` prints do not depend on that.".to_owned(),
        "f5: the minimum is 0, and what is left of it is rounding: one unit in the last place of e is 4.44e-16, and the published 8.88e-16 are two. Whatever is below 1e-14 there counts as 0 when planners are compared.".to_owned(),
    ];
    report.write(options)?;
    Ok(report)
}

/// Each row and planner of the table, and our runs.
fn figures(found: &[&[Run]], v_max: Option<f64>) -> Result<Vec<ComparedFigure>, Error> {
    let rows = TABLE_2.iter().flat_map(|row| PLANNERS.into_iter().zip(row.results).map(move |(planner, printed)| (row, planner, printed)));
    rows.zip(found)
        .map(|((row, planner, printed), runs)| figure(row, planner, printed, runs, &Task::new(row.scene, planner, v_max, 1)?.setup))
        .collect()
}

/// What hangs on the limit of velocities.
fn limits(limited: &[ComparedFigure], unlimited: &[ComparedFigure]) -> Table {
    let columns = ["row", "mean", "value", "mean, v_max=1", "value, v_max=1"];
    let mut table = Table::new("limits", "Velocities limited to 20 % of the box, and not limited", &columns);
    for (a, b) in limited.iter().zip(unlimited) {
        let cells = [a, b].map(|figure| {
            [Cell::significant(figure.computed.mean(), 4), marking::value(figure).map_or(Cell::Empty, |marked| marked.mark.name().into())]
        });
        table.rows.push([Cell::Text(a.row.clone())].into_iter().chain(cells.into_iter().flatten()).collect());
    }
    table
}

/// Best, mean and standard deviation and the computed ones.
fn figure(row: &published::Row, planner: &str, [best, mean, std]: [&str; 3], runs: &[Run], setup: &Setup) -> Result<ComparedFigure, Error> {
    Ok(ComparedFigure {
        table: "Table 2".to_owned(),
        group: format!("{}, {} variables", row.name, row.dimension),
        row: format!("{}, {} variables: {planner}", row.name, row.dimension),
        measure: "value".to_owned(),
        lower_is_better: true,
        published: Published {
            best: Some(Printed::read(best)?),
            mean: Some(Printed::read(mean)?),
            std: Some(Printed::read(std)?.value),
            runs: Some(published::RUNS),
        },
        computed: Computed::runs(runs.iter().filter_map(|run| run.value)),
        basis: if planner == PLANNERS[0] { Basis::Reconstruction(OPEN) } else { Basis::Printed },
        source: None,
        command: command(setup),
    })
}

/// The values by which planners are compared: rounding is none.
fn values(name: &str, runs: &[Run]) -> Vec<Option<f64>> {
    runs.iter().map(|run| run.value.map(|value| if name == "f5" && value < ROUNDING { 0.0 } else { value })).collect()
}

/// Which planners differ, function by function.
fn differences(found: &[&[Run]]) -> Table {
    let columns = ["function", "variables", "planner", "median", "mean rank", "better than", "worse than"];
    let title = "Ranks over the seeds, and which planners differ (Wilcoxon’s rank-sum test at 5 %, Holm’s correction)";
    let mut out = Table::new("ranks", title, &columns);
    for (row, cells) in TABLE_2.iter().zip(found.chunks(PLANNERS.len())) {
        let groups = PLANNERS.into_iter().zip(cells).map(|(name, runs)| Group::new(name, values(row.name, runs)));
        let compared = compare(&groups.collect::<Vec<_>>());
        for (k, planner) in PLANNERS.into_iter().enumerate() {
            let than = |smaller: bool| {
                let names = compared.pairs.iter().filter(|pair| pair.corrected.is_some_and(|p| p < 0.05)).filter_map(|pair| {
                    let first_is_better = pair.better > 0.5;
                    match k {
                        _ if k == pair.first && first_is_better == smaller => Some(PLANNERS[pair.second]),
                        _ if k == pair.second && first_is_better != smaller => Some(PLANNERS[pair.first]),
                        _ => None,
                    }
                });
                Cell::Text(names.collect::<Vec<_>>().join(", "))
            };
            out.rows.push(vec![
                row.name.into(),
                Cell::whole(row.dimension as u64),
                planner.into(),
                Cell::significant(compared.groups[k].summary.map(|s| s.median), 4),
                Cell::maybe(compared.friedman.as_ref().and_then(|friedman| friedman.ranks[k]), 2),
                than(true),
                than(false),
            ]);
        }
    }
    out
}

fn path_tasks(options: &Options) -> Result<Vec<Task>, Error> {
    let runs = options.runs_or(PATH_RUNS)?;
    let mut tasks = Vec::new();
    for planner in RIVALS {
        for seed in 1..=runs {
            tasks.push(Task::new("wcpso-discs", planner, None, seed)?);
        }
    }
    Ok(tasks)
}

fn paths(options: &Options, control: &Control) -> Result<Report, Failure> {
    let runs = options.runs_or(PATH_RUNS)?;
    let path = options.out.join(PATHS_FILE);
    let rows = runner::run(&path_tasks(options)?, &path, options.fresh, options.threads, control)?;
    let mut report = PATHS.report(runs, PATH_RUNS);
    report.files.push(path);
    let found: Vec<&[Run]> = rows.chunks(runs as usize).collect();
    let scene = shipped("wcpso-discs")?;
    let exact = scene.exact().map(|exact| exact.length);
    let (table, measure) = ("§3.2", "length");
    report.figures.push(ComparedFigure {
        table: table.to_owned(),
        group: "optimum".to_owned(),
        row: "the shortest path".to_owned(),
        measure: measure.to_owned(),
        lower_is_better: true,
        published: Published::figure(Printed::read(SHORTEST)?),
        computed: exact.map_or(Computed::Nothing, Computed::Exact),
        basis: Basis::Printed,
        source: None,
        command: "forage exact --scene wcpso-discs".to_owned(),
    });
    for (planner, runs) in RIVALS.into_iter().zip(&found) {
        report.figures.push(ComparedFigure {
            table: format!("{table}, fig. 5"),
            group: String::new(),
            row: planner.to_owned(),
            measure: measure.to_owned(),
            lower_is_better: true,
            published: Published { runs: Some(PATH_RUNS), ..Published::default() },
            computed: Computed::runs(runs.iter().filter_map(|run| run.value)),
            basis: Basis::Printed,
            source: None,
            command: command(&Task::new("wcpso-discs", planner, None, 1)?.setup),
        });
    }
    report.tables.push(lengths(&found));
    report.notes = vec![format!(
        "Population 150, 500 iterations, three way-points (the paper does not say how many), `penalty=segments`: as printed, (15) looks at the way-points only. Lengths are of feasible results, checked against the discs; `near` counts those within {:.1} % of the exact {:.6}.",
        100.0 * NEAR,
        exact.unwrap_or(f64::NAN)
    )];
    report.write(options)?;
    Ok(report)
}

fn lengths(found: &[&[Run]]) -> Table {
    let columns = ["planner", "feasible", "near", "best", "mean", "std", "median", "worst", "mean gap %", "evaluations to 1 %, median"];
    let mut table = Table::new("paths", format!("Lengths of {} runs each", found.first().map_or(0, |runs| runs.len())), &columns);
    for (planner, runs) in RIVALS.into_iter().zip(found) {
        let summary = Summary::of(runs.iter().filter_map(|run| run.value));
        let number = |of: fn(&Summary) -> f64| Cell::maybe(summary.as_ref().map(of), 6);
        let count = |is: &dyn Fn(&Run) -> bool| Cell::Text(format!("{} of {}", runs.iter().filter(|run| is(run)).count(), runs.len()));
        table.rows.push(vec![
            planner.into(),
            count(&|run| run.feasible),
            count(&|run| run.feasible && run.gap.is_some_and(|gap| gap <= NEAR)),
            number(|s| s.min),
            number(|s| s.mean),
            Cell::maybe(summary.and_then(|s| s.std), 6),
            number(|s| s.median),
            number(|s| s.max),
            Cell::maybe(Summary::of(runs.iter().filter(|run| run.feasible).filter_map(|run| run.gap)).map(|s| 100.0 * s.mean), 3),
            Cell::maybe(Summary::of(runs.iter().filter_map(|run| run.reached).map(|n| n as f64)).map(|s| s.median), 0),
        ]);
    }
    table
}
