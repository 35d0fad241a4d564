//! Formulas against numbers worked out by hand, and what must hold for any posture.

use std::f64::consts::PI;

use nalgebra::{Isometry3, Matrix4, Unit, Vector3};

use crate::{rng::Stream, shipped};

use super::*;

fn paper() -> Arm {
    shipped("arm-cuboid").unwrap().arm().unwrap().arm.clone()
}

fn random(arm: &Arm, stream: &mut Stream) -> Posture {
    arm.joints.map(|joint| stream.between(joint.min, joint.max).to_radians())
}

/// The larger of how far the tips are apart, and the columns of the rotations.
fn off(a: &Isometry3<f64>, b: &Isometry3<f64>) -> f64 {
    let turned = (a.rotation.to_rotation_matrix().matrix() - b.rotation.to_rotation_matrix().matrix()).abs().max();
    (a.translation.vector - b.translation.vector).norm().max(turned)
}

/// How far a posture is from another, whole turns not counted.
fn apart(a: &Posture, b: &Posture) -> f64 {
    a.iter().zip(b).map(|(a, b)| ((a - b) / (2.0 * PI)).round().mul_add(-2.0 * PI, a - b).abs()).fold(0.0, f64::max)
}

/// [ARM-RRT] §4.1: [a1 + d4 + a6, 0, a2 + a3].
#[test]
fn at_home_the_tip_is_where_the_paper_says() {
    let arm = paper();
    let skeleton = arm.skeleton(&arm.home());
    let from_base = |at: [f64; 3]| [0, 1, 2].map(|i| at[i] - arm.base.position[i]);
    let expected = [[0.0; 3], [0.085, 0.0, 0.0], [0.085, 0.0, 0.38], [0.51, 0.0, 0.48], [0.595, 0.0, 0.48]];
    for (at, expected) in skeleton.map(from_base).into_iter().zip(expected) {
        assert!((0..3).all(|i| (at[i] - expected[i]).abs() < 1e-12), "{at:?} {expected:?}");
    }
}

fn check_round_trip(arm: &Arm, poses: u32) {
    let mut stream = Stream::new(1, 0);
    let mut most = 0;
    for _ in 0..poses {
        let (posture, near) = (random(arm, &mut stream), random(arm, &mut stream));
        let [.., pose] = arm.forward(&posture);
        let limited = arm.inverse(&pose, &near).unwrap();
        let all = arm.inverse_all(&pose, &near).unwrap();
        for found in limited.iter().chain(&*all) {
            let error = off(&pose, &arm.forward(found)[6]);
            assert!(error < 1e-9, "{error:e} {posture:?} {found:?}");
        }
        for list in [&limited, &all] {
            let nearest = list.iter().map(|found| apart(found, &posture)).fold(f64::INFINITY, f64::min);
            assert!(nearest < 1e-5, "{nearest:e} {posture:?} {list:?}");
        }
        assert!(limited.is_sorted_by(|a, b| distance(a, &near) <= distance(b, &near)));
        most = most.max(all.len());
    }
    assert_eq!(most, 8);
}

#[test]
fn forward_of_inverse_is_the_pose() {
    check_round_trip(&paper(), 100_000);
}
