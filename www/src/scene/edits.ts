import type { Disc, DiscsScene, GridScene, Point, Scene, TourScene } from 'forage-lab'
import { movingOf, placed, withMoving } from './moving'
import { stopsOf, withStops } from './stops'

/** Scenes with places that can be taken hold of. */
export type Plane = DiscsScene | GridScene | TourScene

/** Something of a scene that can be selected. */
export type Selection = { kind: 'start' | 'goal' | 'base' } | { kind: 'disc' | 'stop' | 'moving' | 'cuboid'; index: number }
/** Something of a scene that can be taken hold of; the tip of a moving obstacle's arrow is its aim. */
export type Handle = Selection | { kind: 'rim'; index: number } | { kind: 'aim'; index: number }

export const LEAST_RADIUS = 0.01
const DIGITS = 1e4

/** Short numbers in links and lists: a ten-thousandth of a unit is finer than a hand. */
export const rounded = (value: number): number => Math.round(value * DIGITS) / DIGITS

const numberOf = (handle: Handle | null): number => (handle && 'index' in handle ? handle.index : -1)

export const same = (a: Selection | null, b: Selection | null): boolean => a?.kind === b?.kind && numberOf(a) === numberOf(b)

/** Where a path begins and ends, as far as the scene says. */
export function ends(scene: Plane): { kind: 'start' | 'goal'; at: Point }[] {
  return (['start', 'goal'] as const).flatMap((kind) => {
    const at = scene.kind === 'tour' ? undefined : scene[kind]
    return at ? [{ kind, at }] : []
  })
}

export function place(scene: Plane, handle: Selection): Point {
  if (handle.kind === 'disc') return discOf(scene, handle.index)?.center ?? [0, 0]
  if (handle.kind === 'stop') return stopsOf(scene)[handle.index] ?? [0, 0]
  if (handle.kind === 'moving') return movingOf(scene)[handle.index]?.center ?? [0, 0]
  return ends(scene).find(({ kind }) => kind === handle.kind)?.at ?? [0, 0]
}

export const discOf = (scene: Plane, index: number): Disc | undefined => (scene.kind === 'discs' ? scene.discs[index] : undefined)

/** Moves an object. In a grid it stays inside, unless it moves by itself; the same scene where it can't be moved. */
export function move(scene: Plane, handle: Selection, [x, y]: Point): Plane {
  if (handle.kind === 'moving') {
    const [fromX, fromY] = place(scene, handle)
    const shift = (at: Point): Point => [rounded(at[0] + x - fromX), rounded(at[1] + y - fromY)]
    return withMoving(scene, (all) => all.map((one, index) => (index === handle.index ? placed(one, shift) : one)))
  }
  const within = (value: number, cells = 0): number => (scene.kind === 'grid' ? Math.min(Math.max(value, 0), cells * scene.cell) : value)
  const rows = scene.kind === 'grid' ? scene.rows : []
  const at: Point = [rounded(within(x, rows[0]?.length)), rounded(within(y, rows.length))]
  if (handle.kind === 'stop') return withStops(scene, (stops) => stops.with(handle.index, at))
  if (scene.kind === 'tour') return scene
  if (handle.kind === 'disc') return scene.kind === 'discs' ? withDisc(scene, handle.index, (disc) => ({ ...disc, center: at })) : scene
  return { ...scene, [handle.kind]: at }
}

export function resize(scene: DiscsScene, index: number, radius: number): DiscsScene {
  return withDisc(scene, index, (disc) => ({ ...disc, radius: rounded(radius) }))
}

export function add(scene: DiscsScene, disc: Disc): DiscsScene {
  const [x, y] = disc.center
  return { ...scene, discs: [...scene.discs, { center: [rounded(x), rounded(y)], radius: rounded(disc.radius) }] }
}

/** The scene without a disc, a stop or a moving obstacle; the same where there is nothing to remove. */
export function remove(scene: Plane, handle: Selection | null): Plane {
  const others = (_: unknown, at: number): boolean => at !== numberOf(handle)
  if (handle?.kind === 'stop') return withStops(scene, (stops) => stops.filter(others))
  if (handle?.kind === 'moving') return withMoving(scene, (all) => all.filter(others))
  return handle?.kind === 'disc' && scene.kind === 'discs' ? { ...scene, discs: scene.discs.filter(others) } : scene
}

function withDisc(scene: DiscsScene, index: number, change: (disc: Disc) => Disc): DiscsScene {
  return { ...scene, discs: scene.discs.map((disc, at) => (at === index ? change(disc) : disc)) }
}

/** What was published or is stored about a scene doesn't hold for an edited one. */
export function edited<S extends Scene>(scene: S): S {
  const { exact: _exact, published: _published, source: _source, note: _note, ...rest } = scene
  return rest as S
}

/** Which object a refused field belongs to: `discs[2].radius`, `moving[0].velocity[1]`, `cuboids[0].max[2]`, `start`, … */
export function blamed(field: string): Selection | null {
  const [, list, index] = /^(disc|stop|point|moving|cuboid)s?\[(\d+)\]/.exec(field) ?? []
  if (list) return { kind: list === 'point' ? 'stop' : (list as 'disc' | 'stop' | 'moving' | 'cuboid'), index: Number(index) }
  const [, end] = /^(start|goal|arm\.base)/.exec(field) ?? []
  return end ? { kind: end === 'arm.base' ? 'base' : (end as 'start' | 'goal') } : null
}
