//! An arm by itself: where it is in a posture, which postures bring its tip somewhere, and where the tip can come.

use std::sync::Arc;

use js_sys::{Float32Array, Uint8Array};
use nalgebra::{Unit, Vector3};
use wasm_bindgen::prelude::*;

use forage::{
    Error, Scene,
    arm::{self, ArmScene, Posture, radians},
    kernel::{Message, allowed},
};

use crate::{
    JsArmPose, JsArmSolutions, JsJoints, JsJointsOrUndefined, JsNumber, JsPoint, JsPoint3, JsPoint3OrNull, JsReachability, JsSceneOrName,
    js_error, object, plain,
    read::{read_list, read_number, read_scene, refused},
    tool::Tool,
};

/// Scene, posture, pair of joints, their least and greatest angles, the links' radius.
type Slice = fn(&JsValue, &JsValue, &JsValue, &JsValue, &JsValue, &JsValue) -> Result<Uint8Array, JsValue>;

struct Arms {
    pose: fn(&JsValue, &JsValue) -> Result<JsArmPose, JsValue>,
    solutions: fn(&JsValue, &JsValue, &JsValue, &JsValue) -> Result<JsArmSolutions, JsValue>,
    reachability: fn(&JsValue, &JsValue) -> Result<JsReachability, JsValue>,
    slice: Slice,
}

static ARMS: Tool<Arms> = Tool::new("arm");

/// Offers what an arm can do by itself.
pub fn offer_arm() {
    ARMS.offer(&Arms { pose, solutions, reachability: cloud, slice });
}

/// An arm's scene, or a refusal of its `kind`.
fn read_arm(scene: &JsValue) -> Result<Arc<Scene>, JsValue> {
    let scene = read_scene(scene)?;
    arm_of(&scene)?;
    Ok(scene)
}

fn arm_of(scene: &Scene) -> Result<&ArmScene, JsValue> {
    scene.get::<ArmScene>().map_err(js_error)
}

/// A list of so many finite numbers.
fn read_numbers<const N: usize>(field: &str, value: &JsValue, allowed: fn() -> Message) -> Result<[f64; N], JsValue> {
    // One copy for all lengths.
    let list = read_finite(field, value, N, allowed)?;
    Ok(std::array::from_fn(|i| list[i]))
}

fn read_finite(field: &str, value: &JsValue, count: usize, allowed: fn() -> Message) -> Result<Vec<f64>, JsValue> {
    let list = read_list(field, value)?;
    if list.len() != count {
        return Err(refused(field, value, allowed()));
    }
    let finite = |(i, value): (usize, &JsValue)| {
        let at = format!("{field}[{i}]");
        let number = read_number(&at, value)?;
        if number.is_finite() { Ok(number) } else { Err(js_error(Error::refused(at, number, forage::kernel::error::finite()))) }
    };
    list.iter().enumerate().map(finite).collect()
}

fn read_posture(field: &str, value: &JsValue) -> Result<Posture, JsValue> {
    Ok(radians(&read_numbers(field, value, allowed::six_joints)?))
}

fn read_in_space(field: &str, value: &JsValue) -> Result<[f64; 3], JsValue> {
    read_numbers(field, value, allowed::point_in_space)
}

fn read_direction(value: &JsValue) -> Result<Unit<Vector3<f64>>, JsValue> {
    let direction = Vector3::from(read_in_space("direction", value)?);
    // Scaled first: squares of numbers near the ends of what f64 holds would be infinite, or 0.
    let scaled = direction / direction.amax();
    Unit::try_new(scaled, 0.5).ok_or_else(|| refused("direction", value, allowed::direction()))
}

/// Where the links of a scene's arm are in a posture of six joints in degrees, within its limits or not.
///
/// # Errors
/// An `Error` with `field`, `value` and `allowed`.
#[wasm_bindgen(js_name = armPose)]
pub fn arm_pose(scene: &JsSceneOrName, joints: &JsJoints) -> Result<JsArmPose, JsValue> {
    (ARMS.get()?.pose)(scene, joints)
}

