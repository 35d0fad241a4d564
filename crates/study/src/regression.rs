//! How N and M grow with D: the regression of [LTQPSO](forage#papers) §3, Tables 1 and 2, repeated.
//!
//! The paper increases N and M "in turn" until the standard deviation of 100 results falls under 0.05, and records "the
//! largest and the smallest". It says neither how N and M go together nor over what the extremes are taken. Our rule:
//! both begin at 4, N and M grow in turn by a fifth (at least by 1), the first sizes that pass count; smallest and
//! largest are taken over [`BLOCKS`] blocks of 100 seeds.

use forage::math;

use super::{
    chart,
    compared::{ComparedFigure, Computed, Published},
    failure::Failure,
    figure::Figure,
    fingerprints::JobList,
    fit::{self, Fit},
    marks::Basis,
    options::{Options, command},
    published::{Regression, TABLE_1, TABLE_2},
    quantities::{Case, QUANTITIES, Quantity, Range},
    report::Report,
    runner::{self, Control},
    search::{Aim, Found, LIMIT, Start, THRESHOLD, Task},
    study::Study,
    table::{Cell, Table},
};

/// See the module.
pub const REPRODUCTION: Study = Study {
    name: "ltqpso-regression",
    title: "how many particles and iterations ltqpso needs for D segments",
    source: "[LTQPSO] Tables 1 and 2",
    repeatable: true,
    jobs: |options| Ok(vec![JobList::new(FILE, tasks(options.runs_or(RUNS)?))]),
    run,
};

/// Searches a D and start, each with seeds of its own.
pub const BLOCKS: u64 = 3;
/// The paper's number of runs.
const RUNS: u64 = 100;
const SEGMENTS: std::ops::RangeInclusive<u64> = 5..=20;

const CASES: [Case; 2] = [
    Case { start: Start::Uniform, name: "table-1", title: "Table 1: uniform start", published: TABLE_1 },
    Case { start: Start::Normal, name: "table-2", title: "Table 2: start N(30°, 45°)", published: TABLE_2 },
];

const FILE: &str = "ltqpso-regression-runs.csv";

fn tasks(runs: u64) -> Vec<Task> {
    let mut tasks = Vec::new();
    for Case { start, .. } in CASES {
        for segments in SEGMENTS {
            tasks.extend((0..BLOCKS).map(|block| Task { aim: Aim::Search, start, segments, block, runs }));
            tasks.push(Task { aim: Aim::Published, start, segments, block: 0, runs });
        }
    }
    tasks
}

fn run(options: &Options, control: &Control) -> Result<Report, Failure> {
    let runs = options.runs_or(RUNS)?;
    let path = options.out.join(FILE);
    let rows = runner::run(&tasks(runs), &path, options.fresh, options.threads, control)?;
    let mut report = report(&rows, runs, options)?;
    report.files.insert(0, path);
    Ok(report)
}

/// What the rows say.
fn report(rows: &[Found], runs: u64, options: &Options) -> Result<Report, Failure> {
    let mut report = REPRODUCTION.report(runs, RUNS);
    for case in &CASES {
        let ranges: Vec<Range> = SEGMENTS.filter_map(|d| range(rows, case.start, d)).collect();
        let fits = QUANTITIES.map(|(_, of)| power_law(&ranges, of));
        report.tables.push(sizes(case, rows));
        report.tables.push(coefficients(case, &fits));
        report.figures.extend(figures(case, &fits, ranges.len() as u64));
        let reached: Vec<_> = ranges.iter().map(|range| range.d).collect();
        report.notes.push(format!("{}: the fit is over D = {reached:?}, where all {BLOCKS} blocks passed.", case.title));
        let picture = options.out.join(format!("ltqpso-regression-{}.svg", case.name));
        chart::draw(&picture, case, &ranges, &fits)?;
        report.files.push(picture);
        let example = rows.iter().find(|row| row.start == case.start && row.aim == Aim::Search);
        if let Some(Found { aim, start, segments, block, runs, population, iterations, .. }) = example.cloned() {
            report.commands.push(command(&Task { aim, start, segments, block, runs }.setup([population, iterations], 1)?));
        }
    }
    report.notes.extend([
        format!("Without obstacles, from (0, 0) to (10, 10), smoothing, redraws and early stop off. The paper does not say how N and M are increased together, nor over what minimum and maximum are taken. Here both begin at 4 and grow in turn by a fifth (at least by 1); the first pair whose {runs} lengths have a standard deviation under {THRESHOLD} counts; extremes over {BLOCKS} blocks of seeds."),
        format!("A search ends at N · M = {LIMIT} positions a run, to keep the whole within minutes: a D at which a block came so far is left out of the fit. With hours to spare, raise `LIMIT` in `crates/study/src/search.rs`."),
        "The fit is of logarithms by least squares, with 95 % confidence intervals (t) as Matlab’s `regress` gives; published R² that cannot be read are computed from the published F and 16 points (the three legible ones agree with that). The interval of Table 1’s b1 of M min does not contain its value: so printed.".to_owned(),
    ]);
    report.write(options)?;
    Ok(report)
}

