//! Solutions of inverse kinematics, at most eight, and the reasons for having none.

use std::{fmt, ops::Deref};

use serde::Serialize;

use crate::{
    kernel::{Error, Message},
    message,
};

use super::Posture;

/// The largest number of solutions for a pose: two turns of the base, two bends of the elbow, two of the wrist.
pub const MAX_SOLUTIONS: usize = 8;

/// The solutions for a pose, the nearest first: a list of fixed capacity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Solutions {
    postures: [Posture; MAX_SOLUTIONS],
    n: usize,
}

/// Solutions nearer than this in every joint are one, in radians.
const SAME: f64 = 1e-9;

impl Solutions {
    pub(super) const NONE: Self = Self { postures: [[0.0; 6]; MAX_SOLUTIONS], n: 0 };

    /// Puts a posture where it belongs by its distance from `near`, unless it is there already.
    pub(super) fn insert(&mut self, posture: Posture, near: &Posture) {
        let same = |known: &Posture| known.iter().zip(posture).all(|(a, b)| (a - b).abs() < SAME);
        if self.n == MAX_SOLUTIONS || self.iter().any(same) {
            return;
        }
        let away = distance(&posture, near);
        let place = self.iter().position(|known| away < distance(known, near)).unwrap_or(self.n);
        self.postures.copy_within(place..self.n, place + 1);
        self.postures[place] = posture;
        self.n += 1;
    }

    /// The posture nearest to the one that was asked for.
    pub fn nearest(&self) -> Option<&Posture> {
        self.first()
    }
}

impl Deref for Solutions {
    type Target = [Posture];

    fn deref(&self) -> &[Posture] {
        &self.postures[..self.n]
    }
}

impl<'a> IntoIterator for &'a Solutions {
    type Item = &'a Posture;
    type IntoIter = std::slice::Iter<'a, Posture>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

/// The Euclidean distance of two postures' angles, in radians. Whole turns count.
pub fn distance(a: &Posture, b: &Posture) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt()
}

/// The reason why no posture brings the tool into a pose. A later variant is closer to a solution.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub enum Unreachable {
    /// The tip cannot reach the position, in any orientation.
    Position,
    /// The tip can reach the position, but not in this orientation.
    Orientation,
    /// The joints would have to turn beyond their limits.
    Limits,
}

impl Unreachable {
    /// The cause, in a word.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Position => "position",
            Self::Orientation => "orientation",
            Self::Limits => "limits",
        }
    }

    /// The error for the field `position`, `orientation` or `limits`.
    pub fn refusal(self) -> Error {
        let allowed = match self {
            Self::Position => message!("arm-reachable-position", "one that the tip can reach in some orientation"),
            Self::Orientation => message!("arm-reachable-orientation", "one in which the tip can reach this position"),
            Self::Limits => message!("arm-reachable-limits", "such that some posture within them reaches the pose"),
        };
        Error::refused(self.name(), message!("arm-out-of-reach", "out of reach"), allowed)
    }

    /// The reason in a sentence, without a full stop.
    pub fn message(self) -> Message {
        match self {
            Self::Position => message!("arm-no-position", "the tip cannot reach this position in any orientation"),
            Self::Orientation => message!("arm-no-orientation", "the tip cannot reach this position in this orientation"),
            Self::Limits => message!("arm-no-limits", "the joints would have to turn beyond their limits"),
        }
    }
}

impl fmt::Display for Unreachable {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.message().fmt(f)
    }
}

impl std::error::Error for Unreachable {}
