//! Paths as way-points, [WCPSO](crate#papers) §3.2.2: a position is (x₁ … x_n, y₁ … y_n).

use crate::{
    geometry,
    kernel::{Frame, Readings, Solution, rng::Stream},
    math,
    params::Parameters,
};

use super::{
    objective::{Evaluation, Objective, Scratch, SearchBox, subscripted},
    paths::{ORDERED, WAYPOINTS},
    terrain::Terrain,
};

/// Paths through way-points anywhere in the bounds.
#[derive(Clone)]
pub struct Waypoints {
    terrain: Terrain,
    search_box: SearchBox,
    count: usize,
    ordered: bool,
}

impl Waypoints {
    /// Paths over this terrain with the settings `waypoints` and `ordered`.
    pub(super) fn new(terrain: Terrain, settings: &Parameters) -> Self {
        Self::with(terrain, settings[WAYPOINTS] as usize, settings[ORDERED])
    }

    fn with(terrain: Terrain, count: usize, ordered: bool) -> Self {
        let (min, max) = (terrain.bounds.min, terrain.bounds.max);
        let search_box = SearchBox::of((0..2 * count).map(|j| usize::from(j >= count)).map(|axis| [min[axis], max[axis]]));
        Self { terrain, search_box, count, ordered }
    }

    #[inline]
    fn endpoints<'a>(&'a self, x: &'a [f64]) -> impl Iterator<Item = [f64; 2]> + 'a {
        let (xs, ys) = x.split_at(self.count);
        xs.iter().zip(ys).map(|(&x, &y)| [x, y])
    }

    /// With `ordered`, sorts the way-points along the direction from start to goal. The set of points stays the
    /// uniform draw that it was; only their numbering changes, so that no path begins as a zigzag.
    fn arrange(&self, x: &mut [f64]) {
        if !self.ordered {
            return;
        }
        let Terrain { start, goal, .. } = &self.terrain;
        let [dx, dy] = [goal[0] - start[0], goal[1] - start[1]];
        let points: Vec<_> = self.endpoints(x).collect();
        let mut along: Vec<_> = points.iter().enumerate().map(|(i, [px, py])| (px * dx + py * dy, i)).collect();
        math::sort(&mut along);
        for (i, (_, from)) in along.into_iter().enumerate() {
            [x[i], x[self.count + i]] = points[from];
        }
    }
}

/// So many points between a path's ends: its corners, and the middle of the longest piece until there are enough. Where it
/// has too many corners, points at equal distances along it.
fn resampled(path: &[[f64; 2]], count: usize) -> Vec<[f64; 2]> {
    let apart = |w: &[[f64; 2]]| geometry::length(w);
    let between = |a: [f64; 2], b: [f64; 2], t: f64| [0, 1].map(|axis| a[axis] + t * (b[axis] - a[axis]));
    let mut points = path.to_vec();
    while points.len() < count + 2 {
        // The first of equals.
        let pieces = points.windows(2).map(apart).enumerate();
        let Some((longest, _)) = pieces.reduce(|most, piece| if piece.1 > most.1 { piece } else { most }) else { break };
        points.insert(longest + 1, between(points[longest], points[longest + 1], 0.5));
    }
    if points.len() == count + 2 {
        return points[1..=count].to_vec();
    }
    let spacing = points.windows(2).map(apart).sum::<f64>() / (count + 1) as f64;
    let mut out = Vec::with_capacity(count);
    let mut along = 0.0;
    for w in points.windows(2) {
        let length = apart(w);
        while out.len() < count && along + length >= spacing * (out.len() + 1) as f64 {
            let t = if length > 0.0 { (spacing * (out.len() + 1) as f64 - along) / length } else { 0.0 };
            out.push(between(w[0], w[1], t));
        }
        along += length;
    }
    // What rounding left.
    out.resize(count, points[points.len() - 1]);
    out
}

impl Objective for Waypoints {
    fn search_box(&self) -> &SearchBox {
        &self.search_box
    }

    fn evaluate(&self, x: &[f64], scratch: &mut Scratch) -> Evaluation {
        self.terrain.evaluate(self.endpoints(x), scratch)
    }

    fn draw(&self, x: &mut [f64], rng: &mut Stream) {
        self.search_box.draw(x, rng);
        self.arrange(x);
    }

    fn encode(&self, path: &[[f64; 2]], x: &mut [f64]) -> bool {
        for (i, point) in resampled(path, self.count).into_iter().enumerate() {
            [x[i], x[self.count + i]] = [0, 1].map(|axis| self.search_box.clamp(i + axis * self.count, point[axis]));
        }
        true
    }

    fn redraws(&self) -> u64 {
        self.terrain.redraws
    }

    fn constrained(&self) -> bool {
        true
    }

    fn point_count(&self) -> usize {
        self.count
    }

    fn point(&self, x: &[f64], i: usize) -> [f64; 2] {
        [x[i], x[self.count + i]]
    }

    fn ends(&self) -> Option<([f64; 2], [f64; 2])> {
        Some((self.terrain.start, self.terrain.goal))
    }

    fn solution(&self, x: &[f64]) -> Solution {
        self.terrain.solution(self.endpoints(x))
    }

