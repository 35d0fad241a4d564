//! How long tours take, over the number of stops: [ANTBAT](forage#papers) fig. 8.

use std::{
    collections::BTreeMap,
    path::PathBuf,
    sync::{Arc, atomic::AtomicBool},
};

use serde::{Deserialize, Serialize};

use forage::{
    Setup, Value,
    exact::MAX_EXACT_STOPS,
    kernel::Error,
    math,
    scene::{Scene, generate},
    shipped, standard,
    statistics::Summary,
};

use super::{
    chart::{self, Curve},
    disk,
    escape::path_text,
    failure::{Failure, at},
    fit::{self, Fit},
    options::{Options, command},
    report::Report,
    rows::KeyedRow,
    runner::{self, Control, Job},
    study::Study,
    table::{Cell, Table},
    tours::{self, Network},
};

/// See the module.
pub const REPRODUCTION: Study = Study {
    name: "antbat-time",
    title: "time over the number of stops: three methods, and all tour planners",
    source: "[ANTBAT] fig. 8",
    repeatable: false,
    // Times are measured: there is nothing to compare.
    jobs: |_| Ok(Vec::new()),
    run,
};

/// A way to find paths between stops and an order of the stops.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Method {
    name: &'static str,
    /// Orders the stops.
    planner: &'static str,
    /// Finds the paths.
    roads: &'static str,
}

/// The paper's ants find the paths, unless another planner is named.
const ANTS: &str = "aco-direction";
const fn by_ants(planner: &'static str) -> Method {
    Method { name: planner, planner, roads: ANTS }
}
/// The paper's method, those of its references 31 and 32, and other orders on the ants' paths.
const METHODS: [Method; 9] = [
    by_ants("bat"),
    Method { name: "bat, cuckoo-search", planner: "bat", roads: "cuckoo-search" },
    Method { name: "bat, pso-rrt", planner: "bat", roads: "pso-rrt" },
    by_ants("hybrid-bat"),
    by_ants("ga"),
    by_ants("tour-pso"),
    by_ants("sa"),
    by_ants("two-opt"),
    by_ants("held-karp"),
];

/// How many stops; the figure's are not in the paper's text.
const STOPS: [usize; 6] = [5, 10, 15, 20, 25, 30];
/// Runs a planner and number of stops; how many the paper has is not said.
const RUNS: u64 = 5;

/// With fewer runs than that, the slower methods of references 31 and 32 are tried with no more stops than these.
const MOST_IN_SHORT: usize = 10;

/// A run. What begins with `measured` is no result: it differs each time.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct Run {
    method: String,
    stops: usize,
    seed: u64,
    feasible: bool,
    length: Option<f64>,
    /// To the exact tour, where that can be computed.
    gap: Option<f64>,
    evaluations: u64,
    /// Runs that went on side by side.
    measured_threads: usize,
    measured_roads_ms: f64,
    measured_order_ms: f64,
    measured_total_ms: f64,
}

impl KeyedRow for Run {
    fn key(&self) -> String {
        key(&self.method, self.stops, self.seed)
    }

    fn computed(&self) -> Self {
        Self { measured_threads: 0, measured_roads_ms: 0.0, measured_order_ms: 0.0, measured_total_ms: 0.0, ..self.clone() }
    }
}

fn key(method: &str, stops: usize, seed: u64) -> String {
    format!("{method}, {stops} stops, seed {seed}")
}

struct Task {
    method: Method,
    setup: Setup,
    stops: usize,
    threads: usize,
    network: Arc<Network>,
}

impl Job for Task {
    type Row = Run;

    fn key(&self) -> String {
        key(self.method.name, self.stops, self.setup.seed)
    }

    /// The first method of each kind of paths finds them. They keep their order, see [`tasks`].
    fn weight(&self) -> u64 {
        if self.method.planner == METHODS[0].planner { 100 } else { 1 }
    }

