//! The swarm over parameters: its state, and what it does in a round.

use std::sync::Arc;

use crate::{
    describe::{Entry, Reading},
    kernel::{State, SubtaskResult, rng::Stream},
    math,
    params::{Domain, Overrides, Parameter, Value},
    scene::Scene,
};

use super::parameters::{ITERATIONS, READINGS};

/// A parameter that is searched, in the range that its slider offers; where that is logarithmic, so is the search.
#[derive(Debug, Clone, Copy)]
pub(super) struct Axis {
    pub(super) parameter: &'static Parameter,
    /// What tells its best value.
    pub(super) reading: Reading,
    pub(super) low: f64,
    pub(super) high: f64,
    pub(super) whole: bool,
}

impl Axis {
    pub(super) fn new(parameter: &'static Parameter) -> Option<Self> {
        let (min, max, whole) = match parameter.domain {
            Domain::Number { min, max, .. } => (min, max, false),
            Domain::Integer { min, max, .. } => (min as f64, max as f64, true),
            _ => return None,
        };
        let reading = *READINGS.iter().find(|reading| reading.name == parameter.name)?;
        let (low, high) = parameter.slider.unwrap_or((min, max));
        let scale = |x: f64| if parameter.logarithmic { math::log10(x) } else { x };
        Some(Self { parameter, reading, low: scale(low), high: scale(high), whole })
    }

    /// The parameter's value at a coordinate.
    pub(super) fn value(&self, x: f64) -> f64 {
        let (low, high) = self.parameter.slider.unwrap_or((self.low, self.high));
        let value = if self.parameter.logarithmic { math::pow(10.0, x) } else { x };
        // Rounding must not lead out of what is allowed.
        math::clamp(if self.whole { value.round() } else { value }, low, high)
    }
}

/// How good a set of parameters is. The less the better: first the mean length, then the mean iteration of convergence.
#[derive(Debug, Clone, Copy, PartialEq, State)]
pub(super) struct Fitness {
    /// Infinite if a run found no way.
    pub(super) length: f64,
    pub(super) converged: f64,
}

pub(super) const NONE: Fitness = Fitness { length: f64::INFINITY, converged: f64::INFINITY };

impl Fitness {
    /// The mean over some runs.
    pub(super) fn of(found: &[SubtaskResult]) -> Self {
        let n = found.len() as f64;
        // Equal lengths in another order must give the same mean, or rounding would break ties.
        let mut lengths: Vec<_> = found.iter().map(|f| f.cost.unwrap_or(f64::INFINITY)).collect();
        math::sort_numbers(&mut lengths);
        let length = lengths.iter().sum::<f64>() / n;
        let converged = if length.is_finite() { found.iter().map(|f| f.converged).sum::<f64>() / n } else { f64::INFINITY };
        Self { length, converged }
    }

    pub(super) fn better_than(self, other: Self) -> bool {
        self.length < other.length || (self.length == other.length && self.converged < other.converged)
    }
}

/// The swarm. Positions are drawn when it starts; the first step judges them, each later one moves and judges them.
#[derive(Clone, State)]
pub(super) struct Tuning {
    #[state(shared)]
    pub(super) scene: Arc<Scene>,
    #[state(shared)]
    pub(super) colony: &'static Entry,
    #[state(shared)]
    pub(super) rounds: u64,
    #[state(shared)]
    pub(super) axes: Vec<Axis>,
    #[state(shared)]
    pub(super) population: usize,
    /// w, c1, c2.
    #[state(shared)]
    pub(super) weights: [f64; 3],
    /// The seeds that every set of parameters is judged by.
    #[state(shared)]
    pub(super) seeds: Vec<u64>,
    /// Positions of the particles, judged in the last step; then the positions that the next step judges.
    pub(super) shown: Vec<f64>,
    pub(super) x: Vec<f64>,
    pub(super) v: Vec<f64>,
    pub(super) cost: Vec<Fitness>,
    pub(super) p: Vec<f64>,
    pub(super) p_cost: Vec<Fitness>,
    pub(super) g: Vec<f64>,
    pub(super) g_cost: Fitness,
    /// The shortest way that each particle's parameters gave in the last step, and the best one's.
    pub(super) ways: Vec<Vec<[f64; 2]>>,
    pub(super) best: Vec<[f64; 2]>,
    /// What the runs of the next step found.
    #[state(skip)]
    pub(super) provided: Vec<SubtaskResult>,
    pub(super) iteration: u64,
    pub(super) rng: Stream,
}

impl Tuning {
    /// The colony's parameters at a position.
    pub(super) fn given(&self, x: &[f64]) -> Overrides {
        let mut given = Overrides::new();
        given.insert(ITERATIONS.name(), Value::from(self.rounds as f64));
        for (axis, &x) in self.axes.iter().zip(x) {
            given.insert(axis.parameter.name, Value::from(axis.value(x)));
        }
        given
    }

    pub(super) fn row(&self, i: usize) -> std::ops::Range<usize> {
        i * self.axes.len()..(i + 1) * self.axes.len()
    }

    /// What the runs found, particle by particle, and the bests that follow.
    pub(super) fn judge(&mut self, found: &[SubtaskResult]) {
        self.shown.copy_from_slice(&self.x);
        for (i, found) in found.chunks_exact(self.seeds.len()).enumerate() {
            let row = self.row(i);
            let cost = Fitness::of(found);
            self.cost[i] = cost;
            let shortest = found.iter().filter(|f| f.cost.is_some()).min_by(|a, b| a.cost.unwrap_or(0.0).total_cmp(&b.cost.unwrap_or(0.0)));
            self.ways[i] = shortest.map_or(Vec::new(), |f| f.path.clone());
            if cost.better_than(self.p_cost[i]) {
                self.p_cost[i] = cost;
                self.p[row.clone()].copy_from_slice(&self.x[row.clone()]);
            }
            if cost.better_than(self.g_cost) {
                self.g_cost = cost;
                self.g.copy_from_slice(&self.x[row]);
                self.best.clone_from(&self.ways[i]);
            }
        }
    }

    /// v ← w v + c1 r1 (p − x) + c2 r2 (g − x), x ← x + v; both kept in their ranges.
    pub(super) fn fly(&mut self) {
        let [w, c1, c2] = self.weights;
        for i in 0..self.x.len() {
            let j = i % self.axes.len();
            let Axis { low, high, .. } = self.axes[j];
            let (r1, r2) = (self.rng.unit(), self.rng.unit());
            let v = w * self.v[i] + c1 * r1 * (self.p[i] - self.x[i]) + c2 * r2 * (self.g[j] - self.x[i]);
            self.v[i] = math::clamp(v, low - high, high - low);
            self.x[i] = math::clamp(self.x[i] + self.v[i], low, high);
        }
    }
}