    fn coordinate(&self, j: usize) -> String {
        subscripted(if j < self.count { 'x' } else { 'y' }, j % self.count + 1)
    }

    fn read(&self, x: &[f64], out: &mut Readings) {
        self.terrain.read(self.endpoints(x), out);
    }

    fn draw_result(&self, x: &[f64], frame: &mut Frame) {
        self.terrain.draw_result(self.endpoints(x), frame);
    }
}

#[cfg(test)]
mod tests {
    use super::{
        super::{paths::Penalty, terrain::Obstacles},
        *,
    };
    use crate::geometry::{Bounds, Disc};

    fn objective(penalty: Penalty) -> Waypoints {
        let discs = [Disc { center: [2.0, 1.0], radius: 2.0 }, Disc { center: [6.0, -3.0], radius: 1.0 }];
        let terrain = Terrain {
            start: [0.0, 0.0],
            goal: [8.0, 0.0],
            bounds: Bounds { min: [0.0, -5.0], max: [8.0, 5.0] },
            obstacles: Obstacles::Discs(discs.into(), penalty),
            f: [1.0, 0.0],
            weight: 100.0,
            redraws: 0,
            smoothing: None,
        };
        Waypoints::with(terrain, 1, true)
    }

    #[test]
    fn coordinates_are_all_x_and_then_all_y() {
        let two = Waypoints::with(objective(Penalty::Segments).terrain, 2, true);
        assert_eq!([0, 1, 2, 3].map(|j| two.coordinate(j)), ["x₁", "x₂", "y₁", "y₂"]);
    }

    fn evaluate(objective: &Waypoints, x: &[f64]) -> Evaluation {
        objective.evaluate(x, &mut Scratch::default())
    }

    #[test]
    fn an_ordered_start_renumbers_the_way_points_and_changes_none() {
        let mut objective = Waypoints::with(objective(Penalty::Segments).terrain, 3, true);
        let mut x = [7.0, 1.0, 4.0, -1.0, 2.0, 3.0];
        objective.arrange(&mut x);
        assert_eq!(x, [1.0, 4.0, 7.0, 2.0, 3.0, -1.0]);
        objective.ordered = false;
        objective.arrange(&mut x[..]);
        assert_eq!(x, [1.0, 4.0, 7.0, 2.0, 3.0, -1.0]);
    }

    #[test]
    fn a_path_s_corners_become_waypoints_and_halves_of_its_longest_pieces() {
        // Pieces 2 and 6: the middle of the longer one, then of the first of two halves of 3.
        let path = [[0.0, 0.0], [2.0, 0.0], [2.0, 6.0]];
        assert_eq!(resampled(&path, 1), [[2.0, 0.0]]);
        assert_eq!(resampled(&path, 2), [[2.0, 0.0], [2.0, 3.0]]);
        assert_eq!(resampled(&path, 3), [[2.0, 0.0], [2.0, 1.5], [2.0, 3.0]]);
        // Three corners for two waypoints: at a third and two thirds of the length of 9.
        let path = [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [4.0, 2.0], [4.0, 5.0]];
        assert_eq!(resampled(&path, 2), [[2.0, 1.0], [4.0, 2.0]]);
        let mut x = [0.0; 4];
        let objective = Waypoints::with(objective(Penalty::Segments).terrain, 2, true);
        assert!(objective.encode(&[[0.0, 0.0], [2.0, -4.0], [8.0, 0.0]], &mut x));
        assert_eq!(x, [2.0, 5.0, -4.0, -2.0]);
    }

    #[test]
    fn waypoints_penalty_is_the_printed_one() {
        // The way-point (4, 0) is √5 from (2, 1): outside. Length 4 + 4; the segment through the disc is not seen.
        assert_eq!(evaluate(&objective(Penalty::Waypoints), &[4.0, 0.0]), Evaluation { cost: 8.0, violation: 0.0 });
        // (2, 0) lies 1 from the centre: V = 1 − 1/2.
        assert_eq!(evaluate(&objective(Penalty::Waypoints), &[2.0, 0.0]), Evaluation { cost: 58.0, violation: 0.5 });
        // In the other disc's centre: V = 1. Length 2 · 3 √5 … here √45 + √13.
        let deep = evaluate(&objective(Penalty::Waypoints), &[6.0, -3.0]);
        assert!((deep.cost - (45f64.sqrt() + 13f64.sqrt() + 100.0)).abs() < 1e-12);
    }

    #[test]
    fn segments_penalty_sees_what_lies_between_the_waypoints() {
        // The first segment's closest point to (2, 1) is (2, 0): V = 1/2. The second segment is clear.
        assert_eq!(evaluate(&objective(Penalty::Segments), &[4.0, 0.0]), Evaluation { cost: 58.0, violation: 0.5 });
        // Both segments meet at (2, 0), so both are charged.
        assert_eq!(evaluate(&objective(Penalty::Segments), &[2.0, 0.0]), Evaluation { cost: 108.0, violation: 1.0 });
        let round = evaluate(&objective(Penalty::Segments), &[2.0, -4.0]);
        assert_eq!(round.violation, 0.0, "below the first disc and over the second");
    }
}
