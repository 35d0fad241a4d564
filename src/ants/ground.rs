//! What never changes while a colony searches: the cells, and how attractive each step is before any pheromone lies on it.

use std::{
    f64::consts::{FRAC_PI_2, PI, TAU},
    sync::Arc,
};

use crate::{
    exact,
    geometry::{self, Cells, Endpoints, angle},
    kernel::Error,
    math,
    scene::GridScene,
};

/// Directions of a step; `NOWHERE` stands for the direction from which an ant comes that has not moved yet.
pub(super) const NOWHERE: usize = 8;

/// How an ant sees the cells around it: η of the step to each of them.
#[derive(Debug, Clone, Copy)]
#[non_exhaustive]
pub enum Heuristic {
    /// η = 1 / distance to the goal, [ANTBAT](crate#papers) §3.1.
    Distance,
    /// η = ε times 5, 4, 4, 3, 3, 2, 2, 1 by rank, [WOLF-ANT](crate#papers) (6).
    Ranked {
        /// ε.
        epsilon: f64,
    },
    /// An own one: η of a step to a cell, by its number and the goal's. It is kept between 0 and 10⁹, and asked for once in a run for
    /// each step that an ant can take.
    Own(fn(&Cells, usize, usize) -> f64),
}

/// How ψ of [ANTBAT](crate#papers) (2) falls with an angle θ.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Direction {
    /// exp(−(θ/π)²). In the scan the brackets of (2) are lost and the 2 stands behind π: it is an exponent.
    Squared,
    /// exp(−θ/(π/2)): our first reading, in which the 2 divides π.
    Linear,
}

impl Direction {
    /// −ln ψ of an angle.
    pub fn exponent(self, theta: f64) -> f64 {
        match self {
            Self::Squared => (theta / PI) * (theta / PI),
            Self::Linear => theta / FRAC_PI_2,
        }
    }
}

/// The cells with everything that a colony computes once.
#[derive(Debug)]
pub(super) struct Ground {
    pub cells: Arc<Cells>,
    pub endpoints: Endpoints,
    pub grid: Arc<GridScene>,
    /// What a turn from one direction to another leaves of a step's attraction: ψ^γ as far as θ1 goes.
    pub turn: [[f64; 8]; 9],
    pub heuristic: Heuristic,
    pub beta: Power,
    pub gamma: f64,
    pub direction: Direction,
    /// Whether there is a way at all.
    pub reachable: bool,
}

impl Ground {
    pub fn new(grid: &Arc<GridScene>, heuristic: Heuristic, beta: f64, gamma: f64, direction: Direction) -> Result<Self, Error> {
        let cells = Arc::clone(grid.cells());
        let endpoints = grid.endpoints()?;
        let mut ground = Self {
            turn: [[1.0; 8]; 9],
            heuristic,
            beta: Power::new(beta),
            gamma,
            direction,
            reachable: exact::is_reachable(&cells, endpoints.start, endpoints.goal),
            cells,
            endpoints,
            grid: Arc::clone(grid),
        };
        if gamma != 0.0 {
            for from in 0..8 {
                for to in 0..8 {
                    ground.turn[from][to] = math::exp(-gamma * direction.exponent(theta1(from, to)));
                }
            }
        }
        Ok(ground)
    }

    /// η^β ψ^γ of each step from a cell without its turn; 0 where none is allowed.
    pub fn attraction(&self, cell: usize) -> [f64; 8] {
        let eta = self.eta(cell);
        let allowed = self.cells.moves(cell);
        std::array::from_fn(|d| {
            if allowed >> d & 1 == 0 {
                0.0
            } else if self.gamma == 0.0 {
                self.beta.of(eta[d])
            } else {
                self.beta.of(eta[d]) * math::exp(-self.gamma * self.direction.exponent(self.theta2(cell, d)))
            }
        })
    }

    /// η of each step from a cell.
    pub fn eta(&self, cell: usize) -> [f64; 8] {
        match self.heuristic {
            Heuristic::Distance => self.of_each(cell, &|next| self.nearness(next)),
            Heuristic::Ranked { epsilon } => ranked(self.to_goal(cell)).map(|weight| epsilon * weight),
            Heuristic::Own(eta) => self.of_each(cell, &|next| {
                let eta = eta(&self.cells, next, self.endpoints.goal);
                if eta > 0.0 { eta.min(1e9) } else { 0.0 }
            }),
        }
    }

