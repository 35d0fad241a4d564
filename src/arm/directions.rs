//! Directions spread evenly over the sphere, in which a tool may point.

use std::sync::OnceLock;

use nalgebra::{Unit, Vector3};

use super::Arm;

/// The number of [`Arm::directions`].
pub const DIRECTIONS: usize = 42;

impl Arm {
    /// Directions spread evenly over the sphere, each with its opposite: the midpoints of an icosahedron's 30 edges, the six
    /// along the axes first, and its 12 corners.
    ///
    /// ```
    /// let directions = forage::arm::Arm::directions();
    /// assert_eq!(directions[0].into_inner(), nalgebra::Vector3::x());
    /// // Any direction at all is less than 21° from one of them.
    /// let any = nalgebra::Vector3::new(0.3, -0.5, 0.2).normalize();
    /// assert!(directions.iter().any(|direction| direction.dot(&any) > 0.9336));
    /// ```
    pub fn directions() -> &'static [Unit<Vector3<f64>>; DIRECTIONS] {
        static SPHERE: OnceLock<[Unit<Vector3<f64>>; DIRECTIONS]> = OnceLock::new();
        SPHERE.get_or_init(|| {
            let golden = f64::midpoint(1.0, 5.0_f64.sqrt());
            // Cyclic permutations of (±2φ, 0, 0), of (±φ, ±1, ±φ²) and of (0, ±1, ±φ).
            let kinds = [[2.0 * golden, 0.0, 0.0], [golden, 1.0, golden * golden], [0.0, 1.0, golden]];
            let mut sphere = [Vector3::x_axis(); DIRECTIONS];
            let all = kinds.into_iter().flat_map(|kind| (0..3).flat_map(move |turn| signs(kind).map(move |v| rotated(v, turn))));
            for (place, direction) in sphere.iter_mut().zip(all) {
                *place = Unit::new_normalize(direction);
            }
            sphere
        })
    }
}

/// A vector with every choice of signs for the coordinates that have one.
fn signs(v: [f64; 3]) -> impl Iterator<Item = [f64; 3]> {
    let fits = move |bits: u32| (0..3).all(|axis| v[axis] != 0.0 || bits >> axis & 1 == 0);
    (0..8).filter(move |&bits| fits(bits)).map(move |bits| [0, 1, 2].map(|axis| if bits >> axis & 1 == 0 { v[axis] } else { -v[axis] }))
}

fn rotated([x, y, z]: [f64; 3], turn: usize) -> Vector3<f64> {
    [Vector3::new(x, y, z), Vector3::new(z, x, y), Vector3::new(y, z, x)][turn]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn directions_are_apart_and_each_has_its_opposite() {
        let all = Arm::directions();
        for (i, a) in all.iter().enumerate() {
            assert!((a.norm() - 1.0).abs() < 1e-15);
            assert!(all.iter().any(|b| (a.into_inner() + b.into_inner()).norm() < 1e-15), "{a:?}");
            let nearest = all.iter().enumerate().filter(|&(j, _)| j != i).map(|(_, b)| a.dot(b)).fold(-1.0, f64::max);
            // An icosahedron's corner is 31.7° from the middles of its edges, these are 36° from each other.
            assert!((nearest - 0.850_650_808_352_04).abs() < 1e-12, "{nearest}");
        }
        assert_eq!(all[..6].iter().map(|v| v.abs().max()).collect::<Vec<_>>(), [1.0; 6]);
    }
}
