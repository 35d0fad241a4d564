//! Pure pursuit: the robot steers along the circle that leads from where it is, the way it looks, to a point of the
//! path a little ahead.

use std::f64::consts::FRAC_PI_4;

use crate::math::{self, clamp};

use super::motion::{Motion, Pose};

/// A target farther aside than this is turned to on the spot. Pure pursuit says nothing of it: beyond 90° its circle
/// would lead away first, and well before that it swings far off the path. Half of that is the limit here.
const TURN_ON_THE_SPOT: f64 = FRAC_PI_4;

/// A path by how far one has come along it.
#[derive(Debug, Clone)]
pub(super) struct Course {
    /// Corners, no two in succession alike.
    points: Vec<[f64; 2]>,
    /// How far along the path each corner is.
    along: Vec<f64>,
}

/// The point of a course that is nearest to another point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Nearest {
    /// How far along the course it is.
    pub(super) along: f64,
    /// How far away the other point is; positive where a turn from x towards y leads from the course to it.
    pub(super) aside: f64,
}

/// What the robot steers for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Target {
    pub(super) point: [f64; 2],
    /// How far along the course it is.
    pub(super) along: f64,
    /// It is the course's end.
    pub(super) is_goal: bool,
}

impl Course {
    /// `None` for a path without a corner.
    pub(super) fn new(path: &[[f64; 2]]) -> Option<Self> {
        let mut points = path.to_vec();
        points.dedup();
        let mut at = 0.0;
        let mut along = vec![0.0; points.len().min(1)];
        along.extend(points.windows(2).map(|w| {
            at += distance(w[0], w[1]);
            at
        }));
        (!points.is_empty()).then_some(Self { points, along })
    }

    /// The whole length.
    pub(super) fn length(&self) -> f64 {
        self.along[self.along.len() - 1]
    }

    /// At the beginning, looking along the path.
    pub(super) fn start(&self) -> Pose {
        let at = self.points[0];
        let heading = self.points.get(1).map_or(0.0, |next| math::atan2(next[1] - at[1], next[0] - at[0]));
        Pose { at, heading }
    }

    /// The goal.
    pub(super) fn goal(&self) -> [f64; 2] {
        self.points[self.points.len() - 1]
    }

    /// The first segment that is not over at `along`.
    fn segment(&self, along: f64) -> usize {
        self.along[1..].partition_point(|&end| end <= along).min(self.points.len().saturating_sub(2))
    }

    /// The nearest point of the part between `from` and `to` (the earliest of several): what the course does before and
    /// after does not count, however near it comes.
    pub(super) fn nearest(&self, from: f64, to: f64, point: [f64; 2]) -> Nearest {
        let mut least = Nearest { along: 0.0, aside: f64::INFINITY };
        for i in self.segment(from)..self.points.len() - 1 {
            if self.along[i] > to {
                break;
            }
            let (a, b) = (self.points[i], self.points[i + 1]);
            let length = self.along[i + 1] - self.along[i];
            let way = [(b[0] - a[0]) / length, (b[1] - a[1]) / length];
            let relative = [point[0] - a[0], point[1] - a[1]];
            let on = clamp(relative[0] * way[0] + relative[1] * way[1], clamp(from - self.along[i], 0.0, length), length);
            let on = on.min((to - self.along[i]).max(0.0));
            let rest = [relative[0] - on * way[0], relative[1] - on * way[1]];
            let aside = (rest[0] * rest[0] + rest[1] * rest[1]).sqrt();
            if aside < least.aside.abs() {
                let left = way[0] * rest[1] - way[1] * rest[0] >= 0.0;
                least = Nearest { along: self.along[i] + on, aside: if left { aside } else { -aside } };
            }
        }
        if least.aside.is_finite() { least } else { Nearest { along: 0.0, aside: distance(self.points[0], point) } }
    }

    /// The first point beyond `along` that is `ahead` away from the robot; the goal if none is. A robot that is farther
    /// than that from the point at `along` steers for it.
    pub(super) fn target(&self, along: f64, robot: [f64; 2], ahead: f64) -> Target {
        let first = self.segment(along);
        for i in first..self.points.len() - 1 {
            let b = self.points[i + 1];
            if distance(robot, b) < ahead {
                continue;
            }
            let length = self.along[i + 1] - self.along[i];
            let share = if i == first { ((along - self.along[i]) / length).clamp(0.0, 1.0) } else { 0.0 };
            let a = between(self.points[i], b, share);
            let part = leaving(a, b, robot, ahead);
            let along = self.along[i] + (share + part * (1.0 - share)) * length;
            if along < self.length() {
                return Target { point: between(a, b, part), along, is_goal: false };
            }
        }
        Target { point: self.goal(), along: self.length(), is_goal: true }
    }
}