    fn run(&self, stop: &AtomicBool) -> Result<Option<Run>, Error> {
        let Some(found) = tours::carry_out(&self.setup, &self.network, stop)? else { return Ok(None) };
        let outcome = found.outcome;
        Ok(Some(Run {
            method: self.method.name.to_owned(),
            stops: self.stops,
            seed: self.setup.seed,
            feasible: outcome.feasible,
            length: outcome.length.filter(|_| outcome.feasible),
            gap: outcome.gap.filter(|_| outcome.feasible),
            evaluations: outcome.evaluations,
            measured_threads: self.threads,
            measured_roads_ms: found.roads_ms,
            measured_order_ms: found.order_ms,
            measured_total_ms: found.roads_ms + found.order_ms,
        }))
    }
}

fn run(options: &Options, control: &Control) -> Result<Report, Failure> {
    let runs = options.runs_or(RUNS)?;
    // Side by side, runs would take each other's time.
    let threads = options.threads.unwrap_or(1);
    let grid = shipped("ant-bat-30")?;
    let scenes: Vec<Vec<Arc<Scene>>> = STOPS
        .iter()
        .map(|&n| (1..=runs).map(|seed| generate::with_stops(&grid, n, seed).map(Arc::new)).collect::<Result<_, _>>())
        .collect::<Result<_, _>>()?;
    let path = options.out.join("antbat-time-runs.csv");
    let rows = runner::run(&tasks(&scenes, threads)?, &path, options.fresh, Some(threads), control)?;

    let mut report = REPRODUCTION.report(runs, RUNS);
    report.shortened = (runs != RUNS).then(|| format!("{runs} runs a planner and number of stops instead of {RUNS}"));
    report.files.push(path);
    let points: Vec<Point> = METHODS.iter().flat_map(|method| STOPS.map(|n| Point::of(*method, n, &rows))).flatten().collect();
    let growths = growths(&points);
    report.tables = vec![times(&points, runs), growth(&growths)];
    report.notes = notes(&rows);
    draw(&mut report, &points, options)?;
    for scenes in &scenes {
        let path = keep(&scenes[0], options)?;
        report.commands.push(command(&setup(&scenes[0], METHODS[0], 1)).replace(scenes[0].name(), &path_text(&path)));
        report.files.push(path);
    }
    report.write(options)?;
    Ok(report)
}

fn setup(scene: &Arc<Scene>, Method { planner, roads, .. }: Method, seed: u64) -> Setup {
    // The paths of Table 2: from cell to cell.
    let mut params = tours::published(planner);
    params.insert("smooth", Value::from("false"));
    if roads != ANTS {
        params.insert("roads", Value::from(roads));
    }
    Setup { planner: planner.to_owned(), scene: Arc::clone(scene), params, seed }
}

/// Method by method, as many stops as each takes. All numbers of stops take turns: were they timed one number after the
/// other, a machine that has more to do at first than later would bend the curves.
fn tasks(scenes: &[Vec<Arc<Scene>>], threads: usize) -> Result<Vec<Task>, Error> {
    let mut networks: BTreeMap<(&str, usize, u64), Arc<Network>> = BTreeMap::new();
    let mut tasks = Vec::new();
    for method in METHODS {
        let from = tasks.len();
        for (stops, scenes) in STOPS.into_iter().zip(scenes) {
            let takes_long = method.roads != ANTS && (scenes.len() as u64) < RUNS && stops > MOST_IN_SHORT;
            if takes_long || standard().planner(method.planner)?.most_stops.is_some_and(|most| stops > most) {
                continue;
            }
            tasks.extend((1..).zip(scenes).map(|(seed, scene)| Task {
                method,
                setup: setup(scene, method, seed),
                stops,
                threads,
                network: Arc::clone(networks.entry((method.roads, stops, seed)).or_default()),
            }));
        }
        tasks[from..].sort_by_key(|task: &Task| task.setup.seed);
    }
    Ok(tasks)
}

