//! Boxes in space, and their intersections with segments, [ARM-RRT](crate#papers) §3.1.

use crate::math::clamp;

/// An axis-parallel box, closed: what touches a face meets it.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Cuboid {
    /// The smallest coordinates.
    pub min: [f64; 3],
    /// The largest coordinates.
    pub max: [f64; 3],
}

impl Cuboid {
    /// Whether a point lies in it or on a face.
    #[inline]
    pub fn contains(&self, point: [f64; 3]) -> bool {
        (0..3).all(|axis| self.min[axis] <= point[axis] && point[axis] <= self.max[axis])
    }

    /// The part of the segment `a`–`b` in it, as parameters 0 ≤ from ≤ to ≤ 1; `None` if there is none. The plane intersections
    /// are [ARM-RRT](crate#papers) (7)–(10), two parallel faces at a time.
    #[inline]
    pub fn clip(&self, a: [f64; 3], b: [f64; 3]) -> Option<[f64; 2]> {
        let (mut from, mut to) = (0.0_f64, 1.0_f64);
        for axis in 0..3 {
            let step = b[axis] - a[axis];
            if step == 0.0 {
                if a[axis] < self.min[axis] || a[axis] > self.max[axis] {
                    return None;
                }
                continue;
            }
            let (t0, t1) = ((self.min[axis] - a[axis]) / step, (self.max[axis] - a[axis]) / step);
            let (enters, leaves) = if t0 < t1 { (t0, t1) } else { (t1, t0) };
            from = if enters > from { enters } else { from };
            to = if leaves < to { leaves } else { to };
            if from > to {
                return None;
            }
        }
        Some([from, to])
    }

    /// Whether the segment `a`–`b` meets a face or lies inside.
    #[inline]
    pub fn meets(&self, a: [f64; 3], b: [f64; 3]) -> bool {
        self.clip(a, b).is_some()
    }

    /// The squared distance between the segment `a`–`b` and the cuboid, exact up to rounding; 0 exactly where they meet.
    ///
    /// On the way from `a` to `b` the squared distance to the cuboid is convex, and a parabola between any two
    /// of the at most six places where the segment passes the plane of a face. So the interval that holds the least is narrowed
    /// down by the sign of the slope at those places, and in what is left the slope is a straight line.
    #[inline]
    pub fn distance_squared(&self, a: [f64; 3], b: [f64; 3]) -> f64 {
        if self.meets(a, b) {
            return 0.0;
        }
        let along = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
        let excess = |t: f64| {
            std::array::from_fn::<f64, 3, _>(|axis| {
                let x = a[axis] + t * along[axis];
                x - clamp(x, self.min[axis], self.max[axis])
            })
        };
        let dot = |u: [f64; 3], v: [f64; 3]| u[0] * v[0] + u[1] * v[1] + u[2] * v[2];
        let slope = |t: f64| dot(excess(t), along);
        let ([mut from, mut to], [mut falls, mut rises]) = ([0.0, 1.0], [slope(0.0), slope(1.0)]);
        let least = if falls >= 0.0 {
            0.0
        } else if rises <= 0.0 {
            1.0
        } else {
            for axis in 0..3 {
                for plane in [self.min[axis], self.max[axis]] {
                    let t = (plane - a[axis]) / along[axis];
                    if from < t && t < to {
                        let s = slope(t);
                        if s < 0.0 { (from, falls) = (t, s) } else { (to, rises) = (t, s) }
                    }
                }
            }
            from + (to - from) * (falls / (falls - rises))
        };
        let e = excess(least);
        dot(e, e)
    }

    /// A lower bound of [`Cuboid::distance_squared`] in a fraction of the time, from the segment's bounding box.
    #[inline]
    pub fn gap_squared(&self, a: [f64; 3], b: [f64; 3]) -> f64 {
        let gap = |axis: usize| {
            let (low, high) = if a[axis] < b[axis] { (a[axis], b[axis]) } else { (b[axis], a[axis]) };
            let apart = if low > self.max[axis] { low - self.max[axis] } else { self.min[axis] - high };
            if apart > 0.0 { apart } else { 0.0 }
        };
        let [x, y, z] = [gap(0), gap(1), gap(2)];
        x * x + y * y + z * z
    }

