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
            failure::{Failure, at},
            table::{Cell, Table},
        },
        suite::{distinct, empty},
    },
    row::Row,
    score,
};

/// The results that the repository has of its own planner, in Gazebo.
const DWA: &str = "res/dwa_out.txt";

/// What counts of a run.
struct Result {
    set: String,
    success: bool,
    collided: bool,
    timeout: bool,
    time: f64,
    score: f64,
}

fn results(rows: &[Row], contender: &str) -> Vec<Result> {
    let own = rows.iter().filter(|row| row.contender() == contender);
    let result = |row: &Row| {
        let Row { success, collided, timeout, time, score, .. } = *row;
        Result { set: row.set.clone(), success, collided, timeout, time, score }
    };
    own.map(result).collect()
}

/// Lines of the challenge: world, success, collided, timeout, time, and a score by an older rule. Of the worlds that have rows.
fn published(folder: &Path, rows: &[Row]) -> Vec<Result> {
    let best: BTreeMap<usize, f64> = rows.iter().map(|row| (row.world, row.best)).collect();
    let text = fs::read_to_string(folder.join(DWA)).unwrap_or_default();
    let line = |line: &str| {
        let numbers: Vec<f64> = line.split_whitespace().map(|number| number.parse().ok()).collect::<Option<_>>()?;
        let &[world, success, collided, timeout, time, _] = numbers.as_slice() else { return None };
        let best = *best.get(&(world as usize))?;
        let set = if world < 300.0 { "BARN" } else { "DynaBARN" };
        let [success, collided, timeout] = [success, collided, timeout].map(|flag| flag > 0.0);
        Some(Result { set: set.to_owned(), success, collided, timeout, time, score: score(success, best, time) })
    };
    text.lines().filter_map(line).collect()
}

fn line(set: &str, name: &str, results: &[Result]) -> Option<Vec<Cell>> {
    let own: Vec<&Result> = results.iter().filter(|result| result.set == set).collect();
    let share = |of: &dyn Fn(&Result) -> bool| {
        let count = own.iter().filter(|result| of(result)).count();
        Cell::Number(100.0 * count as f64 / own.len() as f64, 1)
    };
    let successes = own.iter().filter(|result| result.success).count();
    let interval = proportion(successes, own.len())?;
    let scores: Vec<f64> = own.iter().map(|result| result.score).collect();
    let mean = |groups: &[Vec<f64>]| groups[0].iter().sum::<f64>() / groups[0].len() as f64;
    let score = mean(std::slice::from_ref(&scores));
    let bounds = bootstrap(&[scores], RESAMPLES, &mut Stream::new(1, 0), mean);
    let time = Summary::of(own.iter().filter(|result| result.success).map(|result| result.time));
    Some(vec![
        set.into(),
        name.into(),
        Cell::whole(own.len() as u64),
        share(&|result| result.success),
        Cell::Number(100.0 * interval[0], 1),
        Cell::Number(100.0 * interval[1], 1),
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
    let columns =
        ["set", "planner", "worlds", "success %", "from", "to", "collision %", "timeout %", "no way %", "time, s", "score", "from", "to"];
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

/// Writes the report and, for each planner, the file that `report_test.py` reads.
pub(super) fn write(rows: &[Row], data: &Path, folder: &Path) -> std::result::Result<Vec<PathBuf>, Failure> {
    let logs = folder.join("challenge");
    empty(&logs)?;
    for contender in distinct(rows.iter().map(Row::contender)) {
        let file = logs.join(format!("{}.txt", contender.replace(|c: char| !(c.is_alphanumeric() || c == '-'), "_")));
        let mut text = String::new();
        for row in rows.iter().filter(|row| row.contender() == contender) {
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
        fs::write(&file, text).map_err(at(&file))?;
    }
    let mut text = String::from("# barn\n\n");
    // Writing to a text cannot fail.
    let _ = writeln!(
        text,
        "{} runs. The robot is a disc that drives from cell to cell at 2 m/s and stands while it turns; it is no physical model, and sees \
         moving obstacles within 10 m. A run succeeds within a metre of the goal, without having touched anything, within 100 s. The score is \
         the challenge’s: the best time at 2 m/s, by the time taken, which counts as at least twice and at most eight times the best; 0 \
         without success. For DynaBARN the best time is that of 20 m; the repository’s own script has a sign wrong there, by which each \
         success scores 0.125. `DWA, in Gazebo` is what the repository has of its own planner in its own simulation, of the same worlds: another robot, scored by its times. The \
         folder `challenge` has files for `report_test.py`.\n",
        rows.len(),
    );
    text.push_str(&table(rows, data).markdown());
    let report = folder.join("report.md");
    fs::write(&report, text).map_err(at(&report))?;
    Ok(vec![report, logs])
}
