//! Formulas against numbers and matrices worked out by hand, and what must hold for any posture of any such arm.

use std::f64::consts::PI;

use nalgebra::{Isometry3, Unit, UnitQuaternion, Vector3};

use crate::{arm::ArmScene, kernel::rng::Stream, shipped};

use super::*;

type Matrix = [[f64; 4]; 4];

fn arm_of(scene: &str) -> Arm {
    shipped(scene).unwrap().get::<ArmScene>().unwrap().arm.clone()
}

fn paper() -> Arm {
    arm_of("arm-cuboid")
}

fn random(arm: &Arm, stream: &mut Stream) -> Posture {
    arm.joints.map(|joint| stream.between(joint.min, joint.max).to_radians())
}

fn random_direction(stream: &mut Stream) -> Unit<Vector3<f64>> {
    Unit::new_normalize(Vector3::new(stream.normal(), stream.normal(), stream.normal()))
}

fn within_limits(arm: &Arm, posture: &Posture) -> bool {
    arm.joints.iter().zip(posture).all(|(joint, &angle)| joint.min.to_radians() <= angle && angle <= joint.max.to_radians())
}

/// The larger of how far the tips are apart, and the columns of the rotations.
fn off(a: &Isometry3<f64>, b: &Isometry3<f64>) -> f64 {
    let turned = (a.rotation.to_rotation_matrix().matrix() - b.rotation.to_rotation_matrix().matrix()).abs().max();
    (a.translation.vector - b.translation.vector).norm().max(turned)
}

/// How far a posture is from another, whole turns not counted.
fn apart(a: &Posture, b: &Posture) -> f64 {
    let turned = a.iter().zip(b).map(|(a, b)| (a - b) - 2.0 * PI * ((a - b) / (2.0 * PI)).round());
    turned.map(f64::abs).fold(0.0, f64::max)
}

/// [ARM-RRT](crate#papers) §2: [a1 + d4 + a6, 0, a2 + a3].
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

fn product(a: &Matrix, b: &Matrix) -> Matrix {
    [0, 1, 2, 3].map(|i| [0, 1, 2, 3].map(|j| (0..4).map(|k| a[i][k] * b[k][j]).sum()))
}

/// The six matrices of the paper's arm, written out from its Table 1.
fn by_hand(t: &Posture) -> [Matrix; 6] {
    let s = t.map(crate::math::sin);
    let c = t.map(crate::math::cos);
    let last = [0.0, 0.0, 0.0, 1.0];
    [
        [[c[0], -s[0], 0.0, 0.0], [s[0], c[0], 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], last],
        [[c[1], -s[1], 0.0, 0.085], [0.0, 0.0, 1.0, 0.0], [-s[1], -c[1], 0.0, 0.0], last],
        [[c[2], -s[2], 0.0, 0.38], [s[2], c[2], 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], last],
        [[c[3], -s[3], 0.0, 0.1], [0.0, 0.0, 1.0, 0.425], [-s[3], -c[3], 0.0, 0.0], last],
        [[c[4], -s[4], 0.0, 0.0], [0.0, 0.0, -1.0, 0.0], [s[4], c[4], 0.0, 0.0], last],
        [[c[5], -s[5], 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [-s[5], -c[5], 0.0, 0.0], last],
    ]
}

fn assert_frame(frame: &Isometry3<f64>, matrix: &Matrix) {
    let found = frame.to_homogeneous();
    for (i, row) in matrix.iter().enumerate() {
        assert!(row.iter().enumerate().all(|(j, x)| (found[(i, j)] - x).abs() < 1e-12), "{found} {matrix:?}");
    }
}

/// [ARM-RRT](crate#papers) (1), each frame of the product.
#[test]
fn frames_are_the_products_of_matrices_written_out_by_hand() {
    let (arm, mut stream) = (paper(), Stream::new(2, 0));
    for _ in 0..1000 {
        let posture = random(&arm, &mut stream);
        let frames = arm.forward(&posture);
        let [x, y, z] = arm.base.position;
        let mut at = [[1.0, 0.0, 0.0, x], [0.0, 1.0, 0.0, y], [0.0, 0.0, 1.0, z], [0.0, 0.0, 0.0, 1.0]];
        for (frame, link) in frames.iter().zip(by_hand(&posture)) {
            at = product(&at, &link);
            assert_frame(frame, &at);
        }
        let tool = [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.085], [0.0, 0.0, 0.0, 1.0]];
        assert_frame(&frames[6], &product(&at, &tool));
        let skeleton = arm.skeleton(&posture);
        for (at, frame) in skeleton[1..].iter().zip([1, 2, 3, 6]) {
            assert!((Vector3::from(*at) - frames[frame].translation.vector).norm() < 1e-15);
        }
    }
}