/// A method's runs through so many stops.
struct Point {
    method: Method,
    stops: usize,
    /// Medians, in milliseconds.
    roads: f64,
    order: f64,
    total: f64,
    evaluations: f64,
    /// The mean, in percent.
    gap: Option<f64>,
    exact: String,
}

impl Point {
    fn of(method: Method, stops: usize, rows: &[Run]) -> Option<Self> {
        let runs: Vec<&Run> = rows.iter().filter(|run| run.method == method.name && run.stops == stops).collect();
        let median = |of: fn(&Run) -> f64| Summary::of(runs.iter().map(|run| of(run))).map(|summary| summary.median);
        let hits = runs.iter().filter(|run| run.gap == Some(0.0)).count();
        Some(Self {
            method,
            stops,
            roads: median(|run| run.measured_roads_ms)?,
            order: median(|run| run.measured_order_ms)?,
            total: median(|run| run.measured_total_ms)?,
            evaluations: median(|run| run.evaluations as f64)?,
            gap: Summary::of(runs.iter().filter_map(|run| run.gap)).map(|summary| 100.0 * summary.mean),
            exact: if stops > MAX_EXACT_STOPS { String::new() } else { format!("{hits} of {}", runs.len()) },
        })
    }
}

fn times(points: &[Point], runs: u64) -> Table {
    let title = format!("Milliseconds over the number of stops, medians of {runs} runs: roads, order, both");
    let columns = ["method", "stops", "roads", "roads ms", "order ms", "total ms", "evaluations", "gap %", "exact tour"];
    let mut table = Table::new("time", title, &columns);
    for point in points {
        table.rows.push(vec![
            point.method.name.into(),
            Cell::whole(point.stops as u64),
            Cell::whole(pairs(point.stops) as u64),
            Cell::Number(point.roads, 1),
            Cell::Number(point.order, 3),
            Cell::Number(point.total, 1),
            Cell::Number(point.evaluations, 0),
            Cell::maybe(point.gap, 3),
            Cell::Text(point.exact.clone()),
        ]);
    }
    table
}

/// How many roads there are.
fn pairs(stops: usize) -> usize {
    stops * (stops - 1) / 2
}

/// time = e^b0 · x^b1, fitted on logarithms.
struct Growth {
    of: String,
    over: &'static str,
    fit: Option<Fit>,
}

/// Of the paths over the stops and over their own number, of the three methods as a whole, then of each order over the stops.
fn growths(points: &[Point]) -> Vec<Growth> {
    let growth = |of: String, over: &'static str, method: Method, x: fn(&Point) -> f64, y: fn(&Point) -> f64| {
        let logs: Vec<_> = points.iter().filter(|p| p.method == method).map(|p| [math::ln(x(p)), math::ln(y(p))]).collect();
        Growth { of, over, fit: fit::line(&logs) }
    };
    let stops = |p: &Point| p.stops as f64;
    let mut all = vec![
        growth("roads".to_owned(), "stops", METHODS[0], stops, |p| p.roads),
        growth("roads".to_owned(), "roads", METHODS[0], |p| pairs(p.stops) as f64, |p| p.roads),
    ];
    all.extend(METHODS[..3].iter().map(|method| growth(format!("{}, roads and order", method.name), "stops", *method, stops, |p| p.total)));
    let orders = METHODS.iter().filter(|method| method.roads == ANTS);
    all.extend(orders.map(|method| growth(method.name.to_owned(), "stops", *method, stops, |p| p.order)));
    all
}

fn growth(growths: &[Growth]) -> Table {
    let title = "How time grows: its exponent over a number, by least squares on logarithms of the medians";
    let mut table = Table::new("growth", title, &["of", "over", "exponent", "from", "to", "R²", "points"]);
    for Growth { of, over, fit } in growths {
        let number = |of: fn(&Fit) -> f64, digits| Cell::maybe(fit.as_ref().map(of), digits);
        table.rows.push(vec![
            Cell::Text(of.clone()),
            (*over).into(),
            number(|fit| fit.b[1], 3),
            number(|fit| fit.interval[1][0], 3),
            number(|fit| fit.interval[1][1], 3),
            number(|fit| fit.r2, 4),
            number(|fit| fit.count as f64, 0),
        ]);
    }
    table
}

