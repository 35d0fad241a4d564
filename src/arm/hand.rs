//! Postures with the hand held: θ4, θ5 and θ6 are given, and the first three joints bring the tip to a point.
//!
//! The tip is then a fixed point of the forearm, and θ1, θ2 and θ3 follow as for the wrist in [ARM-RRT](crate#papers) §2.1,
//! with the tip in the wrist's place. Where the tool may point anywhere this has no wrist singularity: what the hand does is
//! chosen, and smooth.

use std::f64::consts::{PI, TAU};

use nalgebra::{Isometry3, Point3};

use crate::math::{acos, atan2, cos, sin};

use super::{Arm, Axis, Joint, Posture};

/// How far beyond its limit an angle is taken for the limit: what rounding does.
const LIMIT: f64 = 1e-10;

/// An arm whose hand is held.
#[derive(Debug)]
pub(crate) struct Holding {
    arm: Arm,
    /// Into the forearm's frame from the world's, with the first three joints at 0.
    forearm: Isometry3<f64>,
}

/// θ4, θ5, θ6, and where they hold the tip in the forearm's frame.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Hand {
    pub(crate) angles: [f64; 3],
    tip: [f64; 3],
}

impl Holding {
    pub(crate) fn new(arm: &Arm) -> Self {
        Self { arm: arm.clone(), forearm: arm.forward(&[0.0; 6])[2].inverse() }
    }

    /// A hand with these angles.
    #[inline(never)]
    pub(crate) fn hand(&self, angles: [f64; 3]) -> Hand {
        let [a, b, c] = angles;
        let tip = Point3::from(self.arm.skeleton(&[0.0, 0.0, 0.0, a, b, c])[4]);
        Hand { angles, tip: (self.forearm * tip).coords.into() }
    }

    /// Hands all over the limits of their joints: θ4 every 40°, θ5 every 30°, and θ6 every 60° where it moves the tip. A wrist
    /// that is stretched holds the tool one way, whatever θ4.
    pub(crate) fn hands(&self) -> Vec<Hand> {
        let ([_, _, _, fourth, fifth, sixth], home) = (&self.arm.joints, self.arm.home());
        let spins = self.arm.tool.axis == Axis::Z;
        let around = |joint: &Joint, step: f64| {
            let (low, high) = (joint.min.max(joint.home - 180.0), joint.max.min(joint.home + 179.0));
            let (first, last) = (((low - joint.home) / step).ceil() as i32, ((high - joint.home) / step).floor() as i32);
            let home = joint.home;
            (first..=last).map(move |i| (home + f64::from(i) * step) * (PI / 180.0))
        };
        let thirds: Vec<_> = if spins { vec![home[5]] } else { around(sixth, 60.0).collect() };
        let mut hands = Vec::new();
        for second in around(fifth, 30.0) {
            let stretched = spins && sin(second).abs() < 1e-9;
            for first in around(fourth, 40.0).filter(|&first| !stretched || first == home[3]) {
                hands.extend(thirds.iter().map(|&third| self.hand([first, second, third])));
            }
        }
        hands
    }

    /// Calls `each` with the postures within the limits that hold the hand so and bring the tip to a point: at most four. Of
    /// angles whole turns apart it takes those nearest to `near`'s.
    #[inline(never)]
    pub(crate) fn reach(&self, hand: &Hand, point: [f64; 3], near: &Posture, each: &mut dyn FnMut(Posture)) {
        let ([base, shoulder, elbow, ..], [ox, oy, oz]) = (&self.arm.joints, self.arm.base.position);
        let (sine, cosine) = self.arm.base.turn();
        let (wx, wy) = (point[0] - ox, point[1] - oy);
        let (x, y, z) = (cosine * wx + sine * wy, cosine * wy - sine * wx, point[2] - oz - base.d);
        let [px, py, pz] = hand.tip;
        // Along the second joint's axis the tip is as far off as it is, whatever θ2 and θ3.
        let (up, offset) = (if shoulder.alpha < 0.0 { -1.0 } else { 1.0 }, shoulder.d + elbow.d + pz);
        let (across, forward) = (-up * offset, x * x + y * y - offset * offset);
        let (upper, fore) = (elbow.a, (px * px + py * py).sqrt());
        if forward < 0.0 || fore * upper == 0.0 {
            return;
        }
        for forward in [forward.sqrt(), -forward.sqrt()] {
            let theta1 = atan2(y, x) - atan2(across, forward);
            let (u, v) = (forward - shoulder.a, up * z);
            let bend = (u * u + v * v - upper * upper - fore * fore) / (2.0 * upper * fore);
            if !(-1.0..=1.0).contains(&bend) {
                continue;
            }
            for bend in [acos(bend), -acos(bend)] {
                let theta2 = atan2(v, u) - atan2(fore * sin(bend), upper + fore * cos(bend));
                let firsts = [theta1, theta2, bend - atan2(py, px)];
                if let [Some(a), Some(b), Some(c)] = std::array::from_fn(|i| self.fit(i, firsts[i], near[i])) {
                    let [d, e, f] = hand.angles;
                    each([a, b, c, d, e, f]);
                }
            }
        }
    }

