//! `ltqpso` against `qpso` on the 10 m grid at equal evaluations: [LTQPSO](forage#papers) Tables 3 and 4.

use std::{collections::BTreeMap, sync::atomic::AtomicBool};

use serde::{Deserialize, Serialize};

use forage::{
    Overrides, Setup, Value,
    kernel::{Error, Message},
    shipped, standard,
    statistics::Summary,
};

use super::{
    compared::{ComparedFigure, Computed, Published},
    failure::Failure,
    figure::Figure,
    fingerprints::JobList,
    marks::Basis,
    options::{Options, command},
    published::{Results, TABLE_3, TABLE_4},
    report::Report,
    rows::KeyedRow,
    runner::{self, Control, Job},
    study::Study,
    table::{Cell, Table},
};

/// See the module.
pub const REPRODUCTION: Study = Study {
    name: "ltqpso",
    title: "ltqpso against qpso on the 10 m grid",
    source: "[LTQPSO] Tables 3 and 4",
    repeatable: true,
    jobs: |options| Ok(vec![JobList::new(FILE, tasks(options)?)]),
    run,
};

const PLANNERS: [&str; 2] = ["qpso", "ltqpso"];
/// The paper's number of runs.
const RUNS: u64 = 50;

/// What a table is about.
struct Case {
    name: &'static str,
    title: &'static str,
    segments: u64,
    /// Mean and standard deviation of normal first angles, in degrees; `None`: uniform.
    normal: Option<[u64; 2]>,
    /// N and M; `None`: by (10) or (11).
    sizes: Option<[u64; 2]>,
    published: Option<Results>,
}

const CASES: [Case; 4] = [
    Case { name: "table-3", title: "Table 3: uniform start", segments: 8, normal: None, sizes: Some([30, 50]), published: Some(TABLE_3) },
    Case {
        name: "table-4",
        title: "Table 4: start N(45°, 30°)",
        segments: 16,
        normal: Some([45, 30]),
        sizes: None,
        published: Some(TABLE_4),
    },
    Case { name: "uniform-16", title: "Not published: uniform start", segments: 16, normal: None, sizes: None, published: None },
    Case {
        name: "normal-8",
        title: "Not published: start N(30°, 45°), which the text names",
        segments: 8,
        normal: Some([30, 45]),
        sizes: Some([30, 50]),
        published: None,
    },
];

impl Case {
    fn setup(&self, planner: &str, seed: u64) -> Result<Setup, Error> {
        let number = |n: u64| Value::Number(n as f64);
        let mut params = Overrides::from_iter([("segments", number(self.segments)), ("early_stop", number(0))]);
        params.insert("initial", if self.normal.is_some() { "normal" } else { "uniform" }.into());
        if let Some([mean, std]) = self.normal {
            params.insert("initial_mean", number(mean));
            params.insert("initial_std", number(std));
        }
        let mut setup = Setup { planner: planner.to_owned(), scene: shipped("qpso-10m")?, params, seed };
        let [population, iterations] = if let Some(sizes) = self.sizes {
            sizes
        } else {
            // By ltqpso's equation for both planners: equal evaluations.
            let (entry, parameters) = Setup { planner: "ltqpso".to_owned(), ..setup.clone() }.check(standard())?;
            (entry.suggest)(&parameters)
                .map(|suggestion| [suggestion.population, suggestion.iterations])
                .ok_or_else(|| Error::refused("segments", self.segments, Message::verbatim("from 5 to 20")))?
        };
        setup.params.insert("population", number(population));
        setup.params.insert("iterations", number(iterations));
        Ok(setup)
    }
}

/// A run.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct Run {
    case: String,
    planner: String,
    seed: u64,
    /// What the planner made as small as it could, penalty included.
    cost: f64,
    /// Of the path that is handed over.
    length: f64,
    /// Before smoothing.
    raw_length: f64,
    feasible: bool,
    gap: Option<f64>,
    evaluations: u64,
    ms: f64,
}

impl KeyedRow for Run {
    fn key(&self) -> String {
        key(&self.case, &self.planner, self.seed)
    }

    fn computed(&self) -> Self {
        Self { ms: Default::default(), ..self.clone() }
    }
}

