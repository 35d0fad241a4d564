//! Which node is nearest: a grid of cells over the space, as fine as there are nodes. No scan of all nodes.

use crate::{kernel::State, math};

use super::vector::squared;

/// No node.
const NONE: u32 = u32::MAX;
/// Of so few, looking at all is quicker than looking at cells.
const FEW: usize = 32;
/// How many axes have cells: those of the first coordinates. In more dimensions the distance along these bounds it below.
const AXES: usize = 3;

/// The nodes of a tree by the cell in which they lie.
#[derive(Debug, Clone, State)]
pub(super) struct Nearest<const N: usize> {
    /// The corner of the cells; nodes beyond the outermost ones belong to these.
    min: [f64; N],
    /// A cell's side.
    side: f64,
    /// Cells along each axis.
    cells: [usize; AXES],
    /// The node of each cell that came last.
    first: Vec<u32>,
    /// Of each node, the one of its cell that came before it.
    before: Vec<u32>,
    /// How many nodes there were when the cells were made.
    divided: usize,
}

impl<const N: usize> Nearest<N> {
    /// No node yet.
    pub(super) fn new() -> Self {
        Self { min: [0.0; N], side: f64::INFINITY, cells: [1; AXES], first: vec![NONE], before: Vec::new(), divided: FEW }
    }

    /// Adds the last of the points. Whenever there are twice as many, cells are made anew, for the box that the nodes fill.
    pub(super) fn add(&mut self, points: &[[f64; N]]) {
        if points.len() > 2 * self.divided {
            self.divide(points);
        } else {
            self.put(points.len() - 1, &points[points.len() - 1]);
        }
    }

    /// Puts all the points into finer cells.
    fn divide(&mut self, points: &[[f64; N]]) {
        self.divided = points.len();
        let mut extents = [0.0; AXES];
        for (i, extent) in extents.iter_mut().enumerate().take(N) {
            let (low, high) = points.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), p| (low.min(p[i]), high.max(p[i])));
            (self.min[i], *extent) = (low, high - low);
        }
        // Eight cells a node on average; an axis along which the box is thinner than a cell has one.
        let wanted = (8 * points.len()) as f64;
        let mut wide = extents;
        self.side = loop {
            let (volume, axes) =
                wide.iter().filter(|&&extent| extent > 0.0).fold((1.0, 0), |(volume, axes), extent| (volume * extent, axes + 1));
            let side = match axes {
                0 => f64::INFINITY,
                1 => volume / wanted,
                2 => (volume / wanted).sqrt(),
                _ => libm::cbrt(volume / wanted),
            };
            if wide.iter().all(|&extent| extent == 0.0 || extent >= side) {
                break side;
            }
            wide = wide.map(|extent| if extent < side { 0.0 } else { extent });
        };
        // Where numbers underflow the quotient is nothing, or without end.
        self.cells = wide.map(|extent| (extent / self.side).min(wanted) as usize + 1);
        self.first.clear();
        self.first.resize(self.cells.iter().product(), NONE);
        self.before.clear();
        points.iter().enumerate().for_each(|(node, point)| self.put(node, point));
    }

    fn put(&mut self, node: usize, point: &[f64; N]) {
        let [x, y, z] = self.cell(point);
        let cell = self.number(x, y, z);
        self.before.push(std::mem::replace(&mut self.first[cell], node as u32));
    }

    #[inline]
    fn cell(&self, point: &[f64; N]) -> [usize; AXES] {
        let mut cell = [0; AXES];
        for i in 0..AXES.min(N) {
            // Casting cuts off below 0.
            cell[i] = (((point[i] - self.min[i]) / self.side) as usize).min(self.cells[i] - 1);
        }
        cell
    }

    #[inline]
    fn number(&self, x: usize, y: usize, z: usize) -> usize {
        (z * self.cells[1] + y) * self.cells[0] + x
    }

    /// The node nearest to a point, and its squared distance; of equals the first. There must be one.
    pub(super) fn nearest(&self, points: &[[f64; N]], to: &[f64; N]) -> (usize, f64) {
        let mut found = (0, f64::INFINITY);
        if points.len() <= FEW {
            (0..points.len()).for_each(|node| offer(&mut found, points, to, node));
            return found;
        }
        let centre = self.cell(to);
        for ring in 0.. {
            self.shell(centre, ring, points, to, &mut found);
            let reach = self.reach(to, centre, ring);
            if found.1 <= reach * reach {
                break;
            }
        }
        found
    }

    /// Offers the nodes of the cells that are exactly `ring` away from the centre along some axis.
    fn shell(&self, centre: [usize; AXES], ring: usize, points: &[[f64; N]], to: &[f64; N], found: &mut (usize, f64)) {
        let low = centre.map(|c| c.saturating_sub(ring));
        let high: [usize; AXES] = std::array::from_fn(|i| (centre[i] + ring).min(self.cells[i] - 1));
        let on = |axis: usize, at: usize| at.abs_diff(centre[axis]) == ring;
        for z in low[2]..=high[2] {
            for y in low[1]..=high[1] {
                let mut row = |x: usize| {
                    let mut node = self.first[self.number(x, y, z)];
                    while node != NONE {
                        offer(found, points, to, node as usize);
                        node = self.before[node as usize];
                    }
                };
                if on(2, z) || on(1, y) {
                    (low[0]..=high[0]).for_each(row);
                } else {
                    // Between its two ends a row lies within the shell.
                    [low[0], high[0]].into_iter().filter(|&x| on(0, x)).for_each(&mut row);
                }
            }
        }
    }

    /// How far a node outside the cells up to `ring` is away at least.
    fn reach(&self, to: &[f64; N], centre: [usize; AXES], ring: usize) -> f64 {
        let mut least = f64::INFINITY;
        for i in 0..AXES.min(N) {
            if centre[i] > ring {
                least = least.min(to[i] - (self.min[i] + (centre[i] - ring) as f64 * self.side));
            }
            if centre[i] + ring + 1 < self.cells[i] {
                least = least.min(self.min[i] + (centre[i] + ring + 1) as f64 * self.side - to[i]);
            }
        }
        // Rounding may put a node that lies on a cell's border on either side.
        if least.is_finite() { (least - 1e-9 * self.side).max(0.0) } else { f64::INFINITY }
    }

    /// The nodes within a radius, in the order of their numbers.
    pub(super) fn within(&self, points: &[[f64; N]], to: &[f64; N], radius: f64, out: &mut Vec<u32>) {
        out.clear();
        let squared_radius = radius * radius;
        let (mut low, mut high) = (*to, *to);
        (0..N).for_each(|i| (low[i], high[i]) = (to[i] - radius, to[i] + radius));
        let ([x0, y0, z0], [x1, y1, z1]) = (self.cell(&low), self.cell(&high));
        for z in z0..=z1 {
            for y in y0..=y1 {
                for x in x0..=x1 {
                    let mut node = self.first[self.number(x, y, z)];
                    while node != NONE {
                        if squared(&points[node as usize], to) <= squared_radius {
                            out.push(node);
                        }
                        node = self.before[node as usize];
                    }
                }
            }
        }
        math::sort_indices(out);
    }
}

