//! Inverse kinematics of the PUMA against two independent libraries: no branch is lost, none is invented.
//!
//! `scripts/arm-ik.py` made the poses and the libraries' branches, and says how; `FORAGE_ARM_IK` names another file of it.

use std::{collections::BTreeMap, f64::consts::TAU, fs};

use forage::{
    arm::{Arm, ArmScene, Posture},
    math, shipped,
};
use nalgebra::{Isometry3, Matrix3, Rotation3, Translation3, UnitQuaternion, Vector3};

/// Branches of the same pose are the same branch up to this, in radians.
const SAME: f64 = 1e-6;
/// Where two branches meet, rounding of a pose in its last digits moves angles by the root of that, and more where several meet. Then also
/// the posture in the middle between two of them leads to the pose; of branches that differ it does not, unless they are nearer than
/// about a ten thousandth.
const MEETING: f64 = 1e-3;
/// Wrists that are so near to a singular one, in radians, are taken for it.
const SINGULAR: f64 = 1e-4;
/// How far forward kinematics may be from the pose, in metres, and in the entries of the rotation.
const CLOSE: f64 = 1e-9;

struct Sample {
    kind: usize,
    pose: [f64; 12],
    /// Of the posture that the pose was made of, and of each library.
    branches: [Vec<Posture>; 3],
}

fn samples(bytes: &[u8]) -> Vec<Sample> {
    let mut numbers = bytes.chunks_exact(8).map(|bytes| f64::from_le_bytes(bytes.try_into().unwrap()));
    let mut next = || numbers.next();
    let mut samples = Vec::new();
    while let Some(kind) = next() {
        let pose = std::array::from_fn(|_| next().unwrap());
        let branches = |count: Option<f64>, next: &mut dyn FnMut() -> Option<f64>| -> Vec<Posture> {
            let count = count.unwrap_or_else(|| next().unwrap()) as usize;
            (0..count).map(|_| std::array::from_fn(|_| next().unwrap())).collect()
        };
        let branches = [Some(1.0), None, None].map(|count| branches(count, &mut next));
        samples.push(Sample { kind: kind as usize, pose, branches });
    }
    samples
}

fn isometry(pose: &[f64; 12]) -> Isometry3<f64> {
    let at = |row: usize, column: usize| pose[4 * row + column];
    let rotation = Matrix3::from_fn(at);
    let rotation = UnitQuaternion::from_rotation_matrix(&Rotation3::from_matrix_unchecked(rotation));
    Isometry3::from_parts(Translation3::from(Vector3::new(at(0, 3), at(1, 3), at(2, 3))), rotation)
}

/// How far two angles are apart, whole turns aside.
fn apart(a: f64, b: f64) -> f64 {
    let turns = (a - b) / TAU;
    (turns - turns.round()).abs() * TAU
}

/// How far a posture leads away from a pose.
fn off(arm: &Arm, posture: &Posture, pose: &Isometry3<f64>) -> f64 {
    let [.., tip] = arm.forward(posture);
    (tip.to_homogeneous() - pose.to_homogeneous()).abs().max()
}

/// Whether two postures are the same branch. Where the wrist is singular only the sum, or the difference, of its outer angles is
/// determined.
fn same(arm: &Arm, pose: &Isometry3<f64>, a: &Posture, b: &Posture) -> bool {
    let far = |k: usize| apart(a[k], b[k]);
    // So near to a singular wrist both are taken for singular: the outer angles are ill determined.
    if math::sin(a[4]).abs() < SINGULAR && math::sin(b[4]).abs() < SINGULAR {
        let sign = if math::cos(a[4]) > 0.0 { 1.0 } else { -1.0 };
        return (0..3).all(|k| far(k) < SINGULAR) && far(4) < 2.0 * SINGULAR && apart(a[3] + sign * a[5], b[3] + sign * b[5]) < SINGULAR;
    }
    let farthest = (0..6).map(far).fold(0.0, f64::max);
    let middle = std::array::from_fn(|k| {
        let turns = ((a[k] - b[k]) / TAU).round();
        f64::midpoint(a[k], b[k] + turns * TAU)
    });
    farthest < SAME || farthest < MEETING && off(arm, &middle, pose) < CLOSE
}

/// Whether all angles are the same up to rounding.
fn close(a: &Posture, b: &Posture) -> bool {
    (0..6).all(|k| apart(a[k], b[k]) < SAME)
}

/// How many branches there are; `meeting` counts those of regular poses that are not exactly one of each library's.
fn check(arm: &Arm, sample: &Sample, meeting: &mut usize) -> usize {
    let Sample { kind, pose, branches } = sample;
    let wanted = isometry(pose);
    let found = arm.inverse_all(&wanted, &arm.home()).unwrap_or_else(|error| panic!("{pose:?}: {error:?}"));
    for branch in &found {
        let off = off(arm, branch, &wanted);
        assert!(off < CLOSE, "kind {kind}, {pose:?}: {branch:?} leads {off} away");
    }
    for (library, theirs) in branches.iter().enumerate() {
        for branch in theirs {
            let has = found.iter().any(|own| same(arm, &wanted, own, branch));
            assert!(has, "kind {kind}, {pose:?}: lost {branch:?} of source {library}, has {:?}", &found[..]);
        }
    }
    // Away from singularities each branch is one of each library's, and no two of ours are the same.
    if *kind == 0 {
        for theirs in &branches[1..] {
            assert_eq!(theirs.len(), found.len(), "{pose:?}");
            let strict = found.iter().filter(|own| theirs.iter().filter(|branch| close(own, branch)).count() == 1).count();
            *meeting += found.len() - strict;
        }
    }
    for own in &found {
        let known = branches.iter().flatten().any(|branch| same(arm, &wanted, own, branch));
        assert!(known, "kind {kind}, {pose:?}: {own:?} is none of {branches:?}");
    }
    found.len()
}

#[test]
fn no_branch_is_lost_and_none_invented() {
    let scene = shipped("arm-puma").unwrap();
    let arm = &scene.get::<ArmScene>().unwrap().arm;
    let bytes = match std::env::var_os("FORAGE_ARM_IK") {
        Some(file) => fs::read(file).unwrap(),
        None => include_bytes!("arm_ik.bin").to_vec(),
    };
    let samples = samples(&bytes);
    let mut meeting = 0;
    let mut counts: BTreeMap<(usize, usize), usize> = BTreeMap::new();
    for sample in &samples {
        *counts.entry((sample.kind, check(arm, sample, &mut meeting))).or_default() += 1;
    }
    println!("{meeting} branches of regular poses that meet another one");
    assert_eq!(meeting, 0);
    println!("{} poses; by kind and number of branches: {counts:?}", samples.len());
    assert!((0..5).all(|kind| samples.iter().any(|sample| sample.kind == kind)), "{counts:?}");
    // Away from singularities there are eight: two of the base, of the elbow and of the wrist.
    assert!(counts.keys().all(|&(kind, branches)| kind != 0 || branches == 8), "{counts:?}");
}
