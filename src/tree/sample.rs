//! Where a tree is asked to grow to.

use std::f64::consts::PI;

use crate::{kernel::rng::Stream, math};

use super::vector::{dot, minus};

/// A point drawn evenly from a box.
#[inline]
pub(super) fn uniform<const N: usize>(min: &[f64; N], max: &[f64; N], rng: &mut Stream) -> [f64; N] {
    std::array::from_fn(|i| rng.between(min[i], max[i]))
}

/// Where a shorter path than the best could lead: the points whose distances from start and goal are together less than
/// its length, Gammell, Srinivasa and Barfoot 2014. In the plane z stays 0.
#[derive(Debug, Clone)]
pub(super) struct Informed {
    start: [f64; 3],
    goal: [f64; 3],
    /// Unit vectors: along the line from start to goal, and across it.
    axes: [[f64; 3]; 3],
    straight: f64,
    dimensions: usize,
}

impl Informed {
    /// About a start and a goal.
    pub(super) fn new(start: [f64; 3], goal: [f64; 3], dimensions: usize) -> Self {
        let way = minus(&goal, &start);
        let straight = dot(&way, &way).sqrt();
        let along = if straight > 0.0 { way.map(|x| x / straight) } else { [1.0, 0.0, 0.0] };
        // Across: in the plane the normal; in space by Duff et al. 2017, which never divides by nearly nothing.
        let axes = if dimensions == 2 {
            [along, [-along[1], along[0], 0.0], [0.0; 3]]
        } else {
            let [x, y, z] = along;
            let sign = 1.0_f64.copysign(z);
            let a = -1.0 / (sign + z);
            let b = x * y * a;
            [along, [1.0 + sign * x * x * a, sign * b, -sign * x], [b, sign + y * y * a, -y]]
        };
        Self { start, goal, axes, straight, dimensions }
    }

    /// A point drawn evenly from the ellipsoid of a length; a sphere of radius 1, stretched.
    pub(super) fn draw(&self, length: f64, rng: &mut Stream) -> [f64; 3] {
        let mut ball = [0.0; 3];
        let mut squared = 0.0;
        for x in &mut ball[..self.dimensions] {
            *x = rng.normal();
            squared += *x * *x;
        }
        let u = rng.unit();
        let radius = if self.dimensions == 2 { u.sqrt() } else { libm::cbrt(u) };
        let scale = if squared > 0.0 { radius / squared.sqrt() } else { 0.0 };
        let across = (length * length - self.straight * self.straight).max(0.0).sqrt() / 2.0;
        let halves = [length / 2.0, across, across];
        std::array::from_fn(|i| {
            let middle = f64::midpoint(self.start[i], self.goal[i]);
            middle + (0..3).fold(0.0, |sum, k| sum + self.axes[k][i] * halves[k] * ball[k] * scale)
        })
    }

    /// The extent of the ellipsoid across the line over the extent of the space: not worth drawing from if larger.
    pub(super) fn volume(&self, length: f64) -> f64 {
        let across = (length * length - self.straight * self.straight).max(0.0).sqrt() / 2.0;
        if self.dimensions == 2 { PI * length / 2.0 * across } else { 4.0 / 3.0 * PI * length / 2.0 * across * across }
    }
}

/// The angle between two directions, [ARM-RRT](crate#papers) §3.2.1: 0 where one of them is none.
pub(super) fn angle<const N: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    let (aa, bb) = (dot(a, a), dot(b, b));
    if aa == 0.0 || bb == 0.0 {
        return 0.0;
    }
    math::acos(math::clamp(dot(a, b) / (aa * bb).sqrt(), -1.0, 1.0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tree::vector::distance;

    #[test]
    fn informed_samples_fill_the_ellipsoid_and_stay_in_it() {
        for dimensions in [2, 3] {
            let (start, goal) = ([-0.2, 0.02, 0.0], [0.9, 0.7, if dimensions == 2 { 0.0 } else { 0.3 }]);
            let informed = Informed::new(start, goal, dimensions);
            let straight = distance(&start, &goal);
            let mut rng = Stream::new(1, 0);
            let (n, length) = (4000, 1.2 * straight);
            let (mut inner, mut largest) = (0, 0.0_f64);
            for _ in 0..n {
                let p = informed.draw(length, &mut rng);
                let sum = distance(&p, &start) + distance(&p, &goal);
                assert!(sum <= length * (1.0 + 1e-12));
                assert!(dimensions == 3 || p[2] == 0.0);
                largest = largest.max(sum);
                // The image of the ball of half the radius has a quarter or an eighth of the volume.
                let along: [f64; 3] =
                    std::array::from_fn(|k| dot(&informed.axes[k], &std::array::from_fn(|i| p[i] - f64::midpoint(start[i], goal[i]))));
                let across = (length * length - straight * straight).sqrt() / 2.0;
                let unit = [along[0] / (length / 2.0), along[1] / across, along[2] / across];
                let r = dot(&unit, &unit);
                inner += usize::from(r <= 0.25);
            }
            let share = inner as f64 / f64::from(n);
            let expected = if dimensions == 2 { 0.25 } else { 0.125 };
            assert!((share - expected).abs() < 4.0 * (expected * (1.0 - expected) / f64::from(n)).sqrt(), "{share} {expected}");
            assert!(largest > 0.999 * length);
        }
    }

    #[test]
    fn angles_are_those_between_directions() {
        assert_eq!(angle(&[1.0, 0.0, 0.0], &[0.0, 2.0, 0.0]), PI / 2.0);
        assert_eq!(angle(&[1.0, 1.0, 0.0], &[-1.0, -1.0, 0.0]), PI);
        assert!((angle(&[1.0, 0.0, 0.0], &[1.0, 1.0, 0.0]) - PI / 4.0).abs() < 1e-15);
        assert_eq!(angle(&[0.0; 3], &[1.0, 0.0, 0.0]), 0.0);
    }
}
