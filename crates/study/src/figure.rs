//! Figures as they are printed, to so many digits, and what can be asked of them.

use std::f64::consts::SQRT_2;

use forage::{
    kernel::Error,
    scene::{GridScene, Scene},
};

/// A number as a paper prints it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Figure {
    /// The number.
    pub value: f64,
    /// How many digits stand after the point.
    pub digits: usize,
}

impl Figure {
    /// This number, printed to so many digits.
    pub const fn new(value: f64, digits: usize) -> Self {
        Self { value, digits }
    }

    /// Another number, printed as this one is.
    pub fn like(&self, number: f64) -> f64 {
        format!("{number:.*}", self.digits).parse().unwrap_or(number)
    }

    /// Whether it is the length of some path from cell to cell, if nothing were in the way.
    pub fn is_length(&self, by: &Steps) -> bool {
        by.around(self.value).into_iter().flatten().any(|length| self.like(length) == self.value)
    }
}

/// How far the goal's cell is from the start's, and how large a cell is: which lengths paths from cell to cell can have.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Steps {
    /// A cell's side.
    pub side: f64,
    /// Columns and rows from one to the other.
    pub apart: [u64; 2],
}

impl Steps {
    /// Of a grid's start and goal.
    ///
    /// # Errors
    /// A scene that is no grid, or has no ends.
    pub fn of(scene: &Scene) -> Result<Self, Error> {
        let grid = scene.get::<GridScene>()?;
        let endpoints = grid.endpoints()?;
        let [from, to] = [endpoints.start, endpoints.goal].map(|cell| grid.cells().place(cell));
        Ok(Self { side: grid.cell, apart: [0, 1].map(|axis| from[axis].abs_diff(to[axis]) as u64) })
    }

    /// The lengths next below (or equal) and above that some path can have.
    pub fn around(&self, length: f64) -> [Option<f64>; 2] {
        let mut around: [Option<f64>; 2] = [None; 2];
        for diagonal in 0..=(length / (self.side * SQRT_2)) as u64 + 1 {
            // Along an axis straight steps make up what diagonal ones leave, and come in pairs beyond that.
            let least: u64 = self.apart.iter().map(|&n| n.checked_sub(diagonal).unwrap_or_else(|| (diagonal - n) % 2)).sum();
            let whole = |straight: u64| (straight as f64 + diagonal as f64 * SQRT_2) * self.side;
            let pairs = ((length - whole(least)) / (2.0 * self.side)).floor().max(-1.0);
            for straight in [pairs, pairs + 1.0].into_iter().filter(|&pairs| pairs >= 0.0).map(|pairs| least + 2 * pairs as u64) {
                let found = whole(straight);
                let side = usize::from(found > length);
                let nearer = |old: f64| (found - length).abs() < (old - length).abs();
                if around[side].is_none_or(nearer) {
                    around[side] = Some(found);
                }
            }
        }
        around
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every way of a small board, counted out: one column and three rows further, up to six steps.
    #[test]
    fn the_lengths_around_are_those_of_all_ways() {
        let mut lengths = Vec::new();
        let mut ways = vec![(0_i64, 0_i64, 0.0)];
        for _ in 0..6 {
            ways = ways
                .iter()
                .flat_map(|&(x, y, length)| {
                    let step = move |(dx, dy): (i64, i64)| (x + dx, y + dy, length + if dx != 0 && dy != 0 { SQRT_2 } else { 1.0 });
                    let all = (-1..=1).flat_map(|dx| (-1..=1).map(move |dy| (dx, dy)));
                    all.filter(|&step| step != (0, 0)).map(step).collect::<Vec<_>>()
                })
                .collect();
            ways.sort_by(|a, b| (a.0, a.1).cmp(&(b.0, b.1)).then(a.2.total_cmp(&b.2)));
            ways.dedup_by(|a, b| (a.0, a.1) == (b.0, b.1) && (a.2 - b.2).abs() < 1e-9);
            lengths.extend(ways.iter().filter(|way| (way.0, way.1) == (1, 3)).map(|way| way.2));
        }
        lengths.sort_by(f64::total_cmp);
        let by = Steps { side: 1.0, apart: [1, 3] };
        for k in 30..60 {
            let length = f64::from(k) / 10.0 + 0.003;
            let below = lengths.iter().rev().find(|&&l| l <= length).copied();
            let above = lengths.iter().find(|&&l| l > length).copied();
            for (found, expected) in by.around(length).into_iter().zip([below, above]) {
                let same = found.zip(expected).is_some_and(|(a, b)| (a - b).abs() < 1e-9) || (found, expected) == (None, None);
                assert!(same, "{length}: {found:?}, {expected:?}");
            }
        }
    }
}
