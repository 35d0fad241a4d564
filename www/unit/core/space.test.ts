import { PerspectiveCamera, Quaternion, Matrix4, Vector3 } from 'three'
import { expect, test } from 'vitest'
import { armPose, type Point3, Session } from '../../../pkg/node.js'
import { Camera } from '../../src/render/space/camera'
import { home, stance } from '../../src/render/space/kinematics'
import { basis, eyeOf, FIELD_OF_VIEW, type Orbit } from '../../src/render/space/orbit'

const session = new Session({ planner: 'rrt', scene: 'arm-puma' })
const { scene } = session
if (scene.kind !== 'arm') throw new Error(scene.kind)
const { arm } = scene

test('an arm stands where the core has it, in any posture', () => {
  const postures = [home(arm), arm.joints.map((_, at) => 17 * at - 40), arm.joints.map((_, at) => 90 - 33 * at)]
  for (const posture of postures) {
    const { skeleton } = armPose(scene, posture)
    stance(arm, posture).skeleton.forEach((point, at) => {
      for (const [axis, value] of point.entries()) expect(value).toBeCloseTo(skeleton[at]?.[axis] ?? NaN, 12)
    })
  }
})

test('a camera shows points where a camera of the library does, and looks along its rays', () => {
  const size = { width: 900, height: 600 }
  const orbits: Orbit[] = [
    { target: [0.2, -0.1, 0.4], distance: 3, azimuth: -62, elevation: 27 },
    { target: [0, 0, 0], distance: 1.5, azimuth: 140, elevation: 90 },
    { target: [1, 2, 3], distance: 7, azimuth: 5, elevation: -20 },
  ]
  for (const orbit of orbits) {
    const other = new PerspectiveCamera(FIELD_OF_VIEW, size.width / size.height, orbit.distance / 50, orbit.distance * 8)
    const [right, up, back] = basis(orbit).map((axis) => new Vector3(...axis)) as [Vector3, Vector3, Vector3]
    other.position.set(...eyeOf(orbit))
    other.quaternion.copy(new Quaternion().setFromRotationMatrix(new Matrix4().makeBasis(right, up, back)))
    other.updateMatrixWorld()
    const camera = new Camera(orbit, size)
    for (const by of [
      [0, 0, 0],
      [0.3, -0.2, 0.1],
      [-0.5, 0.4, 0.2],
    ] as Point3[]) {
      const point: Point3 = [orbit.target[0] + by[0], orbit.target[1] + by[1], orbit.target[2] + by[2]]
      const seen = camera.project(point)
      const at = new Vector3(...point).project(other)
      expect(seen?.x).toBeCloseTo(((at.x + 1) / 2) * size.width, 6)
      expect(seen?.y).toBeCloseTo(((1 - at.y) / 2) * size.height, 6)
      const { origin, direction } = camera.ray([seen?.x ?? NaN, seen?.y ?? NaN])
      for (const [axis, part] of direction.entries())
        expect((origin[axis] ?? NaN) + part * (seen?.depth ?? NaN)).toBeCloseTo(point[axis] ?? NaN, 9)
    }
    const behind = new Vector3(...eyeOf(orbit)).addScaledVector(back, 1)
    expect(camera.project([behind.x, behind.y, behind.z])).toBeNull()
  }
})
