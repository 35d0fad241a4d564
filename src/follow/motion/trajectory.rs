//! Postures become a motion: when the arm is where, and what it touches.

use std::f64::consts::PI;

use crate::{
    arm::{Links, Posture},
    message,
    params::Parameters,
};

use super::{
    course::{aside, distance},
    follow::{Followed, Stop, evenly},
    outcome::{Motion, MotionOutcome},
    parameters::{RESOLUTION, SPACING, SPEED, TOOL_SPEED},
};

/// How many places between two rows the tip's distance from the path is measured at.
const BETWEEN: i32 = 4;

/// A tip that is farther off its path than this, in metres, and than its postures are apart, does not follow it.
const OFF: f64 = 0.01;

/// What a motion is timed and checked by.
pub(super) struct Trajectory<'a> {
    pub(super) scene: &'a crate::arm::ArmScene,
    pub(super) links: &'a Links<'a>,
    pub(super) parameters: &'a Parameters,
    /// The path, if postures were planned and do not stand at its points.
    pub(super) path: Option<&'a [[f64; 3]]>,
}

impl Trajectory<'_> {
    /// The time from one posture to the next: every joint keeps its limit, and the tip its own.
    fn seconds(&self, from: &Posture, to: &Posture, way: f64) -> f64 {
        let share = self.parameters[SPEED];
        let limits = self.scene.arm.joints.map(|joint| joint.speed * (PI / 180.0) * share);
        let joints = (0..6).map(|i| (to[i] - from[i]).abs() / limits[i]);
        joints.fold(way / self.parameters[TOOL_SPEED], f64::max)
    }

    /// The tip's distance from the path on the way from one posture to the next.
    fn error(&self, from: &Stop, to: &Stop) -> f64 {
        (1..=BETWEEN)
            .map(|i| {
                let tip = self.scene.arm.skeleton(&evenly(&from.posture, &to.posture, f64::from(i) / f64::from(BETWEEN)))[4];
                match self.path {
                    None => aside(tip, from.station.at, to.station.at),
                    Some(path) => path.windows(2).map(|leg| aside(tip, leg[0], leg[1])).fold(f64::INFINITY, f64::min),
                }
            })
            .fold(0.0, f64::max)
    }

    /// The motion through all stops. `points`: how many the path has; with fewer stops the arm does not arrive.
    pub(super) fn motion(&self, followed: Followed, points: usize) -> Motion {
        let arm = &self.scene.arm;
        let resolution = self.parameters[RESOLUTION];
        let mut motion = Motion { rows: Vec::new(), skeletons: Vec::new(), outcome: nothing(), parameters: self.parameters.clone() };
        let Motion { rows, skeletons, outcome, .. } = &mut motion;
        let mut last: Option<(&Stop, [f64; 3])> = None;
        let mut off = None;
        for stop in &followed.stops {
            let skeleton = arm.skeleton(&stop.posture);
            let [.., tip] = skeleton;
            let begun = outcome.time;
            // Where it starts there is no move; it may touch all the same.
            let (from, way) = last.map_or((stop, 0.0), |(from, at)| (from, distance(at, tip)));
            outcome.time += self.seconds(&from.posture, &stop.posture, way);
            outcome.length += way;
            if outcome.touched_at.is_none() {
                let touched = self.links.first_touch(&from.posture, &stop.posture, resolution);
                outcome.touched_at = touched.map(|share| begun + share * (outcome.time - begun));
            }
            let step = (0..6).map(|i| (stop.posture[i] - from.posture[i]).abs() * (180.0 / PI)).fold(0.0, f64::max);
            outcome.largest_step = outcome.largest_step.max(step);
            let error = self.error(from, stop);
            if error > OFF.max(self.parameters[SPACING]) && off.is_none() {
                let [x, y, z] = tip;
                off = Some(message!(
                    "motion-leaves-path",
                    "before ({x:.4}, {y:.4}, {z:.4}), {along:.4} m along the path, the tip is {error:.4} m off it, while a joint turns by {step:.1}°: no postures that touch nothing lead on evenly",
                    x,
                    y,
                    z,
                    along = stop.station.along,
                    error,
                    step
                ));
            }
            outcome.max_error = outcome.max_error.max(error);
            let clearance = self.links.clearance(&skeleton);
            outcome.clearance = match (outcome.clearance, clearance) {
                (Some(least), Some(here)) => Some(least.min(here)),
                (least, here) => least.or(here),
            };
            rows.extend([outcome.time, stop.station.along]);
            rows.extend(tip);
            rows.extend(crate::arm::degrees(&stop.posture));
            rows.push(clearance.unwrap_or(f64::INFINITY));
            skeletons.extend(skeleton.as_flattened());
            last = Some((stop, tip));
        }
        outcome.free = outcome.touched_at.is_none() && !followed.stops.is_empty();
        outcome.arrived = followed.stops.len() == points;
        (outcome.mirrored, outcome.drawn, outcome.failure) = (followed.mirrored, followed.drawn, followed.failure.or(off));
        motion
    }
}

fn nothing() -> MotionOutcome {
    MotionOutcome {
        time: 0.0,
        length: 0.0,
        arrived: false,
        free: false,
        touched_at: None,
        clearance: None,
        largest_step: 0.0,
        max_error: 0.0,
        mirrored: 0,
        drawn: 0,
        failure: None,
    }
}
