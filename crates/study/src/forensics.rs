//! What printed figures can rest on: how many runs, which paths, which other figures. Arithmetic on what the papers print, no runs.

mod texts;

use std::{cmp::Reverse, fmt::Write};

use serde::Serialize;

use forage::{kernel::Error, math, scene::shipped};

use super::{
    Failure, Options, Study,
    compared::{ComparedFigure, Printed},
    figure::{Figure, Steps},
    marks::Marked,
    papers::PAPERS,
    published::{
        ANTBAT, ANTBAT_TOURS, TABLE_1, TABLE_2, Tours, WOLF_ANT, WOLF_ANT_TURNS,
        wcpso::{self, PLANNERS},
    },
    report::Report,
    runner::Control,
    table::{Cell, Table},
    tours,
};

/// See the module.
pub const STUDY: Study = Study {
    name: "forensics",
    title: "what the printed figures can rest on",
    source: "our own",
    repeatable: true,
    jobs: |_| Ok(Vec::new()),
    run,
};

/// Whether a figure can be what the paper says it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Source {
    /// It can.
    Consistent,
    /// It can, but of something else than the paper says.
    Doubtful,
    /// It cannot, as it is printed.
    Impossible,
}

impl Source {
    /// In words.
    pub fn name(self) -> &'static str {
        match self {
            Self::Consistent => "consistent",
            Self::Doubtful => "doubtful",
            Self::Impossible => "impossible as printed",
        }
    }
}

/// What arithmetic says of a figure.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Finding {
    /// Where it stands: `[WCPSO] Table 2`.
    pub place: String,
    /// What is printed.
    pub figure: String,
    /// Whether it can be.
    pub source: Source,
    /// The arithmetic.
    pub because: String,
    /// The figures that it is about: how the table’s name begins, the row and the measure.
    pub rows: Vec<[String; 3]>,
}

impl Finding {
    fn new(place: &str, figure: impl Into<String>, source: Source, because: impl Into<String>) -> Self {
        Self { place: place.to_owned(), figure: figure.into(), source, because: because.into(), rows: Vec::new() }
    }

    /// Names a figure that it is about.
    fn about(mut self, table: &str, row: impl Into<String>, measure: &str) -> Self {
        self.rows.push([table.to_owned(), row.into(), measure.to_owned()]);
        self
    }
}

/// Numbers of runs of which a mean and a standard deviation can be.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Sample {
    /// How many runs.
    pub runs: u64,
    /// How many of them ended in each of the local minima.
    pub stuck: Vec<u64>,
}

/// The most runs that are tried.
const MOST_RUNS: u64 = 60;
/// What all runs together may be above the optimum that are not stuck.
const REST: f64 = 0.01;

/// All samples of 3 to `MOST_RUNS` runs that have this mean and this standard deviation (with n − 1), if some of them ended at
/// these values and the others at the optimum, which is 0: none below, and all together at most `REST` above.
pub fn samples(mean: Printed, std: Printed, minima: &[f64]) -> Vec<Sample> {
    let mut found = Vec::new();
    for runs in 3..=MOST_RUNS {
        let n = runs as f64;
        let sum = n * mean.value;
        let squares = (n - 1.0) * std.value * std.value + n * mean.value * mean.value;
        // What the digits that are not printed can change.
        let sum_error = 0.5 * n * mean.unit;
        let squares_error = (n - 1.0) * std.value * std.unit + n * mean.value * mean.unit;
        let mut stuck = vec![0; minima.len()];
        loop {
            let at = |of: fn(f64) -> f64| -> f64 { stuck.iter().zip(minima).map(|(&k, &value)| k as f64 * of(value)).sum() };
            let (rest, rest_squares) = (sum - at(|value| value), squares - at(|value| value * value));
            let others = runs.saturating_sub(stuck.iter().sum()) as f64;
            // What is left of the sum adds least to the squares if the runs at the optimum share it, most if all of it belongs to the
            // worst run.
            let above = rest.max(0.0);
            let worst = stuck.iter().zip(minima).filter(|(k, _)| **k > 0).map(|(_, value)| *value).fold(0.0, f64::max);
            let least = if others > 0.0 { above * above / others } else { 0.0 };
            let most = above * above + 2.0 * worst * above;
            let fits =
                (-sum_error..=REST + sum_error).contains(&rest) && (least - squares_error..=most + squares_error).contains(&rest_squares);
            if fits {
                found.push(Sample { runs, stuck: stuck.clone() });
            }
            if !advance(&mut stuck, runs, sum + sum_error, minima) {
                break;
            }
        }
    }
    found
}

