use std::f64::consts::PI;

use super::*;
use crate::{arm::radians, kernel::rng::Stream, shipped};

fn scene(cuboids: &[Cuboid]) -> ArmScene {
    let shipped = shipped("arm-free").unwrap();
    let mut scene = shipped.get::<ArmScene>().unwrap().clone();
    scene.cuboids = cuboids.to_vec();
    scene
}

fn cube(center: [f64; 3], half: f64) -> Cuboid {
    Cuboid { min: center.map(|x| x - half), max: center.map(|x| x + half) }
}

/// At home the upper arm stands at (0.385, 0.65) from z = 0.4 to 0.78, and the forearm rises by 0.1 on 0.425 from there.
#[test]
fn at_home_a_cuboid_below_the_forearm_and_one_beside_the_upper_arm_are_as_far_as_they_are() {
    let scene = scene(&[cube([0.885, 0.65, 0.6], 0.1)]);
    let home = scene.arm.skeleton(&scene.arm.home());
    // The edge at (0.785, 0.7) is (0.4, −0.08) from the elbow: across the forearm that is (0.4 · 0.1 + 0.08 · 0.425) / |(0.425, 0.1)|.
    let expected = 0.074 / 0.190_625_f64.sqrt();
    assert!((clearance(&scene, &home, 0.0).unwrap() - expected).abs() < 1e-12);
    let mut beside = scene.clone();
    beside.cuboids = vec![cube([0.585, 0.65, 0.6], 0.1)];
    assert!((clearance(&beside, &home, 0.0).unwrap() - 0.1).abs() < 1e-12);
    assert!((clearance(&beside, &home, 0.03).unwrap() - 0.07).abs() < 1e-12);
    assert!(!touches(&beside, &home, 0.0999) && touches(&beside, &home, 0.1001));
    beside.cuboids = vec![cube([0.485, 0.65, 0.6], 0.1)];
    assert!(touches(&beside, &home, 0.0), "a face against the upper arm's segment: to touch is to collide");
    assert_eq!(clearance(&beside, &home, 0.02), Some(-0.02));
    beside.cuboids.clear();
    assert_eq!(clearance(&beside, &home, 0.02), None);
}

/// The column's radius is 0.08 and the shoulder is 0.085 from its axis, level with its top.
#[test]
fn the_upper_arm_may_stand_at_its_mount_but_not_lean_in() {
    let scene = scene(&[]);
    let arm = &scene.arm;
    for radius in [0.0, 0.02] {
        let touch = |degrees: [f64; 6]| touches(&scene, &arm.skeleton(&radians(&degrees)), radius);
        assert!(!touch([0.0, -90.0, 0.0, 0.0, 0.0, 0.0]), "upright");
        assert!(!touch([30.0, 0.0, 0.0, 0.0, 0.0, 0.0]), "stretched out");
        assert!(touch([30.0, 120.0, -90.0, 0.0, 0.0, 0.0]), "down, and in");
    }
    // Straight down it is as near as its mount: 0.085 from the axis all along.
    assert!(!touches(&scene, &arm.skeleton(&radians(&[0.0, 90.0, -90.0, 0.0, 0.0, 0.0])), 0.004));
    let reach = |from: f64, to: f64| {
        motion_is_free(&scene, &radians(&[0.0, from, -90.0, 0.0, 0.0, 0.0]), &radians(&[0.0, to, -90.0, 0.0, 0.0, 0.0]), 0.0, 1e-3)
    };
    assert!(reach(-90.0, 80.0) && reach(80.0, -90.0) && !reach(-90.0, 120.0));
}