    /// Whether the segment `a`–`b` comes as near as `radius`, or nearer.
    #[inline]
    pub fn is_within(&self, radius: f64, a: [f64; 3], b: [f64; 3]) -> bool {
        self.gap_squared(a, b) <= radius * radius && self.distance_squared(a, b) <= radius * radius
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kernel::rng::Stream;

    /// The five cases of [ARM-RRT](crate#papers) fig. 3: through a face, over an edge, in a face's plane, parallel to it,
    /// apart.
    #[test]
    fn a_segment_meets_a_face_an_edge_and_the_inside() {
        let cuboid = Cuboid { min: [0.0; 3], max: [1.0, 2.0, 3.0] };
        assert_eq!(cuboid.clip([-1.0, 1.0, 1.0], [3.0, 1.0, 1.0]), Some([0.25, 0.5]));
        assert!(cuboid.meets([-1.0, 1.0, 1.0], [1.0, -1.0, 1.0]), "the edge x = y = 0");
        assert!(!cuboid.meets([-1.0, 0.999, 1.0], [1.0, -1.001, 1.0]));
        assert!(cuboid.meets([0.0, -1.0, 1.0], [0.0, 3.0, 1.0]), "in the plane of a face");
        assert!(!cuboid.meets([-1e-9, -1.0, 1.0], [-1e-9, 3.0, 1.0]), "parallel to it");
        assert!(cuboid.meets([0.5; 3], [0.6; 3]), "inside");
        assert!(!cuboid.meets([2.0; 3], [5.0; 3]));
    }

    /// To a face, an edge and a corner of the unit cube; along a face; from inside; a point; and a box without width.
    #[test]
    fn the_distance_is_that_of_the_closest_features() {
        let cube = Cuboid { min: [0.0; 3], max: [1.0; 3] };
        for (a, b, expected) in [
            ([2.0, 0.5, 0.5], [3.0, 0.5, 0.5], 1.0),
            ([-1.0, 0.2, 1.5], [2.0, 0.8, 1.5], 0.25),
            ([3.0, 0.0, 0.5], [0.0, 3.0, 0.5], 0.5),
            ([2.0, 2.0, 2.0], [3.0, 3.0, 3.0], 3.0),
            // Across the corner (1, 1, 1): the plane x + y + z = 6 is 3/√3 away, and its foot (2, 2, 2) is on the segment.
            ([3.0, 1.0, 2.0], [1.0, 3.0, 2.0], 3.0),
            ([0.5; 3], [0.6; 3], 0.0),
            ([2.0, 2.0, 0.5], [2.0, 2.0, 0.5], 2.0),
        ] {
            assert!((cube.distance_squared(a, b) - expected).abs() < 1e-15, "{a:?} {b:?}: {}", cube.distance_squared(a, b));
        }
        let line = Cuboid { min: [0.0; 3], max: [0.0, 0.0, 2.0] };
        assert!((line.distance_squared([1.0, -1.0, 1.0], [1.0, 3.0, 1.0]) - 1.0).abs() < 1e-15, "two skew lines");
        assert!((line.distance_squared([1.0, 0.0, 3.0], [3.0, 0.0, 5.0]) - 2.0).abs() < 1e-15, "its end");
        assert!(line.is_within(1.0, [1.0, -1.0, 1.0], [1.0, 3.0, 1.0]), "touching counts");
        assert!(!line.is_within(0.999, [1.0, -1.0, 1.0], [1.0, 3.0, 1.0]));
        assert!(line.is_within(4.0, [4.0, -1.0, 1.0], [4.0, 3.0, 1.0]), "radii above 2, too");
        assert!(!line.is_within(3.999, [4.0, -1.0, 1.0], [4.0, 3.0, 1.0]));
    }

    /// The least over 2001 points of the segment is at least the distance, and at most half a piece more.
    #[test]
    fn the_distance_agrees_with_many_points() {
        let mut random = Stream::new(1, 0);
        let mut point = |from: f64, to: f64| std::array::from_fn::<f64, 3, _>(|_| random.between(from, to));
        for _ in 0..3000 {
            let (p, q) = (point(-1.0, 1.0), point(-1.0, 1.0));
            let cuboid = Cuboid { min: [0, 1, 2].map(|i| p[i].min(q[i])), max: [0, 1, 2].map(|i| p[i].max(q[i])) };
            let (a, b) = (point(-2.0, 2.0), point(-2.0, 2.0));
            let at = |i: i32| [0, 1, 2].map(|axis| a[axis] + (b[axis] - a[axis]) * f64::from(i) / 2000.0);
            let norm = |x: [f64; 3]| (x[0] * x[0] + x[1] * x[1] + x[2] * x[2]).sqrt();
            let to_box = |x: [f64; 3]| norm([0, 1, 2].map(|i| x[i] - clamp(x[i], cuboid.min[i], cuboid.max[i])));
            let brute = (0..=2000).map(|i| to_box(at(i))).fold(f64::INFINITY, f64::min);
            let exact = cuboid.distance_squared(a, b).sqrt();
            let piece = norm([0, 1, 2].map(|i| b[i] - a[i])) / 2000.0;
            assert!(exact <= brute + 1e-12 && brute <= exact + 0.5 * piece + 1e-12, "{cuboid:?} {a:?} {b:?}: {exact} {brute}");
            assert_eq!(exact == 0.0, cuboid.meets(a, b));
            assert!(cuboid.gap_squared(a, b) <= exact * exact + 1e-12);
            let back = cuboid.distance_squared(b, a).sqrt();
            assert!((back - exact).abs() < 1e-12, "the other way round");
        }
    }
}
