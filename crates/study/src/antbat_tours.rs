//! Orders of twelve stops by all tour planners: [ANTBAT](forage#papers) Table 2.

use std::{
    collections::BTreeMap,
    sync::{Arc, atomic::AtomicBool},
};

use serde::{Deserialize, Serialize};

use forage::{
    Setup, Value,
    exact::Distances,
    kernel::{Error, ReferenceOptimum, TourEnds},
    scene::Scene,
    shipped,
    statistics::Summary,
};

use super::{
    compared::{ComparedFigure, Computed, Published},
    failure::Failure,
    figure::{Figure, Steps},
    fingerprints::JobList,
    marks::Basis,
    options::{Options, command},
    published::{ANTBAT_TOURS, Tours},
    report::Report,
    rows::KeyedRow,
    runner::{self, Control, Job},
    study::Study,
    table::{Cell, Table},
    tours::{self, Network, PLANNERS, same},
};

/// See the module.
pub const REPRODUCTION: Study = Study {
    name: "antbat-tours",
    title: "orders of twelve stops by all tour planners",
    source: "[ANTBAT] Table 2",
    repeatable: true,
    jobs: |options| Ok(vec![JobList::new(FILE, tasks(&shipped("ant-bat-30")?, options.runs_or(Tours::RUNS)?))]),
    run,
};

/// What the roads are.
struct Block {
    /// In the rows and in file names.
    name: &'static str,
    title: &'static str,
    params: [(&'static str, &'static str); 2],
    reference: ReferenceOptimum,
    /// Whether the published lengths are measured like these.
    comparable: bool,
}

const BLOCKS: [Block; 3] = [
    Block {
        name: "ants",
        title: "Roads from cell to cell by the improved ants",
        params: [("roads", "aco-direction"), ("smooth", "false")],
        reference: ReferenceOptimum::Cells,
        comparable: true,
    },
    Block {
        name: "exact-roads",
        title: "The shortest roads from cell to cell, the same in all runs",
        params: [("roads", "dijkstra"), ("smooth", "false")],
        reference: ReferenceOptimum::Cells,
        comparable: true,
    },
    Block {
        name: "smoothed",
        title: "The ants’ roads without redundant nodes, measured at any angle",
        params: [("roads", "aco-direction"), ("smooth", "true")],
        reference: ReferenceOptimum::AnyAngle,
        comparable: false,
    },
];

/// A run.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct Run {
    block: String,
    planner: String,
    seed: u64,
    feasible: bool,
    /// Missing where no tour was found.
    length: Option<f64>,
    /// To the exact tour: 0 if it was found.
    gap: Option<f64>,
    /// The stops' numbers, from 1.
    order: String,
    /// The iteration of the search in which the tour was found.
    converged: Option<f64>,
    evaluations: u64,
}

impl KeyedRow for Run {
    fn key(&self) -> String {
        key(&self.block, &self.planner, self.seed)
    }
}

fn key(block: &str, planner: &str, seed: u64) -> String {
    format!("{block}, {planner}, seed {seed}")
}

struct Task {
    block: &'static str,
    setup: Setup,
    network: Arc<Network>,
}

impl Job for Task {
    type Row = Run;

    fn key(&self) -> String {
        key(self.block, &self.setup.planner, self.setup.seed)
    }

    /// The first planner's runs find the roads.
    fn weight(&self) -> u64 {
        if self.setup.planner == PLANNERS[0] && self.block != "exact-roads" { 20 } else { 1 }
    }

    fn run(&self, stop: &AtomicBool) -> Result<Option<Run>, Error> {
        let Some(found) = tours::carry_out(&self.setup, &self.network, stop)? else { return Ok(None) };
        let outcome = found.outcome;
        Ok(Some(Run {
            block: self.block.to_owned(),
            planner: self.setup.planner.clone(),
            seed: self.setup.seed,
            feasible: outcome.feasible,
            length: outcome.length.filter(|_| outcome.feasible),
            gap: outcome.gap.filter(|_| outcome.feasible),
            order: tours::printed(&outcome.order.unwrap_or_default()),
            converged: outcome.readings.iter().find(|(name, _)| *name == "converged").map(|(_, value)| *value),
            evaluations: outcome.evaluations,
        }))
    }
}

const FILE: &str = "antbat-tours-runs.csv";

fn run(options: &Options, control: &Control) -> Result<Report, Failure> {
    let runs = options.runs_or(Tours::RUNS)?;
    let scene = shipped("ant-bat-30")?;
    let path = options.out.join(FILE);
    let rows = runner::run(&tasks(&scene, runs), &path, options.fresh, options.threads, control)?;

    let mut report = REPRODUCTION.report(runs, Tours::RUNS);
    report.files.push(path);
    for (block, rows) in BLOCKS.iter().zip(rows.chunks(PLANNERS.len() * runs as usize)) {
        let cells: Vec<_> = rows.chunks(runs as usize).map(Tried::of).collect();
        let measured = Measured::of(&scene, block, rows)?;
        report.tables.push(table(block, &cells, &measured, runs));
        if block.comparable {
            report.figures.extend(figures(&scene, block, &cells));
        }
    }
    report.notes = notes(&scene, &rows);
    report.commands = PLANNERS.iter().map(|planner| command(&setup(&scene, &BLOCKS[0], planner, 1))).collect();
    report.write(options)?;
    Ok(report)
}

