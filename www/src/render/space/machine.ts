import {
  type BufferGeometry,
  type Color,
  ConeGeometry,
  CylinderGeometry,
  Group,
  type Material,
  Mesh,
  MeshStandardMaterial,
  SphereGeometry,
  Vector3,
} from 'three'
import type { Arm } from 'forage-lab'
import { lengthOf, minus } from '../../scene/vector'
import { home, reachOf, type Stance, stance } from './kinematics'

/** What an arm's parts are made of. */
export interface Skin {
  body: Material
  joint: Material
  tool: Material
}

/** Radii as shares of how far the arm reaches: where a link begins, where it ends. */
const LINKS = [
  [0.05, 0.047],
  [0.04, 0.031],
  [0.031, 0.02],
] as const
const JOINTS = [0.05, 0.041, 0.026] as const
const WRIST = 0.028
/** How long a joint's housing is, in radii of it. */
const HOUSING = 2.3
const ROUND = 28

const UP = new Vector3(0, 1, 0)

/** An arm as links and joints. Its links run along the skeleton that the core tests; their width is for the eye. */
export class Machine {
  readonly group = new Group()
  private readonly links: Mesh[] = []
  private readonly ends: Mesh[] = []
  private readonly housings: Mesh[] = []
  private readonly tool = new Group()
  private readonly turret: Mesh | undefined
  private readonly geometries: BufferGeometry[] = []

  /** `floor`: where its column stands; null: without one, beside the same arm. `least`: the radius that its links have at least. */
  constructor(
    private readonly arm: Arm,
    private readonly skin: Skin,
    floor: number | null,
    least = 0,
  ) {
    const reach = reachOf(arm)
    const at = stance(arm, home(arm))
    const length = (joint: number): number => lengthOf(minus(at.skeleton[joint + 1] ?? [0, 0, 0], at.skeleton[joint] ?? [0, 0, 0]))
    LINKS.forEach(([from, to], joint) => {
      const [wide, narrow] = [Math.max(least, from * reach), Math.max(least, to * reach)]
      this.links.push(this.part(new CylinderGeometry(narrow, wide, length(joint), ROUND), skin.body))
      this.ends.push(this.part(new SphereGeometry(narrow, ROUND, ROUND / 2), skin.body))
    })
    JOINTS.forEach((share) => {
      const radius = Math.max(least, share * reach)
      this.housings.push(this.part(new CylinderGeometry(radius, radius, HOUSING * radius, ROUND), skin.joint))
    })
    const base = JOINTS[0] * reach
    this.makeTool(length(3), reach, least)
    if (floor !== null) {
      this.turret = this.part(new CylinderGeometry(base * 1.15, base * 1.3, 2 * base, ROUND), skin.joint)
      this.stand(floor)
    }
    this.pose(home(arm))
  }

  private part(geometry: BufferGeometry, material: Material, parent: Group = this.group): Mesh {
    this.geometries.push(geometry)
    const mesh = new Mesh(geometry, material)
    mesh.castShadow = mesh.receiveShadow = !material.transparent
    parent.add(mesh)
    return mesh
  }

  /** A flange and a point, from the wrist upwards. */
  private makeTool(length: number, reach: number, least: number): void {
    const radius = Math.max(least, WRIST * reach)
    this.part(new SphereGeometry(radius * 0.92, ROUND, ROUND / 2), this.skin.body, this.tool)
    const flange = this.part(new CylinderGeometry(radius * 0.8, radius * 0.8, length * 0.28, ROUND), this.skin.body, this.tool)
    flange.position.y = length * 0.32
    const point = this.part(new ConeGeometry(radius * 0.5, length * 0.56, ROUND), this.skin.tool, this.tool)
    point.position.y = length * 0.72
    this.group.add(this.tool)
  }

  /** The column between the floor and the base, and its foot. */
  private stand(floor: number): void {
    const { position, column_radius: radius = 0 } = this.arm.base
    const height = position[2] - floor
    if (radius <= 0 || height <= 0) return
    const column = this.part(new CylinderGeometry(radius, radius, height, 2 * ROUND), this.skin.body)
    const foot = this.part(new CylinderGeometry(radius * 1.35, radius * 1.45, 0.012, 2 * ROUND), this.skin.joint)
    for (const [mesh, z] of [
      [column, floor + height / 2],
      [foot, floor + 0.006],
    ] as const) {
      mesh.position.set(position[0], position[1], z)
      mesh.quaternion.setFromUnitVectors(UP, new Vector3(0, 0, 1))
    }
  }

  /** Joints in degrees. */
  pose(posture: readonly number[]): Stance {
    const now = stance(this.arm, posture)
    const [skeleton, axes] = [now.skeleton, now.axes].map((all) => all.map((one) => new Vector3(...one))) as [Vector3[], Vector3[]]
    const point = (at: number): Vector3 => skeleton[at] ?? new Vector3()
    for (const [at, link] of this.links.entries()) span(link, point(at), point(at + 1))
    for (const [at, end] of this.ends.entries()) end.position.copy(point(at + 1))
    // The axes that turn upper arm, forearm and hand lie in shoulder, elbow and wrist.
    for (const [at, axis] of [1, 2, 4].entries()) put(this.housings[at], point(at + 1), axes[axis])
    put(this.turret, point(0), axes[0])
    const tip = point(4).clone().sub(point(3))
    put(this.tool, point(3), tip.lengthSq() > 0 ? tip.normalize() : axes[5])
    return now
  }

  drop(): void {
    for (const geometry of this.geometries) geometry.dispose()
  }
}

function put(part: Mesh | Group | undefined, at: Vector3, along: Vector3 | undefined): void {
  part?.position.copy(at)
  if (along) part?.quaternion.setFromUnitVectors(UP, along)
}

function span(link: Mesh, from: Vector3, to: Vector3): void {
  const along = to.clone().sub(from)
  link.visible = along.lengthSq() > 0
  put(link, from.clone().addScaledVector(along, 0.5), along.normalize())
}

/** What a solid arm is made of. */
export function skin(
  body: Color,
  joint: Color,
  tool: Color,
): Skin & { body: MeshStandardMaterial; joint: MeshStandardMaterial; tool: MeshStandardMaterial } {
  return {
    body: new MeshStandardMaterial({ color: body, roughness: 0.48, metalness: 0.05 }),
    joint: new MeshStandardMaterial({ color: joint, roughness: 0.4, metalness: 0.1 }),
    tool: new MeshStandardMaterial({ color: tool, roughness: 0.35, metalness: 0.3 }),
  }
}

/** What a ghost is made of. */
export function veil(colour: Color, alpha: number): Skin {
  const material = new MeshStandardMaterial({ color: colour, roughness: 0.6, transparent: true, opacity: alpha, depthWrite: false })
  return { body: material, joint: material, tool: material }
}
