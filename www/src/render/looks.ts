import type { Catalogue, Color, Layer, Look, Planner, Ramp } from 'forage-lab'
import { colorOf } from './palette'

/** How something is drawn: a layer's look, or one in a colour of the page, by its token. */
export type Style = Omit<Look, 'color'> & { color: Color | string }

/** What tells the layers of a frame apart. */
export interface Names {
  /** The layers that the frame's table counts. */
  layers: readonly Layer[]
  shapes: readonly string[]
}

/** Of what has no layer of its own. */
export const PLAIN: Look = { color: colorOf('--ink-2'), width: 1, order: 20, point: 3, opacity: [0.8, 0.8] }

/** The names in frames that this planner draws. */
export const namesOf = ({ shapes }: Catalogue, planner: Planner | undefined): Names => ({ layers: planner?.layers ?? [], shapes })

/** The layer of this key: one that the planner draws or marks, or one of the scene's own. */
export const layerOf = (catalogue: Catalogue | null, planner: Planner | null | undefined, key: string): Layer | undefined =>
  [...(planner?.layers ?? []), ...(planner?.marks ?? []), ...(catalogue?.layers ?? [])].find(({ role }) => role === key)

/** The key of the layer with this form; empty where there is none. */
export const keyOf = (layers: readonly Layer[], glyph: Look['glyph']): string => layers.find(({ look }) => look.glyph === glyph)?.role ?? ''

/** What was before. */
export const GHOST: Look = { ...PLAIN, width: 2.5, opacity: [0.5, 0.5], dash: [2, 5] }

/** Lines that something walked along, a vertex a step. */
export const isWalked = ({ weight }: Layer): boolean => weight === 'arrived'

/** The result where a later one is shown: how that came about. */
const RAW: Partial<Look> = { width: 1.5, opacity: [0.75, 0.75], dash: [1, 4] }

/** The rank of the result among what is shown. */
export const resultOf = (shown: readonly { look: Look }[]): number => Math.max(0, ...shown.map(({ look }) => look.result ?? 0))

/** A look where the result has this rank. */
export const lookBeside = (look: Look, result: number): Look => (look.result && look.result < result ? { ...look, ...RAW } : look)

/** A look's colour for a style sheet. */
export const cssOf = ({ light, dark }: Color, isDark: boolean): string => (isDark ? dark : light)

export const rampOf = (colours: readonly Color[], isDark: boolean): Ramp => colours.map((colour) => cssOf(colour, isDark))
