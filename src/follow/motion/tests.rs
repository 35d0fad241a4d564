use std::sync::Arc;

use super::{
    parameters::{SPEED, TOOL_SPEED},
    *,
};
use crate::{
    arm::{ArmScene, Posture, radians},
    geometry::Cuboid,
    params::{Domain, Value},
    run::{Run, Setup},
    shipped, standard,
};

const COLUMNS: usize = 12;

/// Close over the cuboid's top, and round its side.
const OVER: [[f64; 3]; 4] = [[-0.2, 0.022, 0.05], [0.245, 0.29, 0.335], [0.455, 0.43, 0.335], [0.9, 0.7, 0.3]];
const ROUND: [[f64; 3]; 4] = [[-0.2, 0.022, 0.05], [0.24, 0.19, 0.15], [0.47, 0.19, 0.2], [0.9, 0.7, 0.3]];

fn given(pairs: &[(&'static str, Value)]) -> Overrides {
    pairs.iter().cloned().collect()
}

fn follow(scene: &Scene, path: &[[f64; 3]], pairs: &[(&'static str, Value)]) -> Motion {
    let solution = Solution::Reach { path: path.to_vec(), postures: Vec::new() };
    along(scene, Some(&solution), &given(pairs)).unwrap().unwrap()
}

fn with_cuboids(cuboids: &[Cuboid]) -> Scene {
    let text = shipped("arm-free").unwrap().to_json();
    let mut json: serde_json::Value = serde_json::from_str(&text).unwrap();
    json["cuboids"] = cuboids.iter().map(|c| serde_json::json!({ "min": c.min, "max": c.max })).collect();
    standard().read_scene(&json.to_string()).unwrap()
}

fn rows(motion: &Motion) -> Vec<&[f64]> {
    motion.rows.chunks_exact(COLUMNS).collect()
}

fn posture(row: &[f64]) -> Posture {
    radians(&row[5..11].try_into().unwrap())
}

/// The least distance of points of the links, 4 mm apart, from cuboids and column, in five postures between rows; from the
/// column those of the links from a given one on. Written anew.
fn room(scene: &ArmScene, motion: &Motion, first_off_column: usize) -> f64 {
    let apart = |p: [f64; 3], low: [f64; 3], high: [f64; 3]| {
        let [x, y, z] = [0, 1, 2].map(|i| p[i] - p[i].clamp(low[i], high[i]));
        (x * x + y * y + z * z).sqrt()
    };
    let ([x, y, top], thick) = (scene.arm.base.position, scene.arm.base.column_radius);
    let mut least = f64::INFINITY;
    for pair in rows(motion).windows(2) {
        let (from, to) = (posture(pair[0]), posture(pair[1]));
        for share in [0.0, 0.2, 0.4, 0.6, 0.8, 1.0] {
            let skeleton = scene.arm.skeleton(&std::array::from_fn(|i| from[i] + share * (to[i] - from[i])));
            for (link, ends) in skeleton.windows(2).enumerate() {
                for k in 0..=100 {
                    let p = [0, 1, 2].map(|i| ends[0][i] + (ends[1][i] - ends[0][i]) * f64::from(k) / 100.0);
                    scene.cuboids.iter().for_each(|c| least = least.min(apart(p, c.min, c.max)));
                    if link >= first_off_column {
                        least = least.min(apart(p, [x, y, 0.0], [x, y, top]) - thick);
                    }
                }
            }
        }
    }
    least
}

/// What must be so of every motion that arrives.
fn check(scene: &Scene, path: &[[f64; 3]], motion: &Motion) {
    let (arm, rows) = (&scene.get::<ArmScene>().unwrap().arm, rows(motion));
    let tip = |row: &[f64]| [row[2], row[3], row[4]];
    let near = |a: [f64; 3], b: [f64; 3]| (0..3).all(|i| (a[i] - b[i]).abs() < 1e-7);
    assert!(near(tip(rows[0]), path[0]) && near(tip(rows[rows.len() - 1]), path[path.len() - 1]));
    assert_eq!(motion.skeletons.len(), rows.len() * 15);
    for (row, joints) in motion.skeletons.chunks_exact(15).zip(&rows) {
        let skeleton = arm.skeleton(&posture(joints));
        assert!(skeleton.as_flattened().iter().zip(row).all(|(a, b)| (a - b).abs() < 1e-9));
        for (i, joint) in arm.joints.iter().enumerate() {
            assert!((joint.min - 1e-9..=joint.max + 1e-9).contains(&joints[5 + i]), "joint {} is {}", i + 1, joints[5 + i]);
        }
    }
    let (speed, tool) = (motion.parameters[SPEED], motion.parameters[TOOL_SPEED]);
    let (mut step, mut length) = (0.0_f64, 0.0);
    for pair in rows.windows(2) {
        let seconds = pair[1][0] - pair[0][0];
        let way = course::distance(tip(pair[0]), tip(pair[1]));
        // One limit is reached, and none is passed.
        let shares = (0..6).map(|i| (pair[1][5 + i] - pair[0][5 + i]).abs() / (arm.joints[i].speed * speed)).chain([way / tool]);
        let most = shares.fold(0.0, f64::max);
        assert!((most - seconds).abs() < 1e-9, "{most} {seconds}");
        step = (0..6).map(|i| (pair[1][5 + i] - pair[0][5 + i]).abs()).fold(step, f64::max);
        length += way;
    }
    let outcome = &motion.outcome;
    assert!((outcome.largest_step - step).abs() < 1e-9 && (outcome.length - length).abs() < 1e-9);
    assert_eq!(outcome.time, rows[rows.len() - 1][0]);
    assert_eq!(outcome.free, outcome.touched_at.is_none());
    assert!(!outcome.free || room(scene.get::<ArmScene>().unwrap(), motion, 1) > 0.0);
}

#[test]
fn the_whole_arm_goes_over_the_cuboid_and_round_it() {
    let scene = shipped("arm-cuboid").unwrap();
    for path in [OVER, ROUND] {
        let motion = follow(&scene, &path, &[]);
        check(&scene, &path, &motion);
        let outcome = &motion.outcome;
        assert!(outcome.arrived && outcome.free && outcome.failure.is_none(), "{outcome:?}");
        assert!(outcome.largest_step < 10.0 && outcome.max_error < 1e-3, "{outcome:?}");
        assert!((outcome.length - crate::geometry::length_in_space(&path)).abs() < 1e-3);
        assert_eq!((outcome.mirrored, outcome.drawn), (0, 0));
        assert!(outcome.clearance.unwrap() > 0.0);
        assert_eq!(motion, follow(&scene, &path, &[]), "the same again");
    }
}

#[test]
fn thick_links_keep_their_distance() {
    let scene = shipped("arm-cuboid").unwrap();
    let path = OVER.map(|[x, y, z]| [x, y, z + 0.1]);
    let motion = follow(&scene, &path, &[("radius", 0.04.into())]);
    check(&scene, &path, &motion);
    assert!(motion.outcome.arrived && motion.outcome.free, "{:?}", motion.outcome);
    // The upper arm is mounted 0.005 from the column, and stays so near.
    let room = room(scene.get::<ArmScene>().unwrap(), &motion, 2);
    assert!(motion.outcome.clearance.unwrap() > 0.0 && room > 0.04, "{room}");
}

/// From home a quarter turn of joint 1 takes 0.5 s at 180° a second; the tip's 0.595 m · π/2 at 0.5 m/s take 1.87 s, a little
/// less along the chords.
#[test]
fn planned_postures_are_gone_through_evenly() {
    let scene = shipped("arm-free").unwrap();
    let arm = &scene.get::<ArmScene>().unwrap().arm;
    let to = radians(&[90.0, -90.0, 0.0, 0.0, 0.0, 0.0]);
    let arc: Vec<_> = (0..=90).map(|i| arm.skeleton(&radians(&[f64::from(i), -90.0, 0.0, 0.0, 0.0, 0.0]))[4]).collect();
    let solution = Solution::Reach { path: arc.clone(), postures: vec![arm.home(), to] };
    let go = |pairs: &[(&'static str, Value)]| along(&scene, Some(&solution), &given(pairs)).unwrap().unwrap();
    let slow = go(&[]);
    check(&scene, &arc, &slow);
    assert!((slow.outcome.time - 0.595 * std::f64::consts::FRAC_PI_2 / 0.5).abs() < 1e-3, "{:?}", slow.outcome);
    assert_eq!(rows(&slow).len(), 95, "93.46 cm in pieces of at most 1 cm");
    assert!(slow.outcome.max_error < 1e-4 && slow.outcome.arrived && slow.outcome.free && slow.outcome.clearance.is_none());
    let fast = go(&[("tool_speed", 100.0.into()), ("spacing", 1.0.into())]);
    assert_eq!((rows(&fast).len(), fast.outcome.largest_step), (2, 90.0));
    assert!((fast.outcome.time - 0.5).abs() < 1e-12 && (fast.outcome.length - 0.595 * 2.0_f64.sqrt()).abs() < 1e-12);
    let halved = go(&[("tool_speed", 100.0.into()), ("speed", 0.5.into())]);
    assert!((halved.outcome.time - 1.0).abs() < 1e-12);
}

/// A wall at 45° in the way of that quarter turn: half-way, after 0.25 s, the forearm touches it.
#[test]
fn a_touch_between_rows_is_found_and_told() {
    let (x, y) = (0.3 + 0.4 * 0.5_f64.sqrt(), 0.65 + 0.4 * 0.5_f64.sqrt());
    let scene = with_cuboids(&[Cuboid { min: [x - 0.001, y - 0.001, 0.7], max: [x + 0.001, y + 0.001, 1.0] }]);
    let arm = &scene.get::<ArmScene>().unwrap().arm;
    let postures = vec![arm.home(), radians(&[90.0, -90.0, 0.0, 0.0, 0.0, 0.0])];
    let path = postures.iter().map(|posture| arm.skeleton(posture)[4]).collect();
    let solution = Solution::Reach { path, postures };
    let motion = along(&scene, Some(&solution), &given(&[("tool_speed", 100.0.into()), ("spacing", 1.0.into())])).unwrap().unwrap();
    assert!(!motion.outcome.free && motion.outcome.arrived && motion.outcome.clearance.unwrap() > 0.1);
    assert!((motion.outcome.touched_at.unwrap() - 0.25).abs() < 0.005, "{:?}", motion.outcome);
    // The chord from end to end is 0.595 (1 − √½) inside the arc.
    assert!((motion.outcome.max_error - 0.595 * (1.0 - 0.5_f64.sqrt())).abs() < 1e-3);
}

#[test]
fn a_path_that_nobody_can_follow_says_where_and_why() {
    let scene = shipped("arm-free").unwrap();
    let far = follow(&scene, &[[0.9, 0.7, 0.3], [5.0, 0.7, 0.3]], &[]);
    let failure = far.outcome.failure.as_ref().unwrap().text();
    assert!(!far.outcome.arrived && !far.rows.is_empty() && far.outcome.free, "{:?}", far.outcome);
    assert!(
        failure.starts_with(&format!("point {} of 411, (", rows(&far).len() + 1)) && failure.contains("the tip cannot reach this position"),
        "{failure}"
    );
    let nowhere = follow(&scene, &[[5.0; 3], [6.0; 3]], &[]);
    assert!(nowhere.rows.is_empty() && nowhere.skeletons.is_empty() && !nowhere.outcome.free && !nowhere.outcome.arrived);
    assert!(nowhere.outcome.failure.unwrap().text().starts_with("point 1 of "));
    let inside = with_cuboids(&[Cuboid { min: [0.7, 0.6, 0.2], max: [0.8, 0.8, 0.4] }]);
    let blocked = follow(&inside, &[[0.9, 0.7, 0.3], [0.75, 0.7, 0.3]], &[]);
    assert!(blocked.outcome.failure.unwrap().text().contains("touches a cuboid or the column") && blocked.outcome.free);
    assert_eq!(along(&scene, Some(&Solution::Reach { path: Vec::new(), postures: Vec::new() }), &Overrides::new()), Ok(None));
    assert_eq!(along(&scene, None, &Overrides::new()), Ok(None));
}

/// Three points, the middle one inside a cuboid: its mirror image is reached; with another cuboid there, joints are drawn.
#[test]
fn a_point_without_a_posture_is_mirrored_and_then_drawn() {
    let path = [[0.8, 0.5, 0.3], [0.75, 0.65, 0.3], [0.8, 0.8, 0.3]];
    let block = |x: f64| Cuboid { min: [x - 0.02, 0.6, 0.28], max: [x + 0.02, 0.7, 0.32] };
    let (one, two) = (with_cuboids(&[block(0.75)]), with_cuboids(&[block(0.75), block(0.85)]));
    for postures in ["smoothest", "nearest"] {
        let pairs = |tries: f64| [("spacing", Value::from(1.0)), ("postures", Value::from(postures)), ("tries", tries.into())];
        let mirrored = follow(&one, &path, &pairs(1000.0));
        let outcome = &mirrored.outcome;
        assert_eq!((outcome.mirrored, outcome.drawn, outcome.arrived), (1, 0, true), "{outcome:?}");
        let middle = rows(&mirrored)[1];
        // 0.1 from the point, and as far from the pieces to its neighbours: 0.1 · 0.15 / |(0.05, 0.15)|.
        let aside = 0.015 / 0.025_f64.sqrt();
        assert!(
            (middle[2] - 0.85).abs() < 1e-7 && (middle[3] - 0.65).abs() < 1e-7 && outcome.max_error >= aside - 1e-9,
            "{middle:?} {outcome:?}"
        );
        let drawn = follow(&two, &path, &pairs(1000.0));
        assert_eq!((drawn.outcome.mirrored, drawn.outcome.drawn, drawn.outcome.arrived), (0, 1, true), "{:?}", drawn.outcome);
        let [from, middle, to] = rows(&drawn)[..] else { panic!("three rows") };
        for i in 5..11 {
            assert!((from[i].min(to[i])..=from[i].max(to[i])).contains(&middle[i]), "between its neighbours");
        }
        let without = follow(&two, &path, &pairs(0.0));
        assert_eq!((rows(&without).len(), without.outcome.arrived), (1, false));
        assert!(without.outcome.failure.unwrap().text().starts_with("point 2 of 3, (0.7500, 0.6500, 0.3000)"));
        // Without replacement the motion ends even where a mirror image could be reached.
        let ended = follow(&one, &path, &[pairs(1000.0)[0].clone(), pairs(0.0)[1].clone(), ("replacement", "false".into())]);
        assert_eq!((rows(&ended).len(), ended.outcome.mirrored, ended.outcome.arrived), (1, 0, false));
    }
}

#[test]
fn the_tool_keeps_its_orientation_or_turns_at_random() {
    let scene = shipped("arm-free").unwrap();
    let arm = &scene.get::<ArmScene>().unwrap().arm;
    let path = [[0.85, 0.5, 0.5], [0.85, 0.8, 0.5]];
    let [.., home] = arm.forward(&arm.home());
    for postures in ["smoothest", "nearest"] {
        let held = follow(&scene, &path, &[("orientation", "home".into()), ("postures", postures.into())]);
        check(&scene, &path, &held);
        assert!(held.outcome.arrived && held.outcome.free, "{:?}", held.outcome);
        for row in rows(&held) {
            let [.., tip] = arm.forward(&posture(row));
            assert!(tip.rotation.angle_to(&home.rotation) < 1e-6);
        }
        let random = |seed: f64| {
            follow(
                &scene,
                &path,
                &[("orientation", "random".into()), ("spread", 0.3.into()), ("postures", postures.into()), ("seed", seed.into())],
            )
        };
        let motion = random(1.0);
        assert!(motion.outcome.arrived, "{:?}", motion.outcome);
        check(&scene, &path, &motion);
        assert!(motion == random(1.0) && motion.rows != random(2.0).rows);
        let turned = rows(&motion).into_iter().filter(|row| arm.forward(&posture(row))[6].rotation.angle_to(&home.rotation) > 0.05).count();
        assert!(turned > 20, "{turned} of 31 rows");
    }
    let smooth = follow(&scene, &path, &[("orientation", "home".into())]);
    let rough = follow(&scene, &path, &[("orientation", "random".into())]);
    assert!(smooth.outcome.largest_step < 10.0 && rough.outcome.largest_step > 20.0);
}

#[test]
fn every_parameter_has_both_its_ends() {
    let scene = shipped("arm-cuboid").unwrap();
    let path = [[0.9, 0.7, 0.3], [0.8, 0.5, 0.3]];
    for parameter in ENTRY.parameters.iter().copied().flatten() {
        let values: Vec<Value> = match parameter.domain {
            Domain::Number { min, max, .. } => vec![min.into(), max.into()],
            Domain::Integer { min, max, .. } => vec![(min as f64).into(), (max as f64).into()],
            Domain::Choice { options } => options.iter().map(|option| option.value.into()).collect(),
            Domain::Flag { .. } => vec!["true".into(), "false".into()],
            Domain::Subset { .. } => Vec::new(),
        };
        assert!(!values.is_empty());
        for value in values {
            let mut pairs = vec![(parameter.name, value.clone())];
            pairs.extend(parameter.when.map(|when| (when.parameter, Value::from(when.value))));
            let motion = follow(&scene, &path, &pairs);
            let (outcome, off) = (&motion.outcome, 0.01_f64.max(motion.parameters[SPACING]));
            // What does not arrive, or leaves the path, says so; nothing else does.
            let failed = !outcome.arrived || outcome.max_error > off;
            assert!(outcome.time.is_finite() && failed == outcome.failure.is_some(), "{} = {value}: {outcome:?}", parameter.name);
        }
    }
    let refused = along(&scene, None, &given(&[("spacing", 0.0.into())])).unwrap_err();
    assert_eq!(refused.field(), "spacing");
}

/// Straight lines between random points of the workspace, whatever stands in between.
#[test]
fn of_random_lines_every_motion_keeps_the_promises() {
    let mut random = Stream::new(11, 0);
    let scene: Arc<Scene> = shipped("arm-cuboid").unwrap();
    let mut free = 0;
    for _ in 0..30 {
        let mut point = || [random.between(0.5, 1.0), random.between(0.2, 1.0), random.between(0.1, 0.6)];
        let path = [point(), point()];
        let motion = follow(&scene, &path, &[("spacing", 0.02.into())]);
        if motion.outcome.arrived {
            check(&scene, &path, &motion);
            free += u32::from(motion.outcome.free);
        }
    }
    assert!(free >= 20, "{free} of 30");
}

/// How many of the paths that a tree finds on a scene the arm follows, seed by seed: nothing touches anything all the way, and no joint
/// jumps.
fn free_of(planner: &str, scene: &str, seeds: std::ops::RangeInclusive<u64>, params: &[(&'static str, Value)]) -> u32 {
    let mut free = 0;
    for seed in seeds {
        let setup = Setup { planner: planner.to_owned(), scene: shipped(scene).unwrap(), params: given(params), seed };
        let mut run = Run::with_keyframes(standard(), setup, 0).unwrap();
        run.step(run.limit());
        let outcome = run.outcome();
        assert!(outcome.feasible, "{planner}, seed {seed}");
        let &MotionOutcome { arrived, free: is_free, touched_at, largest_step, max_error, .. } = outcome.followed.get().unwrap();
        // What is not free says when it touches.
        assert_eq!(is_free, touched_at.is_none(), "seed {seed}");
        free += u32::from(arrived && is_free && largest_step < 20.0 && max_error < 1e-3);
    }
    free
}

/// Trees that ask the arm at each node: it follows nearly all. Those that ask the tip alone, as in the paper: not so.
#[test]
fn the_arm_follows_what_trees_find_that_ask_it() {
    let guided = free_of("rrt-guided", "arm-cuboid", 1..=100, &[]);
    assert!(guided >= 99, "{guided} of 100");
    for (planner, seeds) in [("rrt", 6), ("rrt-connect", 40), ("rrt-star", 3)] {
        assert_eq!(u64::from(free_of(planner, "arm-cuboid", 1..=seeds, &[])), seeds, "{planner}");
    }
    for planner in ["rrt-guided", "rrt-connect"] {
        for scene in ["arm-bench", "arm-puma"] {
            let free = free_of(planner, scene, 1..=20, &[]);
            assert!(free >= 19, "{planner}, {scene}: {free} of 20");
        }
    }
    let of_the_tip = free_of("rrt-star", "arm-cuboid", 10..=13, &[("reachable", Value::Flag(false))]);
    assert!(of_the_tip < 2, "{of_the_tip} of 4");
    let of_the_tip = free_of("rrt-guided", "arm-cuboid", 1..=20, &[("reachable", Value::Flag(false))]);
    assert!((15..20).contains(&of_the_tip), "{of_the_tip} of 20");
}
