import type { Disc, DiscsScene, GridScene, Point, Scene } from 'forage'

/** Scenes in which a path is looked for. */
export type Plane = DiscsScene | GridScene

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

/** Where a path begins and ends, as far as the scene says. */
export function ends(scene: Plane): { kind: 'start' | 'goal'; at: Point }[] {
  return (['start', 'goal'] as const).flatMap((kind) => {
    const at = scene[kind]
    return at ? [{ kind, at }] : []
  })
}

export function place(scene: Plane, handle: Selection): Point {
  if (handle.kind === 'disc') return discOf(scene, handle.index)?.center ?? [0, 0]
  return scene[handle.kind] ?? [0, 0]
}

export const discOf = (scene: Plane, index: number): Disc | undefined => (scene.kind === 'discs' ? scene.discs[index] : undefined)

/** Moves an object. In a grid it stays inside. */
export function move(scene: Plane, handle: Selection, [x, y]: Point): Plane {
  if (scene.kind === 'grid') {
    const within = (value: number, cells: number): number => rounded(Math.min(Math.max(value, 0), cells * scene.cell))
    return { ...scene, [handle.kind]: [within(x, scene.rows[0]?.length ?? 0), within(y, scene.rows.length)] }
  }
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