/// The next numbers of stuck runs whose sum does not exceed what there is; false after the last.
fn advance(stuck: &mut [u64], runs: u64, sum: f64, minima: &[f64]) -> bool {
    for k in 0..stuck.len() {
        stuck[k] += 1;
        let total: f64 = stuck.iter().zip(minima).map(|(&n, value)| n as f64 * value).sum();
        if total <= sum && stuck.iter().sum::<u64>() <= runs {
            return true;
        }
        stuck[k] = 0;
    }
    false
}

/// The values of Ackley's function (a = 20, b = 0.2, c = 2π) in its local minima with 1, 2, … of `dimension` coordinates near 1 and
/// the others at 0.
pub fn ackley_minima(dimension: u32, most: u32) -> Vec<f64> {
    let d = f64::from(dimension);
    let value = |k: f64, t: f64| {
        let tau = std::f64::consts::TAU;
        -20.0 * math::exp(-0.2 * (k * t * t / d).sqrt()) - math::exp((k * math::cos(tau * t) + d - k) / d) + 20.0 + std::f64::consts::E
    };
    let minimum = |k: u32| {
        // Ternary search: there is one minimum between two tops of the cosine.
        let k = f64::from(k);
        let [mut low, mut high] = [0.6, 1.2];
        for _ in 0..200 {
            let third = (high - low) / 3.0;
            if value(k, low + third) < value(k, high - third) {
                high -= third;
            } else {
                low += third;
            }
        }
        value(k, f64::midpoint(low, high))
    };
    (1..=most).map(minimum).collect()
}

/// The least number of runs, none of them below 0, whose standard deviation (with n − 1) is so many times their mean: the ratio is at
/// most √n.
pub fn least_runs(mean: Printed, std: Printed) -> u64 {
    let ratio = (std.value - 0.5 * std.unit) / (mean.value + 0.5 * mean.unit);
    (ratio * ratio).ceil() as u64
}

/// By how much the second figure is less than the first, in per cent of the first.
fn fall([from, to]: [f64; 2]) -> f64 {
    100.0 * (from - to) / from
}

/// Gives each figure of a report the mark of the findings about it, the gravest first.
///
/// # Errors
/// As [`findings`].
pub fn attach(figures: &mut [ComparedFigure], paper: &str) -> Result<(), Error> {
    let mut findings = findings()?;
    findings.retain(|finding| finding.place.starts_with(&format!("[{paper}]")));
    findings.sort_by_key(|finding| Reverse(finding.source));
    for figure in figures {
        let is_about = |finding: &&Finding| {
            let is_it = |[table, row, measure]: &[String; 3]| {
                figure.table.starts_with(table.as_str()) && figure.row == *row && figure.measure == *measure
            };
            finding.rows.iter().any(is_it)
        };
        let mine: Vec<_> = findings.iter().filter(is_about).collect();
        figure.source = mine.first().map(|gravest| {
            let because: Vec<_> = mine.iter().map(|finding| format!("{}: {}", finding.figure, finding.because)).collect();
            Marked { mark: gravest.source, because: because.join("; ") }
        });
    }
    Ok(())
}

/// All findings, paper by paper.
///
/// # Errors
/// A printed figure that cannot be read.
pub fn findings() -> Result<Vec<Finding>, Error> {
    let mut findings = [wcpso()?, ltqpso(), antbat()?, wolf_ant()?, texts::findings()?].concat();
    findings.sort_by_key(|finding| PAPERS.iter().position(|paper| finding.place.starts_with(&format!("[{}]", paper.tag))));
    Ok(findings)
}

