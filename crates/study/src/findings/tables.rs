//! What arithmetic says of the papers' tables.

use std::fmt::Write;

use forage::{kernel::Error, math, scene::GridScene, shipped};

use super::{
    super::{
        compared::Printed,
        figure::{Figure, Steps},
        marks::Source,
        published::{
            ANTBAT, ANTBAT_TOURS, TABLE_1, TABLE_2, Tours, WOLF_ANT, WOLF_ANT_TURNS,
            wcpso::{self, PLANNERS},
        },
        tours,
    },
    finding::Finding,
    samples::{MOST_RUNS, Sample, ackley_minima, fall, least_runs, samples},
};

/// What arithmetic says of tables, paper by paper.
pub(super) fn findings() -> Result<Vec<Finding>, Error> {
    Ok([wcpso()?, ltqpso(), antbat()?, wolf_ant()?].concat())
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
        let shown = |sample: &Sample| {
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
                if fitting.is_empty() { "none".to_owned() } else { fitting.iter().map(shown).collect::<Vec<_>>().join("; ") },
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
    let (speed, turn) = scene.get::<GridScene>()?.robot.and_then(|robot| robot.speed.zip(robot.turn_time)).unwrap_or((f64::NAN, f64::NAN));
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