/// Checks so many poses that an arm can take; gives the most solutions that one had.
fn round_trips(arm: &Arm, poses: u32, seed: u64) -> usize {
    let mut stream = Stream::new(seed, 0);
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
        assert!(limited.iter().all(|found| within_limits(arm, found)));
        for list in [&limited, &all] {
            let nearest = list.iter().map(|found| apart(found, &posture)).fold(f64::INFINITY, f64::min);
            // Where two solutions fall together an angle has half the digits of the pose.
            assert!(nearest < 1e-6, "{nearest:e} {posture:?} {list:?}");
        }
        assert!(limited.is_sorted_by(|a, b| distance(a, &near) <= distance(b, &near)));
        most = most.max(limited.len());
    }
    most
}

#[test]
fn forward_of_every_inverse_is_the_pose_for_the_papers_arm() {
    assert_eq!(round_trips(&paper(), 100_000, 1), 8);
}

#[test]
fn forward_of_every_inverse_is_the_pose_for_the_puma() {
    assert_eq!(round_trips(&arm_of("arm-puma"), 100_000, 1), 8);
}

/// Every choice of signs of α, with lengths and offsets of either sign in every place that has one, and a turned base.
#[test]
fn any_signs_and_offsets_are_solved() {
    let mut stream = Stream::new(3, 0);
    for signs in 0..16_u32 {
        for axis in Axis::ALL {
            let mut arm = paper();
            for (bit, i) in [1, 3, 4, 5].into_iter().enumerate() {
                arm.joints[i].alpha = if signs >> bit & 1 == 0 { 90.0 } else { -90.0 };
            }
            for i in 1..4 {
                arm.joints[i].a = stream.between(-0.5, 0.5);
            }
            for i in [0, 1, 2, 3, 5] {
                arm.joints[i].d = stream.between(-0.3, 0.3);
            }
            for joint in &mut arm.joints {
                (joint.min, joint.max) = (-200.0, 190.0);
            }
            arm.tool = Tool { axis, length: stream.between(0.0, 0.2) };
            arm.base.yaw = stream.between(-180.0, 180.0);
            assert_eq!(arm.check(), Ok(()));
            assert!(round_trips(&arm, 200, u64::from(signs)) >= 4);
        }
    }
}

#[test]
fn a_pose_has_up_to_eight_solutions_and_their_order_follows_what_is_near() {
    let arm = paper();
    let posture = radians(&[10.0, -60.0, 20.0, 40.0, 50.0, 30.0]);
    let [.., pose] = arm.forward(&posture);
    let all = arm.inverse_all(&pose, &posture).unwrap();
    assert_eq!(all.len(), 8);
    for wanted in &all {
        assert!(apart(&arm.inverse_all(&pose, wanted).unwrap()[0], wanted) < 1e-9);
    }
    // Joint 6 has two turns: the one that is nearer.
    for (at, expected) in [(330.0, 30.0), (-330.0, -330.0), (30.0, 30.0), (-150.1, -330.0)] {
        let solutions = arm.inverse(&pose, &radians(&[10.0, -60.0, 20.0, 40.0, 50.0, at])).unwrap();
        let same = solutions.iter().find(|found| apart(found, &posture) < 1e-9).unwrap();
        assert!((same[5].to_degrees() - expected).abs() < 1e-9, "{at}: {same:?}");
    }
}

/// The wrist stretched: only θ4 + θ6 counts (α4 = −α5 here), and both move by the same amount.
#[test]
fn a_singular_wrist_shares_what_is_missing_between_joints_4_and_6() {
    let arm = paper();
    let stretched = |q4: f64, q6: f64| radians(&[20.0, -50.0, 30.0, q4, 0.0, q6]);
    let angles = |pose: &Isometry3<f64>, near: &Posture| arm.inverse(pose, near).unwrap()[0].map(f64::to_degrees);
    let [.., pose] = arm.forward(&stretched(50.0, 20.0));
    for (near, expected) in [
        ([50.0, 20.0], [50.0, 20.0]),
        ([10.0, 20.0], [30.0, 40.0]),
        ([0.0, 0.0], [35.0, 35.0]),
        // Joint 4 comes to its limit, 160: joint 6 takes the rest.
        ([160.0, -130.0], [160.0, -90.0]),
        ([-100.0, 190.0], [-110.0, 180.0]),
        // A whole turn less is nearer.
        ([-130.0, -150.0], [-135.0, -155.0]),
    ] {
        let found = angles(&pose, &stretched(near[0], near[1]));
        let both = [found[3], found[5]];
        assert!((both[0] - expected[0]).abs() < 1e-9 && (both[1] - expected[1]).abs() < 1e-9, "{near:?}: {both:?}");
        assert_eq!(found[4], 0.0);
    }
    // With α4 = α5 their difference counts, and they move by opposite amounts.
    let mut turned = paper();
    turned.joints[5].alpha = 90.0;
    let [.., pose] = turned.forward(&stretched(50.0, 20.0));
    let found = turned.inverse(&pose, &stretched(30.0, 20.0)).unwrap()[0].map(f64::to_degrees);
    assert!((found[3] - 40.0).abs() < 1e-9 && (found[5] - 10.0).abs() < 1e-9, "{found:?}");
}