fn wcpso() -> Result<Vec<Finding>, Error> {
    let place = "[WCPSO] Table 2";
    let mut findings = Vec::new();
    let minima = ackley_minima(10, 3);
    let ackley = wcpso::TABLE_2.iter().find(|row| row.scene == "ackley").map(|row| row.results);
    for (planner, result) in PLANNERS.iter().zip(ackley.into_iter().flatten()) {
        let [mean, std] = [Printed::read(result[1])?, Printed::read(result[2])?];
        if mean.value < 1e-2 {
            continue;
        }
        let fitting = samples(mean, std, &minima);
        let told = |sample: &Sample| {
            let stuck = sample.stuck.iter().zip(&minima).filter(|(k, _)| **k > 0).map(|(k, value)| format!("{k} at {value:.6}"));
            format!("{} runs, {}", sample.runs, stuck.collect::<Vec<_>>().join(", "))
        };
        let as_said = fitting.iter().any(|sample| sample.runs == wcpso::RUNS);
        findings.push(Finding::new(
            place,
            format!("f5, 10 variables, {planner}: mean {}, standard deviation {}", result[1], result[2]),
            if as_said { Source::Consistent } else { Source::Doubtful },
            format!(
                "of 3 to {MOST_RUNS} runs that end at the optimum or in one of the three lowest local minima only these have both: {}; {} are said",
                if fitting.is_empty() { "none".to_owned() } else { fitting.iter().map(told).collect::<Vec<_>>().join("; ") },
                wcpso::RUNS
            ),
        )
        .about("Table 2", format!("f5, 10 variables: {planner}"), "value"));
    }
    for row in &wcpso::TABLE_2 {
        for (planner, [_, mean, std]) in PLANNERS.iter().zip(row.results) {
            let [mean, std] = [Printed::read(mean)?, Printed::read(std)?];
            if mean.value == 0.0 {
                continue;
            }
            let least = least_runs(mean, std);
            if least < 7 {
                continue;
            }
            findings.push(
                Finding::new(
                    place,
                    format!(
                        "{}, {} variables, {planner}: standard deviation {:.3} times the mean",
                        row.name,
                        row.dimension,
                        std.value / mean.value
                    ),
                    if least > wcpso::RUNS { Source::Impossible } else { Source::Consistent },
                    format!("at most √n for n results that are not negative: at least {least} runs"),
                )
                .about("Table 2", format!("{}, {} variables: {planner}", row.name, row.dimension), "value"),
            );
        }
    }
    Ok(findings)
}

fn ltqpso() -> Vec<Finding> {
    let mut findings = Vec::new();
    // The factor of (11) and the intercept of Table 2 that it comes from.
    for (what, factor, b0) in [("N", 0.3161, TABLE_2[1].b[0]), ("M", 0.1525, TABLE_2[3].b[0])] {
        let expected = Figure::new(factor, 4).like(math::exp(b0));
        findings.push(Finding::new(
            "[LTQPSO] (11)",
            format!("{what}: factor {factor}"),
            if expected == factor { Source::Consistent } else { Source::Impossible },
            format!("e^{b0} of Table 2 is {expected:.4}"),
        ));
    }
    for (table, lines) in [("Table 1", &TABLE_1), ("Table 2", &TABLE_2)] {
        for (name, line) in ["N min", "N max", "M min", "M max"].iter().zip(lines) {
            let [low, high] = line.interval[1];
            if !(low..=high).contains(&line.b[1]) {
                let because = "the interval of a fitted number holds it";
                let figure = format!("{name}: exponent {} in ({low}, {high})", line.b[1]);
                let finding = Finding::new(&format!("[LTQPSO] {table}"), figure, Source::Impossible, because);
                findings.push(finding.about(table, format!("ln {name}"), "b1"));
            }
        }
    }
    findings
}