fn key(case: &str, planner: &str, seed: u64) -> String {
    format!("{case}, {planner}, seed {seed}")
}

struct Task {
    case: &'static Case,
    setup: Setup,
}

impl Job for Task {
    type Row = Run;

    fn key(&self) -> String {
        key(self.case.name, &self.setup.planner, self.setup.seed)
    }

    fn weight(&self) -> u64 {
        self.case.segments
    }

    #[expect(clippy::disallowed_types, reason = "the paper tells how long its runs took; no planner sees it")]
    fn run(&self, _stop: &AtomicBool) -> Result<Option<Run>, Error> {
        let begun = std::time::Instant::now();
        let mut run = forage::Run::with_keyframes(standard(), self.setup.clone(), 0)?;
        run.step(u64::MAX);
        let ms = begun.elapsed().as_secs_f64() * 1e3;
        let raw_length = run.readings().get("length").unwrap_or(f64::NAN);
        let outcome = run.outcome();
        Ok(Some(Run {
            case: self.case.name.to_owned(),
            planner: self.setup.planner.clone(),
            seed: self.setup.seed,
            cost: outcome.cost.unwrap_or(f64::NAN),
            length: outcome.length.unwrap_or(f64::NAN),
            raw_length,
            feasible: outcome.feasible,
            gap: outcome.gap,
            evaluations: outcome.evaluations,
            ms,
        }))
    }
}

/// What of a run is averaged. The paper says "cost" and gives metres; it says nothing of runs that end in a collision.
const MEASURES: [(&str, Measure); 4] = [
    ("cost", |run| Some(run.cost)),
    ("length", |run| Some(run.length)),
    ("length, feasible", |run| run.feasible.then_some(run.length)),
    ("unsmoothed, feasible", |run| run.feasible.then_some(run.raw_length)),
];

type Measure = fn(&Run) -> Option<f64>;

const COLUMNS: [&str; 13] = [
    "planner",
    "of",
    "published mean",
    "published std",
    "mean",
    "std",
    "median",
    "best",
    "worst",
    "runs",
    "feasible %",
    "evaluations",
    "ms",
];

const FILE: &str = "ltqpso-runs.csv";

fn tasks(options: &Options) -> Result<Vec<Task>, Error> {
    let runs = options.runs_or(RUNS)?;
    let mut tasks = Vec::new();
    for case in &CASES {
        for planner in PLANNERS {
            for seed in 1..=runs {
                tasks.push(Task { case, setup: case.setup(planner, seed)? });
            }
        }
    }
    Ok(tasks)
}

fn run(options: &Options, control: &Control) -> Result<Report, Failure> {
    let runs = options.runs_or(RUNS)?;
    let path = options.out.join(FILE);
    let rows = runner::run(&tasks(options)?, &path, options.fresh, options.threads, control)?;
    let mut report = REPRODUCTION.report(runs, RUNS);
    report.files.push(path);
    for case in &CASES {
        let of = |planner: &str| rows.iter().filter(|row| row.case == case.name && row.planner == planner).collect::<Vec<_>>();
        let both = PLANNERS.map(of);
        let example = case.setup("ltqpso", 1)?;
        report.figures.extend(figures(case, &example, &both));
        report.tables.push(tabulate(case, &example, &both));
        report.commands.extend(PLANNERS.map(|planner| command(&Setup { planner: planner.to_owned(), ..example.clone() })));
    }
    report.notes = notes(&rows);
    report.write(options)?;
    Ok(report)
}

/// The published costs and times and the computed ones.
fn figures(case: &Case, example: &Setup, both: &[Vec<&Run>; 2]) -> Vec<ComparedFigure> {
    let Some(results) = case.published else { return Vec::new() };
    let mut figures = Vec::new();
    for (planner, (runs, [mean, std, seconds])) in PLANNERS.into_iter().zip(both.iter().zip(results)) {
        let command = command(&Setup { planner: planner.to_owned(), ..example.clone() });
        let printed = |number| Some(Figure::new(number, 4).into());
        for (measure, published, computed, basis) in [
            (
                "cost, m",
                Published { mean: printed(mean), std: Some(std), runs: Some(RUNS), ..Published::default() },
                Computed::runs(runs.iter().map(|run| run.cost)),
                Basis::Reconstruction("the paper prints neither the layout of the obstacles nor what a run in collision counts"),
            ),
            ("time, s", Published { mean: printed(seconds), runs: Some(RUNS), ..Published::default() }, Computed::Nothing, Basis::Machine),
        ] {
            let (table, row) = (case.title.to_owned(), planner.to_owned());
            figures.push(ComparedFigure {
                table,
                group: String::new(),
                row,
                measure: measure.to_owned(),
                lower_is_better: true,
                published,
                computed,
                basis,
                source: None,
                command: command.clone(),
            });
        }
    }
    figures
}