/// Near the singularity too, and on both sides of the tolerance, a solution is a solution.
#[test]
fn nearly_singular_poses_keep_nine_digits() {
    let (arm, mut stream) = (paper(), Stream::new(4, 0));
    for exponent in 1..160 {
        for _ in 0..20 {
            let mut posture = random(&arm, &mut stream);
            posture[4] = crate::math::exp(-0.25 * f64::from(exponent));
            let [.., pose] = arm.forward(&posture);
            let near = random(&arm, &mut stream);
            for found in &arm.inverse(&pose, &near).unwrap() {
                assert!(off(&pose, &arm.forward(found)[6]) < 1e-9, "{posture:?} {found:?}");
            }
        }
    }
}

/// The wrist on the first joint's axis: that joint stays where it was.
#[test]
fn with_the_wrist_above_the_shoulder_joint_1_stays() {
    let arm = paper();
    let [x, y, z] = arm.base.position;
    let near = radians(&[33.0, -60.0, 20.0, 10.0, 20.0, 30.0]);
    let pose = Isometry3::translation(x, y, z + 0.6);
    let solutions = arm.inverse_all(&pose, &near).unwrap();
    assert!(solutions.iter().any(|found| found[0] == near[0]), "{solutions:?}");
    assert!(solutions.iter().all(|found| off(&pose, &arm.forward(found)[6]) < 1e-9));
}

#[test]
fn a_limit_is_kept_and_may_be_reached() {
    let arm = paper();
    let mut stream = Stream::new(5, 0);
    for i in 0..6 {
        for end in [arm.joints[i].min, arm.joints[i].max] {
            let mut posture = random(&arm, &mut stream);
            posture[i] = end.to_radians();
            let [.., pose] = arm.forward(&posture);
            let found = arm.inverse(&pose, &posture).unwrap();
            assert!(apart(&found[0], &posture) < 1e-9 && within_limits(&arm, &found[0]), "{i}: {found:?}");
        }
    }
}

#[test]
fn what_cannot_be_reached_says_why() {
    let arm = paper();
    let home = arm.home();
    let [x, y, z] = arm.base.position;
    let at = |point: [f64; 3], direction: Vector3<f64>| arm.reaching(point, &Unit::new_normalize(direction), &home);
    // a1 + a2 + √(a3² + d4²) + the tool = 0.9866 is as far as the tip comes.
    let reach = 0.085 + 0.38 + (0.1_f64 * 0.1 + 0.425 * 0.425).sqrt() + 0.085;
    assert_eq!(at([x + reach + 1e-6, y, z], Vector3::x()), Err(Unreachable::Position));
    assert!(at([x + reach - 1e-6, y, z], Vector3::x()).is_ok());
    assert_eq!(at([x + reach - 1e-6, y, z], Vector3::z()), Err(Unreachable::Orientation));
    assert_eq!(at([x, y, z + 5.0], Vector3::z()), Err(Unreachable::Position));
    // Straight behind the base, as far as it comes: joint 1 ends at 170°, and cannot bend backwards.
    assert_eq!(at([x - reach + 1e-6, y, z], -Vector3::x()), Err(Unreachable::Limits));
    let mut free = arm.clone();
    free.joints[0].max = 180.0;
    assert!(free.reaching([x - reach + 1e-6, y, z], &-Vector3::x_axis(), &home).is_ok());

    for (why, field) in [(Unreachable::Position, "position"), (Unreachable::Orientation, "orientation"), (Unreachable::Limits, "limits")] {
        assert_eq!((why.name(), why.refusal().field()), (field, field));
        assert!(!why.to_string().is_empty());
    }
}

