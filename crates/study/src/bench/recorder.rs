//! Records every evaluation of a run; the run itself reports once per iteration.

use std::sync::{Arc, Mutex, PoisonError};

use forage::swarm::objective::{Evaluation, Objective, Scratch, SearchBox};

/// When the best value fell, and to what.
#[derive(Debug, Clone, Default)]
pub(super) struct Log {
    /// How many evaluations there were.
    pub evaluations: u64,
    /// After how many the best value fell, and to what.
    pub improvements: Vec<(u64, f64)>,
}

impl Log {
    /// The best value so far.
    pub fn best(&self) -> f64 {
        self.improvements.last().map_or(f64::INFINITY, |(_, value)| *value)
    }
}

/// An objective that keeps a log of its first evaluations.
pub(super) struct Recorder {
    inner: Arc<dyn Objective>,
    /// Later evaluations are not looked at.
    budget: u64,
    log: Mutex<Log>,
}

impl Recorder {
    pub fn new(inner: Arc<dyn Objective>, budget: u64) -> Self {
        Self { inner, budget, log: Mutex::default() }
    }

    /// Forgets what there was.
    pub fn clear(&self) {
        *self.log.lock().unwrap_or_else(PoisonError::into_inner) = Log::default();
    }

    /// What was kept.
    pub fn read<T>(&self, what: impl FnOnce(&Log) -> T) -> T {
        what(&self.log.lock().unwrap_or_else(PoisonError::into_inner))
    }
}

impl Objective for Recorder {
    fn search_box(&self) -> &SearchBox {
        self.inner.search_box()
    }

    fn evaluate(&self, x: &[f64], scratch: &mut Scratch) -> Evaluation {
        let found = self.inner.evaluate(x, scratch);
        let mut log = self.log.lock().unwrap_or_else(PoisonError::into_inner);
        if log.evaluations < self.budget {
            log.evaluations += 1;
            if found.cost < log.best() {
                let at = log.evaluations;
                log.improvements.push((at, found.cost));
            }
        }
        found
    }
}
