//! The suite `trees`: tree planners on scenes, as the benchmarks of OMPL have them.

mod log;
mod report;
mod row;

use std::{
    path::{Path, PathBuf},
    sync::{
        Arc,
        atomic::{AtomicBool, Ordering},
    },
};

use forage::{
    Error, Registry, Run, Scene, Setup, Status, message,
    scene::{ARM, DISCS, GRID},
};

use self::row::key;
use super::{
    super::{
        failure::Failure,
        runner::Job,
        table::Table,
        within::{RunEnd, run_within_budget},
    },
    suite::{Contender, Suite, SuiteJob, check_count, safe_file_name},
};

pub use row::Row;

/// Evaluations of a run, unless it is said otherwise.
pub const BUDGET: u64 = 20_000;
/// Runs of a planner on a scene, unless it is said otherwise.
pub const RUNS: u64 = 50;
/// The family whose planners take part.
const FAMILY: &str = "tree";

/// What is run.
pub struct Plan {
    scenes: Vec<Arc<Scene>>,
    /// They were named: each is to be run on.
    named: bool,
    runs: u64,
    budget: u64,
}

/// A planner on a scene.
#[derive(Clone)]
pub struct Task {
    registry: Arc<Registry>,
    contender: Arc<Contender>,
    scene: Arc<Scene>,
    seed: u64,
    budget: u64,
}

impl Plan {
    /// On these scenes, or without any on all that ship and have paths; `runs` runs each, with the seeds from 1.
    ///
    /// # Errors
    /// Two scenes of the same name.
    pub fn new(registry: &Registry, mut scenes: Vec<Arc<Scene>>, runs: u64, budget: u64) -> Result<Self, Error> {
        let named = !scenes.is_empty();
        if !named {
            scenes = registry.scenes().iter().filter(|scene| [DISCS, GRID, ARM].contains(&scene.kind())).cloned().collect();
        }
        for (k, scene) in scenes.iter().enumerate() {
            if scenes[..k].iter().any(|other| safe_file_name(other.name()) == safe_file_name(scene.name())) {
                let allowed = message!("study-unique-name", "a unique name: files are named after it");
                return Err(Error::refused("scene", scene.name(), allowed));
            }
        }
        Ok(Self { scenes, named, runs, budget })
    }
}

impl Suite for Plan {
    type Task = Task;

    const NAME: &'static str = "trees";

    fn all_planners(registry: &Registry) -> Vec<Contender> {
        let planners = registry.planners().iter().filter(|entry| entry.family == FAMILY || entry.family == forage::describe::Entry::OWN);
        planners.map(|entry| Contender::new(entry.name)).collect()
    }

    fn jobs(&self, registry: &Arc<Registry>, contenders: &[Contender]) -> Result<Vec<Task>, Error> {
        check_count(self.scenes.len().saturating_mul(contenders.len()).saturating_mul(self.runs as usize))?;
        let mut all = Vec::new();
        for contender in contenders {
            let contender = Arc::new(contender.clone());
            let entry = registry.planner(&contender.planner)?;
            for scene in self.scenes.iter().filter(|scene| entry.check_scene(scene).is_ok()) {
                let task = |seed| Task {
                    registry: Arc::clone(registry),
                    contender: Arc::clone(&contender),
                    scene: Arc::clone(scene),
                    seed,
                    budget: self.budget,
                };
                // One run says for all what is set wrongly.
                task(1).setup().check(registry).map_err(|error| error.within(&contender.planner))?;
                all.extend((1..=self.runs).map(task));
            }
        }
        let idle = |scene: &&Arc<Scene>| !all.iter().any(|task| task.scene.name() == scene.name());
        if let Some(scene) = self.scenes.iter().find(idle).filter(|_| self.named || all.is_empty()) {
            return Err(Error::refused(
                "scene",
                scene.name(),
                message!("study-scene-of-planners", "a scene on which one of the planners runs"),
            ));
        }
        Ok(all)
    }

    fn write(&self, rows: &[Row], folder: &Path) -> Result<Vec<PathBuf>, Failure> {
        let logs = log::write(rows, &self.scenes, self.budget, &folder.join("ompl"))?;
        Ok(report::write(rows, folder)?.into_iter().chain([logs]).collect())
    }

    fn table(&self, rows: &[Row]) -> Table {
        report::planners(rows)
    }
}

/// What a scene is, as 16 hexadecimal digits: FNV-1a of its file.
fn content(scene: &Scene) -> String {
    let hash =
        scene.to_json().bytes().fold(0xcbf2_9ce4_8422_2325_u64, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3));
    format!("{hash:016x}")
}

impl Task {
    fn setup(&self) -> Setup {
        let Contender { planner, params } = (*self.contender).clone();
        Setup { planner, scene: Arc::clone(&self.scene), params, seed: self.seed }
    }

    /// Runs until there is nothing to do or the budget is spent; `None` if it is stopped.
    fn attempt(&self, setup: Setup, stop: &AtomicBool) -> Result<Option<(Row, RunEnd)>, Error> {
        #[expect(clippy::disallowed_types, reason = "what it takes is measured, and is no part of the result")]
        let begun = std::time::Instant::now();
        let mut run = Run::with_keyframes(&self.registry, setup, 0)?;
        // Begins the curve: what changes is judged at once, which is part of the time.
        run.curve();
        let mut times = Vec::new();
        while run.evaluations() < self.budget {
            let status = run.step(1);
            let improvements = run.curve().len();
            times.resize(improvements, begun.elapsed().as_secs_f64());
            if status != Status::Running {
                break;
            }
            if stop.load(Ordering::Relaxed) {
                return Ok(None);
            }
        }
        let seconds = begun.elapsed().as_secs_f64();
        let reached = RunEnd::of(&run);
        let improvements: Vec<String> = run.curve().iter().map(|best| format!("{}:{:?}", best.evaluations, best.value)).collect();
        let nodes = run.readings().iter().find(|(name, _)| *name == "nodes").map(|(_, nodes)| nodes);
        let outcome = run.outcome();
        let row = Row {
            planner: self.contender.planner.clone(),
            params: self.contender.overrides_text(),
            scene: self.scene.name().to_owned(),
            content: content(&self.scene),
            seed: self.seed,
            budget: self.budget,
            solved: outcome.feasible && outcome.length.is_some(),
            length: outcome.length.filter(|_| outcome.feasible),
            clearance: outcome.clearance.filter(|_| outcome.feasible),
            exact: outcome.exact,
            nodes,
            iterations: outcome.iterations,
            evaluations: outcome.evaluations,
            improvements: improvements.join(" "),
            seconds,
            times: times.iter().map(|seconds| format!("{seconds:.6}")).collect::<Vec<_>>().join(" "),
        };
        Ok(Some((row, reached)))
    }
}

impl Job for Task {
    type Row = Row;

    fn key(&self) -> String {
        key(&self.contender.name(), self.scene.name(), &content(&self.scene), self.seed, self.budget)
    }

    fn weight(&self) -> u64 {
        self.budget
    }

    fn run(&self, stop: &AtomicBool) -> Result<Option<Row>, Error> {
        run_within_budget(&self.registry, self.setup(), self.budget, |setup| self.attempt(setup, stop))
    }
}

impl SuiteJob for Task {
    fn contender(&self) -> &Contender {
        &self.contender
    }
}
