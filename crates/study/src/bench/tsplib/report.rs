//! How the planners compare: by planner, and instance by instance.

use std::{
    fmt::Write as _,
    path::{Path, PathBuf},
};

use forage::statistics::Summary;
use plotters::chart::SeriesLabelPosition;

use super::{
    super::{
        super::{
            disk,
            failure::{Failure, at},
            plot::{self, Axis, Curve},
            ranking::Ranking,
            table::{Cell, Table},
        },
        suite::distinct,
    },
    row::Row,
};

fn contenders(rows: &[Row]) -> Vec<String> {
    distinct(rows.iter().map(Row::contender))
}

/// A row for each planner.
pub(super) fn planners(rows: &[Row]) -> Table {
    let columns = [
        "planner",
        "instances",
        "runs",
        "found",
        "optimal",
        "mean gap, %",
        "median gap, %",
        "largest gap, %",
        "mean evaluations per stop",
        "total time, s",
    ];
    let mut table = Table::new("tsplib", "Against the published optima", &columns);
    for contender in contenders(rows) {
        let own: Vec<&Row> = rows.iter().filter(|row| row.contender() == contender).collect();
        let gaps = Summary::of(own.iter().filter_map(|row| row.gap()).map(|gap| 100.0 * gap));
        let spent = Summary::of(own.iter().map(|row| row.evaluations as f64 / row.stops as f64));
        table.rows.push(vec![
            Cell::Text(contender),
            Cell::whole(distinct(own.iter().map(|row| row.instance.clone())).len() as u64),
            Cell::whole(own.len() as u64),
            Cell::whole(own.iter().filter(|row| row.length.is_some()).count() as u64),
            Cell::whole(own.iter().filter(|row| row.gap().is_some_and(|gap| gap <= 1e-12)).count() as u64),
            Cell::maybe(gaps.map(|gaps| gaps.mean), 2),
            Cell::maybe(gaps.map(|gaps| gaps.median), 2),
            Cell::maybe(gaps.map(|gaps| gaps.max), 2),
            Cell::maybe(spent.map(|spent| spent.mean), 0),
            Cell::significant(Some(own.iter().map(|row| row.seconds).sum()), 3),
        ]);
    }
    table
}

/// The mean gap of each planner on each instance.
fn gaps(rows: &[Row]) -> Table {
    let contenders = contenders(rows);
    let columns: Vec<&str> = ["instance", "stops", "optimum"].into_iter().chain(contenders.iter().map(String::as_str)).collect();
    let mut table = Table::new("gaps", "Gap to the published optimum, %, mean of the runs", &columns);
    for instance in instances(rows) {
        let own = || rows.iter().filter(|row| row.instance == instance);
        let (stops, optimum) = own().next().map_or((0, None), |row| (row.stops, row.optimum));
        let gap = |contender: &String| {
            let gaps = Summary::of(own().filter(|row| row.contender() == *contender).filter_map(Row::gap));
            Cell::maybe(gaps.map(|gaps| 100.0 * gaps.mean), 2)
        };
        let first = [Cell::Text(instance.clone()), Cell::whole(stops as u64), Cell::maybe(optimum, 0)];
        table.rows.push(first.into_iter().chain(contenders.iter().map(gap)).collect());
    }
    table
}

/// By the number of stops.
fn instances(rows: &[Row]) -> Vec<String> {
    let mut all: Vec<&Row> = rows.iter().collect();
    all.sort_by(|a, b| a.stops.cmp(&b.stops).then_with(|| a.instance.cmp(&b.instance)));
    distinct(all.into_iter().map(|row| row.instance.clone()))
}

/// How the planners rank by the mean length on each instance; one that has not toured it in every run has none.
fn ranking(rows: &[Row]) -> Ranking {
    let all = instances(rows);
    // Who cannot run on all of them has no rank.
    let runs_on_all =
        |planner: &String| all.iter().all(|instance| rows.iter().any(|row| row.instance == *instance && row.contender() == *planner));
    let planners: Vec<String> = contenders(rows).into_iter().filter(runs_on_all).collect();
    let cost = |instance: &str, planner: &String| {
        let lengths: Option<Vec<f64>> =
            rows.iter().filter(|row| row.instance == instance && row.contender() == *planner).map(|row| row.length).collect();
        Some(Summary::of(lengths?)?.mean)
    };
    let costs = all.iter().map(|instance| planners.iter().map(|planner| cost(instance, planner)).collect()).collect();
    Ranking { planners, costs }
}

