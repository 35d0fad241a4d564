//! Ants that share like wolves on the 20 × 20 grid, and the swarm that tunes them: [WOLF-ANT](forage#papers) Table 2 and §5.2.

use std::sync::Arc;

use forage::{
    Overrides, Setup, Value, geometry,
    kernel::{Error, ReferenceOptimum},
    scene::Scene,
    shipped,
};

use super::{
    colonies::{self, CONVERGED, LENGTH, Lines, RUNS, Run, SECONDS, SETTLED, TURNS, hits},
    compared::{ComparedFigure, Computed, Published},
    failure::Failure,
    figure::{Figure, Steps},
    fingerprints::JobList,
    marks::Basis,
    options::{Options, command},
    published::{TUNED, WOLF_ANT, WOLF_ANT_TURNS, wolf_ant_path},
    report::Report,
    runner::Control,
    study::Study,
    table::{Cell, Table},
    tuned::{self, Tuned},
};

/// See the module.
pub const REPRODUCTION: Study = Study {
    name: "wolf-ant",
    title: "a wolf-pack ant colony on the 20 × 20 grid, and its tuning",
    source: "[WOLF-ANT] Table 2 and §5.2",
    repeatable: true,
    jobs,
    run,
};

/// In the order of the paper's table.
const PLANNERS: [&str; 3] = ["a-star", "aco", "aco-wolf"];
/// What its figures rest on and the paper does not print.
const OPEN: &str = "the paper prints neither the layout of the obstacles nor how many runs its figures are of";
/// Tunings in full; of fewer runs a sixth.
const TUNINGS: u64 = 5;

const TUNINGS_FILE: &str = "wolf-ant-tunings.csv";
const FILE: &str = "wolf-ant-runs.csv";

/// Tunings that go with so many runs.
fn tunings(runs: u64) -> u64 {
    (runs * TUNINGS / RUNS).clamp(1, TUNINGS)
}

/// The planners with the published parameters.
fn setups(scene: &Arc<Scene>) -> Result<Vec<Setup>, Error> {
    PLANNERS.into_iter().zip([Overrides::new(), sizes(), sizes()]).map(|(name, params)| colonies::published(name, scene, &params)).collect()
}

/// The tunings, and the runs that do not need them.
fn jobs(options: &Options) -> Result<Vec<JobList>, Failure> {
    let runs = options.runs_or(RUNS)?;
    let scene = shipped("wolf-ant-20")?;
    let tunings = JobList::new(TUNINGS_FILE, tuned::tasks(&scene, tunings(runs)));
    Ok(vec![tunings, JobList::new(FILE, colonies::tasks(&setups(&scene)?, runs))])
}

fn run(options: &Options, control: &Control) -> Result<Report, Failure> {
    let runs = options.runs_or(RUNS)?;
    let scene = shipped("wolf-ant-20")?;
    let tunings_file = options.out.join(TUNINGS_FILE);
    let tuned = tuned::carry_out(&scene, tunings(runs), &tunings_file, options, control)?;
    let mut setups = setups(&scene)?;
    setups.extend(tuned.iter().map(|tuned| tuned.setup(&scene)));
    let path = options.out.join(FILE);
    let mut found = colonies::carry_out(&setups, runs, &path, options, control)?;
    let with_tuned = found.split_off(PLANNERS.len());

    let mut report = colonies::report(&REPRODUCTION, runs);
    report.files.extend([tunings_file, path]);
    report.tables.push(ways(&scene, &found, runs));
    for (k, setup) in setups[..PLANNERS.len()].iter().enumerate() {
        for (measure, figure) in [(LENGTH, WOLF_ANT[k][0]), (TURNS, WOLF_ANT_TURNS), (SECONDS, WOLF_ANT[k][1])] {
            report.figures.push(measure.compared("Table 2", PLANNERS[k], figure, &found[k], OPEN, command(setup)));
        }
    }
    report.figures.extend(printed(&scene)?);
    for (k, (name, value)) in TUNED.into_iter().enumerate() {
        report.figures.push(ComparedFigure {
            table: "§5.2".to_owned(),
            group: name.to_owned(),
            row: format!("tuned {name}"),
            measure: "value".to_owned(),
            lower_is_better: false,
            published: Published::figure(Figure::new(value, if value.fract() == 0.0 { 0 } else { 3 })),
            computed: Computed::runs(tuned.iter().map(|tuned| tuned.tuned()[k].1)),
            basis: Basis::Reconstruction("several sets of parameters are equally good, and the paper does not print how runs judge them"),
            source: None,
            command: command(&tuned::setup(&scene, 1)),
        });
    }
    report.tables.push(optima(&scene, &tuned, &found[2], &with_tuned));
    report.notes = notes(&scene, &found, &tuned)?;
    report.commands = setups[..PLANNERS.len()].iter().chain([&tuned::setup(&scene, 1)]).map(command).collect();
    report.write(options)?;
    Ok(report)
}

