import type { Item, Point } from 'forage-lab'
import { between, type Cell, cellAt, indexOf, isBlocked, middleOf, paint } from '../../scene/cells'
import { discOf, type Handle, LEAST_RADIUS, move, place, resize, same, type Selection } from '../../scene/edits'
import type { Lab } from '../../stores/lab.svelte'
import type { MovingPointer } from './moving-pointer'
import { takesStops } from '../../scene/stops'
import { CROWD, hit } from '../../render/hit'
import { type Size, toScene, type View } from '../../render/view'

/** What a press on the stage is for: looking and moving, a new disc or stop, one that moves, painting cells, going from cell to cell. */
export type Tool = 'look' | 'add' | 'add-moving' | 'paint' | 'cells'

const NEW_RADIUS = 0.5
const DOUBLE = { time: 350, apart: 12 }

const objectOf = (handle: Handle): Selection =>
  handle.kind === 'rim' || handle.kind === 'aim' ? { kind: handle.kind === 'rim' ? 'disc' : 'moving', index: handle.index } : handle

/** What pointer and keys do to the scene on the stage. */
export class PointerController {
  tool = $state<Tool>('look')
  hover = $state.raw<Handle | null>(null)
  held = $state.raw<Handle | null>(null)
  /** The cell under the pointer, or where the keys have gone. */
  cell = $state.raw<Cell | null>(null)
  /** The hint has done its work. */
  painted = $state(false)
  /** What it does to obstacles that move, once that is loaded. */
  movers = $state.raw<MovingPointer | null>(null)
  private offset: Point = [0, 0]
  private stroke: { block: boolean; last: Cell } | null = null
  private lastTap = { time: 0, at: [0, 0] as Point }

  constructor(private readonly lab: Lab) {}

  /** The field that is shown and whose cells can be asked about. */
  readonly role = $derived.by(() =>
    this.lab.scene.grid
      ? (this.lab.layers.list.find(({ role, on, pickable, look }) => pickable && look.ramp && this.lab.layers.shows(role, on))?.role ??
        null)
      : null,
  )
  /** Stops mean something here and can be changed. */
  readonly callsAt = $derived.by(
    () => this.lab.scene.plane !== null && takesStops(this.lab.scene.plane) && (this.lab.setup.touring || this.lab.scene.stops.length > 0),
  )
  /** A tool that the scene has no use for is put away. */
  readonly using = $derived.by<Tool>(() =>
    ((this.tool === 'paint' || this.tool === 'add-moving') && this.lab.scene.grid) ||
    (this.tool === 'add' && (this.lab.scene.discs || this.callsAt)) ||
    (this.tool === 'cells' && this.role)
      ? this.tool
      : 'look',
  )

  /** The cell that is pointed at, to be asked about. */
  readonly item = $derived.by<Item | null>(() =>
    this.role && this.cell && this.lab.scene.grid && this.using !== 'paint'
      ? { role: this.role, index: indexOf(this.lab.scene.grid, this.cell) }
      : null,
  )

  take(tool: Tool): void {
    this.tool = this.using === tool ? 'look' : tool
    if (this.tool === 'look') this.cell = null
    else this.lab.selection.select(null)
  }

  private under(view: View, size: Size, at: Point, coarse: boolean): Handle | null {
    const found =
      this.lab.scene.plane && hit(this.lab.scene.plane, view, size, at, this.lab.selection.object, coarse, this.lab.setup.touring)
    return this.movers ? this.movers.under(found, view, size, at, coarse) : found
  }

  /** Of many stops a finger moves only the one that is selected, and moves the view with the others. */
  private holds(handle: Handle | null, coarse: boolean): boolean {
    if (handle?.kind !== 'stop') return handle !== null && objectOf(handle).kind !== 'moving'
    return this.callsAt && !(coarse && this.lab.scene.stops.length > CROWD && !same(this.lab.selection.object, handle))
  }

  grab(view: View, size: Size, at: Point, coarse: boolean): boolean {
    const { plane, grid } = this.lab.scene
    if (!plane || this.using === 'add') return false
    const [x, y] = toScene(view, size, at)
    const handle = this.under(view, size, at, coarse)
    if (this.movers?.grab(view, size, at, handle)) return true
    this.held = this.holds(handle, coarse) ? handle : null
    if (this.held) {
      const anchor = place(plane, objectOf(this.held))
      this.offset = [anchor[0] - x, anchor[1] - y]
      return true
    }
    const cell = this.using === 'paint' && grid ? cellAt(grid, [x, y]) : null
    if (!grid || !cell) return false
    this.cell = cell
    this.stroke = { block: !isBlocked(grid, cell), last: cell }
    return true
  }

