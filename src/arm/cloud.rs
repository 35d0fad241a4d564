//! The reachable workspace, as a cloud of points.

use crate::{arm::ArmScene, kernel::Error, message};

use super::{Arm, DIRECTIONS, Links, Unreachable};

/// The largest number of points of a lattice.
pub const MAX_LATTICE: usize = 20_000;

/// The reachable workspace of an arm, on a lattice.
#[derive(Debug, Clone, PartialEq)]
pub struct Reachability {
    /// For each point x, y, z and the reachability index: the share of [`Arm::directions`] in which the tool can point there,
    /// from 0 to 1.
    pub points: Vec<f32>,
    /// The distance between neighbours, in metres.
    pub step: f64,
}

/// Computes the reachable workspace on a lattice of this step, in metres, in the middle of the workspace. A direction counts if
/// some posture within the joint limits touches neither a cuboid nor the column. Links are segments, as in the paper.
///
/// ```
/// let scene = forage::shipped("arm-cuboid")?;
/// let cloud = forage::arm::reachability(scene.get()?, 0.25)?;
/// assert_eq!(cloud.points.len(), 4 * 7 * 6 * 3);
/// assert!(cloud.points.chunks(4).any(|point| point[3] > 0.4));
/// # Ok::<(), forage::Error>(())
/// ```
///
/// # Errors
/// [`Error::Refused`] for a `step` that is not above 0, or makes more than [`MAX_LATTICE`] points.
pub fn reachability(scene: &ArmScene, step: f64) -> Result<Reachability, Error> {
    let sides = [0, 1, 2].map(|axis| scene.workspace.max[axis] - scene.workspace.min[axis]);
    if !(step > 0.0 && step.is_finite()) {
        return Err(Error::refused("step", step, message!("arm-step", "a length greater than 0")));
    }
    // A hair more than the quotient: 0.75 / 0.25 must not lose its last point to rounding.
    let counts = sides.map(|side| (side / step + 1e-9).floor() + 1.0);
    let points = counts.iter().product::<f64>();
    if points > MAX_LATTICE as f64 {
        let allowed = message!(
            "arm-step-too-short",
            "long enough for at most {most} points in the workspace, not {points}",
            most = MAX_LATTICE,
            points
        );
        return Err(Error::refused("step", step, allowed));
    }
    let [nx, ny, nz] = counts.map(|count| count as usize);
    let at = |axis: usize, i: usize| {
        let margin = (sides[axis] - (counts[axis] - 1.0) * step) / 2.0;
        scene.workspace.min[axis] + margin + i as f64 * step
    };
    let links = Links::new(scene, 0.0);
    let mut points = Vec::with_capacity(4 * nx * ny * nz);
    for (k, j, i) in (0..nz).flat_map(|k| (0..ny).flat_map(move |j| (0..nx).map(move |i| (k, j, i)))) {
        let point = [at(0, i), at(1, j), at(2, k)];
        let share = directions_free(scene, &links, point) as f32 / DIRECTIONS as f32;
        points.extend(point.map(|x| x as f32).into_iter().chain([share]));
    }
    Ok(Reachability { points, step })
}

/// In how many directions the tool can point with its tip here.
fn directions_free(scene: &ArmScene, links: &Links, point: [f64; 3]) -> usize {
    if scene.cuboids.iter().any(|cuboid| cuboid.contains(point)) {
        return 0;
    }
    let (arm, home) = (&scene.arm, scene.arm.home());
    let mut free = 0;
    for direction in Arm::directions() {
        match arm.reaching(point, direction, &home) {
            Ok(solutions) => free += usize::from(solutions.iter().any(|posture| !links.touch(&arm.skeleton(posture)))),
            // That is so whatever the direction.
            Err(Unreachable::Position) => return 0,
            Err(_) => {}
        }
    }
    free
}

#[cfg(test)]
mod tests {
    use crate::shipped;

    use super::*;

    #[test]
    fn most_of_the_papers_workspace_is_reached_and_nothing_in_a_cuboid() {
        let scene = shipped("arm-cuboid").unwrap();
        let arm = scene.get::<ArmScene>().unwrap();
        let cloud = reachability(arm, 0.1).unwrap();
        assert_eq!(cloud.points.len(), 4 * 16 * 14 * 8);
        let (mut reached, mut most) = (0, 0.0_f32);
        for point in cloud.points.chunks(4) {
            let inside = arm.cuboids[0].contains([0, 1, 2].map(|axis| f64::from(point[axis])));
            assert!(!inside || point[3] == 0.0);
            reached += usize::from(point[3] > 0.0);
            most = most.max(point[3]);
        }
        // §4.1 of the repaired text: about 90 % without the cuboid and the column.
        assert!((1200..1700).contains(&reached), "{reached} of 1792");
        assert!(most > 0.6 && most <= 1.0, "{most}");
    }

    #[test]
    fn a_step_that_makes_too_many_points_is_refused_by_name() {
        let scene = shipped("arm-free").unwrap();
        for step in [0.01, 0.0, -1.0, f64::NAN, f64::INFINITY, 1e-300] {
            let error = reachability(scene.get::<ArmScene>().unwrap(), step).unwrap_err();
            assert_eq!(error.field(), "step", "{step}");
        }
        // Wider than the workspace: its middle.
        assert_eq!(reachability(scene.get::<ArmScene>().unwrap(), 10.0).unwrap().points.len(), 4);
    }
}
