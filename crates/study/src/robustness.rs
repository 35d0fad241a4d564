//! Every grid planner with its default parameters on random maps of every generator: what it is worth beyond the papers' maps.

use std::sync::{Arc, atomic::AtomicBool};

use serde::{Deserialize, Serialize};

use forage::{
    Overrides, Setup, Value,
    describe::Entry,
    kernel::Error,
    scene::{GRID, Scene},
    standard,
    statistics::Summary,
};

use super::{
    failure::Failure,
    fingerprints::JobList,
    options::Options,
    report::Report,
    rows::KeyedRow,
    runner::{self, Control, Job},
    study::Study,
    table::{Cell, Table},
};

/// See the module.
pub const STUDY: Study = Study {
    name: "robustness",
    title: "grid planners with default parameters on random maps",
    source: "our own",
    repeatable: true,
    jobs: |options| Ok(vec![JobList::new(FILE, tasks(options.runs_or(MAPS)?))]),
    run,
};

/// Maps of each generator and size.
const MAPS: u64 = 100;
/// Cells along each side of a map.
const SIDES: [u32; 2] = [20, 50];
const FILE: &str = "robustness-runs.csv";
/// The relative gap up to which a length is the optimum: sums of the same steps in another order.
const OPTIMAL: f64 = 1e-9;

/// A run: a planner on a map, with the map's number as its seed.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct Run {
    planner: String,
    generator: String,
    side: u32,
    map: u64,
    feasible: bool,
    /// (length − exact) / exact, by the optimum of the rule that the planner keeps to.
    gap: Option<f64>,
    /// The iteration from which all members of the planner's population agree; none if they do not, or if it has no such reading.
    settled: Option<f64>,
    evaluations: u64,
}

impl KeyedRow for Run {
    fn key(&self) -> String {
        key(&self.planner, &self.generator, self.side, self.map)
    }
}

fn key(planner: &str, generator: &str, side: u32, map: u64) -> String {
    format!("{planner}, {generator} {side} × {side}, map {map}")
}

struct Task {
    planner: &'static str,
    generator: &'static str,
    side: u32,
    map: u64,
}

impl Task {
    fn setup(&self) -> Result<Setup, Error> {
        let scene = Arc::new(map(self.generator, self.side, self.map)?);
        Ok(Setup { planner: self.planner.to_owned(), scene, params: Overrides::new(), seed: self.map })
    }
}

impl Job for Task {
    type Row = Run;

    fn key(&self) -> String {
        key(self.planner, self.generator, self.side, self.map)
    }

    fn run(&self, _stop: &AtomicBool) -> Result<Option<Run>, Error> {
        let mut run = forage::Run::with_keyframes(standard(), self.setup()?, 0)?;
        run.step(u64::MAX);
        let outcome = run.outcome();
        let settled = outcome.readings.iter().find(|(name, _)| *name == "settled").map(|(_, value)| *value);
        Ok(Some(Run {
            planner: self.planner.to_owned(),
            generator: self.generator.to_owned(),
            side: self.side,
            map: self.map,
            feasible: outcome.feasible,
            gap: outcome.gap.filter(|_| outcome.feasible),
            settled: settled.filter(|value| outcome.feasible && value.is_finite()),
            evaluations: outcome.evaluations,
        }))
    }
}

/// The order in which the rows are published, whatever the registry's is. Planners that come later follow.
const ORDER: &[&str] = &[
    "wcpso",
    "pso",
    "wpso",
    "cpso",
    "ltqpso",
    "qpso",
    "bat-continuous",
    "cuckoo-search",
    "pso-rrt",
    "aco-wolf",
    "aco-direction",
    "aco-dijkstra",
    "aco",
    "a-star",
    "dijkstra",
    "theta-star",
    "rrt-guided",
];

/// The planners that look for one path on a grid. Those that drive along paths or tune other planners do other work.
fn planners() -> impl Iterator<Item = &'static Entry> {
    let finds_a_path = |entry: &&Entry| !entry.stops && !["dynamic", "tuning"].contains(&entry.family);
    let mut found: Vec<_> =
        standard().planners().iter().copied().filter(|entry| entry.kinds.contains(&GRID)).filter(finds_a_path).collect();
    // The sort is stable.
    found.sort_by_key(|entry| ORDER.iter().position(|name| *name == entry.name).unwrap_or(ORDER.len()));
    found.into_iter()
}

fn settings(side: u32) -> Overrides {
    ["columns", "rows"].map(|name| (name, Value::from(f64::from(side)))).into_iter().collect()
}

fn map(generator: &str, side: u32, map: u64) -> Result<Scene, Error> {
    standard().generate(generator, &settings(side), map)
}

/// Map by map, so that a part of them says something of all planners.
fn tasks(maps: u64) -> Vec<Task> {
    let mut tasks = Vec::new();
    for side in SIDES {
        for generator in standard().generators_of(GRID) {
            for map in 1..=maps {
                tasks.extend(planners().map(|entry| Task { planner: entry.name, generator: generator.name, side, map }));
            }
        }
    }
    tasks
}

