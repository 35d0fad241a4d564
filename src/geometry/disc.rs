//! A circular obstacle.

use super::distance_squared;

/// A disc; its rim belongs to the free space, so a path may touch it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Disc {
    /// Where its centre is.
    pub center: [f64; 2],
    /// Its radius, positive.
    pub radius: f64,
}

impl Disc {
    /// How far the point is from the rim; negative inside.
    pub fn clearance(&self, [x, y]: [f64; 2]) -> f64 {
        self.clearance_of_segment([x, y], [x, y])
    }

    /// How far the segment `a`–`b` stays from the rim; negative: how deep it cuts.
    pub fn clearance_of_segment(&self, a: [f64; 2], b: [f64; 2]) -> f64 {
        distance_squared(a, b, self.center).sqrt() - self.radius
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_segment_through_the_centre_cuts_by_the_radius() {
        let disc = Disc { center: [2.0, 1.0], radius: 0.5 };
        assert_eq!(disc.clearance_of_segment([0.0, 1.0], [4.0, 1.0]), -0.5);
        assert_eq!(disc.clearance([2.0, 3.0]), 1.5);
        assert_eq!(disc.clearance_of_segment([0.0, 0.5], [4.0, 0.5]), 0.0, "touching is free");
    }
}
