//! Positions, costs and bests: what every swarm has, whatever moves its particles.

use crate::{digest::Digest, planner::Best, rng::Stream};

use super::objective::Objective;

/// A population of positions. Particle `i`'s coordinates are the `i`-th row of `dimension` numbers.
#[derive(Debug, Clone)]
pub(super) struct Population<O> {
    pub(super) objective: O,
    pub(super) size: usize,
    pub(super) dimension: usize,
    /// Positions x.
    pub(super) x: Vec<f64>,
    /// Their costs f(x).
    pub(super) cost: Vec<f64>,
    /// Personal bests p.
    pub(super) p: Vec<f64>,
    /// Their costs.
    pub(super) p_cost: Vec<f64>,
    /// The global best g, as it was when the last iteration ended.
    pub(super) g: Vec<f64>,
    /// Its cost.
    pub(super) g_cost: f64,
    /// The cheapest position without penalty that was ever evaluated, and its cost (infinite: none yet).
    ///
    /// The swarm follows `g`, as published; but close to the optimum `g` often cuts a disc by a hair, because the
    /// penalty is finite. What is reported is this one, so that a collision-free path that was found is never lost.
    pub(super) free: Vec<f64>,
    pub(super) free_cost: f64,
    pub(super) evaluations: u64,
}

impl<O: Objective> Population<O> {
    /// Positions uniform in the box, evaluated.
    pub(super) fn uniform(objective: O, size: usize, rng: &mut Stream) -> Self {
        let search_box = objective.search_box().clone();
        let dimension = search_box.dimension();
        let mut x = Vec::with_capacity(size * dimension);
        for _ in 0..size {
            let first = x.len();
            x.extend(search_box.low.iter().zip(&*search_box.high).map(|(&low, &high)| rng.between(low, high)));
            objective.arrange(&mut x[first..]);
        }
        let mut population = Self {
            objective,
            size,
            dimension,
            p: x.clone(),
            x,
            cost: vec![f64::INFINITY; size],
            p_cost: vec![f64::INFINITY; size],
            g: vec![0.0; dimension],
            g_cost: f64::INFINITY,
            free: vec![0.0; dimension],
            free_cost: f64::INFINITY,
            evaluations: 0,
        };
        (0..size).for_each(|i| population.evaluate(i));
        population.settle();
        population
    }

    /// Where particle `i`'s row lies.
    #[inline]
    pub(super) fn row(&self, i: usize) -> std::ops::Range<usize> {
        i * self.dimension..(i + 1) * self.dimension
    }

    /// Evaluates particle `i` where it is now and keeps its personal best.
    #[inline]
    pub(super) fn evaluate(&mut self, i: usize) {
        let row = self.row(i);
        let x = &self.x[row.clone()];
        let found = self.objective.evaluate(x);
        self.evaluations += 1;
        self.cost[i] = found.cost;
        if found.cost < self.p_cost[i] {
            self.p_cost[i] = found.cost;
            self.p[row].copy_from_slice(x);
        }
        if found.penalty == 0.0 && found.cost < self.free_cost {
            self.free_cost = found.cost;
            self.free.copy_from_slice(x);
        }
    }

    /// Ends an iteration: the best personal best becomes the global best; the first of equals wins.
    pub(super) fn settle(&mut self) {
        let mut best = None;
        for (i, &cost) in self.p_cost.iter().enumerate() {
            if cost < self.g_cost {
                self.g_cost = cost;
                best = Some(i);
            }
        }
        if let Some(i) = best {
            let row = self.row(i);
            self.g.copy_from_slice(&self.p[row]);
        }
    }

    /// The position that is reported, with its cost: the cheapest without penalty, or else the cheapest.
    pub(super) fn reported(&self) -> (f64, &[f64]) {
        if self.free_cost < f64::INFINITY { (self.free_cost, &self.free) } else { (self.g_cost, &self.g) }
    }

    /// The reported position as a solution.
    pub(super) fn best(&self) -> Best {
        let (cost, x) = self.reported();
        Best { cost, solution: self.objective.solution(x) }
    }

    /// The mean cost of the present positions.
    pub(super) fn mean(&self) -> f64 {
        self.cost.iter().sum::<f64>() / self.size as f64
    }

    pub(super) fn digest(&self, out: &mut Digest) {
        [&self.x, &self.cost, &self.p, &self.p_cost, &self.g, &self.free].into_iter().for_each(|numbers| out.numbers(numbers));
        out.numbers(&[self.g_cost, self.free_cost]);
        out.word(self.evaluations);
    }

    pub(super) fn bytes(&self) -> usize {
        8 * (2 * self.x.len() + 2 * self.size + 2 * self.dimension) + size_of::<Self>()
    }
}
