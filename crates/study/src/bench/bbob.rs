//! The suite `bbob`: 24 functions, each in several instances and dimensions, and how near planners come within a budget.

use std::{
    collections::{BTreeMap, BTreeSet},
    fs,
    path::{Path, PathBuf},
    sync::{
        Arc,
        atomic::{AtomicBool, Ordering},
    },
};

use super::{
    super::{
        failure::{Failure, at},
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
    kernel::Message,
    scene::{FUNCTION, FunctionScene, Header},
};

pub use super::row::{Row, TITLES};

/// The dimensions of the suite.
pub const DIMENSIONS: [usize; 6] = [2, 3, 5, 10, 20, 40];
/// How many instances are looked at, unless it is said otherwise.
pub const INSTANCES: usize = 15;
/// Evaluations for each variable, unless it is said otherwise.
pub const BUDGET: u64 = 1_000;
/// So many runs at most: each is known before the first begins.
pub const MOST: usize = 1_000_000;

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
    /// Too many runs; a parameter that a planner does not have, or a value that it does not allow.
    pub fn check(&self, registry: &Arc<Registry>) -> Result<(), Error> {
        let runs = [self.functions.len(), self.dimensions.len(), self.instances.len()]
            .into_iter()
            .fold(self.contenders.len(), usize::saturating_mul);
        if runs > MOST {
            return Err(Error::refused("runs", runs, Message::verbatim(format!("at most {MOST}"))));
        }
        // One function says it for all.
        for job in (Self { functions: vec![1], instances: vec![1], ..self.clone() }).jobs(registry) {
            let setup = job.setup(FunctionScene::bbob(job.function, job.instance, job.dimension)?)?;
            setup.check(registry).map_err(|error| error.within(&job.contender.planner))?;
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
    /// The planner, with what is set of it.
    fn name(&self) -> String {
        let of = set(&self.contender);
        if of.is_empty() { self.contender.planner.clone() } else { format!("{} {of}", self.contender.planner) }
    }

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
        key(&self.name(), self.function, self.dimension, self.instance, self.budget)
    }

    fn weight(&self) -> u64 {
        self.budget * self.dimension as u64
    }

    fn run(&self, stop: &AtomicBool) -> Result<Option<Row>, Error> {
        self.carry_out(stop)
    }
}

/// Takes the rows of parts that are in the same folder into a file of rows: those that it has not. Of each file and planner the lightest
/// run of `tasks` is carried out again: rows of another version of the program are refused.
///
/// # Errors
/// As [`Rows::open`]; a row that is not what the run gives now.
pub fn gather(file: &Path, parts: &[PathBuf], tasks: &[Task], stop: &AtomicBool) -> Result<(), Failure> {
    let mut rows = Rows::<Row>::open(file, false)?;
    let kept = rows.take();
    check(file, &kept, tasks, stop)?;
    let mut known: BTreeSet<String> = kept.iter().map(Kept::key).collect();
    for part in parts {
        let others = Rows::<Row>::open(part, false)?.take();
        check(part, &others, tasks, stop)?;
        for row in others {
            if known.insert(row.key()) {
                rows.append(&row)?;
            }
        }
    }
    Ok(())
}

fn check(file: &Path, kept: &[Row], tasks: &[Task], stop: &AtomicBool) -> Result<(), Failure> {
    let known: BTreeMap<String, &Row> = kept.iter().map(|row| (row.key(), row)).collect();
    let mut lightest: BTreeMap<String, &Task> = BTreeMap::new();
    for task in tasks.iter().filter(|task| known.contains_key(&task.key())) {
        let known = lightest.entry(task.name()).or_insert(task);
        if task.weight() < known.weight() {
            *known = task;
        }
    }
    for task in lightest.into_values() {
        if task.carry_out(stop)?.is_some_and(|again| known.get(&task.key()) != Some(&&again)) {
            let problem = format!("the row `{}` comes from another version of forage; --fresh starts over", task.key());
            return Err(Error::malformed(&file.display().to_string(), Message::verbatim(problem)).into());
        }
    }
    Ok(())
}

/// By this file a folder is known as one that was written here.
const MARK: &str = "written-by-forage.txt";

/// Makes a folder without what was written there before: tools would read both together.
fn empty(folder: &Path) -> Result<(), Failure> {
    if folder.join(MARK).exists() {
        fs::remove_dir_all(folder).map_err(at(folder))?;
    } else if folder.exists() {
        let problem = "it was not written by forage bench; choose another --out".to_owned();
        return Err(Error::malformed(&folder.display().to_string(), Message::verbatim(problem)).into());
    }
    fs::create_dir_all(folder).map_err(at(folder))?;
    let mark = folder.join(MARK);
    fs::write(&mark, "forage bench writes this folder, and removes it before it writes it again.\n").map_err(at(&mark))
}

/// Writes what COCO's and IOHprofiler's tools read, and a report with a picture, into a folder; returns the files to look at.
///
/// # Errors
/// Files that cannot be written.
pub fn write(rows: &[Row], folder: &Path) -> Result<Vec<PathBuf>, Failure> {
    let [coco, iohprofiler] = ["coco", "iohprofiler"].map(|name| folder.join(name));
    empty(&coco)?;
    coco::write(rows, &coco)?;
    empty(&iohprofiler)?;
    iohprofiler::write(rows, &iohprofiler)?;
    report::write(rows, folder)
}

/// The table that is printed in the end.
pub fn table(rows: &[Row]) -> String {
    report::table(rows)
}
