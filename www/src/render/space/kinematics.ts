import type { Arm, Cuboid, Point3 } from 'forage-lab'
import { along, cross, plus, radians, times } from '../../scene/vector'

/** Where an arm's parts are in a posture. */
export interface Stance {
  /** Base, shoulder, elbow, wrist and tip. */
  skeleton: readonly Point3[]
  /** The directions of the joints' axes. */
  axes: readonly Point3[]
}

/** The home posture, in degrees. */
export const home = (arm: Arm): number[] => arm.joints.map((joint) => joint.home)

/** Where a link is, and where its x and z point to. */
interface Frame {
  origin: Point3
  x: Point3
  z: Point3
}

const yOf = ({ x, z }: Frame): Point3 => cross(z, x)

/** Turned about its x, by degrees. */
function rolled(frame: Frame, angle: number): Frame {
  const [cos, sin] = [Math.cos(radians(angle)), Math.sin(radians(angle))]
  return { ...frame, z: plus(times(frame.z, cos), times(yOf(frame), -sin)) }
}

/** Turned about its z, by degrees. */
function turned(frame: Frame, angle: number): Frame {
  const [cos, sin] = [Math.cos(radians(angle)), Math.sin(radians(angle))]
  return { ...frame, x: plus(times(frame.x, cos), times(yOf(frame), sin)) }
}

/** The product of the links' transforms, [ARM-RRT] (1), as the core has it: Rx(α) Tx(a) Rz(θ) Tz(d) each. */
export function stance(arm: Arm, posture: readonly number[]): Stance {
  const { position, yaw = 0 } = arm.base
  let frame = turned({ origin: [...position], x: [1, 0, 0], z: [0, 0, 1] }, yaw)
  const origins = [frame.origin]
  const axes: Point3[] = []
  arm.joints.forEach(({ a, alpha, d }, at) => {
    const next = rolled(frame, alpha)
    frame = turned({ ...next, origin: along(next.origin, next.x, a) }, posture[at] ?? 0)
    frame = { ...frame, origin: along(frame.origin, frame.z, d) }
    origins.push(frame.origin)
    axes.push(frame.z)
  })
  const { axis, length } = arm.tool
  const tip = along(frame.origin, { x: frame.x, y: yOf(frame), z: frame.z }[axis], length)
  const [base, , shoulder, elbow, wrist] = origins
  return { skeleton: [base, shoulder, elbow, wrist, tip].map((point) => point ?? [0, 0, 0]), axes }
}

/** About how far an arm reaches from its first axis. */
export function reachOf(arm: Arm): number {
  return arm.joints.reduce((sum, { a, d }) => sum + Math.hypot(a, d), arm.tool.length)
}

/** A box about the workspace and the arm in its home posture: what is to be seen. */
export function whole(workspace: Cuboid, arm: Arm): Cuboid {
  const points = [workspace.min, workspace.max, ...stance(arm, home(arm)).skeleton]
  const [min, max] = [Math.min, Math.max].map((of) => [0, 1, 2].map((axis) => of(...points.map((point) => point[axis] ?? 0))) as Point3)
  return { min: min ?? workspace.min, max: max ?? workspace.max }
}
