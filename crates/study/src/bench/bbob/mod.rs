//! The suite `bbob`: 24 functions, each in several instances and dimensions, and how near planners come within a budget.

mod coco;
mod iohprofiler;
mod report;
mod row;

use std::{
    path::{Path, PathBuf},
    sync::{Arc, atomic::AtomicBool},
};

use self::row::key;
use super::{
    super::{failure::Failure, runner::Job, table::Table},
    minimise::Minimisation,
    suite::{Contender, Suite, SuiteJob, check_count, recreate_folder},
};
use forage::{
    Error, Registry,
    scene::{FUNCTION, FunctionScene},
};

pub use row::{Row, TITLES};

/// The dimensions of the suite.
pub const DIMENSIONS: [usize; 6] = [2, 3, 5, 10, 20, 40];
/// How many instances are looked at, unless it is said otherwise.
pub const INSTANCES: usize = 15;
/// Evaluations for each variable, unless it is said otherwise.
pub const BUDGET: u64 = 1_000;

/// What is run.
#[derive(Debug, Clone)]
pub struct Plan {
    /// Numbers of functions, from 1.
    pub functions: Vec<usize>,
    /// Numbers of variables.
    pub dimensions: Vec<usize>,
    /// Instances, from 1; each is run once, with its number as the seed.
    pub instances: Vec<usize>,
    /// Evaluations for each variable.
    pub budget: u64,
}

/// A run of a planner on an instance of a function.
#[derive(Debug, Clone)]
pub struct Task {
    registry: Arc<Registry>,
    contender: Contender,
    function: usize,
    dimension: usize,
    instance: usize,
    budget: u64,
}

impl Suite for Plan {
    type Task = Task;

    const NAME: &'static str = "bbob";

    fn all_planners(registry: &Registry) -> Vec<Contender> {
        let planners = registry.planners().iter().filter(|entry| entry.kinds.contains(&FUNCTION));
        planners.map(|entry| Contender::new(entry.name)).collect()
    }

    fn jobs(&self, registry: &Arc<Registry>, contenders: &[Contender]) -> Result<Vec<Task>, Error> {
        let sizes = [self.functions.len(), self.dimensions.len(), self.instances.len()];
        check_count(sizes.into_iter().fold(contenders.len(), usize::saturating_mul))?;
        // One function says it for all.
        for job in (Self { functions: vec![1], instances: vec![1], ..self.clone() }).jobs(registry, contenders) {
            let setup = job.minimisation(&job.name()).setup(FunctionScene::bbob(job.function, job.instance, job.dimension)?)?;
            setup.check(registry).map_err(|error| error.within(&job.contender.planner))?;
        }
        Ok(self.jobs(registry, contenders))
    }

    fn write(&self, rows: &[Row], folder: &Path) -> Result<Vec<PathBuf>, Failure> {
        let [coco, iohprofiler] = ["coco", "iohprofiler"].map(|name| folder.join(name));
        recreate_folder(&coco)?;
        coco::write(rows, &coco)?;
        recreate_folder(&iohprofiler)?;
        iohprofiler::write(rows, &iohprofiler)?;
        report::write(rows, folder)
    }

    fn table(&self, rows: &[Row]) -> Table {
        report::table(rows)
    }
}

impl Plan {
    fn jobs(&self, registry: &Arc<Registry>, contenders: &[Contender]) -> Vec<Task> {
        let mut jobs = Vec::new();
        for contender in contenders {
            for &function in &self.functions {
                for &dimension in &self.dimensions {
                    let budget = self.budget * dimension as u64;
                    jobs.extend(self.instances.iter().map(|&instance| Task {
                        registry: Arc::clone(registry),
                        contender: contender.clone(),
                        function,
                        dimension,
                        instance,
                        budget,
                    }));
                }
            }
        }
        jobs
    }
}

impl Task {
    fn name(&self) -> String {
        format!("bbob-{}-{}-{}", self.function, self.dimension, self.instance)
    }

    fn minimisation<'a>(&'a self, name: &'a str) -> Minimisation<'a> {
        Minimisation { registry: &self.registry, contender: &self.contender, name, seed: self.instance as u64, budget: self.budget }
    }
}

impl Job for Task {
    type Row = Row;

    fn key(&self) -> String {
        key(&self.contender.name(), self.function, self.dimension, self.instance, self.budget)
    }

    fn weight(&self) -> u64 {
        self.budget * self.dimension as u64
    }

    fn run(&self, stop: &AtomicBool) -> Result<Option<Row>, Error> {
        let known = FunctionScene::bbob(self.function, self.instance, self.dimension)?;
        let convergence = self.minimisation(&self.name()).run(known, stop)?;
        Ok(convergence.map(|convergence| Row {
            planner: self.contender.planner.clone(),
            params: self.contender.overrides_text(),
            function: self.function,
            dimension: self.dimension,
            instance: self.instance,
            budget: self.budget,
            evaluations: convergence.evaluations,
            gap: convergence.gap(),
            improvements: convergence.improvements.iter().map(|(at, gap)| format!("{at}:{gap:?}")).collect::<Vec<_>>().join(" "),
        }))
    }
}

impl SuiteJob for Task {
    fn contender(&self) -> &Contender {
        &self.contender
    }
}
