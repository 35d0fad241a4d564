import { DirectionalLight, Group, HemisphereLight, Matrix4, PCFShadowMap, PerspectiveCamera, Scene, Vector3, WebGLRenderer } from 'three'
import type { Arm, ArmScene, ArmSolutions, Cuboid } from 'forage-lab'
import { colorOf, type Palette } from '../palette'
import type { Size } from '../view'
import { Boxes, type Mood } from './boxes'
import { Cloud } from './cloud'
import { colourOf, mixed } from './colors'
import { home, type Stance } from './kinematics'
import { Layers } from './layers'
import { Machine, skin, veil } from './machine'
import { basis, eyeOf, FAR, FIELD_OF_VIEW, NEAR, type Orbit, pixel } from './orbit'
import { Room } from './room'

/** How much of a ghost is seen, and of the one that is pointed at. */
const GHOST = { many: 0.16, one: 0.6 }
/** Pixels finer than these cost more than they show. */
const DENSEST = 2
const SHADOWS = 2048
const LIGHT = colorOf('--light').light

/** Everything that is drawn in space. It draws when it is asked to, and never by itself. */
export class World {
  readonly layers = new Layers()
  readonly cloud = new Cloud()
  private readonly renderer: WebGLRenderer
  private readonly scene = new Scene()
  private readonly camera = new PerspectiveCamera(FIELD_OF_VIEW)
  private readonly room = new Room()
  private readonly boxes = new Boxes()
  private readonly key = new DirectionalLight(LIGHT, 1.9)
  private readonly sky = new HemisphereLight(LIGHT, LIGHT, 1.6)
  private skin: ReturnType<typeof skin> | undefined
  private machine: Machine | undefined
  private ghosts: Machine[] = []
  private readonly spirits = new Group()
  private size: Size = { width: 1, height: 1 }
  private orbit: Orbit | undefined
  /** What throws shadows has moved since they were drawn. */
  private moved = true

  constructor(canvas: HTMLCanvasElement | OffscreenCanvas, context: WebGL2RenderingContext) {
    this.renderer = new WebGLRenderer({ canvas, context })
    this.renderer.shadowMap.enabled = true
    this.renderer.shadowMap.type = PCFShadowMap
    // Shadows don't change with the eye.
    this.renderer.shadowMap.autoUpdate = false
    this.key.castShadow = true
    this.key.shadow.mapSize.set(SHADOWS, SHADOWS)
    this.key.shadow.radius = 5
    this.key.shadow.bias = -0.0004
    this.key.shadow.normalBias = 0.01
    const fill = new DirectionalLight(LIGHT, 0.55)
    fill.position.set(1.5, -1, 0.6)
    this.sky.position.set(0, 0, 1)
    this.scene.add(
      this.key,
      this.key.target,
      fill,
      this.sky,
      this.room.group,
      this.boxes.group,
      this.layers.group,
      this.cloud.points,
      this.spirits,
    )
  }

  /** `density`: pixels of the screen a pixel of the page. */
  resize(size: Size, density: number): void {
    this.size = size
    this.renderer.setPixelRatio(Math.min(density, DENSEST))
    this.renderer.setSize(size.width, size.height, false)
    this.camera.aspect = size.width / size.height
  }

  look(orbit: Orbit): void {
    this.orbit = orbit
    const [right, up, back] = basis(orbit).map((axis) => new Vector3(...axis)) as [Vector3, Vector3, Vector3]
    this.camera.position.set(...eyeOf(orbit))
    this.camera.quaternion.setFromRotationMatrix(new Matrix4().makeBasis(right, up, back))
    this.camera.near = orbit.distance * NEAR
    this.camera.far = orbit.distance * FAR
    this.camera.updateProjectionMatrix()
    this.camera.updateMatrixWorld()
  }

