//! What a swarm minimises: a box of positions, each with a cost and a meaning in the plane.

use std::sync::Arc;

use crate::{math, message};

use super::{
    Error, Frame, Message, Readings, Solution, State,
    error::{finite, list_of},
    rng::Stream,
};

/// The box in which positions are searched, and what it allows.
#[derive(Debug, Clone)]
pub struct SearchBox {
    low: Arc<[f64]>,
    high: Arc<[f64]>,
}

impl SearchBox {
    /// From the least value of each coordinate to the greatest.
    ///
    /// # Errors
    /// [`Error::Refused`] for `low` and `high` of different lengths or without any coordinate, for values that are not finite, and
    /// where a least value is above the greatest.
    pub fn new(low: impl Into<Arc<[f64]>>, high: impl Into<Arc<[f64]>>) -> Result<Self, Error> {
        Self { low: low.into(), high: high.into() }.checked()
    }

    /// The same range for each of `dimension` coordinates.
    ///
    /// # Errors
    /// As [`SearchBox::new`].
    pub fn cube(dimension: usize, low: f64, high: f64) -> Result<Self, Error> {
        Self::new(vec![low; dimension], vec![high; dimension])
    }

    fn checked(self) -> Result<Self, Error> {
        let (low, high) = (&self.low, &self.high);
        if low.is_empty() {
            return Err(Error::refused("low", list_of(0), message!("error-one-number", "one number at least")));
        }
        if low.len() != high.len() {
            return Err(Error::refused(
                "high",
                list_of(high.len()),
                message!("error-as-long-as", "as long as {field}, which has {n}", field = "low", n = low.len()),
            ));
        }
        for (j, (&low, &high)) in low.iter().zip(&**high).enumerate() {
            if !low.is_finite() {
                return Err(Error::refused(format!("low[{j}]"), low, finite()));
            }
            if !(high.is_finite() && low <= high && (high - low).is_finite()) {
                return Err(Error::refused(
                    format!("high[{j}]"),
                    high,
                    message!("error-finite-from", "a finite number from {low} on", low),
                ));
            }
        }
        Ok(self)
    }

    /// A box whose sides follow from a scene, which was checked.
    pub(crate) fn of(sides: impl Iterator<Item = [f64; 2]>) -> Self {
        let (low, high): (Vec<_>, Vec<_>) = sides.map(|[low, high]| (low, high)).unzip();
        Self { low: low.into(), high: high.into() }
    }

    /// The least value of each coordinate.
    #[inline]
    pub fn low(&self) -> &[f64] {
        &self.low
    }

    /// The greatest value of each coordinate.
    #[inline]
    pub fn high(&self) -> &[f64] {
        &self.high
    }

    /// How many coordinates a position has.
    pub fn dimension(&self) -> usize {
        self.low.len()
    }

    /// Draws a position uniformly.
    pub fn draw(&self, x: &mut [f64], rng: &mut Stream) {
        x.iter_mut().zip(self.low.iter().zip(&*self.high)).for_each(|(x, (&low, &high))| *x = rng.between(low, high));
    }

    /// How long each side is.
    pub fn sides(&self) -> impl Iterator<Item = f64> {
        self.low.iter().zip(&*self.high).map(|(low, high)| high - low)
    }

    /// The value nearest to `x` that coordinate `j` may have.
    #[inline]
    pub fn clamp(&self, j: usize, x: f64) -> f64 {
        math::clamp(x, self.low[j], self.high[j])
    }
}

/// A position's cost.
#[derive(Debug, Clone, Copy, PartialEq, State)]
pub struct Evaluation {
    /// What is minimised, penalty included.
    pub cost: f64,
    /// How much it breaks the rules, before any weight; 0 where it breaks none.
    pub violation: f64,
}

impl From<f64> for Evaluation {
    /// A cost that breaks no rule.
    fn from(cost: f64) -> Self {
        Self { cost, violation: 0.0 }
    }
}