    /// η of the cell to which each step leads; 0 where none is allowed.
    fn of_each(&self, cell: usize, eta: &dyn Fn(usize) -> f64) -> [f64; 8] {
        let allowed = self.cells.moves(cell);
        std::array::from_fn(|d| if allowed >> d & 1 == 0 { 0.0 } else { eta(self.cells.next(cell, d)) })
    }

    /// The cells of a walk in these directions from the start on.
    pub fn way<'a>(&'a self, directions: &'a [u8]) -> impl Iterator<Item = usize> + 'a {
        let start = self.endpoints.start;
        let cells = directions.iter().scan(start, |cell, &d| {
            *cell = self.cells.next(*cell, usize::from(d));
            Some(*cell)
        });
        std::iter::once(start).chain(cells)
    }

    /// The straight distance from start to goal, in the scene's unit.
    pub fn apart(&self) -> f64 {
        let [from, to] = [self.endpoints.start, self.endpoints.goal].map(|cell| self.cells.centre(cell));
        geometry::length(&[from, to])
    }

    /// 1 / distance to the goal, in cells. Reading: the goal itself is half a cell away.
    fn nearness(&self, cell: usize) -> f64 {
        1.0 / self.cells.apart(cell, self.endpoints.goal).max(0.5)
    }

    /// Columns and rows from a cell to the goal.
    fn to_goal(&self, cell: usize) -> [i64; 2] {
        let (from, to) = (self.cells.place(cell), self.cells.place(self.endpoints.goal));
        std::array::from_fn(|axis| to[axis] as i64 - from[axis] as i64)
    }

    /// θ2 of [ANTBAT](crate#papers) (2): the angle between a step and the line from its cell to the goal; 0 at the goal.
    pub fn theta2(&self, cell: usize, direction: usize) -> f64 {
        let [x, y] = self.to_goal(cell).map(|c| c as f64);
        if x == 0.0 && y == 0.0 { 0.0 } else { between(angle(direction), math::atan2(y, x)) }
    }
}

/// θ1 of [ANTBAT](crate#papers) (2): the turn between one step and the next; 0 for an ant that has not moved yet.
pub(super) fn theta1(from: usize, to: usize) -> f64 {
    if from == NOWHERE { 0.0 } else { between(angle(from), angle(to)) }
}

/// The angle between two directions, 0 to π.
fn between(a: f64, b: f64) -> f64 {
    let apart = math::turn((a - b).abs());
    if apart > PI { TAU - apart } else { apart }
}

/// The weights of the eight neighbours by the distance of each from the goal, which lies `dx` columns and `dy` rows away:
/// the nearest 5, then 4, 4, 3, 3, 2, 2, the farthest 1, [WOLF-ANT](crate#papers) (6). Reading: those equally far share their
/// weights.
pub(super) fn ranked([dx, dy]: [i64; 2]) -> [f64; 8] {
    const WEIGHTS: [f64; 8] = [5.0, 4.0, 4.0, 3.0, 3.0, 2.0, 2.0, 1.0];
    let squared = crate::geometry::DIRECTIONS.map(|[x, y]| (dx - i64::from(x)).pow(2) + (dy - i64::from(y)).pow(2));
    squared.map(|own| {
        let nearer = squared.iter().filter(|&&other| other < own).count();
        let alike = squared.iter().filter(|&&other| other == own).count();
        WEIGHTS[nearer..nearer + alike].iter().sum::<f64>() / alike as f64
    })
}

/// x ↦ x^exponent for x ≥ 0; halves and whole numbers, as papers have them, without a general power.
#[derive(Debug, Clone, Copy)]
pub(super) struct Power {
    pub exponent: f64,
    /// Twice the exponent, if that is a small whole number.
    halves: Option<u32>,
}

impl Power {
    pub fn new(exponent: f64) -> Self {
        let twice = 2.0 * exponent;
        let halves = (twice.fract() == 0.0 && (0.0..=64.0).contains(&twice)).then_some(twice as u32);
        Self { exponent, halves }
    }