  paint(palette: Palette, dark: boolean): void {
    const colour = (token: string) => colourOf(palette, token)
    const stage = colour('--stage')
    this.scene.background = stage
    this.sky.groundColor.copy(mixed(stage, colour('--line-strong'), 0.35))
    this.sky.intensity = dark ? 1.9 : 1.75
    this.room.paint(
      mixed(stage, colour('--surface-2'), dark ? 0.55 : 0.6),
      mixed(colour('--grid'), colour('--axis'), 0.65),
      mixed(colour('--axis'), colour('--line-strong'), 0.45),
      dark ? 0.5 : 0.17,
    )
    const edge = colour('--disc-edge')
    const side = mixed(colour('--disc'), colour('--wall-edge'), dark ? 0.42 : 0.12)
    this.boxes.paint({
      plain: { side, edge, width: 1.25 },
      hover: { side, edge: colour('--line-strong'), width: 2.25 },
      selected: { side, edge: colour('--focus'), width: 2.5 },
      wrong: { side: colour('--danger-soft'), edge: colour('--danger'), width: 2.25 },
    })
    const robot = colour('--robot')
    const white = colour(dark ? '--ink' : '--stage')
    this.skin ??= skin(robot, robot, robot)
    this.skin.body.color.copy(mixed(robot, white, dark ? 0.72 : 0.8))
    this.skin.joint.color.copy(mixed(robot, stage, dark ? 0.25 : 0.12))
    this.skin.tool.color.copy(colour('--ink-2'))
  }

  showRoom(workspace: Cuboid): void {
    this.moved = true
    this.room.show(workspace)
    const [low, high] = [new Vector3(...workspace.min), new Vector3(...workspace.max)]
    const middle = low.clone().add(high).multiplyScalar(0.5)
    const radius = low.distanceTo(high) * 0.75
    this.key.target.position.copy(middle)
    this.key.position.copy(middle).add(new Vector3(-0.45, -0.55, 1.35).multiplyScalar(radius * 1.5))
    Object.assign(this.key.shadow.camera, {
      left: -radius,
      right: radius,
      bottom: -radius,
      top: radius,
      near: radius * 0.2,
      far: radius * 5,
    })
    this.key.shadow.camera.updateProjectionMatrix()
  }

  showBoxes(cuboids: readonly Cuboid[], moodOf: (index: number) => Mood): void {
    this.moved = true
    this.boxes.show(cuboids, moodOf)
  }

  /** Another arm, or the same elsewhere; `radius`: that of its links. */
  showArm({ arm, workspace }: ArmScene, radius: number): void {
    if (this.machine) this.scene.remove(this.machine.group)
    this.machine?.drop()
    if (!this.skin) return
    this.machine = new Machine(arm, this.skin, workspace.min[2], radius)
    this.scene.add(this.machine.group)
  }

  /** Its joints in degrees, null: at home. It is in trouble where it touches something. */
  pose(arm: Arm, posture: readonly number[] | null, visible: boolean, trouble: boolean, palette: Palette): Stance | null {
    if (!this.machine || !this.skin) return null
    this.moved = true
    this.machine.group.visible = visible
    const glow = trouble ? colourOf(palette, '--danger') : null
    for (const material of [this.skin.body, this.skin.joint]) {
      material.emissive.set(glow ?? 0)
      material.emissiveIntensity = glow ? 0.55 : 0
    }
    return this.machine.pose(posture ?? home(arm))
  }

  showGhosts(arm: Arm, ghosts: ArmSolutions | null, chosen: number | null, palette: Palette): void {
    for (const ghost of this.ghosts) ghost.drop()
    this.spirits.clear()
    this.ghosts = (ghosts?.solutions ?? []).map(({ joints, free }, index) => {
      const alpha = index === chosen ? GHOST.one : GHOST.many * (chosen === null ? 1.4 : 0.7)
      const machine = new Machine(arm, veil(colourOf(palette, free ? '--accent' : '--danger'), alpha), null)
      machine.pose(joints)
      this.spirits.add(machine.group)
      return machine
    })
  }

  render(): void {
    if (!this.orbit) return
    this.layers.scale(pixel(this.orbit, this.size))
    this.renderer.shadowMap.needsUpdate = this.moved
    this.moved = false
    this.renderer.render(this.scene, this.camera)
  }

  /** The graphics card has lost what it knew. */
  forget(): void {
    this.moved = true
  }

  drop(): void {
    for (const part of [this.layers, this.cloud, this.room, this.boxes, this.machine, ...this.ghosts]) part?.drop()
    this.renderer.dispose()
  }
}
