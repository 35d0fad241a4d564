import type { Item, Point } from 'forage-lab'
import { armOf } from '../../stores/arm.svelte'
import { added, type Axis, faced, moved, objects, whereIs, withBase, without } from '../../scene/arm'
import { rounded, same, type Selection } from '../../scene/edits'
import { times } from '../../scene/vector'
import type { Lab } from '../../stores/lab.svelte'
import { NODES } from '../../stores/nodes'
import { columnOf, distance, faceOf, facing, type Grip, Hold, liftAt } from '../../render/space/handles'
import type { Camera } from '../../render/space/camera'
import { basis, type Orbit } from '../../render/space/orbit'
import type { Renderer } from '../../render/display'

/** How near a pointer and a finger have to come, in pixels: to marks and handles, and to a node. */
const REACH = { mouse: 11, finger: 24 }
/** On a small screen a cuboid would be nothing but handles. */
const FACE = { mouse: 11, finger: 15 }
const NODE = { mouse: 7, finger: 16 }
/** How far a key moves what is selected, in metres, and turns the base, in degrees. */
const STEP = 0.01
const TURN = 5
/** Keys that follow each other within this many milliseconds go on from where the last one led. */
const ROW = 800

/** What a grip is of; `present`: what is selected. */
const selectionOf = (grip: Grip, present: Selection | null): Selection | null =>
  grip.kind === 'face' ? { kind: 'cuboid', index: grip.index } : grip.kind === 'lift' ? present : grip

/** What pointer and keys do to a scene in space. */
export class PointerController {
  hover = $state.raw<Grip | null>(null)
  held = $state.raw<Grip | null>(null)
  /** There is something under the pointer that can be looked at closer. */
  pointed = $state(false)
  private hold: Hold | null = null
  private walked: { item: Item; at: number } | null = null

  /** Of the latest question for a point. */
  private turn = 0

  /** `renderer`: who draws the stage, and knows what lies under a point of it. */
  constructor(
    private readonly lab: Lab,
    private readonly renderer: () => Renderer | null,
  ) {}

  /** What lies under a point of the screen: handles of what is selected over marks, marks over what is solid. */
  private under(camera: Camera, at: Point, coarse: boolean): Grip | null {
    const scene = this.lab.scene.arm
    if (!scene) return null
    const reach = coarse ? REACH.finger : REACH.mouse
    const away = (point: Parameters<Camera['project']>[0]): number => {
      const seen = camera.project(point)
      return seen ? Math.hypot(seen.x - at[0], seen.y - at[1]) : Infinity
    }
    const { object: selection } = this.lab.selection
    if (selection) {
      const lift = liftAt(scene, selection, camera)
      if (lift && Math.abs(lift[0] - at[0]) <= reach && Math.abs(lift[1] - at[1]) <= Math.max(reach, 14)) return { kind: 'lift' }
      const cuboid = selection.kind === 'cuboid' ? scene.cuboids[selection.index] : undefined
      const face = cuboid && facing(cuboid, camera).find((one) => away(faceOf(cuboid, one)) <= (coarse ? FACE.finger : FACE.mouse))
      if (face && 'index' in selection) return { kind: 'face', index: selection.index, ...face }
    }
    const end = (['goal', 'start'] as const).find((kind) => away(scene[kind]) <= reach)
    if (end) return { kind: end }
    const ray = camera.ray(at)
    const solid = [...scene.cuboids, columnOf(scene)]
      .map((box, index) => ({ index, far: distance(ray, box) }))
      .filter(({ far }) => Number.isFinite(far))
      .sort((a, b) => a.far - b.far)[0]
    if (!solid) return away(scene.arm.base.position) <= reach ? { kind: 'base' } : null
    return solid.index < scene.cuboids.length ? { kind: 'cuboid', index: solid.index } : { kind: 'base' }
  }

  /** A finger that turns the view must not carry off what it lands on: solid things are held once they are selected. */
  private holds(grip: Grip, coarse: boolean): boolean {
    if (grip.kind === 'cuboid' || grip.kind === 'base') return same(this.lab.selection.object, grip) || !(coarse || grip.kind === 'base')
    return true
  }

  grab(camera: Camera, at: Point, coarse: boolean): boolean {
    const { arm: scene } = this.lab.scene
    const grip = this.under(camera, at, coarse)
    const selection = grip && selectionOf(grip, this.lab.selection.object)
    if (!scene || !grip || !selection || !this.holds(grip, coarse)) return false
    this.held = grip
    this.hold = new Hold(scene, grip, selection, camera, at)
    return true
  }

  drag(at: Point, across: boolean): void {
    const { arm: scene } = this.lab.scene
    if (!this.hold || !scene) return
    const selection = selectionOf(this.hold.grip, this.lab.selection.object)
    if (!same(this.lab.selection.object, selection)) this.lab.selection.select(selection)
    this.lab.scene.drag(this.hold.carry(scene, at, across))
  }

  drop(cancelled: boolean): void {
    this.hold = null
    this.held = null
    if (cancelled) this.lab.scene.abandon()
    else this.lab.scene.settle()
  }

  over(camera: Camera, at: Point | null): void {
    const grip = at && this.under(camera, at, false)
    this.hover = grip
    const handle = grip && ['face', 'lift', 'start', 'goal'].includes(grip.kind)
    if (at && !handle) this.ask(at, NODE.mouse, (item) => this.meet(item))
    else {
      this.turn += 1
      this.meet(null)
    }
  }