fn searches(rows: &[Found], start: Start, d: u64) -> impl Iterator<Item = &Found> {
    rows.iter().filter(move |row| row.aim == Aim::Search && row.start == start && row.segments == d)
}

/// Smallest and largest over the blocks; `None` if one of them did not pass.
fn range(rows: &[Found], start: Start, d: u64) -> Option<Range> {
    let found: Vec<_> = searches(rows, start, d).collect();
    let extremes = |of: fn(&Found) -> u64| Some([found.iter().map(|row| of(row)).min()?, found.iter().map(|row| of(row)).max()?]);
    let (n, m) = (extremes(|row| row.population)?, extremes(|row| row.iterations)?);
    found.iter().all(|row| row.reached).then_some(Range { d, n, m })
}

/// ln y = b0 + b1 ln D.
fn power_law(ranges: &[Range], of: Quantity) -> Option<Fit> {
    let points: Vec<_> = ranges.iter().map(|range| [math::ln(range.d as f64), math::ln(of(range) as f64)]).collect();
    fit::line(&points)
}

/// What was found for each D, and what the published sizes give.
fn sizes(case: &Case, rows: &[Found]) -> Table {
    let columns = ["D", "N min", "N max", "M min", "M max", "passed", "published N", "published M", "std there", "mean there"];
    let title = format!("{}: N and M at which the standard deviation falls under {THRESHOLD}", case.title);
    let mut table = Table::new(format!("{}-sizes", case.name), title, &columns);
    for d in SEGMENTS {
        let found: Vec<_> = searches(rows, case.start, d).collect();
        let passed = found.iter().filter(|row| row.reached).count();
        let mut row = vec![Cell::whole(d)];
        match range(rows, case.start, d) {
            Some(Range { n, m, .. }) => row.extend([n[0], n[1], m[0], m[1]].map(Cell::whole)),
            None => row.extend((0..4).map(|_| Cell::Empty)),
        }
        let more = if passed < found.len() { format!(", others need N M > {LIMIT}") } else { String::new() };
        row.push(Cell::Text(format!("{passed} of {}{more}", found.len())));
        match rows.iter().find(|row| row.aim == Aim::Published && row.start == case.start && row.segments == d) {
            Some(at) => {
                row.extend([Cell::whole(at.population), Cell::whole(at.iterations), Cell::maybe(at.std, 4), Cell::maybe(at.mean, 4)]);
            }
            None => row.extend((0..4).map(|_| Cell::Empty)),
        }
        table.rows.push(row);
    }
    table
}

fn interval([low, high]: [f64; 2]) -> Cell {
    Cell::Text(format!("({low:.2}, {high:.2})"))
}

/// Computed and the published line for each quantity.
fn coefficients(case: &Case, fits: &[Option<Fit>; 4]) -> Table {
    let columns = ["ln", "from", "b0", "b0 95 %", "b1", "b1 95 %", "R²", "F", "p", "points"];
    let mut table = Table::new(case.name, format!("{}: ln N or ln M = b0 + b1 ln D", case.title), &columns);
    for (((name, _), fit), published) in QUANTITIES.iter().zip(fits).zip(&case.published) {
        let of = |k: usize| fit.map_or([Cell::Empty, Cell::Empty], |fit| [Cell::Number(fit.b[k], 4), interval(fit.interval[k])]);
        let mut computed = vec![Cell::from(*name), "here".into()];
        computed.extend([0, 1].into_iter().flat_map(of));
        computed.extend([Cell::maybe(fit.map(|fit| fit.r2), 4), Cell::maybe(fit.map(|fit| fit.f), 2)]);
        computed
            .extend([fit.map_or(Cell::Empty, |fit| Cell::Text(format!("{:.1e}", fit.p))), Cell::maybe(fit.map(|fit| fit.count as f64), 0)]);
        table.rows.push(computed);
        let [b0, b1] = published.b.map(|b| Cell::Number(b, 4));
        let [around_b0, around_b1] = published.interval.map(interval);
        let rest = [Cell::Number(published.r2(), 4), Cell::Number(published.f, 2), Cell::Empty, Cell::Number(Regression::POINTS, 0)];
        table.rows.push([Cell::from(*name), "published".into(), b0, around_b0, b1, around_b1].into_iter().chain(rest).collect());
    }
    table
}

