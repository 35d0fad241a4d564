import type { Item } from 'forage-lab'
import { same, type Selection } from '../../scene/edits'
import type { Display, InSpace, SpaceState } from '../display'
import type { Frame } from '../frame'
import type { Names } from '../looks'
import type { CanvasPen } from '../canvas/pen'
import type { Mood } from './boxes'
import { Camera } from './camera'
import { isHidden } from './handles'
import { drawAxes } from './labels'
import { drawDetails, drawEnds, drawHandles, drawNode, type Marked } from './marks'
import { World } from './world'

/** How much of a tree is left while it is not that of the scene, while something is looked at closer, and while the arm moves. */
const STALE = 0.15
const CLOSER = 0.4
const MOVING = 0.35
const ARM = 'arm'

type Canvas = HTMLCanvasElement | OffscreenCanvas

/** Where space is drawn, before it is copied to where it is seen: a canvas that one draws on in two dimensions. */
function open(): { canvas: Canvas; context: WebGL2RenderingContext } | null {
  // Not all browsers that draw in space do so on one that is never seen.
  const canvas: Canvas = typeof document === 'undefined' ? new OffscreenCanvas(1, 1) : document.createElement('canvas')
  const options: WebGLContextAttributes = { antialias: true, alpha: false, stencil: false, powerPreference: 'high-performance' }
  // Asked for here: the library would write into the console.
  const context = (canvas as HTMLCanvasElement).getContext('webgl2', options)
  return context && { canvas, context }
}

/** Draws an arm's scene in space. */
export class RoomPainter {
  private readonly opened = open()
  private readonly world: World | null
  private readonly drawn = new Map<string, readonly unknown[]>()
  private lost = false

  /** `tell` is called when pictures can be made no more, or again; `soon`: the picture is to be drawn again. */
  constructor(tell: (state: SpaceState) => void, soon: () => void) {
    this.world = this.opened && new World(this.opened.canvas, this.opened.context)
    if (!this.world) tell('none')
    const canvas: EventTarget | undefined = this.opened?.canvas
    canvas?.addEventListener('webglcontextlost', () => {
      this.lost = true
      tell('lost')
    })
    canvas?.addEventListener('webglcontextrestored', () => {
      this.lost = false
      this.world?.forget()
      tell('there')
      soon()
    })
  }

  draw(pen: CanvasPen, display: Display & InSpace, frame: Frame | null, names: Names | null): void {
    const { world, opened } = this
    const { scene, size } = display
    if (!world || !opened || this.lost || scene.kind !== 'arm') return
    this.furnish(world, pen, display, frame, names)
    world.render()
    pen.context.drawImage(opened.canvas, 0, 0, size.width, size.height)
    const { selection, grip: hover, held, blamed, faded, details, orbit, words } = display
    const camera = new Camera(orbit, size)
    const marked: Marked = { scene, selection, hover, held, blamed, words }
    drawAxes(pen, camera, scene.workspace)
    if (details && !faded) drawDetails(pen, camera, scene, details)
    drawEnds(pen, camera, marked)
    for (const [item, chosen] of [
      [display.pointed, false],
      [display.chosen, true],
    ] as const)
      if (item && !faded) drawNode(pen, camera, world.layers.place(item.role, item.index), chosen)
    drawHandles(pen, camera, marked)
  }

  /** Whether any of these is another one than when it was asked last. */
  private changed(what: string, ...parts: unknown[]): boolean {
    const before = this.drawn.get(what)
    if (before && parts.every((part, at) => part === before[at])) return false
    this.drawn.set(what, parts)
    return true
  }

  /** Brings all that stands there up to what is to be seen. */
  private furnish(world: World, { palette }: CanvasPen, display: Display & InSpace, frame: Frame | null, names: Names | null): void {
    const { scene, size, density, theme, hidden, overlays, highlighted, details, faded, followed } = display
    const { orbit, posture, touching, thickness, ghosts, ghost, reach, selection, blamed, grip } = display
    if (scene.kind !== 'arm') return
    const { arm, workspace, cuboids } = scene
    if (this.changed('colours', theme.dark)) world.paint(palette, theme.dark)
    if (this.changed('size', size.width, size.height, density)) world.resize(size, density)
    if (this.changed('orbit', orbit, size.width, size.height)) world.look(orbit)
    if (this.changed('room', JSON.stringify(workspace))) world.showRoom(workspace)
    if (this.changed('boxes', cuboids, selection, blamed, grip, theme.dark)) {
      const moodOf = (index: number): Mood => {
        const it: Selection = { kind: 'cuboid', index }
        if (same(blamed, it)) return 'wrong'
        if (same(selection, it)) return 'selected'
        return grip?.kind === 'cuboid' && grip.index === index ? 'hover' : 'plain'
      }
      world.showBoxes(cuboids, moodOf)
    }
    if (names && this.changed('layers', frame, names, overlays, hidden))
      world.layers.show(frame, names, overlays, (role) => !hidden.includes(role))
    if (this.changed('faintness', frame, names, overlays, hidden, highlighted, details, faded, followed, theme.dark))
      world.layers.paint(palette, details || highlighted ? CLOSER : followed ? MOVING : 1, faded ? STALE : 1, highlighted)
    // Another arm, or the same elsewhere, is built again.
    const machine = JSON.stringify([arm, workspace.min[2]])
    if (this.changed('arm', machine, thickness, theme.dark)) world.showArm(scene, thickness)
    const visible = !hidden.includes(ARM)
    if (this.changed('posture', machine, thickness, theme.dark, posture, touching, visible))
      world.pose(arm, posture, visible, touching, palette)
    if (this.changed('ghosts', machine, ghosts, ghost, theme.dark)) world.showGhosts(arm, ghosts, ghost, palette)
    if (this.changed('reach', reach, theme.dark)) world.cloud.show(reach, palette)
  }

  /** The nearest of the points that are shown and seen. */
  nearest(
    { scene, orbit, size }: Display & InSpace,
    [x, y]: readonly [number, number],
    reach: number,
    roles: readonly string[],
  ): Item | null {
    if (!this.world || scene.kind !== 'arm') return null
    const camera = new Camera(orbit, size)
    let [found, least]: [Item | null, number] = [null, reach]
    for (const role of roles) {
      const dots = this.world.layers.pointsOf(role)
      for (let index = 0; dots && index < dots.count; index += 1) {
        const place = dots.at(index)
        const seen = camera.project(place)
        const away = seen ? Math.hypot(seen.x - x, seen.y - y) : Infinity
        if (away < least && !isHidden(scene, camera, place)) [found, least] = [{ role, index } as Item, away]
      }
    }
    return found
  }

  drop(): void {
    this.world?.drop()
  }
}
