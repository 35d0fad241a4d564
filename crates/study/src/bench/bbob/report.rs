//! How the planners compare: a table, a report in Markdown, and how many targets are reached over the evaluations.

use std::{
    collections::{BTreeMap, BTreeSet},
    fmt::Write as _,
    path::{Path, PathBuf},
};

use forage::statistics::{Attempt, RunningTime, Summary, expected_running_time};
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
        targets,
    },
    row::{Row, TITLES},
};

fn contenders(rows: &[Row]) -> Vec<String> {
    distinct(rows.iter().map(Row::contender))
}

fn sorted(of: impl Iterator<Item = usize>) -> Vec<usize> {
    of.collect::<BTreeSet<_>>().into_iter().collect()
}

/// The running times to all targets that were hit, in evaluations / D and in order, and the number of targets.
fn times<'a>(rows: impl Iterator<Item = &'a Row>) -> (Vec<f64>, usize) {
    let (mut reached, mut all) = (Vec::new(), 0);
    for row in rows {
        let improvements = row.improvements();
        let hits = (0..targets::COUNT).filter_map(|k| targets::hitting_time(&improvements, targets::target(k)));
        reached.extend(hits.map(|at| at as f64 / row.dimension as f64));
        all += targets::COUNT;
    }
    reached.sort_by(f64::total_cmp);
    (reached, all)
}

/// How runs went towards a target.
fn attempts<'a>(rows: impl Iterator<Item = &'a Row>, level: f64) -> Vec<Attempt> {
    let attempt =
        |row: &Row| Attempt { hit: targets::hitting_time(&row.improvements(), level).map(|at| at as f64), spent: row.evaluations as f64 };
    rows.map(attempt).collect()
}

/// The expected running time to a target, with its 95 % interval and the number of runs that reached it.
fn expected(runs: Vec<Attempt>) -> Cell {
    let (reached, all) = (runs.iter().filter(|run| run.hit.is_some()).count(), runs.len());
    let Some(RunningTime { expected, interval }) = RunningTime::of(runs) else { return Cell::Empty };
    let end = |end: Option<f64>| end.map_or("∞".to_owned(), |end| format!("{end:.0}"));
    let shown = interval.map_or(String::new(), |[low, high]| format!(" ({} to {})", end(low), end(high)));
    Cell::Text(format!("{expected:.0}{shown}, {reached} of {all}"))
}

/// How the planners rank by their gaps in the end, and what they need to come within 0.1.
fn rankings(rows: &[Row]) -> (Ranking, Ranking) {
    let planners = contenders(rows);
    let mut groups: BTreeMap<(usize, usize), Vec<Vec<&Row>>> = BTreeMap::new();
    for row in rows {
        let Some(at) = planners.iter().position(|planner| *planner == row.contender()) else { continue };
        groups.entry((row.function, row.dimension)).or_insert_with(|| vec![Vec::new(); planners.len()])[at].push(row);
    }
    // What is solved is equally good.
    let gap = |rows: &Vec<&Row>| Some(Summary::of(rows.iter().map(|row| row.gap.max(targets::FINAL)))?.median);
    let time = |rows: &Vec<&Row>| expected_running_time(&attempts(rows.iter().copied(), NEAR));
    let gaps = groups.values().map(|group| group.iter().map(gap).collect()).collect();
    let times = groups.values().map(|group| group.iter().map(time).collect()).collect();
    (Ranking { planners: planners.clone(), costs: gaps }, Ranking { planners, costs: times })
}

fn shares(rows: &[Row]) -> Table {
    let dimensions = sorted(rows.iter().map(|row| row.dimension));
    let names: Vec<String> = dimensions.iter().map(|dimension| format!("D = {dimension}")).collect();
    let columns: Vec<&str> =
        ["planner"].into_iter().chain(names.iter().map(String::as_str)).chain(["all", "solved", "ended early"]).collect();
    let mut table = Table::new("bbob", "Share of targets reached within the budget, and runs that were solved", &columns);
    for contender in contenders(rows) {
        let own = || rows.iter().filter(|row| row.contender() == contender);
        let share = |(reached, all): (Vec<f64>, usize)| Cell::maybe((all > 0).then(|| reached.len() as f64 / all as f64), 3);
        let by_dimension = dimensions.iter().map(|dimension| share(times(own().filter(|row| row.dimension == *dimension))));
        let solved = own().filter(|row| row.gap <= targets::FINAL).count();
        let early = own().filter(|row| row.gap > targets::FINAL && row.evaluations < row.budget).count();
        let last = [Cell::Text(format!("{solved} of {}", own().count())), Cell::whole(early as u64)];
        table.rows.push([Cell::Text(contender.clone())].into_iter().chain(by_dimension).chain([share(times(own()))]).chain(last).collect());
    }
    table
}