    #[inline]
    pub fn of(self, x: f64) -> f64 {
        let Some(halves) = self.halves else {
            return math::pow(x, self.exponent);
        };
        let mut result = if halves & 1 == 1 { x.sqrt() } else { 1.0 };
        let (mut base, mut left) = (x, halves >> 1);
        while left > 0 {
            if left & 1 == 1 {
                result *= base;
            }
            base *= base;
            left >>= 1;
        }
        result
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shipped;

    #[test]
    fn the_goal_to_the_lower_right_gives_the_paper_s_example() {
        // Rows along y, here downwards: E, SE, S, SW, W, NW, N, NE.
        assert_eq!(ranked([9, 9]), [4.0, 5.0, 4.0, 3.0, 2.0, 1.0, 2.0, 3.0]);
        // Straight to the right: the cell behind is nearer than the two beside it, which share 2 and 1.
        assert_eq!(ranked([9, 0]), [5.0, 4.0, 3.0, 1.5, 2.0, 1.5, 3.0, 4.0]);
        // A little below: squared distances 65, 64, 81, 100, 101, 104, 85, 68, no ties.
        assert_eq!(ranked([9, 1]), [4.0, 5.0, 3.0, 2.0, 2.0, 1.0, 3.0, 4.0]);
        assert_eq!(ranked([1, 0]), [5.0, 4.0, 3.0, 1.5, 2.0, 1.5, 3.0, 4.0]);
    }

    #[test]
    fn attraction_is_eta_to_the_beta_times_psi_to_the_gamma() {
        let scene = shipped("ant-bat-30").unwrap();
        let ground = Ground::new(&scene.share().unwrap(), Heuristic::Distance, 8.0, 2.5, Direction::Squared).unwrap();
        let cell = ground.endpoints.start;
        assert_eq!(ground.cells.place(cell), [1, 26]);
        // The goal is 27 columns to the right and 25 rows down; a step to the right leaves 26 and 25.
        // √(26² + 25²) to the eighth is 1301⁴; atan(25 / 27) = 0.746946.
        let eighth = 1.0 / (1301.0 * 1301.0 * 1301.0 * 1301.0);
        let theta2 = math::atan2(25.0, 27.0);
        let expected = eighth * math::exp(-2.5 * theta2 * theta2 / (PI * PI));
        assert!((ground.attraction(cell)[0] / expected - 1.0).abs() < 1e-12);
        // A right angle: (1/2)² squared, 1 linear.
        assert!((ground.turn[0][2] / math::exp(-2.5 * 0.25) - 1.0).abs() < 1e-14);
        let linear = Ground::new(&scene.share().unwrap(), Heuristic::Distance, 8.0, 2.5, Direction::Linear).unwrap();
        assert!((linear.attraction(cell)[0] / (eighth * math::exp(-2.5 * theta2 / FRAC_PI_2)) - 1.0).abs() < 1e-12);
        assert!((linear.turn[0][2] / math::exp(-2.5) - 1.0).abs() < 1e-14);
        assert_eq!((ground.turn[3][3], ground.turn[NOWHERE][5]), (1.0, 1.0));
        assert_eq!(ground.nearness(ground.endpoints.goal), 2.0);
        let plain = Ground::new(&scene.share().unwrap(), Heuristic::Distance, 8.0, 0.0, Direction::Squared).unwrap();
        assert!((plain.attraction(cell)[0] / eighth - 1.0).abs() < 1e-12);
        assert!(plain.turn.iter().flatten().all(|&factor| factor == 1.0));
    }

    #[test]
    fn halves_and_general_exponents_agree() {
        for exponent in [0.0, 0.5, 1.0, 1.5, 7.0, 8.0, 20.0, 32.0] {
            for x in [0.001, 0.3, 1.0, 2.7, 19.0_f64] {
                let (fast, general) = (Power::new(exponent).of(x), math::pow(x, exponent));
                assert!((fast / general - 1.0).abs() < 1e-13, "{x}^{exponent}");
            }
        }
        assert_eq!(Power::new(0.367).of(2.0), math::pow(2.0, 0.367));
        assert_eq!((Power::new(0.0).of(0.0), Power::new(2.0).of(0.0)), (1.0, 0.0));
    }
}
