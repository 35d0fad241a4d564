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
/// its length, Gammell, Srinivasa and Barfoot 2014. Dimensions without extent stay as they are.
#[derive(Debug, Clone)]
pub(super) struct Informed<const N: usize> {
    start: [f64; N],
    goal: [f64; N],
    /// Unit vectors: along the line from start to goal, and across it.
    axes: [[f64; N]; N],
    straight: f64,
    dimensions: usize,
}

/// Along a direction and across it, in space or in its plane z = 0: the normal, or by Duff et al. 2017, which never divides by
/// nearly nothing.
fn in_space([x, y, z]: [f64; 3], dimensions: usize) -> [[f64; 3]; 3] {
    if dimensions == 2 {
        return [[x, y, z], [-y, x, 0.0], [0.0; 3]];
    }
    let sign = 1.0_f64.copysign(z);
    let a = -1.0 / (sign + z);
    let b = x * y * a;
    [[x, y, z], [1.0 + sign * x * x * a, sign * b, -sign * x], [b, sign + y * y * a, -y]]
}

/// The same in any number of dimensions: the axes, but for the first, mirrored so that the first lies along the direction
/// (Householder 1958).
fn mirrored<const N: usize>(along: [f64; N]) -> [[f64; N]; N] {
    let mut normal = along;
    normal[0] += 1.0_f64.copysign(along[0]);
    let squared = dot(&normal, &normal);
    std::array::from_fn(|k| {
        let axis = |i: usize| f64::from(u8::from(i == k)) - 2.0 * normal[i] * normal[k] / squared;
        if k == 0 { along } else { std::array::from_fn(axis) }
    })
}

/// The volume of a ball of radius 1.
pub(super) fn ball(dimensions: usize) -> f64 {
    match dimensions {
        0 => 1.0,
        1 => 2.0,
        2 => PI,
        3 => 4.0 / 3.0 * PI,
        d => ball(d - 2) * 2.0 * PI / d as f64,
    }
}

impl<const N: usize> Informed<N> {
    /// About a start and a goal.
    pub(super) fn new(start: [f64; N], goal: [f64; N], dimensions: usize) -> Self {
        let way = minus(&goal, &start);
        let straight = dot(&way, &way).sqrt();
        let first = std::array::from_fn(|i| f64::from(u8::from(i == 0)));
        let along = if straight > 0.0 { way.map(|x| x / straight) } else { first };
        let axes = if N == 3 {
            let axes = in_space([along[0], along[1], along[2]], dimensions);
            std::array::from_fn(|k| std::array::from_fn(|i| axes[k][i]))
        } else {
            mirrored(along)
        };
        Self { start, goal, axes, straight, dimensions }
    }

    /// A point drawn evenly from the ellipsoid of a length; a sphere of radius 1, stretched.
    pub(super) fn draw(&self, length: f64, rng: &mut Stream) -> [f64; N] {
        let mut ball = [0.0; N];
        let mut squared = 0.0;
        for x in &mut ball[..self.dimensions] {
            *x = rng.normal();
            squared += *x * *x;
        }
        let u = rng.unit();
        let radius = match self.dimensions {
            2 => u.sqrt(),
            3 => libm::cbrt(u),
            d => math::pow(u, 1.0 / d as f64),
        };
        let scale = if squared > 0.0 { radius / squared.sqrt() } else { 0.0 };
        let across = (length * length - self.straight * self.straight).max(0.0).sqrt() / 2.0;
        let half = |k: usize| if k == 0 { length / 2.0 } else { across };
        std::array::from_fn(|i| {
            let middle = f64::midpoint(self.start[i], self.goal[i]);
            middle + (0..N).fold(0.0, |sum, k| sum + self.axes[k][i] * half(k) * ball[k] * scale)
        })
    }

    /// The extent of the ellipsoid across the line over the extent of the space: not worth drawing from if larger.
    pub(super) fn volume(&self, length: f64) -> f64 {
        let across = (length * length - self.straight * self.straight).max(0.0).sqrt() / 2.0;
        (1..self.dimensions).fold(ball(self.dimensions) * length / 2.0, |volume, _| volume * across)
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

    /// In so many of N dimensions.
    fn check<const N: usize>(dimensions: usize) {
        let ends = [[-0.2, 0.02, 0.0, 0.4, 0.1], [0.9, 0.7, 0.3, -0.1, 0.2]];
        let [start, goal]: [[f64; N]; 2] = ends.map(|end| std::array::from_fn(|i| if i < dimensions { end[i] } else { 0.0 }));
        let informed = Informed::new(start, goal, dimensions);
        let straight = distance(&start, &goal);
        let mut rng = Stream::new(1, 0);
        let (n, length) = (4000, 1.2 * straight);
        let (mut inner, mut largest) = (0, 0.0_f64);
        for _ in 0..n {
            let p = informed.draw(length, &mut rng);
            let sum = distance(&p, &start) + distance(&p, &goal);
            assert!(sum <= length * (1.0 + 1e-12));
            assert!(p[dimensions..].iter().all(|&x| x == 0.0));
            largest = largest.max(sum);
            // The image of the ball of half the radius has so small a share of the volume.
            let along: [f64; N] =
                std::array::from_fn(|k| dot(&informed.axes[k], &std::array::from_fn(|i| p[i] - f64::midpoint(start[i], goal[i]))));
            let across = (length * length - straight * straight).sqrt() / 2.0;
            let unit: [f64; N] = std::array::from_fn(|k| along[k] / if k == 0 { length / 2.0 } else { across });
            inner += usize::from(dot(&unit, &unit) <= 0.25);
        }
        let share = inner as f64 / f64::from(n);
        let expected = (0..dimensions).fold(1.0, |share, _| share / 2.0);
        assert!((share - expected).abs() < 4.0 * (expected * (1.0 - expected) / f64::from(n)).sqrt(), "{share} {expected}");
        assert!(largest > 0.99 * length);
    }

    #[test]
    fn informed_samples_fill_the_ellipsoid_and_stay_in_it() {
        check::<3>(2);
        check::<3>(3);
        check::<2>(2);
        check::<4>(4);
        check::<5>(5);
        check::<5>(2);
    }

    #[test]
    fn a_ball_has_the_known_volume_in_every_number_of_dimensions() {
        let known = [1.0, 2.0, PI, 4.0 / 3.0 * PI, PI * PI / 2.0, 8.0 / 15.0 * PI * PI, PI * PI * PI / 6.0];
        known.iter().enumerate().for_each(|(d, volume)| assert!((ball(d) / volume - 1.0).abs() < 1e-15, "{d}"));
    }

    #[test]
    fn angles_are_those_between_directions() {
        assert_eq!(angle(&[1.0, 0.0, 0.0], &[0.0, 2.0, 0.0]), PI / 2.0);
        assert_eq!(angle(&[1.0, 1.0, 0.0], &[-1.0, -1.0, 0.0]), PI);
        assert!((angle(&[1.0, 0.0, 0.0], &[1.0, 1.0, 0.0]) - PI / 4.0).abs() < 1e-15);
        assert_eq!(angle(&[0.0; 3], &[1.0, 0.0, 0.0]), 0.0);
    }
}