#[test]
fn the_column_is_an_obstacle_of_forearm_tool_and_tip() {
    let scene = scene(&[]);
    let column = column(&scene).unwrap();
    assert_eq!((column.axis.min, column.axis.max, column.radius), ([0.3, 0.65, 0.0], [0.3, 0.65, 0.4], 0.08));
    assert!(segment_meets_column(&scene, [0.0, 0.73, 0.2], [0.6, 0.73, 0.2]), "it touches");
    assert!(!segment_meets_column(&scene, [0.0, 0.7301, 0.2], [0.6, 0.7301, 0.2]));
    assert!(!segment_meets_column(&scene, [0.0, 0.65, 0.4801], [0.6, 0.65, 0.4801]), "above its round top");
    let mut bare = scene.clone();
    bare.arm.base.column_radius = 0.0;
    assert_eq!(super::column(&bare), None);
    let posture = |theta3| scene.arm.skeleton(&radians(&[0.0, 0.0, theta3, 0.0, 0.0, 0.0]));
    // The elbow is 0.465 in front of the axis; from there the forearm goes back 0.1 below, and the tool goes through the column.
    assert!(touches(&scene, &posture(90.0), 0.0) && !touches(&bare, &posture(90.0), 0.5));
    assert!(!touches(&scene, &posture(-90.0), 0.0), "forwards, away from it");
}

/// The distance of the links' points from what they must not touch, a point every 2 mm, computed without the module.
fn room_at(scene: &ArmScene, skeleton: &Skeleton) -> f64 {
    let norm = |x: [f64; 3]| (x[0] * x[0] + x[1] * x[1] + x[2] * x[2]).sqrt();
    let apart = |p: [f64; 3], low: [f64; 3], high: [f64; 3]| norm([0, 1, 2].map(|i| p[i] - p[i].clamp(low[i], high[i])));
    let [x, y, top] = scene.arm.base.position;
    let mut least = f64::INFINITY;
    for (link, ends) in skeleton.windows(2).enumerate() {
        let n = (norm([0, 1, 2].map(|i| ends[1][i] - ends[0][i])) / 0.002).ceil();
        for k in 0..=n as u32 {
            let p = [0, 1, 2].map(|i| ends[0][i] + (ends[1][i] - ends[0][i]) * f64::from(k) / n.max(1.0));
            scene.cuboids.iter().for_each(|c| least = least.min(apart(p, c.min, c.max)));
            if link > 0 {
                least = least.min(apart(p, [x, y, 0.0], [x, y, top]) - scene.arm.base.column_radius);
            }
        }
    }
    least
}

/// Each joint turns what follows it by as much as it is far from that joint's axis, at most.
#[test]
fn what_links_travel_is_the_sum_of_what_each_joint_turns_them() {
    let scene = scene(&[]);
    let links = Links::new(&scene, 0.0);
    let [base, upper, fore, tool] = links.lengths;
    let turned = |joint: usize| {
        let mut turn = [0.0; 6];
        turn[joint] = 0.5;
        links.travel(turn).all.map(|far| 2.0 * far)
    };
    let expected = [
        [base, base + upper, base + upper + fore, base + upper + fore + tool],
        [0.0, upper, upper + fore, upper + fore + tool],
        [0.0, 0.0, fore, fore + tool],
        [0.0, 0.0, 0.0, tool],
        [0.0, 0.0, 0.0, tool],
        [0.0; 4],
    ];
    for (joint, expected) in expected.into_iter().enumerate() {
        let found = turned(joint);
        assert!(found.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-12), "joint {}: {found:?} {expected:?}", joint + 1);
    }
    let all = links.travel([0.5; 6]).all;
    for (link, far) in all.into_iter().enumerate() {
        let sum: f64 = (0..6).map(|joint| 0.5 * turned(joint)[link]).sum();
        assert!((far - sum).abs() < 1e-12, "link {link}: {far} {sum}");
    }
    assert!(links.spins, "the tool is on the last joint's axis");
}