/// The share of the segment `a`–`b`, which ends outside, after which it leaves the circle; 0 if it begins outside too.
fn leaving(a: [f64; 2], b: [f64; 2], center: [f64; 2], radius: f64) -> f64 {
    let (d, m) = ([b[0] - a[0], b[1] - a[1]], [a[0] - center[0], a[1] - center[1]]);
    let outside = m[0] * m[0] + m[1] * m[1] - radius * radius;
    if outside >= 0.0 {
        return 0.0;
    }
    let (dd, md) = (d[0] * d[0] + d[1] * d[1], m[0] * d[0] + m[1] * d[1]);
    (((md * md - dd * outside).sqrt() - md) / dd).min(1.0)
}

fn between(a: [f64; 2], b: [f64; 2], share: f64) -> [f64; 2] {
    [a[0] + share * (b[0] - a[0]), a[1] + share * (b[1] - a[1])]
}

pub(super) fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    let (dx, dy) = (b[0] - a[0], b[1] - a[1]);
    (dx * dx + dy * dy).sqrt()
}

/// What the robot can do.
#[derive(Debug, Clone, Copy)]
pub(super) struct Limits {
    /// The greatest speed.
    pub(super) speed: f64,
    /// The greatest turn rate.
    pub(super) turn_rate: f64,
    /// The control period in seconds.
    pub(super) period: f64,
}

impl Limits {
    /// What to do for how many seconds: a whole period, or less where that leads to the goal.
    pub(super) fn steer(&self, pose: &Pose, target: Target) -> (Motion, f64) {
        let [dx, dy] = [target.point[0] - pose.at[0], target.point[1] - pose.at[1]];
        let (cos, sin) = (math::cos(pose.heading), math::sin(pose.heading));
        let (ahead, aside) = (cos * dx + sin * dy, cos * dy - sin * dx);
        let eta = math::atan2(aside, ahead);
        if eta.abs() > TURN_ON_THE_SPOT {
            // Where a period is long enough to turn past it, slower.
            let turn_rate = math::clamp(eta / self.period, -self.turn_rate, self.turn_rate);
            return (Motion { speed: 0.0, turn_rate }, self.period);
        }
        let curvature = curvature(eta, ahead, aside);
        let speed = self.speed.min(self.turn_rate / curvature.abs());
        let motion = Motion { speed, turn_rate: math::clamp(curvature * speed, -self.turn_rate, self.turn_rate) };
        // The arc turns by 2η over its chord.
        let arc = if eta.abs() < 1e-6 { (dx * dx + dy * dy).sqrt() } else { 2.0 * eta / curvature };
        let seconds = if target.is_goal { self.period.min(arc / speed) } else { self.period };
        (motion, seconds)
    }
}