fn tabulate(case: &Case, setup: &Setup, both: &[Vec<&Run>; 2]) -> Table {
    let size = |name| setup.params.get(name).map(ToString::to_string).unwrap_or_default();
    let runs = both[0].len();
    let title = format!("{}, D = {}, N = {}, M = {}, seeds 1 to {runs}", case.title, case.segments, size("population"), size("iterations"));
    let mut table = Table::new(case.name, title, &COLUMNS);
    for (k, planner) in PLANNERS.into_iter().enumerate() {
        let share = 100.0 * both[k].iter().filter(|run| run.feasible).count() as f64 / runs as f64;
        let mean = |of: fn(&Run) -> f64| Summary::of(both[k].iter().map(|run| of(run))).map(|summary| summary.mean);
        for (name, measure) in MEASURES {
            let summary = Summary::of(both[k].iter().filter_map(|run| measure(run)));
            let published = case.published.map(|results| results[k]);
            let number = |of: fn(&Summary) -> f64| Cell::maybe(summary.as_ref().map(of), 4);
            table.rows.push(vec![
                planner.into(),
                name.into(),
                Cell::maybe(published.map(|p| p[0]), 4),
                Cell::maybe(published.map(|p| p[1]), 4),
                number(|s| s.mean),
                Cell::maybe(summary.and_then(|s| s.std), 4),
                number(|s| s.median),
                number(|s| s.min),
                number(|s| s.max),
                Cell::whole(summary.map_or(0, |s| s.count as u64)),
                Cell::Number(share, 0),
                Cell::maybe(mean(|run| run.evaluations as f64), 1),
                Cell::maybe(mean(|run| run.ms), 2),
            ]);
        }
    }
    table
}

fn notes(rows: &[Run]) -> Vec<String> {
    let mut notes = vec![
        "`cost` is the fitness (16) with f2 = 0.01 and the penalty, of all runs; the paper averages a \"cost\" in metres and does not say what a run in collision counts, so `length` is shown of all runs and of the feasible ones alone.".to_owned(),
        "The layout of the obstacles is a reconstruction: the paper prints none. Lengths are after smoothing unless `unsmoothed`; feasible means that the path itself was checked against the obstacles grown by the robot’s radius.".to_owned(),
        "D = 16 takes N and M from (10) for the uniform start and from (11) for the normal one; the paper does not say which sizes Table 4 has (its text names N = 83, M = 418 for qpso). No early stop. `ms` is a run’s own time and the one column that differs from machine to machine; published: 4.2507 s and 2.5283 s (Table 3), 2.8812 s and 1.6082 s (Table 4).".to_owned(),
    ];
    let mut evaluations = BTreeMap::new();
    for run in rows {
        evaluations.entry((&run.case, run.seed)).or_insert_with(Vec::new).push(run.evaluations);
    }
    let unequal = evaluations.values().filter(|both| both.iter().any(|&count| count != both[0])).count();
    notes.push(match unequal {
        0 => "Evaluations are equal seed by seed: both planners draw and redraw the same first positions.".to_owned(),
        count => format!("EVALUATIONS DIFFER between the planners for {count} of {} seeds.", evaluations.len()),
    });
    let gaps = PLANNERS.map(|planner| {
        Summary::of(rows.iter().filter(|run| run.planner == planner && run.feasible).filter_map(|run| run.gap))
            .map(|summary| format!("{planner} {:+.2} %", 100.0 * summary.mean))
    });
    if let [Some(qpso), Some(ltqpso)] = gaps {
        notes.push(format!("Mean gap of the feasible runs of all tables to the exact optimum: {qpso}, {ltqpso}."));
    }
    notes
}