/// The upper arm alone, against 2,000 samples of each turn of the second joint: as its column is, and with a thin one, which it may pass
/// in a part of a turn that does not have the turn's middle.
#[test]
fn an_upper_arm_that_keeps_off_leans_in_at_no_sample() {
    let scene = scene(&[]);
    let mut links = Links::new(&scene, 0.003);
    let column = links.column.unwrap();
    let mut random = Stream::new(11, 0);
    for mount in [links.mount, 0.02] {
        links.mount = mount;
        let (mut counts, mut through) = ([0; 2], 0);
        for _ in 0..300 {
            let from = random.between(-PI, PI);
            let to = from + random.between(-6.0, 6.0);
            let samples = (0..=2000).map(|k| from + (to - from) * f64::from(k) / 2000.0);
            let leans = samples.filter(|&theta2| links.leans_in(&column, links.upper_arm(theta2))).count();
            let keeps_off = links.upper_arm_keeps_off(from, to, 1e-6);
            // Within a thousandth of a turn it may be between two samples.
            assert!(if keeps_off { leans == 0 } else { leans > 0 }, "{from} to {to}: {leans} samples lean in");
            counts[usize::from(keeps_off)] += 1;
            let ends_keep_off = [from, to].iter().all(|&theta2| !links.leans_in(&column, links.upper_arm(theta2)));
            through += u32::from(leans > 0 && ends_keep_off);
        }
        assert!(counts.iter().all(|&count| count > 50) && through > 20, "{counts:?}, {through} lean in on their way: all are tested");
    }
}

/// Random motions among cuboids against 400 samples of each.
#[test]
fn a_motion_is_free_if_none_of_many_samples_touches() {
    let mut random = Stream::new(7, 0);
    let mut frees = 0;
    for round in 0..150 {
        let cuboids: Vec<_> =
            (0..3).map(|_| cube([random.between(-0.3, 1.0), random.between(0.0, 1.2), random.between(0.0, 0.9)], 0.1)).collect();
        let scene = scene(&cuboids);
        let posture = |random: &mut Stream| scene.arm.joints.map(|j| random.between(j.min, j.max) * (PI / 180.0));
        let from = posture(&mut random);
        let to = std::array::from_fn(|i| from[i] + random.between(-0.5, 0.5));
        let (radius, resolution, samples) = (0.003, 0.002, 400);
        let room = (0..=samples)
            .map(|k| from.iter().zip(to).map(|(a, b)| a + (b - a) * f64::from(k) / f64::from(samples)).collect::<Vec<_>>())
            .map(|q| room_at(&scene, &scene.arm.skeleton(&q.try_into().unwrap())))
            .fold(f64::INFINITY, f64::min);
        let free = motion_is_free(&scene, &from, &to, radius, resolution);
        // A sample is at most 5 mm of travel from the next, and a point 2 mm from its neighbour.
        assert!(!free || room > radius - 0.5 * resolution, "round {round}: {room} {from:?} {to:?}");
        assert!(free || room < radius + 0.005, "round {round}: {room} {from:?} {to:?}");
        assert_eq!(free, motion_is_free(&scene, &to, &from, radius, resolution));
        frees += u32::from(free);
    }
    assert!((20..130).contains(&frees), "{frees} of 150 are free: both answers are tested");
}

/// A wall 2 mm thick in the middle of a turn that both ends keep clear of.
#[test]
fn nothing_is_jumped_over() {
    let scene = scene(&[Cuboid { min: [0.6, 0.649, 0.3], max: [0.9, 0.651, 0.9] }]);
    let at = |theta1: f64| radians(&[theta1, -90.0, 0.0, 0.0, 0.0, 0.0]);
    for (from, to, free) in [(-80.0, 80.0, false), (-80.0, -1.0, true), (80.0, 1.0, true), (-0.05, 0.1, false)] {
        assert_eq!(motion_is_free(&scene, &at(from), &at(to), 0.0, 0.5), free, "{from}° to {to}°");
    }
}

#[test]
fn what_is_no_number_is_not_free_and_ends() {
    let scene = scene(&[cube([0.5; 3], 0.1)]);
    let home = scene.arm.home();
    for bad in [f64::NAN, f64::INFINITY, -f64::INFINITY] {
        assert!(!motion_is_free(&scene, &home, &[bad; 6], 0.0, 1e-3));
    }
    for resolution in [f64::NAN, 0.0, -1.0, f64::INFINITY] {
        assert!(motion_is_free(&scene, &home, &home, 0.0, resolution));
    }
}