    /// The posture of [`Holding::reach`] that is nearest to `near`.
    #[inline(never)]
    pub(crate) fn nearest(&self, hand: &Hand, point: [f64; 3], near: &Posture) -> Option<Posture> {
        let mut best = None;
        self.reach(hand, point, near, &mut |posture| {
            let away = squared(&posture, near);
            if best.is_none_or(|(least, _)| away < least) {
                best = Some((away, posture));
            }
        });
        best.map(|(_, posture)| posture)
    }

    /// An angle of a joint, turned by whole turns to where it is within the limits and nearest to `near`.
    fn fit(&self, joint: usize, angle: f64, near: f64) -> Option<f64> {
        let (min, max) = (self.arm.joints[joint].min * (PI / 180.0), self.arm.joints[joint].max * (PI / 180.0));
        let turned = angle + TAU * ((near - angle) / TAU).round();
        let fits = |angle: &f64| (min - LIMIT..=max + LIMIT).contains(angle);
        let other = if turned < near { turned + TAU } else { turned - TAU };
        let further = turned + turned - other;
        [turned, other, further].into_iter().find(fits).map(|angle| crate::math::clamp(angle, min, max))
    }
}

/// The squared distance of two postures, in radians.
#[inline]
pub(crate) fn squared(a: &Posture, b: &Posture) -> f64 {
    let d: [f64; 6] = std::array::from_fn(|i| a[i] - b[i]);
    (d[0] * d[0] + d[1] * d[1]) + (d[2] * d[2] + d[3] * d[3]) + (d[4] * d[4] + d[5] * d[5])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        arm::{ArmScene, degrees},
        kernel::rng::Stream,
        shipped,
    };

    /// A random posture's tip is brought back by its own hand, and every posture found has its tip there, on arms of all signs.
    #[test]
    fn with_its_hand_held_a_posture_is_found_again() {
        let shipped = shipped("arm-free").unwrap();
        let mut random = Stream::new(3, 0);
        for round in 0..2000 {
            let mut arm = shipped.get::<ArmScene>().unwrap().arm.clone();
            if round % 2 == 1 {
                arm.joints[1].alpha = 90.0;
                (arm.joints[0].d, arm.joints[1].d, arm.joints[2].d) = (0.2, 0.03, -0.05);
                (arm.base.yaw, arm.tool.axis, arm.joints[2].a) = (30.0, Axis::X, 0.3);
            }
            let posture: Posture = arm.joints.map(|joint| random.between(joint.min, joint.max) * (PI / 180.0));
            let holding = Holding::new(&arm);
            let hand = holding.hand([posture[3], posture[4], posture[5]]);
            let tip = arm.skeleton(&posture)[4];
            let (mut n, mut again) = (0, f64::INFINITY);
            holding.reach(&hand, tip, &posture, &mut |found| {
                let there = arm.skeleton(&found)[4];
                assert!((0..3).all(|i| (there[i] - tip[i]).abs() < 1e-7), "{there:?} {tip:?}");
                (n, again) = (n + 1, again.min(squared(&found, &posture)));
            });
            assert!((1..=4).contains(&n) && again < 1e-10, "round {round}: {n} {again} {:?}", degrees(&posture));
            assert!(squared(&holding.nearest(&hand, tip, &posture).unwrap(), &posture) < 1e-10);
        }
    }

    #[test]
    fn hands_are_within_the_limits_and_home_is_among_them() {
        let shipped = shipped("arm-free").unwrap();
        let arm = &shipped.get::<ArmScene>().unwrap().arm;
        let hands = Holding::new(arm).hands();
        // Eight bends of the wrist with nine turns of it, and the wrist stretched.
        assert_eq!(hands.len(), 8 * 9 + 1);
        assert!(hands.iter().any(|hand| hand.angles == [0.0; 3]));
        for hand in hands {
            for (angle, joint) in hand.angles.iter().zip(&arm.joints[3..]) {
                assert!((joint.min..=joint.max).contains(&(angle * (180.0 / PI))), "{:?}", hand.angles);
            }
        }
    }
}
