//! Checks that an arm has six axes and a spherical wrist.

use crate::{
    kernel::{Error, Message},
    message,
};

use super::{Arm, Joint};

/// The largest length of an arm and coordinate of its base, in metres.
const MAX_LENGTH: f64 = 1000.0;
/// The largest angle, in degrees.
const MAX_ANGLE: f64 = 3600.0;
/// The greatest speed of a joint, in degrees a second.
const MAX_SPEED: f64 = 1e6;
/// The shortest link that bends the elbow, in metres.
const MIN_LINK: f64 = 1e-6;

impl Arm {
    /// Refuses any arm but one of six axes with a spherical wrist: α = (0, ±90, 0, ±90, ±90, ±90), the last three axes meeting
    /// in a point. The first joint turns about the base's z.
    ///
    /// # Errors
    /// [`Error::Refused`] with the field, such as `joints[3].alpha`.
    pub fn check(&self) -> Result<(), Error> {
        let joints = self.joints.iter().enumerate();
        joints.clone().try_for_each(|(i, joint)| check_joint(joint).map_err(|error| error.within(&format!("joints[{i}]"))))?;
        for (i, joint) in joints {
            let parallel = matches!(i, 0 | 2);
            if joint.alpha.abs() != if parallel { 0.0 } else { 90.0 } {
                let allowed = if parallel { zero() } else { message!("arm-right-angle", "90 or -90: {pattern}", pattern = pattern()) };
                return Err(Error::refused(format!("joints[{i}].alpha"), joint.alpha, allowed));
            }
        }
        for (field, value) in [
            ("joints[0].a", self.joints[0].a),
            ("joints[4].a", self.joints[4].a),
            ("joints[5].a", self.joints[5].a),
            ("joints[4].d", self.joints[4].d),
        ] {
            if value != 0.0 {
                return Err(Error::refused(field, value, zero()));
            }
        }
        if self.joints[2].a.abs() < MIN_LINK {
            let allowed = message!("arm-upper-arm", "an upper arm's length, at least {least}", least = MIN_LINK);
            return Err(Error::refused("joints[2].a", self.joints[2].a, allowed));
        }
        if self.joints[3].a.abs().max(self.joints[3].d.abs()) < MIN_LINK {
            let allowed = message!("arm-forearm", "a forearm's length, at least {least}", least = MIN_LINK);
            return Err(Error::refused("joints[3].d", self.joints[3].d, allowed));
        }
        within("tool.length", self.tool.length, 0.0, MAX_LENGTH)?;
        for (i, &x) in self.base.position.iter().enumerate() {
            within(&format!("base.position[{i}]"), x, -MAX_LENGTH, MAX_LENGTH)?;
        }
        within("base.yaw", self.base.yaw, -MAX_ANGLE, MAX_ANGLE)?;
        within("base.column_radius", self.base.column_radius, 0.0, MAX_LENGTH)
    }
}

/// What an arm must be, for refusals.
fn pattern() -> Message {
    message!(
        "arm-pattern",
        "six axes with a spherical wrist, alpha = (0, ±90, 0, ±90, ±90, ±90), a = 0 for joints[0], [4] and [5], d = 0 for joints[4]"
    )
}

fn zero() -> Message {
    message!("arm-zero", "0: {pattern}", pattern = pattern())
}

fn within(field: &str, value: f64, low: f64, high: f64) -> Result<(), Error> {
    if (low..=high).contains(&value) {
        Ok(())
    } else {
        Err(Error::refused(field, value, message!("arm-number-from", "a number from {low} to {high}", low, high)))
    }
}

fn check_joint(joint: &Joint) -> Result<(), Error> {
    let &Joint { a, alpha, home, d, min, max, speed } = joint;
    for (field, value, limit) in
        [("a", a, MAX_LENGTH), ("alpha", alpha, MAX_ANGLE), ("d", d, MAX_LENGTH), ("min", min, MAX_ANGLE), ("max", max, MAX_ANGLE)]
    {
        within(field, value, -limit, limit)?;
    }
    if min >= max {
        return Err(Error::refused("max", max, message!("arm-above-min", "greater than min = {min}", min)));
    }
    within("home", home, min, max)?;
    if speed > 0.0 && speed <= MAX_SPEED {
        Ok(())
    } else {
        Err(Error::refused("speed", speed, message!("arm-speed", "greater than 0, at most {most}", most = MAX_SPEED)))
    }
}

#[cfg(test)]
mod tests {
    use crate::{
        arm::{Arm, ArmScene},
        shipped,
    };

    /// The field that is refused, and how it came to be wrong.
    type Case = (&'static str, fn(&mut Arm));

    #[test]
    fn what_is_no_such_arm_is_refused_by_name() {
        let scene = shipped("arm-free").unwrap();
        let arm = &scene.get::<ArmScene>().unwrap().arm;
        assert_eq!(arm.check(), Ok(()));
        let cases: &[Case] = &[
            ("joints[0].alpha", |arm| arm.joints[0].alpha = 90.0),
            ("joints[1].alpha", |arm| arm.joints[1].alpha = 0.0),
            ("joints[2].alpha", |arm| arm.joints[2].alpha = -90.0),
            ("joints[3].alpha", |arm| arm.joints[3].alpha = 45.0),
            ("joints[4].alpha", |arm| arm.joints[4].alpha = 180.0),
            ("joints[5].alpha", |arm| arm.joints[5].alpha = f64::NAN),
            ("joints[0].a", |arm| arm.joints[0].a = 0.1),
            ("joints[4].a", |arm| arm.joints[4].a = 0.1),
            ("joints[5].a", |arm| arm.joints[5].a = -0.1),
            ("joints[4].d", |arm| arm.joints[4].d = 0.01),
            ("joints[2].a", |arm| arm.joints[2].a = 0.0),
            ("joints[3].d", |arm| (arm.joints[3].a, arm.joints[3].d) = (0.0, 0.0)),
            ("joints[1].d", |arm| arm.joints[1].d = f64::INFINITY),
            ("joints[1].a", |arm| arm.joints[1].a = 1e4),
            ("joints[1].max", |arm| arm.joints[1].max = -92.0),
            ("joints[1].min", |arm| arm.joints[1].min = f64::NAN),
            ("joints[1].home", |arm| arm.joints[1].home = -93.0),
            ("joints[5].speed", |arm| arm.joints[5].speed = 0.0),
            ("joints[5].speed", |arm| arm.joints[5].speed = f64::NAN),
            ("tool.length", |arm| arm.tool.length = -0.1),
            ("base.position[2]", |arm| arm.base.position[2] = f64::NAN),
            ("base.yaw", |arm| arm.base.yaw = 1e9),
            ("base.column_radius", |arm| arm.base.column_radius = -1.0),
        ];
        for (field, change) in cases {
            let mut changed = arm.clone();
            change(&mut changed);
            assert_eq!(changed.check().unwrap_err().field(), *field);
        }
    }
}