/// What the path comes to that the paper prints cell by cell: no run and no layout is needed.
fn printed(scene: &Arc<Scene>) -> Result<Vec<ComparedFigure>, Error> {
    let path = wolf_ant_path(scene)?;
    let (length, turns) = (geometry::length(&path), geometry::turns(&path) as f64);
    // A point, as in the paper: it never comes near the obstacle.
    let point = [("path", "printed"), ("robot", "given"), ("robot_radius", "0"), ("margin", "0")];
    let params = point.map(|(name, value)| (name, Value::from(value))).into_iter().collect();
    let replay = Setup { planner: "a-star-drive".to_owned(), scene: Arc::clone(scene), params, seed: 1 };
    let seconds = colonies::seconds(scene, length, turns);
    let measures = [("length", WOLF_ANT[2][0], Some(length)), ("turns", WOLF_ANT_TURNS, Some(turns)), ("seconds", WOLF_ANT[2][1], seconds)];
    let figure = |(measure, figure, computed): (&str, Figure, Option<f64>)| ComparedFigure {
        table: "§6, the printed path".to_owned(),
        group: String::new(),
        row: "improved ants".to_owned(),
        measure: measure.to_owned(),
        lower_is_better: true,
        published: Published::figure(figure),
        computed: computed.map_or(Computed::Nothing, Computed::Exact),
        basis: Basis::Printed,
        source: None,
        command: command(&replay),
    };
    Ok(measures.into_iter().map(figure).collect())
}

/// 30 ants, 100 iterations.
fn sizes() -> Overrides {
    [("ants", 30.0), ("iterations", 100.0)].map(|(name, number)| (name, Value::Number(number))).into_iter().collect()
}

/// Table 2 and the computed ones.
fn ways(scene: &Arc<Scene>, found: &[Vec<Run>], runs: u64) -> Table {
    let title = format!("Table 2: from cell 21 to cell 378, 30 ants, 100 iterations, seeds 1 to {runs}; lengths in px");
    let mut lines = Lines::new(scene, "table-2", title);
    let published = |k: usize| [Some(WOLF_ANT[k][0]), Some(WOLF_ANT_TURNS), Some(WOLF_ANT[k][1]), None, None];
    for (at, measure) in [LENGTH, TURNS, SECONDS, CONVERGED, SETTLED].iter().enumerate() {
        // The steps of a search are no iterations that could converge.
        for k in if at >= 3 { 1..3 } else { 0..3 } {
            lines.push(PLANNERS[k], measure, published(k)[at], &found[k]);
        }
    }
    lines.table
}

