//! How the planners compare: by planner, and by the problems' lengths.

use std::{
    collections::BTreeMap,
    fmt::Write as _,
    path::{Path, PathBuf},
};

use forage::{kernel::Message, statistics::Summary};
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
    row::{Row, TOLERANCE},
};

/// So many bands of buckets at most has the table of the report.
const BANDS: u64 = 10;
/// And so many have the pictures.
const DRAWN: u64 = 40;

/// What rows have in common.
struct Aggregate {
    problems: usize,
    found: usize,
    optimal: usize,
    gaps: Option<Summary>,
    seconds: Option<Summary>,
    evaluations: Option<Summary>,
}

impl Aggregate {
    fn of<'a>(rows: impl Iterator<Item = &'a Row>) -> Self {
        let rows: Vec<&Row> = rows.collect();
        Self {
            problems: rows.len(),
            found: rows.iter().filter(|row| row.length.is_some()).count(),
            optimal: rows.iter().filter(|row| row.is_optimal()).count(),
            gaps: Summary::of(rows.iter().filter_map(|row| row.gap())),
            seconds: Summary::of(rows.iter().map(|row| row.seconds)),
            evaluations: Summary::of(rows.iter().map(|row| row.evaluations as f64)),
        }
    }

    /// Problems, found, at the optimum, mean gap and largest gap in %, median time in ms, median evaluations.
    fn cells(&self) -> [Cell; 7] {
        [
            Cell::whole(self.problems as u64),
            Cell::whole(self.found as u64),
            Cell::whole(self.optimal as u64),
            Cell::maybe(self.gaps.map(|gap| 100.0 * gap.mean), 3),
            Cell::maybe(self.gaps.map(|gap| 100.0 * gap.max), 2),
            Cell::significant(self.seconds.map(|seconds| 1e3 * seconds.median), 3),
            Cell::maybe(self.evaluations.map(|evaluations| evaluations.median), 0),
        ]
    }
}

const COLUMNS: [&str; 7] = ["problems", "found", "optimal", "mean gap, %", "largest gap, %", "median time, ms", "median evaluations"];

fn contenders(rows: &[Row]) -> Vec<String> {
    distinct(rows.iter().map(Row::contender))
}

/// A row for each planner.
pub(super) fn planners(rows: &[Row]) -> Table {
    let columns: Vec<&str> = ["planner"].into_iter().chain(COLUMNS).collect();
    let mut table = Table::new("movingai", "Against the optima of the files", &columns);
    for contender in contenders(rows) {
        let group = Aggregate::of(rows.iter().filter(|row| row.contender() == contender));
        table.rows.push([Cell::Text(contender)].into_iter().chain(group.cells()).collect());
    }
    table
}

/// A planner's groups, with the first bucket and the last one of each.
type Banded = (String, Vec<([u64; 2], Aggregate)>);

/// The rows of each planner by bands of buckets: so many at most, with the first bucket and the last one of each.
fn by_band(rows: &[Row], bands: u64) -> Vec<Banded> {
    let most = rows.iter().map(|row| row.bucket).max().unwrap_or(0);
    let width = most.saturating_add(1).div_ceil(bands);
    let of = |contender: String| {
        let mut bands: BTreeMap<u64, Vec<&Row>> = BTreeMap::new();
        for row in rows.iter().filter(|row| row.contender() == contender) {
            bands.entry(row.bucket / width).or_default().push(row);
        }
        let ends = |band: u64| [band * width, (band * width).saturating_add(width - 1).min(most)];
        let groups = bands.into_iter().map(|(band, own)| (ends(band), Aggregate::of(own.into_iter())));
        (contender, groups.collect())
    };
    contenders(rows).into_iter().map(of).collect()
}

/// A row for each planner and band.
fn table(rows: &[Row], name: &str, title: &str, bands: u64) -> Table {
    let columns: Vec<&str> = ["planner", "buckets"].into_iter().chain(COLUMNS).collect();
    let mut table = Table::new(name, title, &columns);
    for (contender, groups) in by_band(rows, bands) {
        for ([from, to], group) in groups {
            let name = if from == to { from.to_string() } else { format!("{from}–{to}") };
            table.rows.push([Cell::Text(contender.clone()), Cell::Text(name)].into_iter().chain(group.cells()).collect());
        }
    }
    table
}

/// A quantity of the groups over the buckets.
fn curves(rows: &[Row], of: impl Fn(&Aggregate) -> Option<f64>) -> Vec<Curve> {
    let curve = |(name, groups): Banded| {
        let points = groups.iter().filter_map(|([from, to], group)| Some((f64::midpoint(*from as f64, *to as f64), of(group)?)));
        Curve { name, points: points.collect() }
    };
    by_band(rows, DRAWN).into_iter().map(curve).collect()
}

/// Writes the report, its pictures and the table by bucket.
pub(super) fn write(rows: &[Row], notes: &[Message], folder: &Path) -> Result<Vec<PathBuf>, Failure> {
    let [report, time, gap, by_bucket] = ["report.md", "time.svg", "gap.svg", "buckets.csv"].map(|name| folder.join(name));
    let x = || Axis::linear("bucket: length / 4", 0.0, rows.iter().map(|row| row.bucket as f64));
    let values = |curves: &[Curve]| curves.iter().flat_map(|curve| curve.points.iter().map(|(_, y)| *y)).collect::<Vec<_>>();
    let times = curves(rows, |group| group.seconds.map(|seconds| 1e3 * seconds.median));
    plot::draw(&time, &x(), &Axis::log("median time, ms", values(&times).into_iter()), &times, SeriesLabelPosition::LowerRight)?;
    let gaps = curves(rows, |group| group.gaps.map(|gap| 100.0 * gap.mean));
    let least = values(&gaps).into_iter().fold(0.0, f64::min);
    plot::draw(&gap, &x(), &Axis::linear("mean gap, %", least, values(&gaps).into_iter()), &gaps, SeriesLabelPosition::LowerRight)?;
    disk::write(&by_bucket, table(rows, "buckets", "By bucket", u64::MAX).csv().map_err(at(&by_bucket))?).map_err(at(&by_bucket))?;

    let files = distinct(rows.iter().map(|row| row.file.clone())).len();
    let faults = rows.iter().filter(|row| row.is_fault()).count();
    let exact = rows.iter().filter(|row| row.exact).count();
    let mut text = String::from("# movingai\n\n");
    // Writing to a text cannot fail.
    let _ = writeln!(
        text,
        "{} runs on the problems of {files} files. The optimum is the one that the file gives, from cell to cell without cutting corners; gaps \
         are to it, so planners that go at any angle may be below 0. A result counts as optimal within {TOLERANCE:e} of it, or within the digits of an optimum that is given with six. Planners that \
         say they are exact missed the optimum in {faults} of {exact} runs. Times are of the machine that it was run on, and cover the start and all steps of a run, not the reading of the map.\n",
        rows.len(),
    );
    for note in notes {
        let _ = writeln!(text, "- {note}");
    }
    if !notes.is_empty() {
        text.push('\n');
    }
    text.push_str(&planners(rows).markdown());
    text.push_str("\n![Median time over the bucket](time.svg)\n\n![Mean gap over the bucket](gap.svg)\n\n");
    text.push_str(&table(rows, "bands", "By length: a bucket is four cells long", BANDS).markdown());
    disk::write(&report, text).map_err(at(&report))?;
    Ok(vec![report, time, gap, by_bucket])
}
