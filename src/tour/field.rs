//! Which stops are near, of so many that not all distances can be kept: points in boxes within boxes.

use super::problem::Stop;
use crate::math;

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
}

/// So many stops at most are in a box that is not split.
const FEW: usize = 4;
/// The root's parent, and the halves of what is not split.
const NONE: usize = usize::MAX;

/// The smallest box around some stops.
struct Area {
    low: [f64; 2],
    high: [f64; 2],
    /// Where its stops are in the order.
    from: usize,
    /// How many of them are left.
    left: usize,
    parent: usize,
    /// Its first half; the second one is next to it.
    halves: usize,
    /// None of its stops has a lower number.
    lowest: Stop,
}

/// Stops in boxes that are split in the middle until there are few in each, so that there are as many boxes as there are stops nearby.
pub(super) struct Field<'a> {
    points: &'a [[f64; 2]],
    /// The stops by box; in each those that are left before those that are not.
    order: Vec<Stop>,
    areas: Vec<Area>,
    /// In which box each stop is.
    place: Vec<usize>,
}

impl<'a> Field<'a> {
    /// Some of the stops at these points.
    #[inline(never)]
    pub(super) fn new(points: &'a [[f64; 2]], stops: &[Stop]) -> Self {
        let mut field = Self { points, order: stops.to_vec(), areas: Vec::new(), place: vec![NONE; points.len()] };
        field.enclose(NONE, 0, stops.len());
        let mut aside = Vec::new();
        let mut at = 0;
        while at < field.areas.len() {
            field.split(at, &mut aside);
            at += 1;
        }
        field
    }

    /// Adds the box around some stops.
    fn enclose(&mut self, parent: usize, from: usize, left: usize) {
        let (mut low, mut high, mut lowest) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2], Stop::MAX);
        for &stop in &self.order[from..from + left] {
            lowest = lowest.min(stop);
            let point = self.points[stop as usize];
            for axis in 0..2 {
                low[axis] = low[axis].min(point[axis]);
                high[axis] = high[axis].max(point[axis]);
            }
        }
        self.areas.push(Area { low, high, from, left, parent, halves: NONE, lowest });
    }

    fn split(&mut self, at: usize, aside: &mut Vec<Stop>) {
        let Area { low, high, from, left, .. } = self.areas[at];
        let own = &mut self.order[from..from + left];
        if left <= FEW {
            own.iter().for_each(|&stop| self.place[stop as usize] = at);
            return;
        }
        let spans = [high[0] - low[0], high[1] - low[1]];
        let axis = usize::from(spans[1] > spans[0]);
        let middle = low[axis] + spans[axis] / 2.0;
        aside.clear();
        let mut first = 0;
        for k in 0..left {
            let stop = own[k];
            if self.points[stop as usize][axis] <= middle {
                own[first] = stop;
                first += 1;
            } else {
                aside.push(stop);
            }
        }
        own[first..].copy_from_slice(aside);
        // All in one place, as far as numbers tell it.
        if first == left {
            first /= 2;
        }
        self.areas[at].halves = self.areas.len();
        self.enclose(at, from, first);
        self.enclose(at, from + first, left - first);
    }

    /// Takes a stop out.
    pub(super) fn remove(&mut self, stop: Stop) {
        let mut at = self.place[stop as usize];
        let Area { from, left, .. } = self.areas[at];
        let own = &mut self.order[from..from + left];
        if let Some(k) = own.iter().position(|&one| one == stop) {
            own.swap(k, left - 1);
        }
        while at != NONE {
            self.areas[at].left -= 1;
            at = self.areas[at].parent;
        }
    }

    /// The square of the straight line.
    fn apart(a: [f64; 2], b: [f64; 2]) -> f64 {
        (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1])
    }

    /// The square of the straight line to a box, and the lowest number in it: nothing in it comes before that.
    fn before(&self, point: [f64; 2], at: usize) -> (f64, Stop) {
        let Area { low, high, lowest, .. } = self.areas[at];
        (Self::apart(point, [0, 1].map(|axis| math::clamp(point[axis], low[axis], high[axis]))), lowest)
    }

    /// Offers the stops in a box, and in the nearer half first.
    fn visit(&self, stop: Stop, at: usize, nearest: &mut Nearest) {
        let (point, area) = (self.points[stop as usize], &self.areas[at]);
        if area.left == 0 || nearest.found.get(nearest.count - 1).is_some_and(|last| self.before(point, at) > *last) {
            return;
        }
        if area.halves == NONE {
            for &other in self.order[area.from..area.from + area.left].iter().filter(|&&other| other != stop) {
                nearest.offer(Self::apart(point, self.points[other as usize]), other);
            }
            return;
        }
        let second = usize::from(self.before(point, area.halves + 1) < self.before(point, area.halves));
        self.visit(stop, area.halves + second, nearest);
        self.visit(stop, area.halves + 1 - second, nearest);
    }

    /// The nearest stops that are left, with the squares of the straight lines.
    pub(super) fn nearest(&self, stop: Stop, count: usize) -> Vec<(f64, Stop)> {
        let mut nearest = Nearest::new(count);
        self.visit(stop, 0, &mut nearest);
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
                others.sort_by(|&a, &b| {
                    Field::apart(points[from as usize], points[a as usize])
                        .total_cmp(&Field::apart(points[from as usize], points[b as usize]))
                        .then(a.cmp(&b))
                });
                others.truncate(10);
                assert_eq!(field.nearest(from, 10).into_iter().map(|(_, stop)| stop).collect::<Vec<_>>(), others, "{points:?}");
                let gone = left.swap_remove(rng.below(left.len()));
                field.remove(gone);
            }
            assert!(field.nearest(left[0], 10).is_empty());
        }
    }

    /// A box is split where its stops are: how many boxes a search enters does not depend on how far away the farthest stop is.
    #[test]
    fn stops_in_clusters_are_in_boxes_of_few() {
        let mut rng = Stream::new(6, 0);
        let mut points: Vec<_> = (0..20_000).map(|_| [rng.below(1000) as f64, rng.below(1000) as f64]).collect();
        points.push([1e9, 1e9]);
        points.extend((0..2_000).map(|_| [7.0, 7.0]));
        let field = Field::new(&points, &(0..points.len() as Stop).collect::<Vec<_>>());
        assert!(field.areas.iter().all(|area| area.halves != NONE || area.left <= FEW));
        let depth = |mut at: usize| {
            let mut depth = 0;
            while at != NONE {
                depth += 1;
                at = field.areas[at].parent;
            }
            depth
        };
        assert!(field.place.iter().all(|&at| depth(at) <= 40), "{:?}", field.place.iter().map(|&at| depth(at)).max());
    }
}