  private meet(item: Item | null): void {
    this.pointed = item !== null
    armOf(this.lab).node = item?.role === NODES ? item.index : null
  }

  /** The nearest of the points that are shown, can be seen, and can be looked at closer; only the latest question is answered. */
  private ask(at: Point, reach: number, found: (item: Item | null) => void): void {
    this.turn += 1
    const { turn } = this
    const layers = this.lab.layers.list.filter(({ pickable }) => pickable).map(({ role }) => role)
    const asked = this.renderer()?.nearest(at, reach, layers) ?? Promise.resolve(null)
    asked.then(
      (item) => {
        // Of a big tree only some nodes are drawn.
        if (turn === this.turn) found(item && { ...item, index: item.index * (this.lab.run.report?.thinning ?? 1) })
      },
      () => undefined,
    )
  }

  tap(camera: Camera, at: Point, coarse: boolean): void {
    const grip = this.under(camera, at, coarse)
    if (grip && grip.kind !== 'cuboid' && grip.kind !== 'base') {
      this.lab.selection.select(selectionOf(grip, this.lab.selection.object))
      return
    }
    this.ask(at, coarse ? NODE.finger : NODE.mouse, (item) => {
      this.lab.selection.select(item ? null : grip)
      if (item || !grip) this.lab.selection.inspect(item)
    })
  }

  /** From the node that is looked at to another one; the first is the root. */
  walk(by: 1 | -1): void {
    const now = performance.now()
    // Keys come faster than answers.
    const item = this.walked && now - this.walked.at < ROW ? this.walked.item : this.lab.selection.inspection?.item
    const index = item?.role === NODES ? Math.min(item.index + by, (this.lab.run.readings.nodes ?? Infinity) - 1) : 0
    this.walked = { item: { role: NODES, index: Math.max(0, index) }, at: now }
    this.lab.selection.select(null)
    this.lab.selection.inspect(this.walked.item)
  }

  /** The next thing that can be selected, or the one before. */
  next(by: 1 | -1): void {
    if (!this.lab.scene.arm) return
    const all = objects(this.lab.scene.arm)
    const from = all.findIndex((one) => same(one, this.lab.selection.object))
    const to = from < 0 ? (by > 0 ? 0 : all.length - 1) : (from + by + all.length) % all.length
    this.lab.selection.select(all[to] ?? null)
  }

  /** Keys move what is selected: to the right and away as the view has it, and upwards. */
  nudge(orbit: Orbit, [right, away, up]: readonly [number, number, number]): void {
    const { arm: scene } = this.lab.scene
    const { object: selection } = this.lab.selection
    const at = scene && selection && whereIs(scene, selection)
    if (!at) return
    const [axis, by] = alongAxis(orbit, [right, away, up])
    at[axis] = rounded(at[axis] + by * STEP)
    this.lab.scene.press(moved(scene, selection, at))
  }

  /** Keys move a cuboid's far faces, and turn the base. */
  stretch(orbit: Orbit, keys: readonly [number, number, number]): void {
    const { arm: scene } = this.lab.scene
    const { object: selection } = this.lab.selection
    if (!scene || !selection) return
    const [axis, by] = alongAxis(orbit, keys)
    if (selection.kind === 'base')
      this.lab.scene.press(withBase(scene, { yaw: rounded((scene.arm.base.yaw ?? 0) - TURN * (keys[0] || -keys[1])) }))
    else if (selection.kind === 'cuboid') {
      const cuboid = scene.cuboids[selection.index]
      if (!cuboid) return
      // As the view has it: the face at the far end goes where the key points to.
      const side = sideOf(orbit, axis)
      this.lab.scene.press(faced(scene, selection.index, { axis, side }, rounded(cuboid[side][axis] + by * STEP)))
    } else {
      this.nudge(orbit, [10 * keys[0], 10 * keys[1], 10 * keys[2]])
    }
  }

  add(orbit: Orbit): void {
    const scene = this.lab.scene.arm
    if (!scene) return
    const [x, y] = orbit.target
    this.lab.scene.edit(added(scene, [x, y, scene.workspace.min[2]]))
    this.lab.selection.select({ kind: 'cuboid', index: scene.cuboids.length })
  }

  remove(): void {
    const { arm: scene } = this.lab.scene
    const { object: selection } = this.lab.selection
    const left = scene && without(scene, selection)
    if (!left || left === scene) return
    this.lab.selection.select(null)
    this.lab.scene.edit(left)
  }

  leave(): void {
    this.walked = null
    this.lab.selection.select(null)
    this.lab.selection.inspect(null)
  }
}

/** Which axis of space a key means, and which way. */
function alongAxis(orbit: Orbit, [right, away, up]: readonly [number, number, number]): [axis: Axis, by: number] {
  if (up !== 0) return [2, up]
  const [to, , back] = basis({ ...orbit, elevation: 0 })
  const way = right !== 0 ? times(to, right) : times(back, -away)
  const axis: Axis = Math.abs(way[0]) >= Math.abs(way[1]) ? 0 : 1
  return [axis, Math.sign(way[axis]) * Math.abs(right || away)]
}

/** The face that lies to the right, at the back or on top. */
function sideOf(orbit: Orbit, axis: Axis): 'min' | 'max' {
  if (axis === 2) return 'max'
  const [to, , back] = basis({ ...orbit, elevation: 0 })
  const [across, deep] = [to[axis], -back[axis]]
  return (Math.abs(across) >= Math.abs(deep) ? across : deep) > 0 ? 'max' : 'min'
}