/// The mean of a quantity of each planner over the stops of the instances.
fn curves(rows: &[Row], of: impl Fn(&Row) -> Option<f64>) -> Vec<Curve> {
    let curve = |name: String| {
        let point = |instance: &String| {
            let own = || rows.iter().filter(|row| row.instance == *instance && row.contender() == name);
            Some((own().next()?.stops as f64, Summary::of(own().filter_map(&of))?.mean))
        };
        let points = instances(rows).iter().filter_map(point).collect();
        Curve { name, points }
    };
    contenders(rows).into_iter().map(curve).collect()
}

/// Writes the report, its pictures and the table of gaps.
pub(super) fn write(rows: &[Row], folder: &Path) -> Result<Vec<PathBuf>, Failure> {
    let names = ["report.md", "gap.svg", "time.svg", "profile.svg", "ranks.svg", "gaps.csv"];
    let [report, gap, time, profile, ranks, table] = names.map(|name| folder.join(name));
    let lengths = ranking(rows);
    lengths.draw_profile(&profile, "times the least length")?;
    let ranked = lengths.draw_ranks(&ranks)?;
    let x = || Axis::log("stops", rows.iter().map(|row| row.stops as f64));
    let values = |curves: &[Curve]| curves.iter().flat_map(|curve| curve.points.iter().map(|(_, y)| *y)).collect::<Vec<_>>();
    let drawn = curves(rows, |row| row.gap().map(|gap| 100.0 * gap));
    let measured = !values(&drawn).is_empty();
    if measured {
        plot::draw(&gap, &x(), &Axis::linear("gap, %", 0.0, values(&drawn).into_iter()), &drawn, SeriesLabelPosition::UpperLeft)?;
    } else {
        plot::remove(&gap)?;
    }
    let drawn = curves(rows, |row| Some(row.seconds.max(1e-6)));
    plot::draw(&time, &x(), &Axis::log("mean time, s", values(&drawn).into_iter()), &drawn, SeriesLabelPosition::UpperLeft)?;
    let gaps = gaps(rows);
    disk::write(&table, gaps.csv().map_err(at(&table))?).map_err(at(&table))?;
    let budgets = distinct(rows.iter().map(|row| (row.budget / row.stops.max(1) as u64).to_string()));
    let mut text = String::from("# tsplib\n\n");
    // Writing to a text cannot fail.
    let _ = writeln!(
        text,
        "{} runs on {} instances, at most {} evaluations for each stop: tours, or moves of one, that were measured. A run is over earlier where \
         nothing is left to improve; one whose first tours alone take more has them all: the table shows what was spent. Lengths are by TSPLIB's distances, in whole numbers; optima are those that TSPLIB publishes. Times are of \
         the machine that it was run on.\n",
        rows.len(),
        instances(rows).len(),
        budgets.join(" or "),
    );
    text.push_str(&planners(rows).markdown());
    if measured {
        text.push_str("\n![Gap over the stops](gap.svg)\n");
    }
    text.push_str("\n![Seconds over the stops](time.svg)\n\n");
    if lengths.planners.len() < contenders(rows).len() {
        text.push_str("Planners that do not run on every instance are not ranked.\n\n");
    }
    text.push_str(&lengths.table("instances, by the mean length").map_or(String::new(), |ranks| ranks.markdown()));
    if ranked {
        text.push_str("\n![Mean ranks, with bars over those that do not differ](ranks.svg)\n\n");
    }
    text.push_str("![Share of instances toured within so many times the least length](profile.svg)\n\n");
    text.push_str(&gaps.markdown());
    disk::write(&report, text).map_err(at(&report))?;
    Ok([report, time, profile, table].into_iter().chain(measured.then_some(gap)).chain(ranked.then_some(ranks)).collect())
}
