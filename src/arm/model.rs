//! A six-axis arm as data.

use std::f64::consts::PI;

use nalgebra::Vector3;

/// Six joint angles in radians.
pub type Posture = [f64; 6];

/// Where an arm's joints and its tip are: base, shoulder, elbow, wrist, tip, in the world.
pub type Skeleton = [[f64; 3]; 5];

/// A joint and the link before it, modified Denavit–Hartenberg: T_i = Rx(α_{i−1}) Tx(a_{i−1}) Rz(θ_i) Tz(d_i).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Joint {
    /// a_{i−1}, the length of the link before, in metres.
    pub a: f64,
    /// α_{i−1}, the twist of the link before, in degrees: a multiple of 90.
    pub alpha: f64,
    /// θ_i in the home posture, in degrees.
    pub home: f64,
    /// d_i, the offset along the joint's axis, in metres.
    pub d: f64,
    /// The least θ_i, in degrees.
    pub min: f64,
    /// The greatest, in degrees.
    pub max: f64,
    /// How fast it turns at most, in degrees a second. The paper gives none: [`Joint::SPEED`] unless a scene says otherwise.
    pub speed: f64,
}

impl Joint {
    /// Degrees a second of a joint whose scene gives no limit.
    pub const SPEED: f64 = 180.0;
}

/// An axis of the last joint's frame.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Axis {
    /// x6.
    X,
    /// y6.
    Y,
    /// z6.
    Z,
}

impl Axis {
    /// Every one.
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

/// The tool: a straight piece from the wrist to the tip.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tool {
    /// Along which axis of the last frame.
    pub axis: Axis,
    /// How long, in metres.
    pub length: f64,
}

/// Where the arm stands.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Base {
    /// The origin of its first joint, in the world.
    pub position: [f64; 3],
    /// How far it is turned about z, in degrees.
    pub yaw: f64,
    /// The radius of the column from the workspace's floor up to it; 0: none.
    pub column_radius: f64,
}

/// A six-axis arm with a spherical wrist, as data.
#[derive(Debug, Clone, PartialEq)]
pub struct Arm {
    /// From the base to the wrist.
    pub joints: [Joint; 6],
    /// At its end.
    pub tool: Tool,
    /// Where it stands.
    pub base: Base,
}

impl Arm {
    /// The home posture.
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
    /// From the wrist to the tip, in the last joint's frame.
    pub fn vector(&self) -> Vector3<f64> {
        let mut vector = Vector3::zeros();
        vector[self.axis as usize] = self.length;
        vector
    }
}

/// A posture in degrees.
pub fn degrees(posture: &Posture) -> [f64; 6] {
    posture.map(|angle| angle * (180.0 / PI))
}

/// A posture of degrees.
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
