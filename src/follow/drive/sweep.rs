//! Whether the outline touches anything, and how near it comes: along the whole drive, not only where a period ends.

use crate::geometry::Field;

use super::motion::{Motion, Pose};

/// How deep an overlap counts, as a share of the robot's length: touching is none, and rounding must not make it one.
const HAIR: f64 = 1e-9;

/// Follows the outline through a field.
///
/// While no point of the outline travels farther than u, its distance d from the obstacles changes by at most u. So
/// between two moments with distances d₀ and d₁ it is never below (d₀ + d₁ − u) / 2. Where that could be news, the motion
/// is halved, down to the resolution: no overlap that is deeper than it is missed, and the least distance is true to it
/// and a hundredth of itself.
#[derive(Debug)]
pub(super) struct Sweep<'a> {
    field: &'a Field,
    half: [f64; 2],
    resolution: f64,
    /// The least distance so far, negative for an overlap; infinite without obstacles.
    pub(super) least: f64,
    /// Where the outline first overlapped a blocked cell.
    pub(super) touched_at: Option<[f64; 2]>,
}

/// A moment of a motion.
#[derive(Debug, Clone, Copy)]
struct Moment {
    seconds: f64,
    clearance: f64,
}

impl<'a> Sweep<'a> {
    /// An outline of these half lengths, begun at a pose; and its clearance there.
    pub(super) fn new(field: &'a Field, half: [f64; 2], resolution: f64, start: &Pose) -> (Self, f64) {
        let mut sweep = Self { field, half, resolution, least: f64::INFINITY, touched_at: None };
        let clearance = sweep.clearance(start);
        sweep.note(start, clearance);
        (sweep, clearance)
    }

    /// The distance of the outline from the nearest blocked cell; infinite without one.
    fn clearance(&self, pose: &Pose) -> f64 {
        self.field.distance(&pose.outline(self.half)).unwrap_or(f64::INFINITY)
    }

    fn note(&mut self, pose: &Pose, clearance: f64) {
        self.least = self.least.min(clearance);
        if clearance < -HAIR * 2.0 * self.half[0] && self.touched_at.is_none() {
            self.touched_at = Some(pose.at);
        }
    }

    /// Follows a motion from a pose where the clearance is known; returns the clearance at its end.
    pub(super) fn follow(&mut self, from: &Pose, clearance: f64, motion: Motion, seconds: f64) -> f64 {
        if self.field.blocks().is_empty() {
            return f64::INFINITY;
        }
        let [a, b] = self.half;
        // No point of the outline is faster: its centre's speed, and the turn about it.
        let rate = motion.speed.abs() + motion.turn_rate.abs() * (a * a + b * b).sqrt();
        let end = self.clearance(&from.after(motion, seconds));
        // Known beforehand, it spares looking closely at what is farther away.
        self.least = self.least.min(end);
        self.between(from, motion, rate, Moment { seconds: 0.0, clearance }, Moment { seconds, clearance: end });
        end
    }

    /// What lies between two moments, the earlier half first.
    fn between(&mut self, from: &Pose, motion: Motion, rate: f64, first: Moment, last: Moment) {
        let travel = rate * (last.seconds - first.seconds);
        let lowest = (first.clearance + last.clearance - travel) / 2.0;
        if lowest < self.floor() && travel > self.resolution {
            let seconds = f64::midpoint(first.seconds, last.seconds);
            let pose = from.after(motion, seconds);
            let middle = Moment { seconds, clearance: self.clearance(&pose) };
            self.least = self.least.min(middle.clearance);
            self.between(from, motion, rate, first, middle);
            self.between(from, motion, rate, middle, last);
        } else {
            self.note(&from.after(motion, last.seconds), last.clearance);
        }
    }

    /// Above it nothing is news. Before the first touch that is every overlap, even where a deeper one is known already.
    fn floor(&self) -> f64 {
        let least = if self.touched_at.is_none() { self.least.max(0.0) } else { self.least };
        least - 0.01 * least.max(0.0) - self.resolution
    }
}
