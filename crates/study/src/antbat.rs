//! Three colonies on the 30 × 30 grid: [ANTBAT](forage#papers) §3.1, its table of ways.

use forage::{
    Overrides, Setup,
    kernel::{Error, ReferenceOptimum},
    scene::Scene,
    shipped, standard,
};

use super::{
    chart::{self, Curve},
    colonies::{self, CONVERGED, LENGTH, Lines, Measure, RUNS, Run, SETTLED, SMOOTH_LENGTH, SMOOTH_TURNING, SMOOTH_TURNS, TURNING, TURNS},
    disk,
    failure::{Failure, at},
    figure::{Figure, Steps},
    fingerprints::JobList,
    options::{Options, command},
    published::{ANTBAT, Way},
    report::Report,
    runner::Control,
    study::Study,
    table::{Cell, Table},
};

/// See the module.
pub const REPRODUCTION: Study = Study {
    name: "antbat-paths",
    title: "three colonies of ants on the 30 × 30 grid",
    source: "[ANTBAT] §3.1",
    repeatable: true,
    jobs: |options| Ok(vec![JobList::new(FILE, colonies::tasks(&setups()?, options.runs_or(RUNS)?))]),
    run,
};

/// In the order of the paper's table.
const PLANNERS: [&str; 3] = ["aco", "aco-dijkstra", "aco-direction"];

/// A measure and where its figure stands in the paper.
type Printed = (Measure, fn(&Way) -> Figure);

const OVER_CELLS: [Printed; 5] = [
    (LENGTH, |way| way.length),
    (TURNS, |way| way.turns),
    (TURNING, |way| way.turning),
    (CONVERGED, |way| way.converged),
    (SETTLED, |way| way.converged),
];
const SMOOTHED: [Printed; 3] = [(SMOOTH_LENGTH, |way| way.length), (SMOOTH_TURNS, |way| way.turns), (SMOOTH_TURNING, |way| way.turning)];

/// What its figures rest on and the paper does not print.
const OPEN: &str = "the paper prints neither the layout of the obstacles nor how many runs its figures are of";

const FILE: &str = "antbat-paths-runs.csv";

fn setups() -> Result<Vec<Setup>, Error> {
    let scene = shipped("ant-bat-30")?;
    PLANNERS.into_iter().map(|planner| colonies::published(planner, &scene, &Overrides::new())).collect()
}

fn run(options: &Options, control: &Control) -> Result<Report, Failure> {
    let runs = options.runs_or(RUNS)?;
    let scene = shipped("ant-bat-30")?;
    let setups = setups()?;
    let path = options.out.join(FILE);
    let found = colonies::carry_out(&setups, runs, &path, options, control)?;
    let mut report = colonies::report(&REPRODUCTION, runs);
    report.files.push(path);
    for (name, title, measures) in [
        ("over-cells", "Ways from cell to cell", &OVER_CELLS as &[Printed]),
        ("smoothed", "The same ways without redundant nodes", &SMOOTHED),
    ] {
        let title = format!("{title}, published parameters (50 ants, 100 iterations), seeds 1 to {runs}");
        let mut lines = Lines::new(&scene, name, title);
        for (measure, published) in measures {
            for (k, planner) in PLANNERS.into_iter().enumerate() {
                let figure = published(&ANTBAT[k]);
                lines.push(planner, measure, Some(figure), &found[k]);
                if name == "over-cells" {
                    report.figures.push(measure.compared("§3.1", planner, figure, &found[k], OPEN, command(&setups[k])));
                }
            }
        }
        report.tables.push(lines.table);
    }
    report.notes = colonies::notes(&found);
    report.notes.extend(impossible(&scene)?);
    report.notes.push("Published are 7.07 rad for 9 turns, which is nine times 45°: the published paths are those from cell to cell. Q, φ1 and φ2 are not printed; they are the planners’ defaults here.".to_owned());
    draw(&mut report, &scene, &setups[0], &found, options)?;
    report.commands = setups.iter().map(command).collect();
    report.write(options)?;
    Ok(report)
}

/// Published lengths that no way between these cells has.
fn impossible(scene: &Scene) -> Result<Option<String>, Error> {
    let by = Steps::of(scene)?;
    let lengths: Vec<_> = ANTBAT
        .iter()
        .filter(|way| !way.length.is_length(&by))
        .map(|way| {
            let around: Vec<_> = by.around(way.length.value).into_iter().flatten().map(|length| format!("{length:.4}")).collect();
            format!("{:.2} (next to it are {})", way.length.value, around.join(" and "))
        })
        .collect();
    Ok((!lengths.is_empty()).then(|| {
        format!("No path from cell to cell between these cells has the published lengths {}: they were measured in some other way, so compare with care.", lengths.join(", "))
    }))
}

/// The mean best length over the iterations, as CSV and as a picture.
fn draw(report: &mut Report, scene: &Scene, setup: &Setup, found: &[Vec<Run>], options: &Options) -> Result<(), Failure> {
    let iterations = forage::Run::new(standard(), setup.clone())?.limit();
    let means: Vec<_> = found.iter().map(|runs| mean_curve(runs, iterations)).collect();
    let mut table = Table::new("convergence", "Mean length of the best way", &["iteration", PLANNERS[0], PLANNERS[1], PLANNERS[2]]);
    for k in 0..iterations as usize {
        table.rows.push([Cell::whole(k as u64 + 1)].into_iter().chain(means.iter().map(|mean| Cell::maybe(mean[k], 4))).collect());
    }
    let path = options.out.join("antbat-paths-convergence.csv");
    table.csv().and_then(|text| disk::write(&path, text)).map_err(at(&path))?;
    report.files.push(path);
    let points = |mean: &Vec<Option<f64>>| (1..).zip(mean).filter_map(|(k, mean)| Some([f64::from(k), (*mean)?])).collect();
    let curves: Vec<_> = PLANNERS.into_iter().zip(&means).map(|(name, mean)| Curve { name, points: points(mean) }).collect();
    let path = options.out.join("antbat-paths-convergence.svg");
    if let Some(exact) = scene.optimum(ReferenceOptimum::Cells) {
        let title = format!("{}: mean over {} seeds", scene.name(), found[0].len());
        chart::convergence(&path, &title, &curves, ("exact optimum", exact))?;
        report.files.push(path);
    }
    Ok(())
}

/// The mean over the runs after each iteration, from the first after which all have found a way.
fn mean_curve(runs: &[Run], iterations: u64) -> Vec<Option<f64>> {
    let curves: Vec<_> = runs.iter().map(|run| run.curve(iterations)).collect();
    let mean = |k: usize| Some(curves.iter().map(|curve| curve[k]).sum::<Option<f64>>()? / curves.len() as f64);
    (0..iterations as usize).map(mean).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn run(improved: &str) -> Run {
        Run { improved: improved.to_owned(), ..Run::default() }
    }

    #[test]
    fn the_mean_curve_begins_where_all_runs_have_a_way() {
        let runs = [run("1:8 3:6"), run("2:4")];
        assert_eq!(mean_curve(&runs, 4), [None, Some(6.0), Some(5.0), Some(5.0)]);
        assert_eq!(mean_curve(&[run("")], 2), [None, None]);
    }
}
