//! Boxes in space, and segments that meet them, [ARM-RRT] §3.1.

/// An axis-parallel box, closed: what touches a face meets it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cuboid {
    /// The corner of the smallest coordinates.
    pub min: [f64; 3],
    /// The corner of the largest.
    pub max: [f64; 3],
}

impl Cuboid {
    /// Whether a point lies in it or on a face.
    #[inline]
    pub fn contains(&self, point: [f64; 3]) -> bool {
        (0..3).all(|axis| self.min[axis] <= point[axis] && point[axis] <= self.max[axis])
    }

    /// Which part of the segment `a`–`b` lies in it, as parameters 0 ≤ from ≤ to ≤ 1. The plane intersections are
    /// [ARM-RRT] (7)–(10), two parallel faces at a time.
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
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The five cases of [ARM-RRT] fig. 3: through a face, over an edge, in a face's plane, parallel to it, apart.
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
}
