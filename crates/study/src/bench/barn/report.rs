//! How the robots came through, and the files that the challenge's own report reads.

use std::{
    collections::BTreeMap,
    fmt::Write as _,
    fs,
    path::{Path, PathBuf},
};

use forage::{
    kernel::rng::Stream,
    statistics::{RESAMPLES, Summary, bootstrap, proportion},
};

use super::{
    super::{
        super::{
            disk,
            failure::{Failure, at},
            plot::{self, Bar},
            table::{Cell, Table},
        },
        suite::{distinct, recreate_folder, safe_file_name},
    },
    row::{Row, score},
};

/// The results that the repository has of its own planner, in Gazebo.
const DWA: &str = "res/dwa_out.txt";

/// `report_test.py` knows every sixth of the 300 static worlds.
const EVERY: usize = 6;
const BARN: usize = 300;

/// What counts of a run.
struct Outcome {
    set: String,
    world: usize,
    success: bool,
    collided: bool,
    timeout: bool,
    time: f64,
    score: f64,
}

fn results(rows: &[Row], contender: &str) -> Vec<Outcome> {
    let own = rows.iter().filter(|row| row.contender() == contender);
    let result = |row: &Row| {
        let Row { success, collided, timeout, time, score, .. } = *row;
        Outcome { set: row.set.clone(), world: row.world, success, collided, timeout, time, score }
    };
    own.map(result).collect()
}

/// Lines of the challenge: world, success, collided, timeout, time, and a score by an older rule. Of the worlds that have rows.
fn published(folder: &Path, rows: &[Row]) -> Vec<Outcome> {
    let best: BTreeMap<usize, f64> = rows.iter().map(|row| (row.world, row.best)).collect();
    let text = fs::read_to_string(folder.join(DWA)).unwrap_or_default();
    let line = |line: &str| {
        let numbers: Vec<f64> = line.split_whitespace().map(|number| number.parse().ok()).collect::<Option<_>>()?;
        let &[world, success, collided, timeout, time, _] = numbers.as_slice() else { return None };
        let best = *best.get(&(world as usize))?;
        let set = if world < 300.0 { "BARN" } else { "DynaBARN" };
        let [success, collided, timeout] = [success, collided, timeout].map(|flag| flag > 0.0);
        Some(Outcome { set: set.to_owned(), world: world as usize, success, collided, timeout, time, score: score(success, best, time) })
    };
    text.lines().filter_map(line).collect()
}

fn line(set: &str, name: &str, results: &[Outcome]) -> Option<Vec<Cell>> {
    let mut worlds: BTreeMap<usize, Vec<&Outcome>> = BTreeMap::new();
    results.iter().filter(|result| result.set == set).for_each(|result| worlds.entry(result.world).or_default().push(result));
    let runs: usize = worlds.values().map(Vec::len).sum();
    // Each world counts as much, however many runs it has.
    let by_world = |of: &dyn Fn(&Outcome) -> f64| -> Vec<f64> {
        worlds.values().map(|runs| runs.iter().map(|run| of(run)).sum::<f64>() / runs.len() as f64).collect()
    };
    let mean = |groups: &[Vec<f64>]| groups[0].iter().sum::<f64>() / groups[0].len() as f64;
    let share = |of: &dyn Fn(&Outcome) -> bool| Cell::Number(100.0 * mean(&[by_world(&|run| f64::from(u8::from(of(run))))]), 1);
    // Runs of one world are not independent: then there is no interval of a share.
    let successes = worlds.values().flatten().filter(|result| result.success).count();
    let interval = proportion(successes, runs)?;
    let interval = (runs == worlds.len()).then_some(interval);
    let scores = by_world(&|run| run.score);
    let score = mean(std::slice::from_ref(&scores));
    let bounds = bootstrap(&[scores], RESAMPLES, &mut Stream::new(1, 0), mean);
    let time = Summary::of(worlds.values().flatten().filter(|result| result.success).map(|result| result.time));
    Some(vec![
        set.into(),
        name.into(),
        Cell::whole(worlds.len() as u64),
        Cell::whole(runs as u64),
        share(&|result| result.success),
        Cell::maybe(interval.map(|interval| 100.0 * interval[0]), 1),
        Cell::maybe(interval.map(|interval| 100.0 * interval[1]), 1),
        share(&|result| result.collided),
        share(&|result| result.timeout),
        share(&|result| !(result.success || result.collided || result.timeout)),
        Cell::maybe(time.map(|time| time.mean), 1),
        Cell::Number(score, 4),
        Cell::maybe(bounds.map(|bounds| bounds[0]), 4),
        Cell::maybe(bounds.map(|bounds| bounds[1]), 4),
    ])
}

