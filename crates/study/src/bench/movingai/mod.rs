//! The suite `movingai`: all problems of the `.scen` files in a folder, against the optima that the files give.
//!
//! <https://movingai.com/benchmarks/formats.html>

mod load;
mod report;
mod row;

use std::{
    collections::BTreeMap,
    path::{Path, PathBuf},
    sync::{
        Arc,
        atomic::{AtomicBool, Ordering},
    },
};

use forage::{
    Error, Registry, Run, Setup, Status,
    kernel::Message,
    scene::{GRID, GridScene, Header, grid},
};
use forage_formats::movingai::Problem;

pub use row::Row;

use self::{load::ScenarioFolder, row::key};
use super::{
    super::{failure::Failure, runner::Job, table::Table},
    suite::{Contender, Suite, SuiteJob, check_count},
};

/// The problems of a folder.
pub struct Plan {
    folder: Arc<ScenarioFolder>,
    /// Of each bucket of a file the first so many; `None`: all.
    per_bucket: Option<usize>,
}

/// A planner on a problem.
#[derive(Clone)]
pub struct Task {
    registry: Arc<Registry>,
    folder: Arc<ScenarioFolder>,
    contender: Arc<Contender>,
    /// The file of problems, and the problem in it, from 0.
    at: [usize; 2],
}

impl Plan {
    /// Reads the problems of all `.scen` files in a folder and the folders in it. Maps are looked for there, too.
    ///
    /// # Errors
    /// A folder without a problem that has its map; a file that cannot be read.
    pub fn read(folder: &Path, per_bucket: Option<usize>) -> Result<Self, Failure> {
        Ok(Self { folder: Arc::new(ScenarioFolder::read(folder)?), per_bucket })
    }

    /// File and number of each problem that is run.
    fn chosen(&self) -> Vec<[usize; 2]> {
        let mut all = Vec::new();
        for (file, scenario) in self.folder.scenarios.iter().enumerate() {
            let mut taken: BTreeMap<u64, usize> = BTreeMap::new();
            for &(number, problem) in &scenario.problems {
                let taken = taken.entry(problem.bucket()).or_default();
                *taken += 1;
                if self.per_bucket.is_none_or(|most| *taken <= most) {
                    all.push([file, number]);
                }
            }
        }
        all
    }
}

impl Suite for Plan {
    type Task = Task;

    const NAME: &'static str = "movingai";

    fn all_planners(registry: &Registry) -> Vec<Contender> {
        let planners = registry.planners().iter().filter(|entry| entry.kinds.contains(&GRID) && !entry.stops);
        planners.map(|entry| Contender::new(entry.name)).collect()
    }

    /// The families that have an exact planner: they are fast enough for thousands of problems.
    fn default_planners(registry: &Registry) -> Vec<Contender> {
        let is_exact = |contender: &Contender| {
            let entry = registry.planner(&contender.planner).ok()?;
            Some((entry.family, (entry.exact)(&entry.configure(GRID, &contender.params).ok()?)))
        };
        let all_planners = Self::all_planners(registry);
        let families: Vec<&str> = all_planners.iter().filter_map(is_exact).filter(|(_, exact)| *exact).map(|(family, _)| family).collect();
        all_planners.into_iter().filter(|contender| is_exact(contender).is_some_and(|(family, _)| families.contains(&family))).collect()
    }

    fn jobs(&self, registry: &Arc<Registry>, contenders: &[Contender]) -> Result<Vec<Task>, Error> {
        let chosen = self.chosen();
        check_count(chosen.len().saturating_mul(contenders.len()))?;
        let mut all = Vec::new();
        for contender in contenders {
            let contender = Arc::new(contender.clone());
            all.extend(chosen.iter().map(|&at| Task {
                registry: Arc::clone(registry),
                folder: Arc::clone(&self.folder),
                contender: Arc::clone(&contender),
                at,
            }));
            // One problem says for all what is set wrongly.
            if let Some(task) = all.last() {
                task.setup()?.check(registry).map_err(|error| error.within(&contender.planner))?;
            }
        }
        Ok(all)
    }

    fn write(&self, rows: &[Row], folder: &Path) -> Result<Vec<PathBuf>, Failure> {
        report::write(rows, self.notes(), folder)
    }

    fn table(&self, rows: &[Row]) -> Table {
        report::planners(rows)
    }

    fn faults(&self, rows: &[Row]) -> Vec<Message> {
        rows.iter().filter(|row| row.is_fault()).map(Row::fault).collect()
    }

    fn notes(&self) -> &[Message] {
        &self.folder.notes
    }
}

impl Task {
    fn problem(&self) -> Problem {
        let [file, number] = self.at;
        let problems = &self.folder.scenarios[file].problems;
        problems[problems.partition_point(|(at, _)| *at < number)].1
    }

    fn setup(&self) -> Result<Setup, Error> {
        let [file, number] = self.at;
        let scenario = &self.folder.scenarios[file];
        let Problem { start, goal, .. } = self.problem();
        let map: Arc<GridScene> = self.folder.map(scenario.map)?;
        let name = format!("{} {number}", scenario.name);
        let scene = grid::KIND.scene(Header::named(&name, &name), map.with_ends([start, goal]))?;
        let Contender { planner, params } = (*self.contender).clone();
        Ok(Setup { planner, scene: Arc::new(scene), params, seed: number as u64 + 1 })
    }

    fn carry_out(&self, stop: &AtomicBool) -> Result<Option<Row>, Error> {
        let [file, number] = self.at;
        let scenario = &self.folder.scenarios[file];
        let problem = self.problem();
        let setup = self.setup()?;
        let scene = Arc::clone(&setup.scene);
        #[expect(clippy::disallowed_types, reason = "what it takes is measured, and is no part of the result")]
        let begun = std::time::Instant::now();
        let mut run = Run::with_keyframes(&self.registry, setup, 0)?;
        while run.step(1) == Status::Running {
            if stop.load(Ordering::Relaxed) {
                return Ok(None);
            }
        }
        let seconds = begun.elapsed().as_secs_f64();
        // One that was stopped by its limit has not said that it is done.
        let exact = (run.entry().exact)(run.parameters()) && run.status() != Status::Exhausted;
        let verdict = run.best().map(|best| scene.judge(&best.solution));
        let length = verdict.filter(|verdict| verdict.feasible).and_then(|verdict| verdict.length);
        Ok(Some(Row {
            planner: self.contender.planner.clone(),
            params: self.contender.overrides_text(),
            file: scenario.name.clone(),
            problem: number,
            bucket: problem.bucket(),
            optimum: problem.length,
            exact,
            length,
            iterations: run.iteration(),
            evaluations: run.evaluations(),
            seconds,
        }))
    }
}

impl Job for Task {
    type Row = Row;

    fn key(&self) -> String {
        key(&self.contender.name(), &self.folder.scenarios[self.at[0]].name, self.at[1])
    }

    fn weight(&self) -> u64 {
        self.folder.scenarios[self.at[0]].cells
    }

    fn run(&self, stop: &AtomicBool) -> Result<Option<Row>, Error> {
        self.carry_out(stop)
    }
}

impl SuiteJob for Task {
    fn contender(&self) -> &Contender {
        &self.contender
    }
}
