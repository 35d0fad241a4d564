//! Which stops are near, of so many that not all distances can be kept: points in square cells, about two in each.

use super::problem::Stop;

/// The nearest of the stops that are offered; of equally near ones those with lower numbers.
pub(super) struct Nearest {
    /// So few that each finds its place among them at once.
    pub(super) found: Vec<(f64, Stop)>,
    count: usize,
}

impl Nearest {
    pub(super) fn new(count: usize) -> Self {
        Self { found: Vec::with_capacity(count + 1), count }
    }

    #[inline(never)]
    pub(super) fn offer(&mut self, d: f64, stop: Stop) {
        if self.found.get(self.count - 1).is_some_and(|last| (d, stop) >= *last) {
            return;
        }
        let place = self.found.partition_point(|known| *known < (d, stop));
        self.found.insert(place, (d, stop));
        self.found.truncate(self.count);
    }

    /// How far the last one is; infinitely, while there are fewer.
    fn farthest(&self) -> f64 {
        self.found.get(self.count - 1).map_or(f64::INFINITY, |last| last.0)
    }
}

/// No stop: the end of a cell's list.
const NONE: Stop = Stop::MAX;

/// Stops by the cell that they are in.
pub(super) struct Field<'a> {
    points: &'a [[f64; 2]],
    low: [f64; 2],
    side: f64,
    size: [usize; 2],
    /// The first stop of each cell, and after each stop the next one.
    first: Vec<Stop>,
    next: Vec<Stop>,
}

impl<'a> Field<'a> {
    /// Some of the stops at these points.
    #[inline(never)]
    pub(super) fn new(points: &'a [[f64; 2]], stops: &[Stop]) -> Self {
        let (mut low, mut high) = (points[0], points[0]);
        for point in points {
            for axis in 0..2 {
                low[axis] = low[axis].min(point[axis]);
                high[axis] = high[axis].max(point[axis]);
            }
        }
        let cells = points.len() as f64 / 2.0;
        let spans = [high[0] - low[0], high[1] - low[1]];
        // All in a row: as many cells along it. All in one place: one cell.
        let side = (spans[0] * spans[1] / cells).sqrt().max(spans[0].max(spans[1]) / cells);
        let side = if side > 0.0 { side } else { 1.0 };
        let size = spans.map(|span| (span / side) as usize + 1);
        let (first, next) = (vec![NONE; size[0] * size[1]], vec![NONE; points.len()]);
        let mut field = Self { points, low, side, size, first, next };
        // Each comes first in its list: backwards, so that the lists have the order of the numbers, and few are offered in vain.
        for &stop in stops.iter().rev() {
            let cell = field.cell_of(stop);
            field.next[stop as usize] = field.first[cell];
            field.first[cell] = stop;
        }
        field
    }

    fn column_and_row(&self, stop: Stop) -> [usize; 2] {
        let point = self.points[stop as usize];
        [0, 1].map(|axis| (((point[axis] - self.low[axis]) / self.side) as usize).min(self.size[axis] - 1))
    }

    fn cell_of(&self, stop: Stop) -> usize {
        let [column, row] = self.column_and_row(stop);
        row * self.size[0] + column
    }

    /// Takes a stop out.
    pub(super) fn remove(&mut self, stop: Stop) {
        let (cell, behind) = (self.cell_of(stop), self.next[stop as usize]);
        let mut at = &mut self.first[cell];
        while *at != stop {
            let before = *at as usize;
            at = &mut self.next[before];
        }
        *at = behind;
    }

    /// The square of the straight line.
    fn apart(&self, a: Stop, b: Stop) -> f64 {
        let (a, b) = (self.points[a as usize], self.points[b as usize]);
        (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1])
    }

    /// Offers the stops in a square ring of cells around a stop's; `false` if all of the ring is outside.
    fn ring(&self, stop: Stop, ring: usize, nearest: &mut Nearest) -> bool {
        let [column, row] = self.column_and_row(stop).map(|at| at as isize);
        let ([columns, rows], ring) = (self.size.map(|size| size as isize), ring as isize);
        let (top, bottom) = (row - ring, row + ring);
        for at in top.max(0)..=bottom.min(rows - 1) {
            // Between the first row and the last one only the two ends.
            let step = if at == top || at == bottom || ring == 0 { 1 } else { 2 * ring };
            let mut across = column - ring;
            while across <= column + ring {
                if (0..columns).contains(&across) {
                    self.offer(stop, (at * columns + across) as usize, nearest);
                }
                across += step;
            }
        }
        ring <= column.max(columns - 1 - column).max(row.max(rows - 1 - row))
    }

    /// Offers the stops in a cell.
    fn offer(&self, stop: Stop, cell: usize, nearest: &mut Nearest) {
        let mut other = self.first[cell];
        while other != NONE {
            if other != stop {
                nearest.offer(self.apart(stop, other), other);
            }
            other = self.next[other as usize];
        }
    }

    /// The nearest stops that are left, with the squares of the straight lines.
    pub(super) fn nearest(&self, stop: Stop, count: usize) -> Vec<(f64, Stop)> {
        let mut nearest = Nearest::new(count);
        let mut ring = 0;
        // Whatever is in the next ring is farther than this one is wide.
        let mut wide = 0.0;
        while self.ring(stop, ring, &mut nearest) && nearest.farthest() >= wide * wide {
            ring += 1;
            wide += self.side;
        }
        nearest.found
    }

    /// The nearest stop that is left, which is taken out.
    pub(super) fn take_nearest(&mut self, stop: Stop) -> Option<Stop> {
        let (_, nearest) = self.nearest(stop, 1).pop()?;
        self.remove(nearest);
        Some(nearest)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kernel::rng::Stream;

    #[test]
    fn the_nearest_are_those_that_trying_all_finds() {
        let mut rng = Stream::new(5, 0);
        for case in 0..40 {
            let n = 2 + rng.below(300);
            // Whole numbers: many are equally near, and some at the same place; some cases in a row, or all at one place.
            let side = [40, 400, 1][case % 3];
            let flat = case % 4 == 0;
            let points: Vec<_> = (0..n).map(|_| [rng.below(side) as f64, if flat { 3.0 } else { rng.below(side) as f64 }]).collect();
            let mut field = Field::new(&points, &(0..n as Stop).collect::<Vec<_>>());
            let mut left: Vec<Stop> = (0..n as Stop).collect();
            while left.len() > 1 {
                let from = left[rng.below(left.len())];
                let mut others: Vec<_> = left.iter().copied().filter(|&stop| stop != from).collect();
                others.sort_by(|&a, &b| field.apart(from, a).total_cmp(&field.apart(from, b)).then(a.cmp(&b)));
                others.truncate(10);
                assert_eq!(field.nearest(from, 10).into_iter().map(|(_, stop)| stop).collect::<Vec<_>>(), others, "{points:?}");
                let gone = left.swap_remove(rng.below(left.len()));
                field.remove(gone);
            }
            assert!(field.nearest(left[0], 10).is_empty());
        }
    }
}
