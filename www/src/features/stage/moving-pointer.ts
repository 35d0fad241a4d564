import type { GridScene, Layer, Point } from 'forage-lab'
import { moving } from '../../locales/en/moving'
import { added, aimed, neatly, steered, strideOf, tipOf } from '../../scene/aiming'
import { type Handle, move, place, same, type Selection } from '../../scene/edits'
import type { Lab } from '../../stores/lab.svelte'
import { movedTo, pointsOf } from '../../render/anchors'
import { eventAt, hitMoving } from '../../render/hit-moving'
import { type Size, toScene, type View } from '../../render/view'

/** How near to an axis, in pixels, an arrow is straight. */
const MAGNET = 5

const moverOf = (handle: Handle | null): Selection | null =>
  handle?.kind === 'moving' || handle?.kind === 'aim' ? { kind: 'moving', index: handle.index } : null

/** The pointer of the whole stage. */
interface Pointer {
  tool: string
  readonly using: string
  held: Handle | null
}

/** What pointer and keys do to moving obstacles. */
export class MovingPointer {
  /** From the pointer to what it holds. */
  private offset: Point = [0, 0]
  private held: Handle | null = null
  /** An obstacle that a press puts into a scene, and a drag aims. */
  private born: { scene: GridScene; at: Point } | null = null

  constructor(
    private readonly lab: Lab,
    private readonly pointer: Pointer,
  ) {}

  /** Where the moving obstacles are now, as far as the planner says. */
  get now(): Point[] | null {
    return this.lab.picture.anchors && movedTo(this.lab.picture.anchors, this.lab.scene.moving.length)
  }

  /** A drive goes on: what is on its way can't be caught. */
  get rushing(): boolean {
    return this.lab.playback.playing && this.now !== null
  }

  /** What is meant by a press, beside what else lies there. Ends lie on top, but not of what is selected. */
  under(found: Handle | null, view: View, size: Size, at: Point, coarse: boolean): Handle | null {
    if (!this.lab.scene.grid || this.pointer.using === 'paint') return found
    const mover = hitMoving(this.lab.scene.grid, this.now, view, size, at, this.lab.selection.object, coarse)
    const covered = (found?.kind === 'start' || found?.kind === 'goal') && !same(this.lab.selection.object, moverOf(mover))
    return mover && !covered ? mover : found
  }

  /** Takes hold of what lies there, or of a new one. */
  grab(view: View, size: Size, at: Point, handle: Handle | null): boolean {
    const { grid } = this.lab.scene
    const [x, y] = toScene(view, size, at)
    if (grid && this.pointer.using === 'add-moving') {
      this.born = { scene: grid, at: [x, y] }
      return true
    }
    const object = moverOf(handle)
    if (!grid || !object || this.rushing) return false
    const one = handle?.kind === 'aim' && 'index' in object ? this.lab.scene.moving[object.index] : undefined
    const anchor = (one && tipOf(one)) ?? place(grid, object)
    this.offset = [anchor[0] - x, anchor[1] - y]
    this.pointer.held = this.held = handle
    return true
  }

  /** True while something is held. */
  drag(view: View, size: Size, at: Point): boolean {
    const [x, y] = toScene(view, size, at)
    if (this.born) {
      const { scene, at: center } = this.born
      this.lab.scene.drag(added(scene, center, straight(view, [x - center[0], y - center[1]])))
      return true
    }
    const object = moverOf(this.held)
    if (!object || !this.lab.scene.grid) return false
    this.carry(this.lab.scene.grid, object, [x + this.offset[0], y + this.offset[1]], view)
    return true
  }

  /** An obstacle goes with the hand; its velocity is where the arrow points to. */
  private carry(grid: GridScene, object: Selection, to: Point, view: View): void {
    const [x, y] = place(grid, object)
    this.lab.selection.select(object)
    if (this.held?.kind === 'aim') this.lab.scene.drag(aimed(grid, this.held.index, neatly(grid, straight(view, [to[0] - x, to[1] - y]))))
    else this.lab.scene.drag(move(grid, object, neatly(grid, to)))
  }

  drop(cancelled: boolean): void {
    if (this.born && !cancelled) this.chooseLast()
    this.born = null
    this.held = null
  }

  /** True if the tap was meant for what moves, or for what happened on a drive. */
  tap(view: View, size: Size, at: Point, handle: Handle | null, coarse: boolean): boolean {
    if (this.lab.scene.grid && this.pointer.using === 'add-moving') {
      this.lab.scene.edit(added(this.lab.scene.grid, toScene(view, size, at), [0, 0]))
      this.chooseLast()
      return true
    }
    const object = moverOf(handle)
    if (object && 'index' in object) {
      this.lab.selection.select(object)
      // What the planner has to say about it.
      const moving = asked(this.lab, 'disc')
      if (moving) this.lab.selection.inspect({ role: moving.role, index: object.index })
      return true
    }
    const events = asked(this.lab, 'event')
    const event =
      handle === null && events && this.lab.picture.anchors
        ? eventAt(pointsOf(this.lab.picture.anchors.event), view, size, at, coarse)
        : null
    if (!events || event === null) return false
    this.lab.selection.select(null)
    this.lab.selection.inspect({ role: events.role, index: event })
    return true
  }

  /** The obstacle that was added is the one that is meant now. */
  private chooseLast(): void {
    this.pointer.tool = 'look'
    this.lab.selection.inspect(null)
    this.lab.selection.select({ kind: 'moving', index: this.lab.scene.moving.length - 1 })
  }

  /** Keys make what is selected faster. */
  aim(right: number, up: number): void {
    const { grid } = this.lab.scene
    const { object: selection } = this.lab.selection
    if (grid && selection?.kind === 'moving') this.lab.scene.press(steered(grid, selection.index, [right, up]))
  }

  /** What a new one needs, in words. */
  get hint(): string {
    return this.lab.run.readings.time && this.now ? moving.addingLater : moving.adding
  }

  /** How far a key moves an obstacle. */
  get stride(): number {
    return this.lab.scene.grid ? strideOf(this.lab.scene.grid) : 0
  }
}

/** The planner tells about such things, and they are shown. */
const asked = ({ layers }: Lab, glyph: 'disc' | 'event'): Layer | undefined =>
  layers.list.find(({ role, look, pickable, on }) => look.glyph === glyph && pickable && layers.shows(role, on))

/** Near to an axis the hand means the axis. */
function straight({ scale }: View, [x, y]: Point): Point {
  const along = (by: number): number => (Math.abs(by) * scale < MAGNET ? 0 : by)
  return [along(x), along(y)]
}