/// What the paper leaves open of its regression.
const OPEN: &str = "the paper says neither how N and M are increased together nor over what the extremes are taken";

/// The published coefficients and the computed ones.
fn figures(case: &Case, fits: &[Option<Fit>; 4], points: u64) -> Vec<ComparedFigure> {
    let mut figures = Vec::new();
    for (((name, _), fit), published) in QUANTITIES.into_iter().zip(fits).zip(&case.published) {
        for k in [0, 1] {
            figures.push(ComparedFigure {
                table: case.title.to_owned(),
                group: String::new(),
                row: format!("ln {name}"),
                measure: format!("b{k}"),
                lower_is_better: false,
                published: Published { runs: Some(RUNS), ..Published::figure(Figure::new(published.b[k], 4)) },
                computed: fit.map_or(Computed::Nothing, |fit| Computed::Fitted { value: fit.b[k], interval: fit.interval[k], points }),
                basis: Basis::Reconstruction(OPEN),
                source: None,
                command: format!("forage reproduce {}", REPRODUCTION.name),
            });
        }
    }
    figures
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(d: u64, block: u64, [population, iterations]: [u64; 2], reached: bool) -> Found {
        let (aim, start) = (Aim::Search, Start::Uniform);
        let (mean, std, sizes, evaluations) = (Some(14.2), Some(0.04), 3, 100);
        Found { aim, start, segments: d, block, runs: 100, limit: LIMIT, population, iterations, reached, mean, std, sizes, evaluations }
    }

    #[test]
    fn extremes_are_over_the_blocks_and_only_where_all_passed() {
        let rows = [found(5, 0, [10, 9], true), found(5, 1, [8, 12], true), found(6, 0, [9, 9], true), found(6, 1, [99, 99], false)];
        assert_eq!(range(&rows, Start::Uniform, 5), Some(Range { d: 5, n: [8, 10], m: [9, 12] }));
        assert_eq!(range(&rows, Start::Uniform, 6), None);
        assert_eq!(range(&rows, Start::Normal, 5), None);
    }

    #[test]
    fn a_power_law_is_a_line_in_logarithms() {
        let ranges: Vec<_> = [2, 4, 8].map(|d| Range { d, n: [3 * d * d, 1], m: [1, 1] }).into();
        let fit = power_law(&ranges, |range| range.n[0]).unwrap();
        assert!((fit.b[0] - math::ln(3.0)).abs() < 1e-12 && (fit.b[1] - 2.0).abs() < 1e-12, "{fit:?}");
    }

    /// Rows that follow N = D² and M = 2 D exactly: the fit finds it, and the picture shows it.
    #[test]
    fn the_fit_is_shown_beside_the_published_one_and_drawn() {
        let mut rows: Vec<_> = (5..=12).flat_map(|d| (0..3).map(move |block| found(d, block, [d * d, 2 * d], true))).collect();
        rows.push(found(13, 0, [151, 126], false));
        rows.push(Found { aim: Aim::Published, ..found(5, 0, [7, 10], false) });
        let folder = tempfile::tempdir().unwrap();
        let out = folder.path().to_owned();
        let report = report(&rows, 100, &Options { out: out.clone(), threads: None, runs: None, fresh: false }).unwrap();
        let text = report.text(&crate::table::as_it_is);
        for part in ["2.0000  (2.00, 2.00)", "(1.62, 1.82)", "-1.8788", "0 of 1, others need N M > 20000", "seed 1 "] {
            assert!(text.contains(part), "{part}: {text}");
        }
        let picture = std::fs::read_to_string(out.join("ltqpso-regression-table-1.svg")).unwrap();
        assert!(picture.starts_with("<svg") && picture.contains("N max, published") && picture.contains("M min, here"));
    }
}