fn antbat() -> Result<Vec<Finding>, Error> {
    let by = Steps::of(&*shipped("ant-bat-30")?)?;
    let place = "[ANTBAT] §3.1, table";
    let names = ["traditional", "[14]", "improved"];
    let mut findings = Vec::new();
    for ((name, planner), way) in names.iter().zip(["aco", "aco-dijkstra", "aco-direction"].iter()).zip(&ANTBAT) {
        findings.push(length(place, name, way.length, &by).about("§3.1", *planner, "length"));
        let eighths = way.turning.value / std::f64::consts::FRAC_PI_4;
        let whole = Figure::new(eighths.round() * std::f64::consts::FRAC_PI_4, 2);
        let fits = way.turning.like(whole.value) == way.turning.value;
        findings.push(
            Finding::new(
                place,
                format!("{name}: turning {:.2} rad", way.turning.value),
                if fits { Source::Consistent } else { Source::Impossible },
                format!(
                    "turns between the eight directions are multiples of 45°; {:.0} of them are {:.2} rad",
                    eighths.round(),
                    whole.value
                ),
            )
            .about("§3.1", *planner, "turning"),
        );
    }
    let seconds = [20.8, 18.6, 15.8];
    for (k, (said, what)) in [(24.04, "traditional ants"), (17.2, "[14]")].into_iter().enumerate() {
        let iterations = fall([ANTBAT[k].converged.value, ANTBAT[2].converged.value]);
        let times = fall([seconds[k], seconds[2]]);
        let digits = if k == 0 { 2 } else { 1 };
        let of_times = Figure::new(said, digits).like(times) == said;
        findings.push(Finding::new(
            "[ANTBAT] abstract",
            format!("convergence {said} % faster than the {what}"),
            if of_times { Source::Doubtful } else { Source::Impossible },
            format!("the printed iterations fall by {iterations:.2} %, the printed run times by {times:.2} %"),
        ));
    }
    for (k, said) in [7.62, 3.75].into_iter().enumerate() {
        let fell = fall([ANTBAT[k].length.value, ANTBAT[2].length.value]);
        let same = Figure::new(said, 2).like(fell) == said;
        let source = if same { Source::Consistent } else { Source::Impossible };
        findings.push(Finding::new(
            "[ANTBAT] abstract",
            format!("length {said} % shorter than {}", names[k]),
            source,
            format!("{fell:.2} % by its table"),
        ));
    }
    for (row, planner) in ANTBAT_TOURS.iter().zip(tours::PLANNERS) {
        let largest = row.largest_variance();
        findings.push(
            Finding::new(
                "[ANTBAT] Table 2",
                format!("{}: variance {:.2}", row.name, row.variance.value),
                if row.variance.like(largest) >= row.variance.value { Source::Consistent } else { Source::Impossible },
                format!("{} runs with the printed best, worst and mean have at most {largest:.2}", Tours::RUNS),
            )
            .about("Table 2", format!("{} ({planner})", row.name), "length"),
        );
    }
    Ok(findings)
}

fn wolf_ant() -> Result<Vec<Finding>, Error> {
    let scene = shipped("wolf-ant-20")?;
    let by = Steps::of(&scene)?;
    let (speed, turn) = scene.grid()?.robot.and_then(|robot| robot.speed.zip(robot.turn_time)).unwrap_or((f64::NAN, f64::NAN));
    let mut findings = Vec::new();
    for ((name, planner), [px, seconds]) in
        [("A*", "a-star"), ("traditional ants", "aco"), ("improved ants", "aco-wolf")].into_iter().zip(WOLF_ANT)
    {
        let mut finding = length("[WOLF-ANT] Table 2", name, px, &by);
        let of_time = (seconds.value - WOLF_ANT_TURNS.value * turn) * speed;
        if finding.source == Source::Impossible && (of_time - px.value).abs() < 1e-9 {
            // Writing to a text cannot fail.
            let _ = write!(
                finding.because,
                "; ({} s − {} s) · {speed} is {of_time:.4} exactly: the length was computed from the time",
                seconds.value,
                WOLF_ANT_TURNS.value * turn
            );
        }
        findings.push(finding.about("Table 2", planner, "length").about("Table 2, driven", name, "length, px"));
    }
    Ok(findings)
}

/// Whether a path from cell to cell can be so long.
fn length(place: &str, name: &str, figure: Figure, by: &Steps) -> Finding {
    let digits = figure.digits;
    let near: Vec<_> = by.around(figure.value).into_iter().flatten().map(|length| format!("{length:.digits$}")).collect();
    let (source, because) = if figure.is_length(by) {
        (Source::Consistent, "a path between these cells can have it".to_owned())
    } else {
        (Source::Impossible, format!("no path from cell to cell has it; the nearest lengths are {}", near.join(" and ")))
    };
    Finding::new(place, format!("{name}: length {:.digits$}", figure.value), source, because)
}