/// What positions mean and cost: all that a swarm knows of its scene. An own objective needs a box and a cost; then a position is
/// a [`Solution::Position`], drawn by its first two coordinates. An encoding of paths defines the rest, too.
pub trait Objective: Send + Sync {
    /// Where positions may lie: always the same box.
    fn search_box(&self) -> &SearchBox;
    /// The cost of a position, which is minimised: the same for the same position, whatever came before. A position whose cost is
    /// NaN or infinite never becomes a best one. Called once per particle and iteration; should not allocate, but for `scratch`,
    /// which is re-used from call to call.
    fn evaluate(&self, x: &[f64], scratch: &mut Scratch) -> Evaluation;
    /// The costs of many positions, one after the other in `xs`, into `out`: to the bit what [`Objective::evaluate`] says of each.
    fn evaluate_all(&self, xs: &[f64], scratch: &mut Scratch, out: &mut [Evaluation]) {
        for (x, out) in xs.chunks_exact(self.search_box().dimension()).zip(out) {
            *out = self.evaluate(x, scratch);
        }
    }
    /// Why a cost that is NaN or infinite ends a run with [`Status::Failed`](super::Status): a sentence without a full stop. `None`: it does not.
    fn refuses(&self, _cost: f64) -> Option<Message> {
        None
    }
    /// Draws a position before the first iteration, uniformly in the search box unless there is a better way.
    fn draw(&self, x: &mut [f64], rng: &mut Stream) {
        self.search_box().draw(x, rng);
    }
    /// Writes the position that stands for a path from start to goal, as nearly as one can. False: positions are no paths.
    fn encode(&self, _path: &[[f64; 2]], _x: &mut [f64]) -> bool {
        false
    }
    /// How often a position that violates a constraint is drawn anew before the first iteration.
    fn redraws(&self) -> u64 {
        0
    }
    /// Whether there are constraints that a position can violate.
    fn constrained(&self) -> bool {
        false
    }
    /// How many points in the plane a position places: itself, or a path's way-points.
    fn point_count(&self) -> usize {
        1
    }
    /// The `i`-th of those points.
    fn point(&self, x: &[f64], _i: usize) -> [f64; 2] {
        [x[0], x.get(1).copied().unwrap_or(0.0)]
    }
    /// The ends of the path that the points belong to; `None` where there is no path.
    fn ends(&self) -> Option<([f64; 2], [f64; 2])> {
        None
    }
    /// A position as it is judged.
    fn solution(&self, x: &[f64]) -> Solution {
        Solution::Position(x.to_vec())
    }
    /// The name of the coordinate `j`, e.g. `x₃`.
    fn coordinate(&self, j: usize) -> String {
        subscripted('x', j + 1)
    }
    /// Adds the numbers by which a position's meaning is measured.
    fn read(&self, _x: &[f64], _out: &mut Readings) {}
    /// Draws what belongs to the meaning and not to a particle.
    fn draw_guides(&self, _frame: &mut Frame) {}
    /// Draws what becomes of the reported position: a smoothed path.
    fn draw_result(&self, _x: &[f64], _frame: &mut Frame) {}
}

impl dyn Objective + '_ {
    /// The points in the plane that a position places.
    pub fn points<'a>(&'a self, x: &'a [f64]) -> impl Iterator<Item = [f64; 2]> + 'a {
        (0..self.point_count()).map(move |i| self.point(x, i))
    }
}

/// Room for an evaluation to work in.
#[derive(Debug, Clone, State)]
#[non_exhaustive]
pub struct Scratch {
    /// Corners of a path.
    pub path: Vec<[f64; 2]>,
    /// Pieces of a segment.
    pub pieces: Vec<[f64; 2]>,
    /// Intermediate results.
    pub numbers: Vec<f64>,
}

impl Default for Scratch {
    /// Room for the corners of a path, and for as many pieces as a segment usually meets obstacles.
    fn default() -> Self {
        Self { path: Vec::with_capacity(64), pieces: Vec::with_capacity(64), numbers: Vec::new() }
    }
}

/// A letter with a number below it, e.g. `x₁₂`.
pub(crate) fn subscripted(letter: char, number: usize) -> String {
    let digits = number.to_string().chars().filter_map(|d| char::from_u32(d as u32 - '0' as u32 + '₀' as u32)).collect::<String>();
    format!("{letter}{digits}")
}
