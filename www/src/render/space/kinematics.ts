import { MathUtils, Matrix4, Vector3 } from 'three'
import type { Arm, Cuboid } from 'forage-lab'

/** Where an arm's parts are in a posture. */
export interface Stance {
  /** Base, shoulder, elbow, wrist and tip. */
  skeleton: readonly Vector3[]
  /** The directions of the joints' axes. */
  axes: readonly Vector3[]
}

/** The home posture, in degrees. */
export const home = (arm: Arm): number[] => arm.joints.map((joint) => joint.home)

/** The product of the links' transforms, [ARM-RRT] (1), as the core has it: Rx(α) Tx(a) Rz(θ) Tz(d) each. */
export function stance(arm: Arm, posture: readonly number[]): Stance {
  const { position, yaw = 0 } = arm.base
  const frame = new Matrix4().makeRotationZ(MathUtils.degToRad(yaw)).setPosition(...position)
  const origins = [new Vector3(...position)]
  const axes: Vector3[] = []
  arm.joints.forEach(({ a, alpha, d }, at) => {
    frame
      .multiply(new Matrix4().makeRotationX(MathUtils.degToRad(alpha)).setPosition(a, 0, 0))
      .multiply(new Matrix4().makeRotationZ(MathUtils.degToRad(posture[at] ?? 0)))
      .multiply(new Matrix4().makeTranslation(0, 0, d))
    origins.push(new Vector3().setFromMatrixPosition(frame))
    axes.push(new Vector3().setFromMatrixColumn(frame, 2))
  })
  const { axis, length } = arm.tool
  const tool = new Vector3().setComponent(['x', 'y', 'z'].indexOf(axis), length)
  const [base, , shoulder, elbow, wrist] = origins
  const skeleton = [base, shoulder, elbow, wrist, tool.applyMatrix4(frame)].map((point) => point ?? new Vector3())
  return { skeleton, axes }
}

/** About how far an arm reaches from its first axis. */
export function reachOf(arm: Arm): number {
  return arm.joints.reduce((sum, { a, d }) => sum + Math.hypot(a, d), arm.tool.length)
}

/** A box about the workspace and the arm in its home posture: what is to be seen. */
export function whole(workspace: Cuboid, arm: Arm): Cuboid {
  const points = [new Vector3(...workspace.min), new Vector3(...workspace.max), ...stance(arm, home(arm)).skeleton]
  const low = points.reduce((found, point) => found.min(point), points[0]?.clone() ?? new Vector3())
  const high = points.reduce((found, point) => found.max(point), points[0]?.clone() ?? new Vector3())
  return { min: [low.x, low.y, low.z], max: [high.x, high.y, high.z] }
}