  drag(view: View, size: Size, at: Point): void {
    const { plane, grid, discs } = this.lab.scene
    if (this.movers?.drag(view, size, at)) return
    const [x, y] = toScene(view, size, at)
    if (this.stroke && grid) {
      const cell = cellAt(grid, [x, y])
      if (!cell) return
      const cells = between(this.stroke.last, cell)
      this.stroke.last = this.cell = cell
      const painted = paint(grid, cells, this.stroke.block)
      if (painted === grid) return
      this.painted = true
      this.lab.scene.drag(painted)
    } else if (this.held?.kind === 'rim' && discs) {
      const center = discOf(discs, this.held.index)?.center ?? [x, y]
      this.lab.selection.select(objectOf(this.held))
      this.lab.scene.drag(resize(discs, this.held.index, Math.max(LEAST_RADIUS, Math.hypot(x - center[0], y - center[1]))))
    } else if (this.held && this.held.kind !== 'rim' && this.held.kind !== 'aim' && plane) {
      this.lab.selection.select(this.held)
      this.lab.scene.drag(
        move(
          plane,
          this.held,
          this.held.kind === 'stop' ? this.meant(x + this.offset[0], y + this.offset[1]) : [x + this.offset[0], y + this.offset[1]],
        ),
      )
    }
  }

  /** A hand means a cell and not a place in it: ways go from middle to middle. */
  private meant(x: number, y: number): Point {
    const cell = this.lab.scene.grid && cellAt(this.lab.scene.grid, [x, y])
    return this.lab.scene.grid && cell ? middleOf(this.lab.scene.grid, cell) : [x, y]
  }

  drop(cancelled: boolean): void {
    this.held = null
    this.stroke = null
    if (cancelled) this.lab.scene.abandon()
    else this.lab.scene.settle()
    this.movers?.drop(cancelled)
  }

  tap(view: View, size: Size, at: Point, coarse: boolean): void {
    const { discs, grid } = this.lab.scene
    const [x, y] = toScene(view, size, at)
    const doubled =
      performance.now() - this.lastTap.time < DOUBLE.time &&
      Math.hypot(at[0] - this.lastTap.at[0], at[1] - this.lastTap.at[1]) < DOUBLE.apart
    this.lastTap = { time: performance.now(), at }
    const handle = this.using !== 'add' ? this.under(view, size, at, coarse) : null
    if (this.movers?.tap(view, size, at, handle, coarse)) return
    const cell = this.using === 'paint' && grid ? cellAt(grid, [x, y]) : null
    if (discs && (this.using === 'add' || (doubled && !handle))) {
      this.tool = 'look'
      this.lab.selection.inspect(null)
      this.lab.scene.addDisc(x, y, NEW_RADIUS)
    } else if (this.callsAt && (this.using === 'add' || (doubled && !handle && !cell && this.lab.setup.touring))) {
      this.tool = 'look'
      this.lab.selection.inspect(null)
      this.lab.scene.addStop(this.meant(x, y))
    } else if (handle) {
      this.lab.selection.select(objectOf(handle))
      // What the planner has to say about it.
      const stops = this.lab.layers.list.find(({ pickable, look }) => pickable && look.glyph === 'number')
      if (handle.kind === 'stop' && stops) this.lab.selection.inspect({ role: stops.role, index: handle.index })
    } else if (cell) {
      this.cell = cell
      this.toggle()
    } else if (this.role && grid && cellAt(grid, [x, y])) {
      this.lab.selection.select(null)
      this.look(cellAt(grid, [x, y]), coarse)
    } else {
      this.lab.selection.select(null)
      void this.lab.selection.pick(x, y, (coarse ? 22 : 10) / view.scale)
    }
  }

  /** Looks closer at a cell. A finger on the same cell again lets go of it: nothing else takes its card away. */
  private look(cell: Cell | null, coarse: boolean): void {
    const before = this.item
    this.cell = cell
    const again = coarse && this.lab.selection.wanted && before?.index === this.item?.index
    if (again) this.cell = null
    this.lab.selection.inspect(again ? null : this.item)
  }

  over(view: View | null, size: Size, at: Point | null): void {
    const { grid } = this.lab.scene
    this.hover = at && view ? this.under(view, size, at, false) : null
    if (!grid || !view || (this.using === 'look' && !this.role)) return
    if (at)
      this.cell =
        this.hover && (this.using === 'paint' || objectOf(this.hover).kind === 'moving') ? null : cellAt(grid, toScene(view, size, at))
    else if (this.using === 'look') this.cell = null
  }

  /** The cell that keys paint moves; the first move shows it. */
  walk(columns: number, rows: number): void {
    const { grid } = this.lab.scene
    if (!grid) return
    const limit = (at: number, count: number): number => Math.min(Math.max(at, 0), count - 1)
    const from = this.cell ?? cellAt(grid, grid.start ?? this.lab.scene.stops[0] ?? [0, 0]) ?? { column: 0, row: grid.rows.length - 1 }
    this.cell = {
      column: limit(from.column + columns, grid.rows[0]?.length ?? 1),
      row: limit(from.row + rows, grid.rows.length),
    }
  }

  /** What the keys' cell is for. */
  act(): void {
    if (this.using === 'paint') this.toggle()
    else this.lab.selection.inspect(this.item)
  }

  private toggle(): void {
    const { grid } = this.lab.scene
    this.painted = true
    if (grid && this.cell) this.lab.scene.edit(paint(grid, [this.cell], !isBlocked(grid, this.cell)))
  }

  /** Lets go of everything. */
  leave(): void {
    this.tool = 'look'
    this.cell = null
    this.lab.selection.select(null)
    this.lab.selection.inspect(null)
  }

  /** Where the cell is that keys paint, for the view to follow. */
  get cursor(): Point | null {
    return this.lab.scene.grid && this.cell ? middleOf(this.lab.scene.grid, this.cell) : null
  }
}
