//! Forward kinematics, [ARM-RRT](crate#papers) (1): the product of the joints' transformations.

use nalgebra::{Isometry3, Matrix3, Rotation3, Translation3, UnitQuaternion, Vector3};

use super::model::{Arm, Axis, Posture, Skeleton, Tool, quarters};

/// A frame as three axes and an origin: what the chain is multiplied in.
#[derive(Clone, Copy)]
struct Frame {
    x: Vector3<f64>,
    y: Vector3<f64>,
    z: Vector3<f64>,
    origin: Vector3<f64>,
}

impl Frame {
    /// The base's: turned about the world's z.
    fn base(arm: &Arm) -> Self {
        let (sine, cosine) = arm.base.turn();
        Self {
            x: Vector3::new(cosine, sine, 0.0),
            y: Vector3::new(-sine, cosine, 0.0),
            z: Vector3::z(),
            origin: Vector3::from(arm.base.position),
        }
    }

    /// The next frame: this one by Rx(α) Tx(a) Rz(θ) Tz(d).
    #[inline]
    fn next(&self, arm: &Arm, i: usize, theta: f64) -> Self {
        let joint = &arm.joints[i];
        let (sin_alpha, cos_alpha) = quarters(joint.alpha);
        let middle = self.y * cos_alpha + self.z * sin_alpha;
        let z = self.z * cos_alpha - self.y * sin_alpha;
        let (sine, cosine) = libm::sincos(theta);
        Self {
            x: self.x * cosine + middle * sine,
            y: middle * cosine - self.x * sine,
            z,
            origin: self.origin + self.x * joint.a + z * joint.d,
        }
    }

    /// The tip, which the tool's length lies away along its axis.
    #[inline]
    fn tip(&self, tool: &Tool) -> Vector3<f64> {
        let axis = match tool.axis {
            Axis::X => self.x,
            Axis::Y => self.y,
            Axis::Z => self.z,
        };
        self.origin + axis * tool.length
    }

    fn isometry(&self) -> Isometry3<f64> {
        let rotation = Rotation3::from_matrix_unchecked(Matrix3::from_columns(&[self.x, self.y, self.z]));
        Isometry3::from_parts(Translation3::from(self.origin), UnitQuaternion::from_rotation_matrix(&rotation))
    }
}

impl Arm {
    fn frames(&self, posture: &Posture) -> [Frame; 6] {
        let mut frame = Frame::base(self);
        std::array::from_fn(|i| {
            frame = frame.next(self, i, posture[i]);
            frame
        })
    }

    /// The frame of each joint, and last that of the tip, in the world: [ARM-RRT](crate#papers) (1).
    ///
    /// ```
    /// use forage::arm::ArmScene;
    ///
    /// let scene = forage::shipped("arm-free")?;
    /// let arm = &scene.get::<ArmScene>()?.arm;
    /// let tip = arm.forward(&arm.home())[6];
    /// // [595, 0, 480] mm from the base, as the paper says, with the tool pointing forward.
    /// let expected = nalgebra::Vector3::new(0.30 + 0.595, 0.65, 0.40 + 0.480);
    /// assert!((tip.translation.vector - expected).norm() < 1e-12);
    /// assert!((tip.rotation * nalgebra::Vector3::z() - nalgebra::Vector3::x()).norm() < 1e-12);
    /// # Ok::<(), forage::Error>(())
    /// ```
    pub fn forward(&self, posture: &Posture) -> [Isometry3<f64>; 7] {
        let frames = self.frames(posture);
        let tip = Frame { origin: frames[5].tip(&self.tool), ..frames[5] };
        std::array::from_fn(|i| frames.get(i).unwrap_or(&tip).isometry())
    }

    /// The positions of base, shoulder, elbow, wrist and tip.
    pub fn skeleton(&self, posture: &Posture) -> Skeleton {
        let frames = self.frames(posture);
        let at = |i: usize| frames[i].origin.into();
        [self.base.position, at(1), at(2), at(3), frames[5].tip(&self.tool).into()]
    }

    /// The direction of the tool: its axis in the world.
    pub fn pointing(&self, posture: &Posture) -> Vector3<f64> {
        let [.., last] = self.frames(posture);
        match self.tool.axis {
            Axis::X => last.x,
            Axis::Y => last.y,
            Axis::Z => last.z,
        }
    }
}
