//! What makes one best-first search another: how it guesses what is still to go, and whose child a cell becomes.

use crate::geometry::Cells;

use super::open::{apart, place};

/// The length of a straight step, and thereby of a cell's side. With [`DIAGONAL`] it makes the best fraction for √2 there
/// is up to ten million, so sums of steps are whole numbers below 2^53 (exact), and for ways of up to six million steps
/// they are equal where the ways are equally long, and ordered as the ways are.
pub(super) const STRAIGHT: f64 = 6_625_109.0;
/// The length of a diagonal step.
pub(super) const DIAGONAL: f64 = 9_369_319.0;

/// How far it still is from a cell to the goal. Where that is never more than it really is, the path is the shortest.
#[derive(Debug, Clone, Copy)]
#[non_exhaustive]
pub enum Heuristic {
    /// 0: the search spreads evenly, Dijkstra 1959.
    Nothing,
    /// The way from cell to cell if none were blocked.
    Octile,
    /// The straight line.
    Straight,
    /// An own one, in sides of a cell, from how many columns and rows the goal is away. It is kept between 0 and 10⁹.
    Own(fn([f64; 2]) -> f64),
}

impl Heuristic {
    /// For a goal so many columns and rows away.
    #[inline]
    pub(super) fn ahead(self, [dx, dy]: [i32; 2]) -> f64 {
        let (x, y) = (f64::from(dx.abs()), f64::from(dy.abs()));
        match self {
            Self::Nothing => 0.0,
            Self::Octile => STRAIGHT * x.max(y) + (DIAGONAL - STRAIGHT) * x.min(y),
            Self::Straight => line([dx, dy]),
            Self::Own(ahead) => STRAIGHT * bounded(ahead([x, y])),
        }
    }
}

/// The open list needs numbers that are not negative; what is none is 0.
fn bounded(ahead: f64) -> f64 {
    if ahead > 0.0 { ahead.min(1e9) } else { 0.0 }
}

/// The length of the straight line over so many columns and rows.
#[inline]
pub(super) fn line([dx, dy]: [i32; 2]) -> f64 {
    let (x, y) = (f64::from(dx), f64::from(dy));
    STRAIGHT * (x * x + y * y).sqrt()
}

/// A heuristic, its weight and its goal: what it says of a place.
#[derive(Debug, Clone, Copy)]
pub(super) struct Guess {
    pub(super) heuristic: Heuristic,
    /// What the heuristic is multiplied by.
    pub(super) weight: f64,
    /// Column and row of the goal's cell.
    pub(super) goal: [i32; 2],
}

impl Guess {
    /// The weighted heuristic of a column and a row.
    #[inline]
    pub(super) fn ahead(&self, [x, y]: [i32; 2]) -> f64 {
        self.weight * self.heuristic.ahead([x - self.goal[0], y - self.goal[1]])
    }

    /// What it says of each cell, if it is an own one.
    pub(super) fn table(&self, cells: &Cells) -> Vec<f64> {
        let own = matches!(self.heuristic, Heuristic::Own(_));
        (0..if own { cells.len() } else { 0 }).map(|cell| self.ahead(apart(place(cells.place(cell))))).collect()
    }

    /// The same in the inner loop, which is faster without a call: an own heuristic is looked up in `table`, by cell.
    #[inline]
    pub(super) fn look_up(&self, at: [i32; 2], cell: usize, table: &[f64]) -> f64 {
        if matches!(self.heuristic, Heuristic::Own(_)) { table[cell] } else { self.ahead(at) }
    }
}

/// Whose child a cell becomes when the search comes to it from a neighbour.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Relaxation {
    /// The neighbour's: paths go from cell to cell.
    Step,
    /// The neighbour's parent's if the two see each other, otherwise the neighbour's: paths go at any angle.
    Sight,
}

/// A search's rules.
#[derive(Debug, Clone, Copy)]
pub(super) struct Rules {
    pub(super) heuristic: Heuristic,
    pub(super) relaxation: Relaxation,
}

#[cfg(test)]
mod tests {
    use std::f64::consts::SQRT_2;

    use super::*;

    #[test]
    fn whole_numbers_order_ways_as_their_lengths_do() {
        let (q, p) = (STRAIGHT as i128, DIAGONAL as i128);
        assert_eq!((p * p - 2 * q * q).abs(), 1, "a convergent of √2: no fraction with a smaller denominator is between them");
        let cells = (crate::scene::MAX_SIDE * crate::scene::MAX_SIDE) as f64;
        assert!(cells < STRAIGHT && cells * DIAGONAL < 9_007_199_254_740_992.0);
        assert!((DIAGONAL / STRAIGHT - SQRT_2).abs() < 1e-13);
    }

    #[test]
    fn what_is_ahead_is_nothing_the_octile_way_or_the_straight_line() {
        let cells = |heuristic: Heuristic, by| heuristic.ahead(by) / STRAIGHT;
        assert_eq!(cells(Heuristic::Nothing, [3, -4]), 0.0);
        assert_eq!(Heuristic::Octile.ahead([3, -4]), STRAIGHT + 3.0 * DIAGONAL);
        assert_eq!(Heuristic::Octile.ahead([-5, 0]), 5.0 * STRAIGHT);
        assert_eq!(cells(Heuristic::Straight, [3, -4]), 5.0);
    }
}