/// Table 2 and the computed ones.
fn figures(scene: &Arc<Scene>, block: &Block, cells: &[Tried]) -> Vec<ComparedFigure> {
    let compared = |((published, planner), tried): ((&Tours, &&str), &Tried)| ComparedFigure {
        table: format!("Table 2: {}", block.title),
        group: String::new(),
        row: format!("{} ({planner})", published.name),
        measure: "length".to_owned(),
        lower_is_better: true,
        published: Published {
            best: Some(published.best.into()),
            mean: Some(published.mean.into()),
            std: Some(published.variance.value.sqrt()),
            runs: Some(Tours::RUNS),
        },
        computed: Computed::runs(tried.runs.iter().filter_map(|run| run.length)),
        basis: Basis::Reconstruction("the paper does not print the layout of the obstacles, nor how long the rivals search"),
        source: None,
        command: command(&setup(scene, block, planner, 1)),
    };
    ANTBAT_TOURS.iter().zip(&PLANNERS).zip(cells).map(compared).collect()
}

fn setup(scene: &Arc<Scene>, block: &Block, planner: &str, seed: u64) -> Setup {
    let mut params = tours::published(planner);
    block.params.iter().for_each(|&(name, value)| params.insert(name, Value::from(value)));
    Setup { planner: planner.to_owned(), scene: Arc::clone(scene), params, seed }
}

/// Block by block, planner by planner, seed by seed. The planners of a block have the same roads for the same seed.
fn tasks(scene: &Arc<Scene>, runs: u64) -> Vec<Task> {
    let mut tasks = Vec::new();
    for block in &BLOCKS {
        let networks: Vec<Arc<Network>> = (0..runs).map(|_| Arc::default()).collect();
        for planner in PLANNERS {
            let seeds = (1..=runs).zip(&networks);
            tasks.extend(seeds.map(|(seed, network)| Task {
                block: block.name,
                setup: setup(scene, block, planner, seed),
                network: Arc::clone(network),
            }));
        }
    }
    tasks
}

/// A planner's runs in a block.
struct Tried<'a> {
    runs: &'a [Run],
    lengths: Option<Summary>,
}

impl<'a> Tried<'a> {
    fn of(runs: &'a [Run]) -> Self {
        Self { runs, lengths: Summary::of(runs.iter().filter_map(|run| run.length)) }
    }

    fn variance(&self) -> Option<f64> {
        self.lengths?.std.map(|std| std * std)
    }

    fn count(&self, is: impl Fn(&Run) -> bool) -> usize {
        self.runs.iter().filter(|run| run.feasible && is(run)).count()
    }
}

/// What a block's runs are measured by.
struct Measured {
    optimum: f64,
    /// Of the shortest ways.
    distances: Option<Distances>,
    /// The shortest tour by the roads of each seed, as `held-karp` found it.
    best: BTreeMap<u64, f64>,
}

impl Measured {
    fn of(scene: &Scene, block: &Block, rows: &[Run]) -> Result<Self, Error> {
        let exact = rows.iter().filter(|run| run.planner == "held-karp").filter_map(|run| Some((run.seed, run.length?)));
        Ok(Self {
            optimum: scene.exact_tour(block.reference, TourEnds::Closed).map_or(f64::NAN, |exact| exact.length),
            distances: tours::exact_distances(scene, block.reference)?,
            best: exact.collect(),
        })
    }

    /// Whether the order is that of an exact tour, however long the roads are that it was found by.
    fn is_exact_order(&self, run: &Run) -> bool {
        let order = tours::order(&run.order);
        self.distances
            .as_ref()
            .is_some_and(|distances| order.len() == distances.len() && same(distances.length(&order, true), self.optimum))
    }

    /// Whether no other order is shorter by the roads that the run had.
    fn is_best_order(&self, run: &Run) -> bool {
        run.length.zip(self.best.get(&run.seed)).is_some_and(|(length, best)| same(length, *best))
    }
}

const COLUMNS: [&str; 17] = [
    "planner",
    "published",
    "its best",
    "best",
    "its worst",
    "worst",
    "its mean",
    "mean",
    "its variance",
    "variance",
    "median",
    "gap %",
    "exact tour",
    "exact order",
    "best order",
    "converged",
    "evaluations",
];

