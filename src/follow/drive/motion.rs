//! How a differential drive moves: arcs, wheel speeds, and what the encoders count.

use std::f64::consts::TAU;

use crate::{geometry::Oriented, math};

/// Where the robot is and which way it looks.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Pose {
    pub(super) at: [f64; 2],
    /// Radians from the x axis towards the y axis; counted on over whole turns.
    pub(super) heading: f64,
}

impl Pose {
    /// After `seconds` at constant speed and turn rate: exactly an arc, or a line, or a turn on the spot.
    pub(super) fn after(&self, motion: Motion, seconds: f64) -> Self {
        let half = motion.turn_rate * seconds / 2.0;
        // The chord of an arc lies half way between the headings at its ends. No difference of almost equal numbers,
        // so nothing is lost on very flat arcs.
        let share = if half == 0.0 { 1.0 } else { math::sin(half) / half };
        let chord = motion.speed * seconds * share;
        let middle = self.heading + half;
        Self { at: [self.at[0] + chord * math::cos(middle), self.at[1] + chord * math::sin(middle)], heading: self.heading + 2.0 * half }
    }

    /// The robot's outline there.
    pub(super) fn outline(&self, half: [f64; 2]) -> Oriented {
        Oriented { center: self.at, direction: [math::cos(self.heading), math::sin(self.heading)], half }
    }
}

/// What the robot is to do in a period.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Motion {
    /// v, forward, in the scene's unit per second.
    pub(super) speed: f64,
    /// ω in radians per second, from the x axis towards the y axis.
    pub(super) turn_rate: f64,
}

/// The two wheels and their encoders.
#[derive(Debug, Clone, Copy)]
pub(super) struct Wheels {
    /// R.
    pub(super) radius: f64,
    /// b, between the wheels.
    pub(super) distance: f64,
    /// Counts a revolution: pulses, decoder and gear together.
    pub(super) counts: u64,
    /// 1 where a turn from x towards y is one to the left, −1 where y points down.
    pub(super) left_is: f64,
}

impl Wheels {
    /// How fast the left and the right wheel turn, in radians per second: (v ∓ ω b / 2) / R.
    pub(super) fn speeds(&self, motion: Motion) -> [f64; 2] {
        let across = self.left_is * motion.turn_rate * self.distance / 2.0;
        [(motion.speed - across) / self.radius, (motion.speed + across) / self.radius]
    }

    /// What an encoder shows when its wheel has turned by this angle in all: whole counts. It is taken from the whole
    /// angle, so that what is rounded off in a period is not lost for the next.
    pub(super) fn count(&self, angle: f64) -> f64 {
        (angle * self.counts as f64 / TAU).floor()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::{FRAC_PI_2, PI};

    fn close(a: [f64; 2], b: [f64; 2]) -> bool {
        (a[0] - b[0]).abs() < 1e-15 && (a[1] - b[1]).abs() < 1e-15
    }

    #[test]
    fn motion_is_an_arc_a_line_or_a_turn() {
        let start = Pose { at: [1.0, 2.0], heading: 0.0 };
        let line = start.after(Motion { speed: 0.5, turn_rate: 0.0 }, 3.0);
        assert_eq!(line, Pose { at: [2.5, 2.0], heading: 0.0 });
        // A quarter of a circle of radius v / ω = 2 about (1, 4).
        let quarter = start.after(Motion { speed: PI, turn_rate: FRAC_PI_2 }, 1.0);
        assert!(close(quarter.at, [3.0, 4.0]) && quarter.heading == FRAC_PI_2, "{quarter:?}");
        let back = quarter.after(Motion { speed: PI, turn_rate: -FRAC_PI_2 }, 1.0);
        assert!(close(back.at, [5.0, 6.0]) && back.heading == 0.0, "{back:?}");
        let turn = start.after(Motion { speed: 0.0, turn_rate: -0.2 }, 0.4);
        assert_eq!((turn.at, turn.heading), (start.at, -0.2 * 0.4));
        let flat = start.after(Motion { speed: 1.0, turn_rate: 1e-13 }, 2.0);
        assert!(close(flat.at, [3.0, 2.0 + 2e-13]), "{flat:?}");
    }

    /// The paper's robot: R = 0.068 m, b = 0.3 m, 4192 counts.
    #[test]
    fn wheels_turn_and_count_as_by_hand() {
        let wheels = Wheels { radius: 0.068, distance: 0.3, counts: 4192, left_is: 1.0 };
        let near = |[l, r]: [f64; 2], [a, b]: [f64; 2]| (l - a).abs() < 1e-14 && (r - b).abs() < 1e-14;
        assert!(near(wheels.speeds(Motion { speed: 0.24, turn_rate: 0.0 }), [0.24 / 0.068; 2]));
        assert!(near(wheels.speeds(Motion { speed: 0.24, turn_rate: 0.2 }), [0.21 / 0.068, 0.27 / 0.068]));
        assert!(near(wheels.speeds(Motion { speed: 0.0, turn_rate: 0.2 }), [-0.03 / 0.068, 0.03 / 0.068]));
        let mirrored = Wheels { left_is: -1.0, ..wheels };
        assert!(near(mirrored.speeds(Motion { speed: 0.24, turn_rate: 0.2 }), [0.27 / 0.068, 0.21 / 0.068]));
        assert_eq!(wheels.count(TAU), 4192.0);
        assert_eq!(wheels.count(0.9999 * TAU), 4191.0, "4191.58");
        assert_eq!((wheels.count(0.0), wheels.count(-1e-3)), (0.0, -1.0), "backwards it goes below, by 0.67");
        // 1 m is 1 / (2π · 0.068) = 2.340 513… revolutions: 9811.43… counts.
        assert_eq!(wheels.count(1.0 / 0.068), 9811.0);
    }
}
