//! A run's best results, whenever they changed.

use serde::Serialize;

use crate::kernel::{Scene, Stepper};

/// The best value changed.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Improvement {
    /// In which iteration.
    pub iteration: u64,
    /// After how many evaluations.
    pub evaluations: u64,
    /// The value of the feasible best so far: see [`Record::value`](super::trial::Record::value). It may rise where the planner's cost
    /// is not the length.
    pub value: f64,
}

/// The values of the feasible best, whenever it changed, up to an iteration.
#[derive(Default)]
pub(super) struct Curve {
    pub(super) improvements: Vec<Improvement>,
    /// How many iterations were looked at, iteration 0 included.
    pub(super) seen: u64,
    /// The planner's cost when its best was judged last.
    cost: Option<f64>,
}

impl Curve {
    /// Judges the best of a state if it is another one than before. States are looked at one after the other, each once.
    pub(super) fn look(&mut self, scene: &Scene, state: &Stepper) {
        if state.iteration != self.seen {
            return;
        }
        self.seen += 1;
        let Some(best) = state.planner.best() else { return };
        if self.cost == Some(best.cost) {
            return;
        }
        self.cost = Some(best.cost);
        let verdict = scene.judge(&best.solution);
        if verdict.feasible {
            let value = verdict.length.unwrap_or(best.cost);
            self.improvements.push(Improvement { iteration: state.iteration, evaluations: state.planner.evaluations(), value });
        }
    }
}