/// κ = 2 sin η / L of the circle that touches the heading and passes through a point at the angle η.
fn curvature(eta: f64, ahead: f64, aside: f64) -> f64 {
    2.0 * math::sin(eta) / (ahead * ahead + aside * aside).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    const LIMITS: Limits = Limits { speed: 0.24, turn_rate: 0.2, period: 0.4 };
    const START: Pose = Pose { at: [0.0, 0.0], heading: 0.0 };

    fn steer(point: [f64; 2]) -> (Motion, f64) {
        LIMITS.steer(&START, Target { point, along: 0.0, is_goal: false })
    }

    fn close(a: f64, b: f64) -> bool {
        (a - b).abs() < 1e-14
    }

    /// The circle through (0, 0) along the x axis and through (0.3, 0.1) has its centre at (0, 0.5): κ = 2.
    #[test]
    fn the_command_follows_the_circle_within_the_limits() {
        let (motion, seconds) = steer([0.3, 0.1]);
        assert!(close(motion.speed, 0.1) && close(motion.turn_rate, 0.2) && seconds == 0.4, "ω limits v: {motion:?}");
        let (motion, _) = steer([0.3, -0.1]);
        assert!(close(motion.speed, 0.1) && close(motion.turn_rate, -0.2), "{motion:?}");
        // (0.3, 0.02): κ = 2 · 0.02 / 0.0904 = 0.4425, ω = κ v.
        let (motion, _) = steer([0.3, 0.02]);
        assert!(motion.speed == 0.24 && close(motion.turn_rate, 0.24 * 0.04 / 0.0904), "{motion:?}");
        assert_eq!(steer([0.3, 0.0]).0, Motion { speed: 0.24, turn_rate: 0.0 });
        assert_eq!(steer([0.3, 0.301]).0, Motion { speed: 0.0, turn_rate: 0.2 }, "more than 45°: on the spot");
        assert_eq!(steer([-0.3, -0.001]).0, Motion { speed: 0.0, turn_rate: -0.2 });
        // Whichever way it looks.
        let turned = Pose { at: [2.0, 1.0], heading: std::f64::consts::FRAC_PI_2 };
        let (motion, _) = LIMITS.steer(&turned, Target { point: [1.9, 1.3], along: 0.0, is_goal: false });
        assert!(close(motion.speed, 0.1) && close(motion.turn_rate, 0.2), "{motion:?}");
    }

    #[test]
    fn it_does_not_turn_past_its_target_nor_drive_past_the_goal() {
        let quick = Limits { turn_rate: 10.0, period: 2.0, ..LIMITS };
        let (motion, seconds) = quick.steer(&START, Target { point: [0.0, 1.0], along: 0.0, is_goal: true });
        assert!(motion.speed == 0.0 && close(motion.turn_rate * seconds, 2.0 * FRAC_PI_4), "{motion:?}");
        let goal = |point| LIMITS.steer(&START, Target { point, along: 0.0, is_goal: true });
        assert_eq!(goal([0.06, 0.0]), (Motion { speed: 0.24, turn_rate: 0.0 }, 0.25));
        assert_eq!(goal([0.6, 0.0]).1, 0.4);
        for point in [[0.03, 0.0003], [0.05, -0.001], [0.09, 1e-9]] {
            let (motion, seconds) = goal(point);
            assert!(distance(START.after(motion, seconds).at, point) < 1e-15, "the arc ends there: {point:?}");
        }
    }

    #[test]
    fn the_nearest_point_is_on_the_part_that_is_asked_for() {
        let course = Course::new(&[[0.0, 0.0], [4.0, 0.0], [4.0, 0.0], [4.0, 1.0], [0.0, 1.0]]).unwrap();
        assert_eq!((course.length(), course.goal()), (9.0, [0.0, 1.0]));
        let nearest = |from, to, point| {
            let Nearest { along, aside } = course.nearest(from, to, point);
            (along, aside)
        };
        assert_eq!(nearest(0.0, 2.0, [1.0, 0.75]), (1.0, 0.75), "the way back is nearer, but later");
        assert_eq!(nearest(0.0, 9.0, [1.0, 0.75]), (8.0, 0.25));
        assert_eq!(nearest(0.0, 2.0, [3.0, -0.5]).0, 2.0, "no farther than asked");
        assert_eq!(nearest(2.5, 4.0, [1.0, 0.0]), (2.5, 1.5), "nor before");
        assert_eq!(nearest(0.0, 9.0, [5.0, 0.5]), (4.5, -1.0), "to the right");
        assert_eq!(nearest(-1.0, 1.0, [-3.0, 4.0]).1.abs(), 5.0);
        let point = Course::new(&[[1.0, 2.0]; 3]).unwrap();
        assert_eq!(point.nearest(-1.0, 1.0, [4.0, 6.0]), Nearest { along: 0.0, aside: 5.0 });
        assert!(Course::new(&[]).is_none());
    }

    #[test]
    fn the_target_is_where_the_path_first_leaves_the_circle() {
        let course = Course::new(&[[0.0, 0.0], [4.0, 0.0], [4.0, 3.0]]).unwrap();
        let target = |along, robot| course.target(along, robot, 1.0);
        assert_eq!(target(0.5, [0.5, 0.0]), Target { point: [1.5, 0.0], along: 1.5, is_goal: false });
        let aside = target(1.0, [1.0, 0.6]);
        assert!((aside.point[0] - 1.8).abs() < 1e-15 && aside.point[1] == 0.0, "{aside:?}");
        let round = target(3.4, [3.4, 0.0]);
        assert!(round.point[0] == 4.0 && (round.point[1] - 0.8).abs() < 1e-15 && (round.along - 4.8).abs() < 1e-15, "{round:?}");
        assert_eq!(target(2.0, [2.0, 1.5]).point, [2.0, 0.0], "too far off: back to the path");
        assert_eq!(target(6.2, [4.0, 2.2]), Target { point: [4.0, 3.0], along: 7.0, is_goal: true });
        assert_eq!(target(7.0, [9.0, 3.0]), Target { point: [4.0, 3.0], along: 7.0, is_goal: true });
    }
}
