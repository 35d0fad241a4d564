//! The suite `tsplib`: tours through the instances of a folder, against the published optima.
//!
//! Data: <http://comopt.ifi.uni-heidelberg.de/software/TSPLIB95/>

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
    message,
    scene::{Header, TOUR, TourScene, tour},
};

pub use row::Row;

use self::{
    load::{Instance, instances},
    row::key,
};
use super::{
    super::{
        failure::Failure,
        runner::Job,
        table::Table,
        within::{RunEnd, run_within_budget},
    },
    suite::{Contender, Suite, SuiteJob, check_count},
};

/// Evaluations for each stop, unless it is said otherwise.
pub const BUDGET: u64 = 1_000;

/// The instances of a folder.
pub struct Plan {
    instances: Vec<Arc<Instance>>,
    notes: Vec<Message>,
    budget: u64,
    runs: u64,
}

/// A planner on an instance.
#[derive(Clone)]
pub struct Task {
    registry: Arc<Registry>,
    contender: Arc<Contender>,
    instance: Arc<Instance>,
    budget: u64,
    seed: u64,
}

impl Plan {
    /// Reads the `.tsp` files in a folder and the folders in it, up to so many stops. Each is toured `runs` times, with the seeds from 1,
    /// and `budget` evaluations for each stop.
    ///
    /// # Errors
    /// A folder without an instance; a file that cannot be read.
    pub fn read(registry: &Registry, folder: &Path, largest: Option<usize>, budget: u64, runs: u64) -> Result<Self, Failure> {
        let (instances, notes) = instances(registry, folder, largest)?;
        Ok(Self { instances, notes, budget, runs })
    }
}

impl Plan {
    /// Rows with the optima that are known now: the file of a tour may have come after a run.
    fn measured(&self, rows: &[Row]) -> Vec<Row> {
        let known: BTreeMap<&str, Option<f64>> = self.instances.iter().map(|one| (one.name.as_str(), one.optimum)).collect();
        let optimum = |row: &Row| known.get(row.instance.as_str()).copied().unwrap_or(row.optimum);
        rows.iter().map(|row| Row { optimum: optimum(row), ..row.clone() }).collect()
    }
}

impl Suite for Plan {
    type Task = Task;

    const NAME: &'static str = "tsplib";

    fn all_planners(registry: &Registry) -> Vec<Contender> {
        let planners = registry.planners().iter().filter(|entry| entry.kinds.contains(&TOUR) && entry.stops);
        planners.map(|entry| Contender::new(entry.name)).collect()
    }

    /// Planners without a population: populations take hours on thousands of stops.
    fn default_planners(registry: &Registry) -> Vec<Contender> {
        let has_one = |contender: &Contender| {
            let entry = registry.planner(&contender.planner);
            entry.is_ok_and(|entry| entry.most_stops.is_none() && entry.parameter("population").is_none())
        };
        Self::all_planners(registry).into_iter().filter(has_one).collect()
    }

    fn jobs(&self, registry: &Arc<Registry>, contenders: &[Contender]) -> Result<Vec<Task>, Error> {
        let runs = usize::try_from(self.runs).unwrap_or(usize::MAX);
        check_count(self.instances.len().saturating_mul(contenders.len()).saturating_mul(runs))?;
        let mut all = Vec::new();
        for contender in contenders {
            let contender = Arc::new(contender.clone());
            let most = registry.planner(&contender.planner)?.most_stops.unwrap_or(usize::MAX);
            let mut checked = false;
            for instance in self.instances.iter().filter(|instance| instance.tour.len() <= most) {
                for seed in 1..=self.runs {
                    let budget = self.budget * instance.tour.len() as u64;
                    let task = Task {
                        registry: Arc::clone(registry),
                        contender: Arc::clone(&contender),
                        instance: Arc::clone(instance),
                        budget,
                        seed,
                    };
                    // One instance says for all what is set wrongly.
                    if !checked {
                        task.setup()?.check(registry).map_err(|error| error.within(&contender.planner))?;
                        checked = true;
                    }
                    all.push(task);
                }
            }
        }
        if all.is_empty() {
            let names: Vec<String> = contenders.iter().map(Contender::name).collect();
            let allowed = message!("study-planner-of-stops", "a planner that takes as many stops as an instance has");
            return Err(Error::refused("--planners", names.join(","), allowed));
        }
        Ok(all)
    }

    fn write(&self, rows: &[Row], folder: &Path) -> Result<Vec<PathBuf>, Failure> {
        report::write(&self.measured(rows), folder)
    }

    fn table(&self, rows: &[Row]) -> Table {
        report::planners(&self.measured(rows))
    }

    fn faults(&self, rows: &[Row]) -> Vec<Message> {
        self.measured(rows).iter().filter_map(Row::fault).collect()
    }

    fn notes(&self) -> &[Message] {
        &self.notes
    }
}

impl Task {
    fn setup(&self) -> Result<Setup, Error> {
        // A copy makes its own distances: those of all instances would be too much memory.
        let tour: TourScene = self.instance.tour.clone();
        let scene = tour::KIND.scene(Header::named(&self.instance.name, &self.instance.name), tour)?;
        let Contender { planner, params } = (*self.contender).clone();
        Ok(Setup { planner, scene: Arc::new(scene), params, seed: self.seed })
    }

    /// Runs until the budget is spent or the planner comes to its end; `None` if it is stopped.
    fn attempt(&self, setup: Setup, stop: &AtomicBool) -> Result<Option<(Row, RunEnd)>, Error> {
        let scene = Arc::clone(&setup.scene);
        #[expect(clippy::disallowed_types, reason = "what it takes is measured, and is no part of the result")]
        let begun = std::time::Instant::now();
        let mut run = Run::with_keyframes(&self.registry, setup, 0)?;
        while run.evaluations() < self.budget && run.step(1) == Status::Running {
            if stop.load(Ordering::Relaxed) {
                return Ok(None);
            }
        }
        let seconds = begun.elapsed().as_secs_f64();
        let verdict = run.best().map(|best| scene.judge(&best.solution));
        let row = Row {
            planner: self.contender.planner.clone(),
            params: self.contender.overrides_text(),
            instance: self.instance.name.clone(),
            stops: self.instance.tour.len(),
            seed: self.seed,
            budget: self.budget,
            optimum: self.instance.optimum,
            length: verdict.filter(|verdict| verdict.feasible).and_then(|verdict| verdict.length),
            iterations: run.iteration(),
            evaluations: run.evaluations(),
            seconds,
        };
        Ok(Some((row, RunEnd::of(&run))))
    }
}

impl Job for Task {
    type Row = Row;

    fn key(&self) -> String {
        key(&self.contender.name(), &self.instance.name, self.seed, self.budget)
    }

    fn weight(&self) -> u64 {
        self.budget
    }

    fn run(&self, stop: &AtomicBool) -> Result<Option<Row>, Error> {
        run_within_budget(&self.registry, self.setup()?, self.budget, |setup| self.attempt(setup, stop))
    }
}

impl SuiteJob for Task {
    fn contender(&self) -> &Contender {
        &self.contender
    }
}
