//! A turned rectangle, such as a robot's outline, and its distance from a block.

use super::Block;

/// A rectangle about a centre, turned by an angle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Oriented {
    /// Its centre.
    pub center: [f64; 2],
    /// Cosine and sine of the angle from the x axis to its length.
    pub direction: [f64; 2],
    /// Half of its length and half of its width.
    pub half: [f64; 2],
}

impl Oriented {
    /// The four corners: front left, rear left, rear right, front right (left: from the length towards +90°).
    pub fn corners(&self) -> [[f64; 2]; 4] {
        let ([x, y], [c, s], [a, b]) = (self.center, self.direction, self.half);
        [[a, b], [-a, b], [-a, -b], [a, -b]].map(|[u, v]| [x + c * u - s * v, y + s * u + c * v])
    }

    /// The radius of its circumscribed circle.
    pub fn radius(&self) -> f64 {
        let [a, b] = self.half;
        (a * a + b * b).sqrt()
    }

    /// A point in its own frame: along and across.
    fn local(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let ([dx, dy], [c, s]) = ([x - self.center[0], y - self.center[1]], self.direction);
        [c * dx + s * dy, c * dy - s * dx]
    }

    /// The distance from a block, exact up to rounding: 0 if they touch; if they overlap, minus the smallest distance by which
    /// one would have to be moved to separate them.
    ///
    /// Moving or turning the rectangle so that none of its points goes farther than δ changes it by at most δ: it is
    /// the greatest gap between the two that a line of any direction could pass through, and no such gap changes more.
    pub fn distance(&self, block: &Block) -> f64 {
        let (mine, its) = (self.corners(), block.corners());
        let own = Block { min: self.half.map(|h| -h), max: self.half };
        let locals = its.map(|corner| self.local(corner));
        let gap = gap_between(&mine, block).max(gap_between(&locals, &own));
        if gap < 0.0 {
            // Two overlapping polygons part soonest along the normal of a side of one of them.
            return gap;
        }
        // Apart, a corner of one is a closest point.
        let from_mine = mine.into_iter().map(|corner| block.distance_squared_to(corner));
        let from_its = locals.into_iter().map(|corner| own.distance_squared_to(corner));
        from_mine.chain(from_its).fold(f64::INFINITY, f64::min).sqrt()
    }
}

/// The widest gap between points and an axis-parallel rectangle along the rectangle's sides; negative: they overlap.
fn gap_between(points: &[[f64; 2]; 4], block: &Block) -> f64 {
    let along = |axis: usize| {
        let low = points.iter().fold(f64::INFINITY, |least, p| least.min(p[axis]));
        let high = points.iter().fold(f64::NEG_INFINITY, |most, p| most.max(p[axis]));
        (block.min[axis] - high).max(low - block.max[axis])
    };
    along(0).max(along(1))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{geometry::distance_squared, kernel::rng::Stream, math};

    const BLOCK: Block = Block { min: [2.0, 1.0], max: [5.0, 3.0] };

    fn turned(center: [f64; 2], angle: f64, half: [f64; 2]) -> Oriented {
        Oriented { center, direction: [math::cos(angle), math::sin(angle)], half }
    }

    #[test]
    fn distance_is_from_sides_and_corners_and_negative_where_they_overlap() {
        let straight = |x, y| turned([x, y], 0.0, [0.5, 0.25]).distance(&BLOCK);
        assert_eq!(straight(0.0, 2.0), 1.5, "beside it");
        assert_eq!(straight(3.0, 0.0), 0.75, "below");
        assert_eq!(straight(8.5, 7.25), 5.0, "off the corner (5, 3): 3 and 4");
        assert_eq!(straight(1.5, 2.0), 0.0, "touching");
        assert_eq!(straight(1.75, 2.0), -0.25, "a quarter in");
        assert_eq!(straight(3.5, 2.0), -1.25, "in the middle: out by the nearer side");
        // Turned by 45 degrees, a square of side 2 reaches √2 beyond its centre.
        let square = |x, y| turned([x, y], std::f64::consts::FRAC_PI_4, [1.0, 1.0]).distance(&BLOCK);
        let root = std::f64::consts::SQRT_2;
        assert!((square(0.0, 2.0) - (2.0 - root)).abs() < 1e-15);
        assert!((square(1.0, 0.0) - (root - 1.0)).abs() < 1e-15, "a corner of the block before a side of the square");
        assert!((square(2.0 - 0.5, 1.0 - 0.5) + (1.0 - root / 2.0)).abs() < 1e-15, "parted along the square’s own normal");
    }

    /// Against the distances between all pairs of sides, and points sampled inside.
    #[test]
    fn distance_agrees_with_a_plain_computation() {
        let mut rng = Stream::new(3, 0);
        let (mut apart, mut over) = (0, 0);
        for _ in 0..4000 {
            let half = [rng.between(0.05, 1.5), rng.between(0.05, 1.0)];
            let shape = turned([rng.between(0.0, 7.0), rng.between(-1.0, 5.0)], rng.between(-4.0, 4.0), half);
            let (mine, its) = (shape.corners(), BLOCK.corners());
            let sides = |corners: [[f64; 2]; 4]| [0, 1, 2, 3].map(|i| [corners[i], corners[(i + 1) % 4]]);
            let between = sides(mine).into_iter().map(|[a, b]| BLOCK.distance_squared(a, b)).fold(f64::INFINITY, f64::min).sqrt();
            let covers = its.iter().any(|&corner| {
                let [u, v] = shape.local(corner);
                u.abs() < half[0] && v.abs() < half[1]
            });
            let distance = shape.distance(&BLOCK);
            if between > 0.0 && !covers {
                apart += 1;
                assert!((distance - between).abs() < 1e-12, "{distance} {between}");
                let corners = its.iter().flat_map(|&c| sides(mine).map(|[a, b]| distance_squared(a, b, c))).fold(f64::INFINITY, f64::min);
                assert!(distance <= corners.sqrt() + 1e-12);
            } else {
                over += 1;
                assert!(distance <= 1e-12, "{distance}");
                // Moved out by its depth along the best of many directions, it is apart; by less, along none.
                let moved = |by: f64| {
                    (0..720).any(|i| {
                        let angle = f64::from(i) * std::f64::consts::PI / 360.0;
                        let center = [shape.center[0] + by * math::cos(angle), shape.center[1] + by * math::sin(angle)];
                        Oriented { center, ..shape }.distance(&BLOCK) >= 0.0
                    })
                };
                assert!(moved(-distance * 1.01 + 1e-9) && !moved(-distance * 0.99 - 1e-9), "{distance}");
            }
        }
        assert!(apart > 500 && over > 500);
    }
}