fn notes(rows: &[Run]) -> Vec<String> {
    let mut notes = vec![
        "The times are not reproducible: in the rows all that begins with `measured` differs from run to run and from machine to machine; the rest is computed and does not. Published times are none: fig. 8 is a picture of three algorithms without numbers in the text, not even of the stops, so 5 to 30 are used.".to_owned(),
        "Stops are centres of free cells at random, others for each seed. The roads of a network are built one after the other on one thread and timed once; all planners then order the stops by these same roads, so that their totals differ in the order only. The roads are the improved ants’ (from cell to cell), but of `bat, cuckoo-search` ([31]) and `bat, pso-rrt` ([32]), which are compared as whole methods: the paper prints none of their details. Time for the order is that of the whole search with the planner’s default sizes: see `evaluations`. `gap` and `exact tour` where the exact tour is computed, up to 15 stops; what held-karp has of a gap is the roads’. Its time is no power of the number of stops but exponential: three points fit either.".to_owned(),
    ];
    let most = rows.iter().map(|run| run.measured_threads).max().unwrap_or(1);
    notes.push(match most {
        1 => "Runs were timed one after the other; --jobs N lets N go on side by side, faster, but they take each other’s time.".to_owned(),
        _ => format!(
            "UP TO {most} RUNS WENT ON SIDE BY SIDE: they took each other’s time. Without --jobs they are timed one after the other."
        ),
    });
    if cfg!(debug_assertions) {
        notes.push("This is NOT A RELEASE BUILD: one takes far less time.".to_owned());
    }
    let failed = rows.iter().filter(|run| !run.feasible).count();
    if failed > 0 {
        notes.push(format!("{failed} of {} runs FOUND NO FEASIBLE TOUR.", rows.len()));
    }
    notes
}

/// Both stages and the order alone, over the number of stops.
fn draw(report: &mut Report, points: &[Point], options: &Options) -> Result<(), Failure> {
    let of =
        |method: &Method, y: fn(&Point) -> f64| points.iter().filter(|p| p.method == *method).map(|p| [p.stops as f64, y(p)]).collect();
    let curves = |y: fn(&Point) -> f64| METHODS.each_ref().map(|method| Curve { name: method.name, points: of(method, y) });
    let path = options.out.join("antbat-time.svg");
    chart::times(&path, &[("roads and order", &curves(|p| p.total)), ("order alone", &curves(|p| p.order))])?;
    report.files.push(path);
    Ok(())
}

/// Writes a scene where a command finds it.
fn keep(scene: &Scene, options: &Options) -> Result<PathBuf, Failure> {
    let path = options.out.join(format!("{}.json", scene.name()));
    disk::write(&path, scene.to_json()).map_err(at(&path))?;
    Ok(path)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn growth_is_the_exponent_of_a_power() {
        let point = |stops: usize| {
            let (roads, order) = (3.0 * pairs(stops) as f64, 0.5 * (stops * stops * stops) as f64);
            let (evaluations, gap, exact) = (1.0, None, String::new());
            Point { method: METHODS[0], stops, roads, order, total: roads + order, evaluations, gap, exact }
        };
        let growths = growths(&STOPS.map(point));
        let exponent = |k: usize| growths[k].fit.unwrap().b[1];
        assert!((exponent(1) - 1.0).abs() < 1e-12 && (exponent(5) - 3.0).abs() < 1e-12);
        assert!((2.0..2.2).contains(&exponent(0)), "n (n − 1) / 2 is a little more than n²");
        assert!(growths[6].fit.is_none(), "nothing was timed");
    }
}