fn table(block: &Block, cells: &[Tried], measured: &Measured, runs: u64) -> Table {
    let title = format!("{}, seeds 1 to {runs}; the exact tour is {:.4}", block.title, measured.optimum);
    let mut table = Table::new(block.name, title, &COLUMNS);
    for (k, (planner, tried)) in PLANNERS.iter().zip(cells).enumerate() {
        let published = ANTBAT_TOURS.get(k).filter(|_| block.comparable);
        let figure = |of: fn(&Tours) -> Figure| published.map(of).map_or(Cell::Empty, |figure| Cell::Number(figure.value, figure.digits));
        let number = |of: fn(&Summary) -> f64| Cell::maybe(tried.lengths.as_ref().map(of), 4);
        let share = |is: &dyn Fn(&Run) -> bool| Cell::Text(format!("{} of {}", tried.count(is), tried.runs.len()));
        let evaluations = tried.runs.iter().map(|run| run.evaluations as f64);
        table.rows.push(vec![
            (*planner).into(),
            published.map_or(Cell::Empty, |published| published.name.into()),
            figure(|row| row.best),
            number(|s| s.min),
            figure(|row| row.worst),
            number(|s| s.max),
            figure(|row| row.mean),
            number(|s| s.mean),
            figure(|row| row.variance),
            Cell::maybe(tried.variance(), 4),
            number(|s| s.median),
            Cell::maybe(tried.lengths.map(|s| gap(s.mean, measured.optimum)), 3),
            share(&|run| run.gap == Some(0.0)),
            share(&|run| measured.is_exact_order(run)),
            share(&|run| measured.is_best_order(run)),
            Cell::maybe(Summary::of(tried.runs.iter().filter_map(|run| run.converged)).map(|s| s.mean), 1),
            Cell::maybe(Summary::of(evaluations).map(|s| s.mean), 0),
        ]);
    }
    table
}

/// In percent; a sum in another order is no gap, and no negative zero.
fn gap(length: f64, optimum: f64) -> f64 {
    if same(length, optimum) { 0.0 } else { 100.0 * (length - optimum) / optimum }
}

fn notes(scene: &Scene, rows: &[Run]) -> Vec<String> {
    let exact = scene.exact_tour(ReferenceOptimum::Cells, TourEnds::Closed).map_or(f64::NAN, |exact| exact.length);
    let mut notes = vec![
        "`its` columns are the paper’s. Variances are of samples, with n − 1.".to_owned(),
        format!("`exact tour`: runs whose tour is as long as the exact one. `exact order`: runs whose order would be an exact tour’s by the shortest roads; what remains of the gap is the roads’. `best order`: runs whose order is the best by the very roads that they had, as held-karp’s with the same seed is. The gap is that of the mean; `converged` is the mean iteration of the search in which the tour was found. The published {:.2} is shorter than the exact {exact:.4}: the layout of the obstacles is a reconstruction (the paper prints none), and lengths are rounded.", ANTBAT_TOURS[0].best.value),
        "In the paper all runs have the same network of roads, as in `exact-roads`; in `ants` and `smoothed` each seed builds its own, the same for all planners. The paper says that redundant nodes are deleted; its lengths still are like those from cell to cell.".to_owned(),
        "bat has the parameters of the paper (50 bats, 100 iterations, no local search), tour-pso no local search, the others their defaults. The paper does not say how long the others searched; here they do not evaluate equally many tours: see `evaluations`.".to_owned(),
    ];
    notes.extend(impossible());
    let failed = rows.iter().filter(|run| !run.feasible).count();
    notes.push(match failed {
        0 => "All runs are feasible.".to_owned(),
        failed => format!("{failed} of {} runs FOUND NO FEASIBLE TOUR; the tables leave them out.", rows.len()),
    });
    notes
}

/// Published figures that contradict each other, or that no tour from cell to cell has.
fn impossible() -> Vec<String> {
    // A closed tour over centres of cells goes as far back as forth.
    let closed = Steps { side: 1.0, apart: [0, 0] };
    let figures = || ANTBAT_TOURS.iter().flat_map(|row| [row.best, row.worst]);
    let lengths: Vec<_> = figures().filter(|figure| !figure.is_length(&closed)).map(|figure| format!("{:.2}", figure.value)).collect();
    let variances: Vec<_> = ANTBAT_TOURS
        .iter()
        .filter(|row| row.variance.like(row.largest_variance()) < row.variance.value)
        .map(|row| format!("{:.2} of {} (at most {:.2})", row.variance.value, row.name, row.largest_variance()))
        .collect();
    let mut notes = Vec::new();
    if !lengths.is_empty() {
        let (some, all) = (lengths.len(), figures().count());
        notes.push(format!(
            "{some} of the {all} published best and worst lengths are of no closed tour from cell to cell: {}.",
            lengths.join(", ")
        ));
    }
    if !variances.is_empty() {
        notes.push(format!(
            "Published variances that {} runs with the published best, worst and mean cannot have: {}.",
            Tours::RUNS,
            variances.join(", ")
        ));
    }
    notes
}
