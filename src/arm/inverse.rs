//! Inverse kinematics in closed form, [ARM-RRT](crate#papers) §2.1: up to eight postures.

use std::f64::consts::PI;

use nalgebra::{Isometry3, Matrix3, Unit, Vector3};

use crate::math::clamp;

use super::{
    Arm, Axis, Posture, Solutions, Unreachable, distance,
    reach::Limbs,
    wrist::{Turn, Turned, Wrist, share},
};

/// How far beyond its limit an angle is taken for the limit, in radians: what rounding does.
const LIMIT: f64 = 1e-10;
/// A full turn.
const TURN: f64 = 2.0 * PI;
/// How many rolls are tried for a tool that is not along the last joint's axis.
const ROLLS: u32 = 24;

/// What decides between a joint's angles that are whole turns apart.
#[derive(Clone, Copy, PartialEq)]
enum Within {
    /// The joint's limits.
    Limits,
    /// (−π, π].
    Turn,
}

/// How the tool may turn about itself.
#[derive(Clone, Copy, PartialEq)]
enum Roll {
    /// As the pose says.
    Overrides,
    /// Joint 6, about whose axis the tool lies, stays as it is.
    Kept,
}

impl Arm {
    /// The postures within the joint limits that bring the tip into a pose in the world, the nearest to `near` first by
    /// [`distance`].
    ///
    /// A joint whose range is more than a turn takes the angle nearest to `near`'s. If the wrist is singular
    /// ([`SINGULAR`](super::SINGULAR)), only the sum or difference of θ4 and θ6 is determined, and they are the nearest to
    /// `near`'s; if the wrist lies on joint 1's or 2's axis, that joint stays. `near` is clamped to the limits first.
    ///
    /// ```
    /// use forage::arm::ArmScene;
    ///
    /// let scene = forage::shipped("arm-free")?;
    /// let arm = &scene.get::<ArmScene>()?.arm;
    /// let home = arm.home();
    /// let [.., tip] = arm.forward(&home);
    /// let solutions = arm.inverse(&tip, &home)?;
    /// // The wrist is stretched at home, so θ4 and θ6 are only determined together: they stay.
    /// assert!(solutions[0].iter().zip(home).all(|(found, at)| (found - at).abs() < 1e-9));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`Unreachable`] with the cause: position, orientation or limits.
    pub fn inverse(&self, pose: &Isometry3<f64>, near: &Posture) -> Result<Solutions, Unreachable> {
        self.solve(pose, near, Within::Limits, Roll::Overrides)
    }

    /// As [`inverse`](Self::inverse), without joint limits: angles in (−π, π].
    ///
    /// # Errors
    /// [`Unreachable::Position`] or [`Unreachable::Orientation`].
    pub fn inverse_all(&self, pose: &Isometry3<f64>, near: &Posture) -> Result<Solutions, Unreachable> {
        self.solve(pose, near, Within::Turn, Roll::Overrides)
    }

    /// The postures within the joint limits that bring the tip to a point with the tool pointing in a direction, the nearest to
    /// `near` first. The roll of the tool is free: a tool along z6 leaves joint 6 as in `near` (and joint 4, if the wrist is
    /// singular); for a tool along x6 or y6, 24 rolls 15° apart are tried and the one with the nearest posture is taken.
    ///
    /// ```
    /// use forage::arm::ArmScene;
    ///
    /// let scene = forage::shipped("arm-cuboid")?;
    /// let (arm, start) = (&scene.get::<ArmScene>()?.arm, scene.get::<ArmScene>()?.start);
    /// let down = -nalgebra::Vector3::z_axis();
    /// let solutions = arm.reaching(start, &down, &arm.home())?;
    /// let [.., tip] = arm.skeleton(&solutions[0]);
    /// assert!((0..3).all(|axis| (tip[axis] - start[axis]).abs() < 1e-9));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// As [`inverse`](Self::inverse); for a tool along x6 or y6, the error of the roll that came closest.
    pub fn reaching(&self, point: [f64; 3], direction: &Unit<Vector3<f64>>, near: &Posture) -> Result<Solutions, Unreachable> {
        if self.tool.axis == Axis::Z {
            return self.solve(&self.pose(point, direction, 0.0), near, Within::Limits, Roll::Kept);
        }
        let mut best = Err(Unreachable::Position);
        for roll in (0..ROLLS).map(|i| f64::from(i) * TURN / f64::from(ROLLS)) {
            let next = self.solve(&self.pose(point, direction, roll), near, Within::Limits, Roll::Overrides);
            best = match (best, next) {
                (Ok(a), Ok(b)) => Ok(if distance(&b[0], near) < distance(&a[0], near) { b } else { a }),
                (Ok(found), _) | (_, Ok(found)) => Ok(found),
                (Err(a), Err(b)) => Err(a.max(b)),
            };
        }
        best
    }

    /// As [`reaching`](Self::reaching), with the one of [`directions`](Self::directions) whose posture is nearest to `near`.
    ///
    /// # Errors
    /// [`Unreachable::Position`] or [`Unreachable::Limits`]; [`Unreachable::Orientation`] if only a direction between those
    /// tried would be possible.
    pub fn reaching_somehow(&self, point: [f64; 3], near: &Posture) -> Result<(Unit<Vector3<f64>>, Solutions), Unreachable> {
        let mut best: Result<(_, Solutions), _> = Err(Unreachable::Position);
        for direction in Self::directions() {
            best = match (best, self.reaching(point, direction, near)) {
                // That is so whatever the direction.
                (_, Err(Unreachable::Position)) => return Err(Unreachable::Position),
                (Ok((_, a)), Ok(b)) if distance(&b[0], near) < distance(&a[0], near) => Ok((*direction, b)),
                (Ok(found), _) => Ok(found),
                (Err(_), Ok(b)) => Ok((*direction, b)),
                (Err(a), Err(b)) => Err(a.max(b)),
            };
        }
        best
    }

