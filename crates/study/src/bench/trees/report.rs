//! How the trees compare: a table for each scene, and how soon there is a path.

use std::{
    fmt::Write as _,
    path::{Path, PathBuf},
};

use forage::statistics::{Summary, proportion};
use plotters::chart::SeriesLabelPosition;

use super::{
    super::{
        super::{
            disk,
            failure::{Failure, at},
            plot::{self, Axis, Curve},
            table::{Cell, Table},
        },
        suite::distinct,
    },
    row::Row,
};

fn contenders(rows: &[Row]) -> Vec<String> {
    distinct(rows.iter().map(Row::contender))
}

/// Runs, solved with its interval, and the medians of evaluations until a path, of time, nodes, length, gap and clearance.
fn cells(rows: &[&Row]) -> Vec<Cell> {
    let solved = rows.iter().filter(|row| row.solved).count();
    let interval = proportion(solved, rows.len());
    let median = |of: &dyn Fn(&Row) -> Option<f64>| Summary::of(rows.iter().filter_map(|row| of(row))).map(|summary| summary.median);
    vec![
        Cell::whole(rows.len() as u64),
        Cell::maybe((!rows.is_empty()).then(|| 100.0 * solved as f64 / rows.len() as f64), 1),
        Cell::maybe(interval.map(|interval| 100.0 * interval[0]), 1),
        Cell::maybe(interval.map(|interval| 100.0 * interval[1]), 1),
        Cell::maybe(median(&|row| row.first().map(|at| at as f64)), 0),
        Cell::significant(median(&|row| Some(1000.0 * row.seconds)), 3),
        Cell::maybe(median(&|row| row.nodes), 0),
        Cell::significant(median(&|row| row.length), 4),
        Cell::maybe(median(&|row| row.gap().map(|gap| 100.0 * gap)), 2),
        Cell::significant(median(&|row| row.clearance), 3),
    ]
}

const COLUMNS: [&str; 11] =
    ["planner", "runs", "solved %", "from", "to", "evaluations to first path", "time, ms", "nodes", "length", "gap, %", "clearance"];

/// On all scenes.
pub(super) fn planners(rows: &[Row]) -> Table {
    // Lengths of different scenes have nothing in common.
    let columns = [&COLUMNS[..8], &COLUMNS[9..10]].concat();
    let title = "All scenes: runs solved, with 95 % intervals; medians of the evaluations until there was a path, of time, nodes and gap";
    let mut table = Table::new("trees", title, &columns);
    for contender in contenders(rows) {
        let cells = cells(&rows.iter().filter(|row| row.contender() == contender).collect::<Vec<_>>());
        let shown = cells[..7].iter().chain(&cells[8..9]).cloned();
        table.rows.push([Cell::Text(contender)].into_iter().chain(shown).collect());
    }
    table
}

fn scene(rows: &[Row], scene: &str) -> Table {
    let exact = rows.iter().filter(|row| row.scene == scene).find_map(|row| row.exact);
    let optimum = exact.map_or(String::new(), |exact| format!("; the exact optimum is {exact:.4}"));
    let mut table = Table::new(scene, format!("{scene}: as above, with medians of length and clearance{optimum}"), &COLUMNS);
    for contender in contenders(rows) {
        let own: Vec<&Row> = rows.iter().filter(|row| row.scene == scene && row.contender() == contender).collect();
        if !own.is_empty() {
            table.rows.push([Cell::Text(contender)].into_iter().chain(cells(&own)).collect());
        }
    }
    table
}

/// Writes the report and its picture.
pub(super) fn write(rows: &[Row], folder: &Path) -> Result<Vec<PathBuf>, Failure> {
    let [report, picture] = ["report.md", "solved.svg"].map(|name| folder.join(name));
    draw(&picture, rows)?;
    let scenes = distinct(rows.iter().map(|row| row.scene.clone()));
    let budgets = distinct(rows.iter().map(|row| row.budget.to_string()));
    let mut text = String::from("# trees\n\n");
    // Writing to a text cannot fail.
    let _ = writeln!(
        text,
        "{} runs on {} scenes, at most {} evaluations each: straight segments that are checked for collisions. A run is over earlier where its planner has \
         nothing left to do. Solved is what was checked to be free. Times are of the machine that it was run on. The folder `ompl` has \
         the logs for OMPL's `ompl_benchmark_statistics`.\n",
        rows.len(),
        scenes.len(),
        budgets.join(" or "),
    );
    text.push_str(&planners(rows).markdown());
    text.push_str("\n![Share of runs that have a path over evaluations](solved.svg)\n");
    for name in scenes {
        text.push('\n');
        text.push_str(&scene(rows, &name).markdown());
    }
    disk::write(&report, text).map_err(at(&report))?;
    Ok(vec![report, picture])
}

/// The share of runs that have a path, over evaluations.
fn draw(path: &Path, rows: &[Row]) -> Result<(), Failure> {
    let most = rows.iter().map(|row| row.first().unwrap_or(0).max(row.budget) as f64).fold(10.0, f64::max);
    let curve = |name: String| {
        let own: Vec<&Row> = rows.iter().filter(|row| row.contender() == name).collect();
        let mut first: Vec<f64> = own.iter().filter_map(|row| row.first()).map(|at| at as f64).collect();
        first.sort_by(f64::total_cmp);
        Curve::ecdf(&name, &first, own.len(), [1.0, most])
    };
    let x = Axis { title: "evaluations", range: 1.0..most, log: true };
    let y = Axis { title: "share of runs with a path", range: 0.0..1.02, log: false };
    plot::draw(path, &x, &y, &contenders(rows).into_iter().map(curve).collect::<Vec<_>>(), SeriesLabelPosition::UpperLeft)
}