/// By set and planner.
pub(super) fn table(rows: &[Row], folder: &Path) -> Table {
    let columns = [
        "set",
        "planner",
        "worlds",
        "runs",
        "success %",
        "success from",
        "success to",
        "collision %",
        "timeout %",
        "gave up %",
        "time, s",
        "score",
        "score from",
        "score to",
    ];
    let title = "Runs by how they ended, with 95 % intervals; the mean time of those that succeeded, and the challenge’s mean score";
    let mut table = Table::new("barn", title, &columns);
    let dwa = published(folder, rows);
    for set in distinct(rows.iter().map(|row| row.set.clone())) {
        for contender in distinct(rows.iter().map(Row::contender)) {
            table.rows.extend(line(&set, &contender, &results(rows, &contender)));
        }
        table.rows.extend(line(&set, "DWA, in Gazebo", &dwa));
    }
    table
}

/// The challenge's score of each planner in each set, with its interval.
fn draw(path: &Path, table: &Table) -> Result<(), Failure> {
    let number = |cell: &Cell| if let Cell::Number(number, _) = cell { Some(*number) } else { None };
    let name = |cell: &Cell| if let Cell::Text(name) = cell { name.clone() } else { String::new() };
    let bar = |row: &Vec<Cell>| {
        let [score, low, high] = [11, 12, 13].map(|column| number(&row[column]));
        let name = format!("{}, {}", name(&row[1]), name(&row[0]));
        Some(Bar { name, value: score?, interval: low.zip(high).map(|(low, high)| [low, high]) })
    };
    plot::draw_values(path, "the challenge’s score", &table.rows.iter().filter_map(bar).collect::<Vec<_>>())
}

/// Writes the report with its picture and, for each planner, the file that `report_test.py` reads.
pub(super) fn write(rows: &[Row], data: &Path, folder: &Path) -> Result<Vec<PathBuf>, Failure> {
    let logs = folder.join("challenge");
    recreate_folder(&logs)?;
    for contender in distinct(rows.iter().map(Row::contender)) {
        let file = logs.join(format!("{}.txt", safe_file_name(&contender)));
        let mut text = String::new();
        for row in rows.iter().filter(|row| row.contender() == contender && row.world < BARN && row.world % EVERY == 0) {
            let flag = u8::from;
            // Writing to a text cannot fail.
            let _ = writeln!(
                text,
                "{} {} {} {} {:.4} {:.4}",
                row.world,
                flag(row.success),
                flag(row.collided),
                flag(row.timeout),
                row.time,
                row.score
            );
        }
        disk::write(&file, text).map_err(at(&file))?;
    }
    let mut text = String::from("# barn\n\n");
    // Writing to a text cannot fail.
    let _ = writeln!(
        text,
        "{} runs. A run succeeds within a metre of the goal, within 100 s and without a collision. The robot is a disc that drives at 2 m/s \
         from cell to cell and stops to turn, no physical model. `DWA, in Gazebo`: what the repository has of its own planner and robot, on \
         those of the worlds that it has. The folder `challenge` has the files for `report_test.py`, which knows every sixth static world.\n",
        rows.len(),
    );
    let table = table(rows, data);
    let [report, picture] = ["report.md", "score.svg"].map(|name| folder.join(name));
    draw(&picture, &table)?;
    text.push_str(&table.markdown());
    text.push_str("\n![The challenge’s score of each planner, with 95 % intervals](score.svg)\n");
    disk::write(&report, text).map_err(at(&report))?;
    Ok(vec![report, picture, logs])
}