fn run(options: &Options, control: &Control) -> Result<Report, Failure> {
    let maps = options.runs_or(MAPS)?;
    let path = options.out.join(FILE);
    let runs = runner::run(&tasks(maps), &path, options.fresh, options.threads, control)?;
    let mut report = STUDY.report(maps, MAPS);
    report.shortened = (maps != MAPS).then(|| format!("{maps} maps of each kind instead of {MAPS}"));
    report.files.push(path);
    for side in SIDES {
        for generator in standard().generators_of(GRID) {
            let some: Vec<&Run> = runs.iter().filter(|run| run.side == side && run.generator == generator.name).collect();
            report.tables.push(table(generator.name, side, maps, &some));
        }
    }
    report.notes = vec![
        "Default parameters, one run on each map, the map’s number as its seed. A path from start to goal exists on every map.".to_owned(),
        "`solved`: the result was checked and is free of collisions. `optimal`: it is as long as the exact optimum; `mean gap` and `worst gap` are those of the solved maps, in per cent of the optimum. The optimum is that of the rule which the planner keeps to: over cells, or at any angle. `settled`: on how many maps the members of the population agreed at the end (their mean within 1 % of their best), and since which iteration, the median over those maps; empty for planners without that reading.".to_owned(),
        "Planners do not get the same number of evaluations here: each has its default iterations and population.".to_owned(),
    ];
    report.commands = SIDES
        .into_iter()
        .flat_map(|side| standard().generators_of(GRID).map(move |generator| (generator.name, side)))
        .map(|(generator, side)| format!("forage generate {generator} --set columns={side} --set rows={side} --seed 1 --out map.json"))
        .collect();
    report.write(options)?;
    Ok(report)
}

/// A line for each planner.
fn table(generator: &str, side: u32, maps: u64, runs: &[&Run]) -> Table {
    let columns = ["planner", "solved", "optimal", "mean gap %", "worst gap %", "settled", "since"];
    let title = format!("{generator}, {side} × {side} cells, {maps} maps");
    let mut table = Table::new(format!("{generator}-{side}"), title, &columns);
    for entry in planners() {
        let mine = || runs.iter().filter(|run| run.planner == entry.name);
        let count = |of: &dyn Fn(&Run) -> bool| Cell::whole(mine().filter(|run| of(run)).count() as u64);
        // A sum in another order is no gap.
        let gap = Summary::of(mine().filter_map(|run| run.gap).map(|gap| if gap.abs() < OPTIMAL { 0.0 } else { 100.0 * gap }));
        let settled = Summary::of(mine().filter_map(|run| run.settled));
        let tells = entry.readings.iter().any(|reading| reading.name == "settled");
        table.rows.push(vec![
            entry.name.into(),
            count(&|run| run.feasible),
            count(&|run| run.gap.is_some_and(|gap| gap.abs() < OPTIMAL)),
            Cell::maybe(gap.map(|gap| gap.mean), 2),
            Cell::maybe(gap.map(|gap| gap.max), 1),
            if tells { count(&|run| run.settled.is_some()) } else { Cell::Empty },
            Cell::maybe(settled.map(|settled| settled.median), 0),
        ]);
    }
    table
}

#[cfg(test)]
mod tests {
    use super::*;

    fn run(map: u64, gap: Option<f64>, settled: Option<f64>) -> Run {
        let (planner, generator) = ("aco".to_owned(), "maze".to_owned());
        Run { planner, generator, side: 20, map, feasible: gap.is_some(), gap, settled, evaluations: 1 }
    }

    #[test]
    fn a_line_counts_what_its_planner_did() {
        let runs = [run(1, Some(1e-15), Some(10.0)), run(2, Some(0.25), None), run(3, None, None), run(4, Some(0.05), Some(30.0))];
        let table = table("maze", 20, 4, &runs.iter().collect::<Vec<_>>());
        let line = table.rows.iter().find(|row| row[0] == Cell::from("aco")).unwrap();
        let number = Cell::Number;
        assert_eq!(line[1..], [number(3.0, 0), number(1.0, 0), number(10.0, 2), number(25.0, 1), number(2.0, 0), number(20.0, 0)]);
        let none = table.rows.iter().find(|row| row[0] == Cell::from("a-star")).unwrap();
        assert_eq!((&none[1], &none[3], &none[5]), (&number(0.0, 0), &Cell::Empty, &Cell::Empty));
    }

    #[test]
    fn every_map_has_a_path_and_exact_planners_find_the_optimum() {
        for task in tasks(2).iter().filter(|task| task.side == SIDES[0] && task.planner == "a-star") {
            let row = task.run(&AtomicBool::new(false)).unwrap().unwrap();
            assert!(row.feasible && row.gap.is_some_and(|gap| gap.abs() < OPTIMAL), "{row:?}");
        }
    }
}
