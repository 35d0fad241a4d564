//! Pheromone on the steps from cell to cell, and what it makes of their attraction.

use crate::{geometry::Cells, kernel::State, math};

use super::ground::{Ground, Power};

/// τ of each step. A step and the step back are two.
///
/// Only cells that an ant has come to have numbers of their own: everywhere else the same lies on every step, so large
/// maps cost what is walked of them.
#[derive(Debug, Clone, State)]
pub(super) struct Pheromone {
    /// Where a cell's numbers are in `known`; `UNKNOWN` for those that no ant has come to.
    place: Vec<u32>,
    known: Vec<Known>,
    /// What lies on every other step.
    elsewhere: f64,
    /// Counts the iterations, so that a cell's weights are made once in each.
    #[state(skip)]
    now: u32,
    #[state(shared)]
    alpha: Power,
    #[state(shared)]
    rho: f64,
    /// Nothing falls below or rises above.
    #[state(shared)]
    bounds: [f64; 2],
}

const UNKNOWN: u32 = u32::MAX;

/// The steps from a cell, in the order of [`crate::geometry::DIRECTIONS`].
#[derive(Debug, Clone, State)]
struct Known {
    cell: u32,
    /// The iteration for which the weights were made.
    #[state(skip)]
    made: u32,
    tau: [f64; 8],
    /// η^β ψ2^γ.
    #[state(skip)]
    attraction: [f64; 8],
    /// τ^α η^β ψ2^γ.
    #[state(skip)]
    weight: [f64; 8],
}

impl Pheromone {
    pub fn new(cells: &Cells, start: f64, alpha: f64, rho: f64, bounds: [f64; 2]) -> Self {
        let elsewhere = math::clamp(start, bounds[0], bounds[1]);
        Self { place: vec![UNKNOWN; cells.len()], known: Vec::new(), elsewhere, now: 1, alpha: Power::new(alpha), rho, bounds }
    }

    /// α.
    pub fn exponent(&self) -> f64 {
        self.alpha.exponent
    }

    /// τ of a step.
    pub fn tau(&self, cell: usize, direction: usize) -> f64 {
        self.known.get(self.place[cell] as usize).map_or(self.elsewhere, |known| known.tau[direction])
    }

    /// τ of the steps that no ant has come to.
    pub fn elsewhere(&self) -> f64 {
        self.elsewhere
    }

    /// Multiplies τ of a step.
    pub fn favour(&mut self, ground: &Ground, cell: usize, direction: usize, factor: f64) {
        let [low, high] = self.bounds;
        let tau = &mut self.known(ground, cell).tau[direction];
        *tau = math::clamp(*tau * factor, low, high);
    }

    #[inline]
    fn known(&mut self, ground: &Ground, cell: usize) -> &mut Known {
        if self.place[cell] == UNKNOWN {
            self.place[cell] = self.known.len() as u32;
            let (tau, attraction) = ([self.elsewhere; 8], ground.attraction(cell));
            self.known.push(Known { cell: cell as u32, made: 0, tau, attraction, weight: [0.0; 8] });
        }
        &mut self.known[self.place[cell] as usize]
    }

    /// τ_ij^α η_j^β ψ^γ of the steps from a cell, but for the turn; made when an ant first comes there in an iteration.
    #[inline]
    pub fn weights(&mut self, ground: &Ground, cell: usize) -> &[f64; 8] {
        let (alpha, now) = (self.alpha, self.now);
        let known = self.known(ground, cell);
        if known.made != now {
            known.made = now;
            known.weight = weighed(alpha, &known.tau, &known.attraction);
        }
        &known.weight
    }

    /// The same for anybody who only looks.
    pub fn look(&self, ground: &Ground, cell: usize) -> [f64; 8] {
        weighed(self.alpha, &std::array::from_fn(|d| self.tau(cell, d)), &ground.attraction(cell))
    }

    /// τ^α of a step.
    pub fn pull(&self, cell: usize, direction: usize) -> f64 {
        self.alpha.of(self.tau(cell, direction))
    }

    /// The same lies on every step.
    pub fn wipe(&mut self) {
        self.place.fill(UNKNOWN);
        self.known.clear();
    }

    /// The same pheromone under ants that see the cells otherwise: with another goal, or where other steps are allowed.
    pub fn seen_from(&self, ground: &Ground) -> Self {
        let mut other = self.clone();
        for known in &mut other.known {
            (known.attraction, known.made) = (ground.attraction(known.cell as usize), 0);
        }
        other
    }

    /// (1 − ρ) τ of [ANTBAT](crate#papers) (4) and [WOLF-ANT](crate#papers) (10). What the ants lay comes next, then
    /// [`Pheromone::settle`].
    pub fn evaporate(&mut self) {
        let left = 1.0 - self.rho;
        self.elsewhere *= left;
        self.known.iter_mut().for_each(|known| known.tau.iter_mut().for_each(|tau| *tau *= left));
    }

    /// Adds to a step that an ant took; what is laid may be negative.
    #[inline]
    pub fn lay(&mut self, cell: usize, direction: usize, amount: f64) {
        self.known[self.place[cell] as usize].tau[direction] += amount;
    }

    /// Keeps τ within its bounds; weights are made anew from here on.
    pub fn settle(&mut self) {
        let [low, high] = self.bounds;
        self.elsewhere = math::clamp(self.elsewhere, low, high);
        self.known.iter_mut().for_each(|known| known.tau.iter_mut().for_each(|tau| *tau = math::clamp(*tau, low, high)));
        self.now += 1;
    }

    /// The strongest step from a cell; −1 where none is allowed.
    pub fn strongest(&self, cells: &Cells, cell: usize) -> f64 {
        let allowed = cells.moves(cell);
        match self.known.get(self.place[cell] as usize) {
            _ if allowed == 0 => -1.0,
            None => self.elsewhere,
            Some(known) => (0..8).filter(|d| allowed >> d & 1 != 0).map(|d| known.tau[d]).fold(-1.0, f64::max),
        }
    }

    /// The most that lies on any step.
    pub fn most(&self) -> f64 {
        self.known.iter().flat_map(|known| known.tau).fold(self.elsewhere, f64::max)
    }
}

#[inline(never)]
fn weighed(alpha: Power, tau: &[f64; 8], attraction: &[f64; 8]) -> [f64; 8] {
    std::array::from_fn(|d| if attraction[d] == 0.0 { 0.0 } else { alpha.of(tau[d]) * attraction[d] })
}
