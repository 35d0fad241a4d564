import type { Disc, DiscsScene, Point, Scene } from 'forage'

/** Something of a scene that can be taken hold of. */
export type Handle = { kind: 'start' } | { kind: 'goal' } | { kind: 'disc'; index: number } | { kind: 'rim'; index: number }
/** A handle that stays selected. */
export type Selection = Exclude<Handle, { kind: 'rim' }>

export const LEAST_RADIUS = 0.01
const DIGITS = 1e4

/** Short numbers in links and lists: a ten-thousandth of a unit is finer than a hand. */
export const rounded = (value: number): number => Math.round(value * DIGITS) / DIGITS

export function same(a: Selection | null, b: Selection | null): boolean {
  return a?.kind === b?.kind && (a?.kind !== 'disc' || (b?.kind === 'disc' && a.index === b.index))
}

export function place(scene: DiscsScene, handle: Selection): Point {
  if (handle.kind === 'disc') return scene.discs[handle.index]?.center ?? [0, 0]
  return scene[handle.kind]
}

export function move(scene: DiscsScene, handle: Selection, [x, y]: Point): DiscsScene {
  const at: Point = [rounded(x), rounded(y)]
  if (handle.kind === 'disc') return withDisc(scene, handle.index, (disc) => ({ ...disc, center: at }))
  return { ...scene, [handle.kind]: at }
}

export function resize(scene: DiscsScene, index: number, radius: number): DiscsScene {
  return withDisc(scene, index, (disc) => ({ ...disc, radius: rounded(radius) }))
}

export function add(scene: DiscsScene, disc: Disc): DiscsScene {
  const [x, y] = disc.center
  return { ...scene, discs: [...scene.discs, { center: [rounded(x), rounded(y)], radius: rounded(disc.radius) }] }
}

export function remove(scene: DiscsScene, index: number): DiscsScene {
  return { ...scene, discs: scene.discs.filter((_, at) => at !== index) }
}

function withDisc(scene: DiscsScene, index: number, change: (disc: Disc) => Disc): DiscsScene {
  return { ...scene, discs: scene.discs.map((disc, at) => (at === index ? change(disc) : disc)) }
}

/** What was published or is stored about a scene doesn't hold for an edited one. */
export function edited<S extends Scene>(scene: S): S {
  const { exact: _exact, published: _published, source: _source, note: _note, ...rest } = scene
  return rest as S
}

/** Which object a refused field belongs to: `discs[2].radius`, `start`, … */
export function blamed(field: string): Selection | null {
  const disc = /^discs\[(\d+)\]/.exec(field)
  if (disc) return { kind: 'disc', index: Number(disc[1]) }
  if (field.startsWith('start')) return { kind: 'start' }
  return field.startsWith('goal') ? { kind: 'goal' } : null
}
