//! Paths among discs as way-points, [WCPSO] §3.2.2: a position is (x₁ … x_n, y₁ … y_n).

use std::sync::Arc;

use crate::{
    geometry::{Disc, distance_squared},
    math,
    params::Settings,
    planner::Solution,
    scene::DiscsScene,
};

use super::objective::{Evaluation, Objective, SearchBox, subscripted};

/// Where (15) looks for a path in a disc.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Penalty {
    /// At the way-points, as printed. A segment may cut through a disc unpunished.
    Waypoints,
    /// At each segment's point closest to the disc's centre (our reading).
    Segments,
}

/// The objective of [WCPSO] (14) and (15).
#[derive(Debug, Clone)]
pub struct Waypoints {
    start: [f64; 2],
    goal: [f64; 2],
    discs: Arc<[Disc]>,
    search_box: SearchBox,
    count: usize,
    penalty: Penalty,
    weight: f64,
    ordered: bool,
}

impl Waypoints {
    /// The scene's objective with the settings `waypoints`, `penalty`, `penalty_weight` and `ordered`.
    pub fn new(scene: &DiscsScene, settings: &Settings) -> Self {
        let count = settings.integer("waypoints") as usize;
        let side = |corner: [f64; 2]| (0..2 * count).map(|j| corner[usize::from(j >= count)]).collect();
        Self {
            start: scene.start,
            goal: scene.goal,
            discs: scene.discs.as_slice().into(),
            search_box: SearchBox { low: side(scene.bounds.min), high: side(scene.bounds.max) },
            count,
            penalty: if settings.choice("penalty") == "waypoints" { Penalty::Waypoints } else { Penalty::Segments },
            weight: settings.number("penalty_weight"),
            ordered: settings.flag("ordered"),
        }
    }

    /// Σ_k V(k) over the discs for the path's piece from `a` to the way-point or goal `b`, (15).
    #[inline]
    fn violation(&self, a: [f64; 2], b: [f64; 2], to_goal: bool) -> f64 {
        let from = match self.penalty {
            Penalty::Segments => a,
            Penalty::Waypoints if to_goal => return 0.0,
            Penalty::Waypoints => b,
        };
        let mut sum = 0.0;
        for disc in &*self.discs {
            let squared = distance_squared(from, b, disc.center);
            if squared < disc.radius * disc.radius {
                sum += 1.0 - squared.sqrt() / disc.radius;
            }
        }
        sum
    }
}

impl Objective for Waypoints {
    fn search_box(&self) -> &SearchBox {
        &self.search_box
    }

    /// L = Σ ‖segment‖ + w Σ_k V(k), [WCPSO] (14).
    #[inline]
    fn evaluate(&self, x: &[f64]) -> Evaluation {
        let (mut length, mut violation, mut from) = (0.0, 0.0, self.start);
        let (xs, ys) = x.split_at(self.count);
        for i in 0..=self.count {
            let to = if i < self.count { [xs[i], ys[i]] } else { self.goal };
            let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
            length += (dx * dx + dy * dy).sqrt();
            violation += self.violation(from, to, i == self.count);
            from = to;
        }
        let penalty = self.weight * violation;
        Evaluation { cost: length + penalty, penalty }
    }

    /// With `ordered`, sorts the way-points along the direction from start to goal. The set of points stays the
    /// uniform draw that it was; only their numbering changes, so that no path begins as a zigzag.
    fn arrange(&self, x: &mut [f64]) {
        if !self.ordered {
            return;
        }
        let [dx, dy] = [self.goal[0] - self.start[0], self.goal[1] - self.start[1]];
        let points: Vec<_> = self.points(x).collect();
        let mut along: Vec<_> = points.iter().enumerate().map(|(i, [px, py])| (px * dx + py * dy, i)).collect();
        math::sort(&mut along);
        for (i, (_, from)) in along.into_iter().enumerate() {
            [x[i], x[self.count + i]] = points[from];
        }
    }

    fn constrained(&self) -> bool {
        true
    }

    fn points(&self, x: &[f64]) -> impl Iterator<Item = [f64; 2]> {
        (0..self.count).map(move |i| [x[i], x[self.count + i]])
    }

    fn point_count(&self) -> usize {
        self.count
    }

    fn ends(&self) -> Option<([f64; 2], [f64; 2])> {
        Some((self.start, self.goal))
    }

    fn solution(&self, x: &[f64]) -> Solution {
        Solution::Path(std::iter::once(self.start).chain(self.points(x)).chain([self.goal]).collect())
    }

    fn coordinate(&self, j: usize) -> String {
        subscripted(if j < self.count { 'x' } else { 'y' }, j % self.count + 1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Bounds;

    fn objective(penalty: Penalty) -> Waypoints {
        let scene = DiscsScene {
            bounds: Bounds { min: [0.0, -5.0], max: [8.0, 5.0] },
            start: [0.0, 0.0],
            goal: [8.0, 0.0],
            discs: vec![Disc { center: [2.0, 1.0], radius: 2.0 }, Disc { center: [6.0, -3.0], radius: 1.0 }],
        };
        Waypoints {
            start: scene.start,
            goal: scene.goal,
            discs: scene.discs.into(),
            search_box: SearchBox { low: [0.0, -5.0].into(), high: [8.0, 5.0].into() },
            count: 1,
            penalty,
            weight: 100.0,
            ordered: true,
        }
    }

    #[test]
    fn an_ordered_start_renumbers_the_way_points_and_changes_none() {
        let mut objective = objective(Penalty::Segments);
        objective.count = 3;
        let mut x = [7.0, 1.0, 4.0, -1.0, 2.0, 3.0];
        objective.arrange(&mut x);
        assert_eq!(x, [1.0, 4.0, 7.0, 2.0, 3.0, -1.0]);
        objective.ordered = false;
        objective.arrange(&mut x[..]);
        assert_eq!(x, [1.0, 4.0, 7.0, 2.0, 3.0, -1.0]);
    }

    #[test]
    fn waypoints_penalty_is_the_printed_one() {
        // The way-point (4, 0) is √5 from (2, 1): outside. Length 4 + 4; the segment through the disc is not seen.
        assert_eq!(objective(Penalty::Waypoints).evaluate(&[4.0, 0.0]), Evaluation { cost: 8.0, penalty: 0.0 });
        // (2, 0) lies 1 from the centre: V = 1 − 1/2.
        assert_eq!(objective(Penalty::Waypoints).evaluate(&[2.0, 0.0]), Evaluation { cost: 58.0, penalty: 50.0 });
        // In the other disc's centre: V = 1. Length 2 · 3 √5 … here √45 + √13.
        let deep = objective(Penalty::Waypoints).evaluate(&[6.0, -3.0]);
        assert!((deep.cost - (45f64.sqrt() + 13f64.sqrt() + 100.0)).abs() < 1e-12);
    }

    #[test]
    fn segments_penalty_sees_what_lies_between_the_waypoints() {
        // The first segment's closest point to (2, 1) is (2, 0): V = 1/2. The second segment is clear.
        assert_eq!(objective(Penalty::Segments).evaluate(&[4.0, 0.0]), Evaluation { cost: 58.0, penalty: 50.0 });
        // Both segments meet at (2, 0), so both are charged.
        assert_eq!(objective(Penalty::Segments).evaluate(&[2.0, 0.0]), Evaluation { cost: 108.0, penalty: 100.0 });
        let round = objective(Penalty::Segments).evaluate(&[2.0, -4.0]);
        assert_eq!(round.penalty, 0.0, "below the first disc and over the second");
    }
}
