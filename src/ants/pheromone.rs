//! Pheromone on the steps from cell to cell, and what it makes of their attraction.

use crate::{digest::Digest, math, scene::Cells};

use super::ground::{Ground, Power};

/// τ of each step, eight numbers a cell in the order of [`crate::scene::DIRECTIONS`]. A step and the step back are two.
#[derive(Debug, Clone)]
pub(super) struct Pheromone {
    pub tau: Vec<f64>,
    /// τ^α η^β ψ2^γ, made for a cell when an ant first comes there in an iteration.
    weight: Vec<[f64; 8]>,
    /// The iteration for which a cell's weights were made.
    made: Vec<u32>,
    now: u32,
    alpha: Power,
    rho: f64,
    /// Nothing falls below or rises above.
    pub bounds: [f64; 2],
}

impl Pheromone {
    pub fn new(cells: &Cells, start: f64, alpha: f64, rho: f64, bounds: [f64; 2]) -> Self {
        let tau = vec![math::limit(start, bounds[0], bounds[1]); 8 * cells.len()];
        Self { tau, weight: vec![[0.0; 8]; cells.len()], made: vec![0; cells.len()], now: 1, alpha: Power::new(alpha), rho, bounds }
    }

    /// α.
    pub fn exponent(&self) -> f64 {
        self.alpha.exponent
    }

    /// Multiplies τ along a way.
    pub fn favour(&mut self, way: &[usize], direction: impl Fn(usize, usize) -> usize, factor: f64) {
        for step in way.windows(2) {
            let tau = &mut self.tau[8 * step[0] + direction(step[0], step[1])];
            *tau = math::limit(*tau * factor, self.bounds[0], self.bounds[1]);
        }
    }

    /// τ_ij^α η_j^β ψ^γ of the steps from a cell, but for the turn.
    #[inline]
    pub fn weights(&mut self, ground: &Ground, cell: usize) -> &[f64; 8] {
        if self.made[cell] != self.now {
            self.made[cell] = self.now;
            self.weight[cell] = self.weighed(ground, cell);
        }
        &self.weight[cell]
    }

    /// The same, computed anew.
    #[inline(never)]
    pub fn weighed(&self, ground: &Ground, cell: usize) -> [f64; 8] {
        let at = 8 * cell;
        std::array::from_fn(|d| {
            let attraction = ground.attraction[at + d];
            if attraction == 0.0 { 0.0 } else { self.alpha.of(self.tau[at + d]) * attraction }
        })
    }

    /// (1 − ρ) τ of [ANTBAT] (4) and [WOLF-ANT] (10). What the ants lay comes next, then [`Pheromone::settle`].
    pub fn evaporate(&mut self) {
        let left = 1.0 - self.rho;
        self.tau.iter_mut().for_each(|tau| *tau *= left);
    }

    /// Adds to a step; what is laid may be negative.
    #[inline]
    pub fn lay(&mut self, cell: usize, direction: usize, amount: f64) {
        self.tau[8 * cell + direction] += amount;
    }

    /// Keeps τ within its bounds; weights are made anew from here on.
    pub fn settle(&mut self) {
        let [low, high] = self.bounds;
        self.tau.iter_mut().for_each(|tau| *tau = math::limit(*tau, low, high));
        self.now += 1;
    }

    /// The strongest step from a cell; −1 where none is allowed.
    pub fn strongest(&self, cells: &Cells, cell: usize) -> f64 {
        let allowed = cells.moves(cell);
        (0..8).filter(|d| allowed >> d & 1 != 0).map(|d| self.tau[8 * cell + d]).fold(-1.0, f64::max)
    }

    pub fn digest(&self, out: &mut Digest) {
        out.numbers(&self.tau);
    }

    pub fn bytes(&self) -> usize {
        self.tau.len() * size_of::<f64>() + self.weight.len() * (size_of::<[f64; 8]>() + size_of::<u32>())
    }
}