    /// A pose with the tip at a point and the tool pointing in a direction, turned about itself by `roll`.
    fn pose(&self, point: [f64; 3], direction: &Unit<Vector3<f64>>, roll: f64) -> Isometry3<f64> {
        let along = direction.into_inner();
        // Across it: away from the world's axis that it is least along.
        let across = along.cross(&Vector3::ith(along.iamin(), 1.0)).normalize();
        let third = along.cross(&across);
        let (sine, cosine) = libm::sincos(roll);
        let (p, q) = (across * cosine + third * sine, third * cosine - across * sine);
        let columns = match self.tool.axis {
            Axis::X => [along, p, q],
            Axis::Y => [q, along, p],
            Axis::Z => [p, q, along],
        };
        let rotation = nalgebra::Rotation3::from_matrix_unchecked(Matrix3::from_columns(&columns));
        Isometry3::from_parts(point.into(), nalgebra::UnitQuaternion::from_rotation_matrix(&rotation))
    }

    fn solve(&self, pose: &Isometry3<f64>, near: &Posture, within: Within, roll: Roll) -> Result<Solutions, Unreachable> {
        let near = &self.tamed(near, within);
        let (tip, wrist, columns) = self.seen(pose);
        let (limbs, hand) = (Limbs::of(self), Wrist::of(self));
        let (mut solutions, mut comes) = (Solutions::NONE, false);
        limbs.stretches(wrist, near, |stretch| {
            comes = true;
            let [theta1, theta2, theta3] = stretch.theta;
            let fit = |i: usize, angle: f64| self.fit(i, angle, near, within);
            let (Some(q1), Some(q2), Some(q3)) = (fit(0, theta1), fit(1, theta2), fit(2, theta3)) else {
                return;
            };
            let sixth = |theta6| if roll == Roll::Kept { Some(near[5]) } else { fit(5, theta6) };
            match hand.turns(&columns.map(|column| stretch.back(column))) {
                Turned::Twice(ways) => {
                    for [theta4, theta5, theta6] in ways {
                        if let (Some(q4), Some(q5), Some(q6)) = (fit(3, theta4), fit(4, theta5), sixth(theta6)) {
                            solutions.insert([q1, q2, q3, q4, q5, q6], near);
                        }
                    }
                }
                Turned::Singular { theta5, sign, sum } => {
                    let shared = if roll == Roll::Kept { Some([near[3], near[5]]) } else { share(sum, sign, near, self.ranges(within)) };
                    if let (Some([q4, q6]), Some(q5)) = (shared, fit(4, theta5)) {
                        solutions.insert([q1, q2, q3, q4, q5, q6], near);
                    }
                }
            }
        });
        if !solutions.is_empty() {
            Ok(solutions)
        } else if comes {
            Err(Unreachable::Limits)
        } else {
            Err(limbs.fault(tip, self.hand().norm()))
        }
    }

    /// From the wrist to the tip, in the last joint's frame.
    fn hand(&self) -> Vector3<f64> {
        self.tool.vector() + Vector3::new(0.0, 0.0, self.joints[5].d)
    }

    /// Where tip and wrist are as the base sees them, and the columns of the last joint's rotation.
    fn seen(&self, pose: &Isometry3<f64>) -> ([f64; 3], [f64; 3], Turn) {
        let (sine, cosine) = self.base.turn();
        let back = |v: Vector3<f64>| [cosine * v.x + sine * v.y, cosine * v.y - sine * v.x, v.z];
        let rotation = pose.rotation.to_rotation_matrix();
        let away = pose.translation.vector - Vector3::from(self.base.position);
        let wrist = away - rotation * self.hand();
        (back(away), back(wrist), [0, 1, 2].map(|i| back(rotation.matrix().column(i).into_owned())))
    }

    /// The posture to stay near to: within the limits, and finite.
    fn tamed(&self, near: &Posture, within: Within) -> Posture {
        std::array::from_fn(|i| {
            let joint = &self.joints[i];
            let angle = if near[i].is_finite() { near[i] } else { joint.home.to_radians() };
            match within {
                Within::Limits => clamp(angle, joint.min.to_radians(), joint.max.to_radians()),
                Within::Turn => wrap(angle),
            }
        })
    }

    /// The angle of joint `i` that is whole turns from this one and nearest to `near`'s, if one is within the limits.
    fn fit(&self, i: usize, angle: f64, near: &Posture, within: Within) -> Option<f64> {
        if within == Within::Turn {
            return Some(wrap(angle));
        }
        let (min, max) = (self.joints[i].min.to_radians(), self.joints[i].max.to_radians());
        let least = ((min - LIMIT - angle) / TURN).ceil();
        let most = ((max + LIMIT - angle) / TURN).floor();
        let turns = clamp(((near[i] - angle) / TURN).round(), least, most);
        (least <= most).then(|| clamp(angle + turns * TURN, min, max))
    }

    /// Where θ4 and θ6 of a singular wrist may be.
    fn ranges(&self, within: Within) -> [[f64; 2]; 2] {
        match within {
            Within::Limits => [3, 5].map(|i| [self.joints[i].min.to_radians(), self.joints[i].max.to_radians()]),
            Within::Turn => [[-PI, PI]; 2],
        }
    }
}

/// The angle in (−π, π].
fn wrap(angle: f64) -> f64 {
    let wrapped = angle - TURN * (angle / TURN).round();
    if wrapped <= -PI { wrapped + TURN } else { wrapped }
}