fn run(options: &Options, _control: &Control) -> Result<Report, Failure> {
    let mut report = Report::new(&STUDY, 0, 0);
    let mut table = Table::new("findings", "What the printed figures can rest on", &["where", "printed", "source", "why"]);
    for Finding { place, figure, source, because, .. } in findings()? {
        table.rows.push(vec![Cell::Text(place), Cell::Text(figure), source.name().into(), Cell::Text(because)]);
    }
    report.tables.push(table);
    report.notes = vec![
        "*consistent*: it can be what the paper says it is. *doubtful*: it can be, but of something else than the paper says. *impossible as printed*: no numbers give it.".to_owned(),
    ];
    report.write(options)?;
    Ok(report)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Printed {
        Printed::read(text).unwrap()
    }

    #[test]
    fn ackleys_lowest_local_minima() {
        let expected = [1.155_149, 1.646_224, 2.013_315];
        for (found, expected) in ackley_minima(10, 3).into_iter().zip(expected) {
            assert!((found - expected).abs() < 1e-6, "{found} is not {expected}");
        }
    }

    #[test]
    fn the_samples_of_a_known_list_are_found() {
        // Nine runs: one at 2, two at 1, the others at 0.
        let list: [f64; 9] = [2.0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
        let mean = list.iter().sum::<f64>() / 9.0;
        let std = (list.iter().map(|x| (x - mean) * (x - mean)).sum::<f64>() / 8.0).sqrt();
        let found = samples(read(&format!("{mean:.7}")), read(&format!("{std:.7}")), &[1.0, 2.0]);
        assert!(found.contains(&Sample { runs: 9, stuck: vec![2, 1] }), "{found:?}");
        assert!(samples(read("0.5"), read("0.1"), &[1.0, 2.0]).is_empty(), "of numbers from 0 and 1 to 2 none have so small a deviation");
    }

    #[test]
    fn so_many_times_the_mean_needs_so_many_runs() {
        // One result of n, the others 0: the standard deviation is √n times the mean.
        let list = |n: u64| [1.0 / n as f64, (1.0 / n as f64).sqrt()];
        for n in [4, 8, 50] {
            let [mean, std] = list(n).map(|x| read(&format!("{x:.9}")));
            assert_eq!(least_runs(mean, std), n);
            assert_eq!(least_runs(mean, read(&format!("{:.9}", std.value * 1.01))), n + 1 + u64::from(n == 50));
        }
    }

    #[test]
    fn the_papers_figures_that_cannot_be() {
        let found = findings().unwrap();
        let of =
            |figure: &str| found.iter().find(|finding| finding.figure.contains(figure)).unwrap_or_else(|| panic!("{figure}: {found:#?}"));
        for (figure, source, because) in [
            ("10 variables, wpso: mean", Source::Doubtful, "8 runs, 1 at 1.646224"),
            ("10 variables, pso: mean", Source::Doubtful, "16 runs, 2 at 1.155149, 1 at 1.646224, 1 at 2.013315"),
            ("3.734 times", Source::Consistent, "at least 14 runs"),
            ("M min: exponent", Source::Impossible, "holds it"),
            ("factor 0.3161", Source::Impossible, "0.3169"),
            ("traditional: length 45.53", Source::Impossible, "no path"),
            ("[14]: length 43.70", Source::Consistent, "can have"),
            ("13.38 rad", Source::Impossible, "17 of them are 13.35 rad"),
            ("7.07 rad", Source::Consistent, "9 of them are 7.07 rad"),
            ("24.04 %", Source::Doubtful, "14.29 %, the printed run times by 24.04 %"),
            ("17.2 %", Source::Impossible, "15.05 %"),
            ("bat: variance 0.95", Source::Impossible, "at most"),
            ("A*: length 602.8420", Source::Impossible, "computed from the time"),
            ("improved ants: length 562.8427", Source::Consistent, "can have"),
        ] {
            let finding = of(figure);
            assert!(finding.source == source && finding.because.contains(because), "{finding:?}");
        }
    }
}
