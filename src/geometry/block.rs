//! A rectangular obstacle grown by a radius on all sides: the exact Minkowski sum of a box and a disc, corners rounded.

use crate::math::clamp;

use super::{Disc, distance_squared};

/// An axis-parallel rectangle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Block {
    /// Lower left corner.
    pub min: [f64; 2],
    /// Upper right corner.
    pub max: [f64; 2],
}

impl Block {
    /// The four corners, counter-clockwise from `min`.
    pub fn corners(&self) -> [[f64; 2]; 4] {
        let ([x0, y0], [x1, y1]) = (self.min, self.max);
        [[x0, y0], [x1, y0], [x1, y1], [x0, y1]]
    }

    /// The same, larger by `by` on all sides (smaller for a negative `by`).
    #[must_use]
    pub fn grown(&self, by: f64) -> Self {
        Self { min: self.min.map(|c| c - by), max: self.max.map(|c| c + by) }
    }

    /// The squared distance of a point; 0 inside.
    #[inline]
    pub fn distance_squared_to(&self, [x, y]: [f64; 2]) -> f64 {
        let dx = (self.min[0] - x).max(x - self.max[0]).max(0.0);
        let dy = (self.min[1] - y).max(y - self.max[1]).max(0.0);
        dx * dx + dy * dy
    }

    /// The squared distance of the segment `a`–`b`, exact up to rounding; 0 where they meet.
    #[inline]
    pub fn distance_squared(&self, a: [f64; 2], b: [f64; 2]) -> f64 {
        if self.clip(a, b).is_some() {
            return 0.0;
        }
        // Apart, the closest points are an end of the one and a side or corner of the other.
        let ends = self.distance_squared_to(a).min(self.distance_squared_to(b));
        self.corners().into_iter().fold(ends, |least, corner| least.min(distance_squared(a, b, corner)))
    }

    /// The part of the segment `a`–`b` in the closed rectangle, as parameters 0 ≤ from ≤ to ≤ 1; `None` if there is none.
    #[inline]
    pub fn clip(&self, a: [f64; 2], b: [f64; 2]) -> Option<[f64; 2]> {
        let (mut from, mut to) = (0.0_f64, 1.0_f64);
        for axis in 0..2 {
            let step = b[axis] - a[axis];
            let (low, high) = (self.min[axis] - a[axis], self.max[axis] - a[axis]);
            if step == 0.0 {
                if low > 0.0 || high < 0.0 {
                    return None;
                }
            } else {
                let (t0, t1) = (low / step, high / step);
                from = from.max(t0.min(t1));
                to = to.min(t0.max(t1));
            }
        }
        (from <= to).then_some([from, to])
    }

    /// The part of the segment within `radius` of the rectangle, as [`Block::clip`]. It is one piece, because the sum of a box
    /// and a disc is convex: two boxes and four discs.
    pub fn clip_grown(&self, radius: f64, a: [f64; 2], b: [f64; 2]) -> Option<[f64; 2]> {
        let ([x0, y0], [x1, y1]) = (self.min, self.max);
        let wide = Self { min: [x0 - radius, y0], max: [x1 + radius, y1] };
        let tall = Self { min: [x0, y0 - radius], max: [x1, y1 + radius] };
        let discs = self.corners().map(|center| Disc { center, radius }.clip(a, b));
        [wide.clip(a, b), tall.clip(a, b)]
            .into_iter()
            .chain(discs)
            .flatten()
            .reduce(|whole, part| [whole[0].min(part[0]), whole[1].max(part[1])])
    }

    /// The depth of the segment in the rectangle: the greatest distance of one of its points from the nearest side.
    pub fn depth(&self, a: [f64; 2], b: [f64; 2]) -> f64 {
        let Some([from, to]) = self.clip(a, b) else {
            return 0.0;
        };
        // The distances from the four sides are linear along the segment; the least of them peaks at an end or where two meet.
        let sides: [[f64; 2]; 4] = std::array::from_fn(|i| {
            let axis = i % 2;
            let step = b[axis] - a[axis];
            if i < 2 { [a[axis] - self.min[axis], step] } else { [self.max[axis] - a[axis], -step] }
        });
        let least = |t: f64| sides.iter().map(|[at, slope]| at + t * slope).fold(f64::INFINITY, f64::min);
        let meetings = (0..4).flat_map(|i| (0..i).map(move |j| (i, j))).map(|(i, j)| {
            let slope = sides[i][1] - sides[j][1];
            if slope == 0.0 { from } else { clamp((sides[j][0] - sides[i][0]) / slope, from, to) }
        });
        meetings.chain([from, to]).map(least).fold(0.0, f64::max)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const BLOCK: Block = Block { min: [2.0, 1.0], max: [5.0, 3.0] };

    #[test]
    fn distance_is_from_sides_corners_and_ends() {
        assert_eq!(BLOCK.distance_squared([0.0, 0.0], [6.0, 0.0]), 1.0, "below");
        assert_eq!(BLOCK.distance_squared([0.0, 2.0], [1.5, 2.0]), 0.25, "an end beside it");
        assert_eq!(BLOCK.distance_squared([8.0, 7.0], [9.0, 9.0]), 25.0, "an end off the corner (5, 3)");
        assert_eq!(BLOCK.distance_squared([5.0, 5.0], [7.0, 3.0]), 2.0, "a corner beside the middle of a segment");
        assert_eq!(BLOCK.distance_squared([0.0, 0.0], [4.0, 4.0]), 0.0, "through it");
        assert_eq!(BLOCK.distance_squared([3.0, 2.0], [4.0, 2.0]), 0.0, "in it");
        assert_eq!(BLOCK.distance_squared([0.0, 3.0], [9.0, 3.0]), 0.0, "along a side");
    }

    #[test]
    fn the_grown_block_is_rounded_at_its_corners() {
        // Along y = 3 + 0.8 with radius 1: the corner discs reach 0.6 beyond the sides.
        let [from, to] = BLOCK.clip_grown(1.0, [0.0, 3.8], [10.0, 3.8]).unwrap();
        assert!((from - 0.14).abs() < 1e-15 && (to - 0.56).abs() < 1e-15, "{from} {to}");
        assert_eq!(BLOCK.clip_grown(1.0, [0.0, 2.0], [10.0, 2.0]), Some([0.1, 0.6]), "through the sides");
        assert_eq!(BLOCK.clip_grown(1.0, [5.8, 3.8], [6.0, 4.0]), None, "past a corner that a square would have");
        assert_eq!(BLOCK.clip_grown(1.0, [3.0, 2.0], [4.0, 2.0]), Some([0.0, 1.0]), "inside");
    }

    #[test]
    fn depth_is_the_distance_from_the_nearest_side() {
        assert_eq!(BLOCK.depth([0.0, 2.0], [9.0, 2.0]), 1.0);
        assert_eq!(BLOCK.depth([0.0, 1.25], [9.0, 1.25]), 0.25);
        assert_eq!(BLOCK.depth([2.5, 0.0], [2.5, 9.0]), 0.5);
        assert_eq!(BLOCK.depth([0.0, 3.0], [9.0, 3.0]), 0.0);
        assert_eq!(BLOCK.depth([0.0, 8.0], [9.0, 8.0]), 0.0);
        assert_eq!(BLOCK.depth([1.0, 0.0], [4.0, 3.0]), 1.0, "along the diagonal through (3, 2)");
    }
}
