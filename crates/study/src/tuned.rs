//! A particle swarm that tunes a colony, once per seed, as rows.

use std::{
    path::Path,
    sync::{
        Arc,
        atomic::{AtomicBool, Ordering},
    },
};

use serde::{Deserialize, Serialize};

use forage::{
    Overrides, Setup, Value,
    kernel::{Error, Message, Status},
    scene::Scene,
    standard,
};

use super::{
    failure::Failure,
    options::Options,
    rows::KeyedRow,
    runner::{self, Control, Job},
};

/// What a swarm recommends.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct Tuned {
    pub scene: String,
    pub seed: u64,
    /// What the colony that was tuned is called, and its iterations.
    pub planner: String,
    pub iterations: f64,
    pub alpha: f64,
    pub beta: f64,
    pub rho: f64,
    pub q: f64,
    pub epsilon: f64,
    /// Means over the runs by which it was judged.
    pub length: f64,
    pub converged: f64,
    /// Runs of the colony.
    pub runs: u64,
}

impl Tuned {
    /// The colony with these parameters.
    pub fn setup(&self, scene: &Arc<Scene>) -> Setup {
        let mut params: Overrides = self.tuned().into_iter().map(|(name, value)| (name, Value::Number(value))).collect();
        params.insert("iterations", Value::Number(self.iterations));
        Setup { planner: self.planner.clone(), scene: Arc::clone(scene), params, seed: 1 }
    }

    /// The parameters that were searched, in the paper's order.
    pub fn tuned(&self) -> [(&'static str, f64); 5] {
        let Self { alpha, beta, rho, q, epsilon, .. } = *self;
        [("alpha", alpha), ("beta", beta), ("rho", rho), ("q", q), ("epsilon", epsilon)]
    }
}

impl KeyedRow for Tuned {
    fn key(&self) -> String {
        key(&self.scene, self.seed)
    }
}

fn key(scene: &str, seed: u64) -> String {
    format!("tuning on {scene}, seed {seed}")
}

pub(super) struct Task(Setup);

impl Job for Task {
    type Row = Tuned;

    fn key(&self) -> String {
        key(self.0.scene.name(), self.0.seed)
    }

    fn run(&self, stop: &AtomicBool) -> Result<Option<Tuned>, Error> {
        let mut run = forage::Run::with_keyframes(standard(), self.0.clone(), 0)?;
        while run.status() == Status::Running {
            if stop.load(Ordering::Relaxed) {
                return Ok(None);
            }
            run.step(1);
        }
        let outcome = run.outcome();
        let tuned = outcome
            .tuned
            .ok_or_else(|| Error::refused("scene", self.0.scene.name(), Message::verbatim("one on which the colony finds a way")))?;
        let number = |name: &str| match tuned.params.get(name) {
            Some(Value::Number(number)) => *number,
            _ => f64::NAN,
        };
        let reading = |name: &str| outcome.readings.iter().find(|(n, _)| *n == name).map_or(f64::NAN, |(_, value)| *value);
        Ok(Some(Tuned {
            scene: self.0.scene.name().to_owned(),
            seed: self.0.seed,
            planner: tuned.planner.to_owned(),
            iterations: number("iterations"),
            alpha: number("alpha"),
            beta: number("beta"),
            rho: number("rho"),
            q: number("q"),
            epsilon: number("epsilon"),
            length: reading("best"),
            converged: reading("converged"),
            runs: outcome.evaluations,
        }))
    }
}

/// The setup of the tuning itself: the published swarm, 20 particles and 30 iterations.
pub(super) fn setup(scene: &Arc<Scene>, seed: u64) -> Setup {
    let params = [("population", 20.0), ("iterations", 30.0), ("seeds", 3.0)].map(|(name, number)| (name, Value::Number(number)));
    Setup { planner: "pso-tuning".to_owned(), scene: Arc::clone(scene), params: params.into_iter().collect(), seed }
}

/// Tunings with the seeds 1 to `count`.
pub(super) fn tasks(scene: &Arc<Scene>, count: u64) -> Vec<Task> {
    (1..=count).map(|seed| Task(setup(scene, seed))).collect()
}

/// The runs of [`tasks`].
pub(super) fn carry_out(scene: &Arc<Scene>, count: u64, file: &Path, options: &Options, control: &Control) -> Result<Vec<Tuned>, Failure> {
    runner::run(&tasks(scene, count), file, options.fresh, options.threads, control)
}