/// Takes a node if it is nearer than what was found; of equals the first.
#[inline]
fn offer<const N: usize>(found: &mut (usize, f64), points: &[[f64; N]], to: &[f64; N], node: usize) {
    let distance = squared(&points[node], to);
    if distance < found.1 || (distance == found.1 && node < found.0) {
        *found = (node, distance);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kernel::rng::Stream;

    fn check<const N: usize>(flat: Option<usize>) {
        let mut rng = Stream::new(N as u64, 0);
        let (min, mut max) = ([-1.0; N], [2.0; N]);
        max[N - 1] = 5.0;
        let mut index = Nearest::new();
        let mut points: Vec<[f64; N]> = Vec::new();
        let mut near = Vec::new();
        for n in 0..1500 {
            // Clustered, as trees are, and now and then the same point twice.
            let mut draw = |spread: f64| {
                std::array::from_fn(|i| if flat == Some(i) { min[i] } else { min[i] + spread * rng.unit() * (max[i] - min[i]) })
            };
            let point = if n % 7 == 6 { points[n / 2] } else { draw(if n % 2 == 0 { 0.2 } else { 1.0 }) };
            let query = draw(1.0);
            points.push(point);
            index.add(&points);
            let by_scan = (0..points.len())
                .map(|i| (i, squared(&points[i], &query)))
                .fold((0, f64::INFINITY), |best, one| if one.1 < best.1 { one } else { best });
            assert_eq!(index.nearest(&points, &query), by_scan);
            index.within(&points, &query, 0.3, &mut near);
            let all: Vec<_> = (0..points.len() as u32).filter(|&i| squared(&points[i as usize], &query) <= 0.09).collect();
            assert_eq!(near, all);
        }
    }

    #[test]
    fn the_nearest_is_that_of_a_scan_in_every_number_of_dimensions() {
        check::<2>(None);
        check::<3>(None);
        check::<3>(Some(2));
        check::<3>(Some(0));
        check::<6>(None);
    }

    /// A needle, a sheet and a cluster in a wide space: no cell has to hold them all, and there are not many more cells than nodes.
    #[test]
    fn cells_fit_what_the_nodes_fill() {
        for scale in [[1.0, 1e-9, 1e-9], [1.0, 1.0, 1e-9], [1e-3, 1e-3, 1e-3], [1e3, 1.0, 1e-6], [1.0, 1.0, 1.0]] {
            let (mut rng, mut points, mut index) = (Stream::new(7, 0), Vec::new(), Nearest::new());
            for _ in 0..5000 {
                points.push(scale.map(|side| side * rng.unit()));
                index.add(&points);
            }
            let mut held = vec![0; index.first.len()];
            for point in &points {
                let [x, y, z] = index.cell(point);
                held[index.number(x, y, z)] += 1;
            }
            assert!(held.iter().all(|&nodes| nodes < 40) && held.len() < 64 * points.len(), "{scale:?} {:?}", index.cells);
        }
    }
}