/// The table that is printed.
pub(super) fn table(rows: &[Row]) -> Table {
    shares(rows)
}

/// So near to the optimum is the target of the tables and profiles of running times.
const NEAR: f64 = 0.1;

/// Expected running times to 10⁻¹ for each function, in one dimension.
fn running_times(rows: &[Row], dimension: usize) -> Table {
    let contenders = contenders(rows);
    let columns: Vec<&str> = ["function"].into_iter().chain(contenders.iter().map(String::as_str)).collect();
    let title = format!(
        "Expected evaluations until {NEAR} above the optimum, D = {dimension}, with 95 % intervals, and how many runs came so far; empty: none"
    );
    let mut table = Table::new(format!("ert-{dimension}"), title, &columns);
    for function in sorted(rows.iter().map(|row| row.function)) {
        let time = |contender: &String| {
            let own = rows.iter().filter(|row| row.function == function && row.dimension == dimension && row.contender() == *contender);
            expected(attempts(own, NEAR))
        };
        let name = Cell::Text(format!("f{function} {}", TITLES[function - 1]));
        table.rows.push([name].into_iter().chain(contenders.iter().map(time)).collect());
    }
    table
}

/// Writes the report and its picture.
pub(super) fn write(rows: &[Row], folder: &Path) -> Result<Vec<PathBuf>, Failure> {
    let [picture, profile, ranks] = ["targets.svg", "profile.svg", "ranks.svg"].map(|name| folder.join(name));
    draw(&picture, rows)?;
    let (gaps, times) = rankings(rows);
    times.draw_profile(&profile, "times the least expected evaluations")?;
    let ranked = gaps.draw_ranks(&ranks)?;
    let mut text = String::from("# bbob\n\n");
    let budget = sorted(rows.iter().map(|row| (row.budget / row.dimension as u64) as usize));
    let budget: Vec<String> = budget.iter().map(ToString::to_string).collect();
    // Writing to a text cannot fail.
    let _ = writeln!(
        text,
        "{} runs, at most {} evaluations for each variable; a run is over when it is {:e} above the optimum. Targets: {} from 100 to {:e} \
         above the optimum, for each function and instance. Planners run once, without restarts, and nothing is \
         counted beyond the budget. Runs that ended early came to an end of their own before the budget, unsolved.\n",
        rows.len(),
        budget.join(" or "),
        targets::FINAL,
        targets::COUNT,
        targets::FINAL,
    );
    let tables = [shares(rows)].into_iter().chain(sorted(rows.iter().map(|row| row.dimension)).into_iter().map(|d| running_times(rows, d)));
    for (k, table) in tables.enumerate() {
        text.push_str(&table.markdown());
        text.push('\n');
        if k == 0 {
            text.push_str("![Share of targets reached over evaluations for each variable](targets.svg)\n\n");
            text.push_str(
                &gaps.table("functions, in each dimension, by the median gap in the end").map_or(String::new(), |ranks| ranks.markdown()),
            );
            if ranked {
                text.push_str("\n![Mean ranks, with bars over those that do not differ](ranks.svg)\n\n");
            }
            text.push_str("![Share of functions that need at most so many times the least expected evaluations](profile.svg)\n\n");
        }
    }
    let report = folder.join("report.md");
    disk::write(&report, text).map_err(at(&report))?;
    Ok(vec![report, picture, profile].into_iter().chain(ranked.then_some(ranks)).collect())
}

/// The share of targets that were reached, over evaluations for each variable.
fn draw(path: &Path, rows: &[Row]) -> Result<(), Failure> {
    let most = rows.iter().map(|row| row.budget as f64 / row.dimension as f64).fold(10.0, f64::max);
    let x = Axis { title: "evaluations / D", range: 0.1..most, log: true };
    let y = Axis { title: "share of targets", range: 0.0..1.0, log: false };
    let curve = |contender: String| {
        let (reached, all) = times(rows.iter().filter(|row| row.contender() == contender));
        Curve::ecdf(&contender, &reached, all, [0.1, most])
    };
    plot::draw(path, &x, &y, &contenders(rows).into_iter().map(curve).collect::<Vec<_>>(), SeriesLabelPosition::UpperLeft)
}
