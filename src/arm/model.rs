//! A six-axis arm as data.

use std::f64::consts::PI;

use nalgebra::Vector3;

/// A configuration of the arm: its six joint angles, in radians.
pub type Posture = [f64; 6];

/// The positions of base, shoulder, elbow, wrist and tip in the world, in metres.
pub type Skeleton = [[f64; 3]; 5];

/// A joint and the link before it, modified Denavit–Hartenberg: T_i = Rx(α_{i−1}) Tx(a_{i−1}) Rz(θ_i) Tz(d_i).
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Joint {
    /// a_{i−1}, the length of the link before, in metres.
    pub a: f64,
    /// α_{i−1}, the twist of the link before, in degrees: a multiple of 90.
    pub alpha: f64,
    /// θ_i in the home configuration, in degrees.
    pub home: f64,
    /// d_i, the offset along the joint's axis, in metres.
    pub d: f64,
    /// The smallest θ_i, in degrees.
    pub min: f64,
    /// The largest θ_i, in degrees.
    pub max: f64,
    /// The largest speed, in degrees per second. The paper gives none; the default is 180 ([`Joint::SPEED`]).
    #[cfg_attr(feature = "types", ts(optional, as = "Option<f64>"))]
    pub speed: f64,
}

impl Joint {
    /// The default of `speed`, in degrees per second.
    pub const SPEED: f64 = 180.0;
}

/// An axis of the last joint's frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename_all = "lowercase"))]
pub enum Axis {
    /// x6.
    X,
    /// y6.
    Y,
    /// z6.
    Z,
}

impl Axis {
    /// All axes.
    pub const ALL: [Self; 3] = [Self::X, Self::Y, Self::Z];

    /// The name that scene files use.
    pub const fn name(self) -> &'static str {
        match self {
            Self::X => "x",
            Self::Y => "y",
            Self::Z => "z",
        }
    }
}

/// The tool: a straight segment from the wrist to the tip.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Tool {
    /// The axis of the last frame that it lies along.
    pub axis: Axis,
    /// Its length, in metres.
    pub length: f64,
}

/// The position of the arm in the world.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Base {
    /// The origin of the first joint in the world, in metres.
    pub position: [f64; 3],
    /// The rotation about z, in degrees.
    #[cfg_attr(feature = "types", ts(optional, as = "Option<f64>"))]
    pub yaw: f64,
    /// The radius of the column from the workspace's floor up to the base, in metres; 0: no column.
    #[cfg_attr(feature = "types", ts(optional, as = "Option<f64>"))]
    pub column_radius: f64,
}

/// A six-axis arm with a spherical wrist, as data.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Arm {
    /// The joints, from the base to the wrist.
    pub joints: [Joint; 6],
    /// The tool at its end.
    pub tool: Tool,
    /// Its base.
    pub base: Base,
}

impl Arm {
    /// The home configuration.
    pub fn home(&self) -> Posture {
        self.joints.map(|joint| joint.home * (PI / 180.0))
    }
}

impl Base {
    /// Sine and cosine of its yaw.
    pub(crate) fn turn(&self) -> (f64, f64) {
        quarters(self.yaw)
    }
}

impl Tool {
    /// The vector from the wrist to the tip in the last joint's frame, in metres.
    pub fn vector(&self) -> Vector3<f64> {
        let mut vector = Vector3::zeros();
        vector[self.axis as usize] = self.length;
        vector
    }
}

/// Converts a posture to degrees.
pub fn degrees(posture: &Posture) -> [f64; 6] {
    posture.map(|angle| angle * (180.0 / PI))
}

/// Converts degrees to a posture.
pub fn radians(degrees: &[f64; 6]) -> Posture {
    degrees.map(|angle| angle * (PI / 180.0))
}

/// Sine and cosine of an angle in degrees; exactly 0 and ±1 at multiples of 90.
#[inline]
pub(super) fn quarters(degrees: f64) -> (f64, f64) {
    if degrees == 0.0 {
        (0.0, 1.0)
    } else if degrees.abs() == 90.0 {
        (degrees.signum(), 0.0)
    } else if degrees.abs() == 180.0 {
        (0.0, -1.0)
    } else {
        libm::sincos(degrees.to_radians())
    }
}
