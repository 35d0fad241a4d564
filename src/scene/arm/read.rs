//! An arm's scene in the scene file.

use serde_json::Value;

use crate::{
    arm::{Arm, ArmScene, Axis, Base, Joint, Tool},
    geometry::Cuboid,
    kernel::{
        Error,
        error::list_of,
        fields::{Fields, each, object},
    },
    message,
};

/// Reads its fields.
pub(super) fn read(fields: &mut Fields) -> Result<ArmScene, Error> {
    let cuboids = fields.optional_list("cuboids")?;
    Ok(ArmScene {
        workspace: cuboid("workspace", fields.take("workspace"))?,
        start: fields.point_in_space("start")?,
        goal: fields.point_in_space("goal")?,
        cuboids: each("cuboids", cuboids, cuboid)?,
        arm: arm(fields.take("arm"))?,
    })
}

fn cuboid(at: &str, value: Value) -> Result<Cuboid, Error> {
    let mut fields = Fields::of(at, value, message!("scene-bounds", "an object with min and max"))?;
    let cuboid = Cuboid { min: fields.point_in_space("min")?, max: fields.point_in_space("max")? };
    fields.end()?;
    Ok(cuboid)
}

fn arm(value: Value) -> Result<Arm, Error> {
    let mut fields = Fields::of("arm", value, message!("scene-arm", "an object with joints, tool and base"))?;
    let joints = each("arm.joints", fields.list("joints")?, joint)?;
    let n = joints.len();
    let joints = joints.try_into().map_err(|_| Error::refused("arm.joints", list_of(n), list_of(6)))?;
    let tool = message!("scene-tool", "an object with axis and length");
    let mut tool = Fields::of("arm.tool", fields.take("tool"), tool)?;
    let base = message!("scene-base", "an object with position, yaw and column_radius");
    let mut base = Fields::of("arm.base", fields.take("base"), base)?;
    fields.end()?;
    let arm = Arm {
        joints,
        tool: Tool { axis: tool.one_of("axis", Axis::ALL, Axis::name)?, length: tool.number("length")? },
        base: Base {
            position: base.point_in_space("position")?,
            yaw: base.optional_number("yaw")?.unwrap_or(0.0),
            column_radius: base.optional_number("column_radius")?.unwrap_or(0.0),
        },
    };
    tool.end()?;
    base.end()?;
    Ok(arm)
}

fn joint(at: &str, value: Value) -> Result<Joint, Error> {
    let mut fields = Fields::of(at, value, message!("scene-joint", "an object with a, alpha, home, d, min and max"))?;
    let joint = Joint {
        a: fields.number("a")?,
        alpha: fields.number("alpha")?,
        home: fields.number("home")?,
        d: fields.number("d")?,
        min: fields.number("min")?,
        max: fields.number("max")?,
        speed: fields.optional_number("speed")?.unwrap_or(Joint::SPEED),
    };
    fields.end()?;
    Ok(joint)
}

fn point(point: [f64; 3]) -> Value {
    Value::Array(point.map(Value::from).to_vec())
}

fn write_cuboid(cuboid: &Cuboid) -> Value {
    object(vec![("min", point(cuboid.min)), ("max", point(cuboid.max))])
}

/// Adds the fields of an arm's scene.
pub(super) fn write(scene: &ArmScene, out: &mut Vec<(&'static str, Value)>) {
    let Arm { joints, tool, base } = &scene.arm;
    let joints = joints.iter().map(|joint| {
        let numbers =
            [("a", joint.a), ("alpha", joint.alpha), ("home", joint.home), ("d", joint.d), ("min", joint.min), ("max", joint.max)];
        let mut fields: Vec<_> = numbers.map(|(name, number)| (name, Value::from(number))).to_vec();
        if joint.speed != Joint::SPEED {
            fields.push(("speed", Value::from(joint.speed)));
        }
        object(fields)
    });
    let tool = object(vec![("axis", Value::from(tool.axis.name())), ("length", Value::from(tool.length))]);
    let base = object(vec![
        ("position", point(base.position)),
        ("yaw", Value::from(base.yaw)),
        ("column_radius", Value::from(base.column_radius)),
    ]);
    let arm = object(vec![("joints", Value::Array(joints.collect())), ("tool", tool), ("base", base)]);
    out.extend([
        ("workspace", write_cuboid(&scene.workspace)),
        ("start", point(scene.start)),
        ("goal", point(scene.goal)),
        ("cuboids", Value::Array(scene.cuboids.iter().map(write_cuboid).collect())),
        ("arm", arm),
    ]);
}