/// Position or orientation, against many directions tried, most in the plane of the base's axis, where the borders are: of a tool long enough that its tip does not reach everywhere
/// inside either, and of an arm with an offset, which leaves a column about its axis.
#[test]
fn no_other_direction_helps_where_the_position_is_at_fault() {
    let mut stream = Stream::new(6, 0);
    let (mut long, mut puma) = (paper(), arm_of("arm-puma"));
    long.joints[2].a = 0.9;
    puma.joints[1].d = 0.3;
    let mut seen = [0; 2];
    for (arm, radius) in [(&paper(), 1.0), (&long, 1.5), (&puma, 1.2)] {
        let home = arm.home();
        let mut tried = 0;
        while tried < 100 {
            let base = Vector3::from(arm.base.position);
            let tip = base + Vector3::from_fn(|_, _| stream.between(-radius, radius));
            let pose = |direction: &Unit<Vector3<f64>>| {
                let turned = UnitQuaternion::rotation_between(&Vector3::z(), direction).unwrap_or_else(UnitQuaternion::identity);
                Isometry3::from_parts(tip.into(), turned)
            };
            let Err(why) = arm.inverse_all(&pose(&random_direction(&mut stream)), &home) else {
                continue;
            };
            tried += 1;
            let outward = (tip - base).component_mul(&Vector3::new(1.0, 1.0, 0.0)).normalize();
            let mut directions = (0..1100).map(|i| match f64::from(i) * (PI / 450.0) {
                angle if i < 900 => Unit::new_normalize(outward * crate::math::cos(angle) + Vector3::z() * crate::math::sin(angle)),
                _ => random_direction(&mut stream),
            });
            let helps = directions.any(|direction| arm.inverse_all(&pose(&direction), &home).is_ok());
            drop(directions);
            assert_eq!(why, if helps { Unreachable::Orientation } else { Unreachable::Position }, "{tip:?}");
            seen[usize::from(helps)] += 1;
        }
    }
    assert!(seen.iter().all(|&n| n > 25), "{seen:?}");
}

#[test]
fn the_tool_points_where_it_should_and_joint_6_stays() {
    let mut stream = Stream::new(7, 0);
    for axis in Axis::ALL {
        let mut arm = arm_of("arm-puma");
        arm.tool = Tool { axis, length: 0.08 };
        let mut found = 0;
        for _ in 0..300 {
            let near = random(&arm, &mut stream);
            let tip = arm.skeleton(&random(&arm, &mut stream))[4];
            let direction = random_direction(&mut stream);
            let Ok(solutions) = arm.reaching(tip, &direction, &near) else {
                continue;
            };
            found += 1;
            for posture in &solutions {
                assert!((Vector3::from(arm.skeleton(posture)[4]) - Vector3::from(tip)).norm() < 1e-9);
                assert!((arm.pointing(posture) - direction.into_inner()).norm() < 1e-9);
                assert!(within_limits(&arm, posture) && (axis != Axis::Z || posture[5] == near[5]));
            }
        }
        assert!(found > 50, "{axis:?}: {found}");
    }
}

#[test]
fn nothing_panics_on_numbers_that_are_none() {
    let arm = paper();
    for bad in [f64::NAN, f64::INFINITY, -f64::INFINITY, 1e300, f64::MIN_POSITIVE] {
        let pose = Isometry3::translation(bad, 0.5, 0.5);
        let _ = arm.inverse(&pose, &[bad; 6]);
        let _ = arm.inverse_all(&pose, &[bad; 6]);
        let home = arm.forward(&arm.home())[6];
        let found = arm.inverse(&home, &[bad; 6]).unwrap();
        assert!(found.iter().all(|posture| within_limits(&arm, posture) && off(&home, &arm.forward(posture)[6]) < 1e-9));
        let _ = arm.reaching([bad; 3], &Unit::new_unchecked(Vector3::repeat(bad)), &arm.home());
        let _ = arm.forward(&[bad; 6]);
    }
}

#[test]
fn start_and_goal_of_every_arms_scene_are_reached_with_the_straight_line_between_them() {
    for name in ["arm-cuboid", "arm-free", "arm-puma"] {
        let scene = shipped(name).unwrap();
        let scene = scene.get::<ArmScene>().unwrap();
        for i in 0..=20 {
            let t = f64::from(i) / 20.0;
            let point = [0, 1, 2].map(|axis| scene.start[axis] + t * (scene.goal[axis] - scene.start[axis]));
            assert!(scene.arm.reaching_somehow(point, &scene.arm.home()).is_ok(), "{name}: {point:?}");
        }
    }
}