fn pose(scene: &JsValue, joints: &JsValue) -> Result<JsArmPose, JsValue> {
    let scene = read_arm(scene)?;
    let scene = arm_of(&scene)?;
    let posture = read_posture("joints", joints)?;
    plain(&scene.pose(&posture))
}

/// The postures within the limits that bring the tip of a scene's arm to a point with the tool pointing in a direction,
/// nearest to `near` (degrees; without it the home posture) first. Without a direction, null: of 42 spread over the sphere
/// the one whose posture is nearest.
///
/// # Errors
/// An `Error` with `field`, `value` and `allowed`.
#[wasm_bindgen(js_name = armSolutions)]
pub fn arm_solutions(
    scene: &JsSceneOrName,
    point: &JsPoint3,
    direction: &JsPoint3OrNull,
    near: &JsJointsOrUndefined,
) -> Result<JsArmSolutions, JsValue> {
    (ARMS.get()?.solutions)(scene, point, direction, near)
}

fn solutions(scene: &JsValue, point: &JsValue, direction: &JsValue, near: &JsValue) -> Result<JsArmSolutions, JsValue> {
    let scene = read_arm(scene)?;
    let scene = arm_of(&scene)?;
    let point = read_in_space("point", point)?;
    let given = |value: &JsValue| !value.is_undefined() && !value.is_null();
    let near = if given(near) { read_posture("near", near)? } else { scene.arm.home() };
    let direction = if given(direction) { Some(read_direction(direction)?) } else { None };
    plain(&scene.answer(point, direction, &near))
}

/// Where the tip of a scene's arm can come, on a lattice of this step over the workspace, of at most 20000 points.
///
/// # Errors
/// An `Error` with `field`, `value` and `allowed`.
#[wasm_bindgen]
pub fn reachability(scene: &JsSceneOrName, step: &JsNumber) -> Result<JsReachability, JsValue> {
    (ARMS.get()?.reachability)(scene, step)
}

fn cloud(scene: &JsValue, step: &JsValue) -> Result<JsReachability, JsValue> {
    let scene = read_arm(scene)?;
    let step = read_number("step", step)?;
    let cloud = arm::reachability(arm_of(&scene)?, step).map_err(js_error)?;
    Ok(object(&[("points", Float32Array::from(&cloud.points[..]).into()), ("step", cloud.step.into())]))
}

/// Where a scene's arm touches something while two of its joints turn and the others stay as in `joints`: 64 rows of 64 cells, 1
/// where it does in the middle of a cell. `pair` are the two joints, from 0; `min` and `max` their angles at the borders: the first
/// joint's change within a row, the second's from row to row. Angles are in degrees, the links' radius is in metres.
///
/// # Errors
/// An `Error` with `field`, `value` and `allowed`.
#[wasm_bindgen(js_name = armSlice)]
pub fn arm_slice(
    scene: &JsSceneOrName,
    joints: &JsJoints,
    pair: &JsPoint,
    min: &JsPoint,
    max: &JsPoint,
    radius: &JsNumber,
) -> Result<Uint8Array, JsValue> {
    (ARMS.get()?.slice)(scene, joints, pair, min, max, radius)
}

fn slice(scene: &JsValue, joints: &JsValue, pair: &JsValue, min: &JsValue, max: &JsValue, radius: &JsValue) -> Result<Uint8Array, JsValue> {
    let scene = read_arm(scene)?;
    let posture = read_posture("joints", joints)?;
    let pair = read_numbers("pair", pair, allowed::point)?
        .map(|joint| if joint >= 0.0 && joint.fract() == 0.0 { joint as usize } else { usize::MAX });
    let [min, max] = [("min", min), ("max", max)].map(|(field, value)| read_numbers::<2>(field, value, allowed::point));
    let [min, max] = [min?, max?].map(|angles| angles.map(f64::to_radians));
    let cells = arm::slice(arm_of(&scene)?, &posture, pair, min, max, read_number("radius", radius)?).map_err(js_error)?;
    Ok(Uint8Array::from(&cells[..]))
}
