//! A circular obstacle.

use super::distance_squared;

/// A disc; its rim belongs to the free space, so a path may touch it.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Disc {
    /// Its centre.
    pub center: [f64; 2],
    /// Its radius, positive.
    pub radius: f64,
}

impl Disc {
    /// The distance of a point from the rim; negative inside.
    pub fn clearance(&self, [x, y]: [f64; 2]) -> f64 {
        self.clearance_of_segment([x, y], [x, y])
    }

    /// The smallest distance of the segment `a`–`b` from the rim; negative inside, by the depth of the cut.
    pub fn clearance_of_segment(&self, a: [f64; 2], b: [f64; 2]) -> f64 {
        distance_squared(a, b, self.center).sqrt() - self.radius
    }

    /// The part of the segment `a`–`b` in the closed disc, as parameters 0 ≤ from ≤ to ≤ 1; `None` if there is none.
    pub fn clip(&self, a: [f64; 2], b: [f64; 2]) -> Option<[f64; 2]> {
        let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
        let (x, y) = (a[0] - self.center[0], a[1] - self.center[1]);
        let (squared, along) = (dx * dx + dy * dy, x * dx + y * dy);
        let outside = x * x + y * y - self.radius * self.radius;
        if squared == 0.0 {
            return (outside <= 0.0).then_some([0.0, 1.0]);
        }
        let root = (along * along - squared * outside).sqrt();
        let (from, to) = ((-along - root) / squared, (-along + root) / squared);
        // A root of a negative number is NaN, and no comparison with it holds.
        (from <= 1.0 && to >= 0.0).then(|| [from.max(0.0), to.min(1.0)])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_chord_is_clipped_at_the_rim() {
        let disc = Disc { center: [2.0, 1.0], radius: 5.0 };
        assert_eq!(disc.clip([-8.0, 4.0], [12.0, 4.0]), Some([0.3, 0.7]));
        assert_eq!(disc.clip([2.0, 4.0], [12.0, 4.0]), Some([0.0, 0.4]));
        assert_eq!(disc.clip([-8.0, 7.0], [12.0, 7.0]), None);
        assert_eq!(disc.clip([7.0, 4.0], [12.0, 4.0]), None, "the line meets it, the segment does not");
        assert_eq!((disc.clip([2.0, 1.0], [2.0, 1.0]), disc.clip([9.0, 1.0], [9.0, 1.0])), (Some([0.0, 1.0]), None));
    }

    #[test]
    fn a_segment_through_the_centre_cuts_by_the_radius() {
        let disc = Disc { center: [2.0, 1.0], radius: 0.5 };
        assert_eq!(disc.clearance_of_segment([0.0, 1.0], [4.0, 1.0]), -0.5);
        assert_eq!(disc.clearance([2.0, 3.0]), 1.5);
        assert_eq!(disc.clearance_of_segment([0.0, 0.5], [4.0, 0.5]), 0.0, "touching is free");
    }
}
