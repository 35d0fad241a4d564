//! The suite `bbob`: 24 functions, each in several instances and dimensions, and how near planners come within a budget.

use std::{
    collections::BTreeSet,
    path::{Path, PathBuf},
    sync::{
        Arc,
        atomic::{AtomicBool, Ordering},
    },
};

use super::{
    super::{
        failure::Failure,
        rows::{Row as Kept, Rows},
        runner::Job,
    },
    Contender, ITERATIONS, coco, iohprofiler, iterations_within,
    recorder::Recorder,
    report,
    row::key,
    targets,
};
use forage::{
    Error, Registry, Run, Setup, Status, Value,
    scene::{FUNCTION, FunctionScene, Header},
};

pub use super::row::{Row, TITLES};

/// The dimensions of the suite.
pub const DIMENSIONS: [usize; 6] = [2, 3, 5, 10, 20, 40];
/// How many instances are looked at, unless it is said otherwise.
pub const INSTANCES: usize = 15;
/// Evaluations for each variable, unless it is said otherwise.
pub const BUDGET: u64 = 1_000;
/// What is run.
#[derive(Debug, Clone)]
pub struct Plan {
    /// Who takes part.
    pub contenders: Vec<Contender>,
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

/// What is set, as a text.
fn set(contender: &Contender) -> String {
    contender.params.iter().map(|(name, value)| format!("{name}={value}")).collect::<Vec<_>>().join(" ")
}

impl Plan {
    /// All planners that run on functions.
    pub fn everyone(registry: &Registry) -> Vec<Contender> {
        let planners = registry.planners().iter().filter(|entry| entry.kinds.contains(&FUNCTION));
        planners.map(|entry| Contender { planner: entry.name.to_owned(), params: forage::Overrides::default() }).collect()
    }

    /// Checks what can be refused without running it.
    ///
    /// # Errors
    /// A parameter that a planner does not have, or a value that it does not allow.
    pub fn check(&self, registry: &Arc<Registry>) -> Result<(), Error> {
        for job in self.jobs(registry) {
            job.setup(FunctionScene::bbob(job.function, job.instance, job.dimension)?)?.check(registry)?;
        }
        Ok(())
    }

    /// The jobs, in the order of their rows.
    pub fn jobs(&self, registry: &Arc<Registry>) -> Vec<Task> {
        let mut jobs = Vec::new();
        for contender in &self.contenders {
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
    fn setup(&self, scene: FunctionScene) -> Result<Setup, Error> {
        let name = format!("bbob-{}-{}-{}", self.function, self.dimension, self.instance);
        let scene = forage::scene::function::KIND.scene(Header::named(&name, &name), scene)?;
        let Contender { planner, params } = self.contender.clone();
        Ok(Setup { planner, scene: Arc::new(scene), params, seed: self.instance as u64 })
    }

    fn carry_out(&self, stop: &AtomicBool) -> Result<Option<Row>, Error> {
        let known = FunctionScene::bbob(self.function, self.instance, self.dimension)?;
        let minimum = known.minimum().map_or(0.0, |minimum| minimum.value);
        let inner = Arc::clone(known.objective());
        let mut setup = self.setup(known)?;
        if setup.params.get(ITERATIONS).is_none() {
            let iterations = iterations_within(&self.registry, &setup, self.budget)?;
            setup.params.insert(ITERATIONS, Value::Number(iterations as f64));
        }
        let recorder = Arc::new(Recorder::new(inner, self.budget));
        setup.scene = self.setup(FunctionScene::of(Arc::<Recorder>::clone(&recorder), None, None)?)?.scene;
        recorder.clear();
        let mut run = Run::with_keyframes(&self.registry, setup, 0)?;
        loop {
            let over = recorder.read(|log| log.evaluations >= self.budget || log.best() - minimum <= targets::FINAL);
            if over || run.step(1) != Status::Running {
                break;
            }
            if stop.load(Ordering::Relaxed) {
                return Ok(None);
            }
        }
        Ok(Some(recorder.read(|log| {
            // What was evaluated in the same iteration after it was solved does not count.
            let course: Vec<_> = log.improvements.iter().map(|(at, value)| (*at, value - minimum)).collect();
            let solved = targets::hit(&course, targets::FINAL);
            let until = solved.unwrap_or(log.evaluations);
            let course: Vec<_> = course.into_iter().filter(|(at, _)| *at <= until).collect();
            Row {
                planner: self.contender.planner.clone(),
                params: set(&self.contender),
                function: self.function,
                dimension: self.dimension,
                instance: self.instance,
                budget: self.budget,
                evaluations: until,
                gap: course.last().map_or(f64::INFINITY, |(_, gap)| *gap),
                improvements: course.iter().map(|(at, gap)| format!("{at}:{gap:?}")).collect::<Vec<_>>().join(" "),
            }
        })))
    }
}

impl Job for Task {
    type Row = Row;

    fn key(&self) -> String {
        let of = set(&self.contender);
        let contender = if of.is_empty() { self.contender.planner.clone() } else { format!("{} {of}", self.contender.planner) };
        key(&contender, self.function, self.dimension, self.instance, self.budget)
    }

    fn weight(&self) -> u64 {
        self.budget * self.dimension as u64
    }

    fn run(&self, stop: &AtomicBool) -> Result<Option<Row>, Error> {
        self.carry_out(stop)
    }
}

/// Takes the rows of parts that are in the same folder into a file of rows: those that it has not.
///
/// # Errors
/// As [`Rows::open`].
pub fn gather(file: &Path, parts: &[PathBuf]) -> Result<(), Failure> {
    let mut rows = Rows::<Row>::open(file, false)?;
    let mut known: BTreeSet<String> = rows.take().iter().map(Kept::key).collect();
    for part in parts {
        for row in Rows::<Row>::open(part, false)?.take() {
            if known.insert(row.key()) {
                rows.append(&row)?;
            }
        }
    }
    Ok(())
}

/// Writes what COCO's and IOHprofiler's tools read, and a report with a picture, into a folder; returns the files to look at.
///
/// # Errors
/// Files that cannot be written.
pub fn write(rows: &[Row], folder: &Path) -> Result<Vec<PathBuf>, Failure> {
    coco::write(rows, &folder.join("coco"))?;
    iohprofiler::write(rows, &folder.join("iohprofiler"))?;
    report::write(rows, folder)
}

/// The table that is printed in the end.
pub fn table(rows: &[Row]) -> String {
    report::table(rows)
}