/// What the tunings recommend, and how it does with seeds that they have not seen.
fn optima(scene: &Scene, tuned: &[Tuned], published: &[Run], with_tuned: &[Vec<Run>]) -> Table {
    let columns = ["parameters", "α", "β", "ρ", "Q", "ε", "fitness", "its converged", "mean", "worst", "hits", "converged"];
    let title = format!("§5.2: what 20 particles find in 30 iterations, and its lengths with seeds 1 to {}", published.len());
    let mut table = Table::new("tuning", title, &columns);
    let optimum = scene.optimum(ReferenceOptimum::Cells).unwrap_or(f64::NAN);
    let mut push = |label: String, parameters: [f64; 5], judged: [Option<f64>; 2], runs: &[Run]| {
        let length = LENGTH.summary(runs);
        let mut row = vec![Cell::Text(label)];
        row.extend(parameters.into_iter().zip([3, 3, 3, 1, 3]).map(|(value, digits)| Cell::Number(value, digits)));
        row.extend([Cell::maybe(judged[0], 4), Cell::maybe(judged[1], 2)]);
        row.extend([Cell::maybe(length.map(|s| s.mean), 4), Cell::maybe(length.map(|s| s.max), 4)]);
        row.push(Cell::Text(format!("{} of {}", hits(runs, LENGTH.of, optimum), runs.len())));
        row.push(Cell::maybe(CONVERGED.summary(runs).map(|s| s.mean), 2));
        table.rows.push(row);
    };
    push("published".to_owned(), TUNED.map(|(_, value)| value), [None; 2], published);
    for (tuned, runs) in tuned.iter().zip(with_tuned) {
        let label = format!("found, seed {}", tuned.seed);
        push(label, tuned.tuned().map(|(_, value)| value), [Some(tuned.length), Some(tuned.converged)], runs);
    }
    table
}

/// Smallest and largest of a parameter over the tunings.
fn range(tuned: &[Tuned], k: usize) -> [f64; 2] {
    let values = || tuned.iter().map(|tuned| tuned.tuned()[k].1);
    [values().fold(f64::INFINITY, f64::min), values().fold(f64::NEG_INFINITY, f64::max)]
}

fn notes(scene: &Scene, found: &[Vec<Run>], tuned: &[Tuned]) -> Result<Vec<String>, Failure> {
    let by = Steps::of(scene)?;
    let mut notes = colonies::notes(found);
    notes.push("A true A* cannot be longer than the ants: the published 602.8420 px is not what an exact search finds by the rule that the published best path keeps to. Computed is exact (no cutting of corners, as all here), so nothing is shorter; it draws nothing, so that all seeds give one way, and of ways equally short it takes any: it does not count turns.".to_owned());
    let misprinted: Vec<_> = WOLF_ANT
        .iter()
        .map(|[length, _]| length)
        .filter(|length| !length.is_length(&by))
        .filter_map(|length| {
            let near = by
                .around(length.value)
                .into_iter()
                .flatten()
                .min_by(|a, b| (a - length.value).abs().total_cmp(&(b - length.value).abs()))?;
            let count = found[1..].iter().flatten().filter_map(LENGTH.of).filter(|found| (found - near).abs() < 1e-9 * near).count();
            Some(format!("{:.4} (next to it is {near:.4}, which {count} of our runs have)", length.value))
        })
        .collect();
    if !misprinted.is_empty() {
        notes.push(format!(
            "No path from cell to cell has the published lengths {}: only their last digits are off.",
            misprinted.join(", ")
        ));
    }
    notes.push("`seconds`: length / speed + turns × the time of a turn, with the scene’s robot (20 px/s, 1 s). aco runs with the parameters of [ANTBAT], and the ants and iterations of aco-wolf; the paper prints no other parameters of its traditional ants.".to_owned());
    let spread: Vec<_> = TUNED
        .iter()
        .enumerate()
        .map(|(k, (name, value))| {
            let [low, high] = range(tuned, k);
            format!("{name} {value} beside {low:.3} to {high:.3}")
        })
        .collect();
    notes.push(format!(
        "Tuning: 20 particles, 30 iterations, each set of parameters judged by the mean length over 3 seeds of the colony, ties by the iteration of convergence. `fitness` and `its converged` are those means, the columns after them what the recommended parameters give with the seeds of the first table: three seeds are few, and what is best for them is not best for others. Published beside found over {} swarms: {}. ε cancels out of the choice (4), as all ranks have it: it cannot be identified, whatever is printed or found.",
        tuned.len(),
        spread.join(", "),
    ));
    Ok(notes)
}
