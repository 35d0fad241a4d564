import type { FormulaScene, Scene } from 'forage-lab'
import type { Refusal } from '../engine/protocol'
import { functions } from '../locales/en/functions'
import { EXAMPLES, type Example } from '../scene/functions'
import { Latest } from '../engine/latest-request'
import { extent } from '../render/view'
import type { HeightMap } from '../render/frame'
import { rampOf } from '../render/looks'
import { perLab } from './context.svelte'
import type { Lab } from './lab.svelte'

/** How fine the heat map is, in pixels a side. */
const SIDE = 240

/** The name of a function that is no example. */
const OWN = 'own-function'

/** What is written into the fields, as text. */
interface Draft {
  name: string
  title: string
  expression: string
  dimension: string
  low: string
  high: string
  optimum: string
  /** Where the minimum is, of an example that was not changed. */
  position: readonly number[] | null
}

/** The fields that a text can be wrong in. */
export type Field = 'expression' | 'dimension' | 'low' | 'high' | 'optimum'

const FIELDS: readonly (readonly [start: string, field: Field])[] = [
  ['expression', 'expression'],
  ['dimension', 'dimension'],
  ['bounds.min', 'low'],
  ['bounds.max', 'high'],
  ['optimum', 'optimum'],
]

const listed = (side: number | readonly number[]): string => (typeof side === 'number' ? String(side) : side.join(', '))

/** A number, or a list of them; null for another text. */
export function numbers(text: string): number | number[] | null {
  const parts = text
    .replaceAll('−', '-')
    .split(/[,;\s]+/)
    .filter(Boolean)
  const found = parts.map(Number)
  if (found.length === 0 || !found.every(Number.isFinite)) return null
  return found.length === 1 ? (found[0] ?? null) : found
}

/** Where in the formula something is wrong, from 0: the core says it first, and counts from 1. */
export function placeIn({ field, message }: Refusal): number | null {
  const [place] = field === 'expression' ? (/\d+/.exec(message) ?? []) : []
  return place === undefined ? null : Number(place) - 1
}

function drafted(of: Example): Draft {
  const { name, title, expression, dimension, bounds, optimum } = of
  const known = typeof optimum === 'object' ? optimum : { value: optimum }
  return {
    name,
    title,
    expression,
    dimension: String(dimension),
    low: listed(bounds.min),
    high: listed(bounds.max),
    optimum: known.value === undefined ? '' : String(known.value),
    position: ('position' in known ? known.position : undefined) ?? null,
  }
}

/** A function in the making. It is kept while the page is open. */
export class WritingStore {
  draft = $state.raw<Draft | null>(null)
  /** The scene that comes of it, once the core has taken it. */
  scene = $state.raw<FormulaScene | null>(null)
  picture = $state.raw<HeightMap | null>(null)
  private refusal = $state.raw<Refusal | null>(null)
  /** What the texts say now; none while one of them says nothing. The core may not have taken it yet. */
  private wanted = $state.raw<FormulaScene | null>(null)

  /** What is wrong with texts that the core was not even asked about. */
  private readonly unread = $derived.by((): Partial<Record<Field, string>> => {
    const { draft } = this
    if (!draft) return {}
    const wrong: Partial<Record<Field, string>> = {}
    for (const field of ['low', 'high'] as const) if (numbers(draft[field]) === null) wrong[field] = functions.noNumbers(draft[field])
    for (const field of ['dimension', 'optimum'] as const) {
      const empty = draft[field].trim() === ''
      if (field === 'optimum' && empty) continue
      if (typeof numbers(draft[field]) !== 'number') wrong[field] = functions.noNumber(draft[field])
    }
    return wrong
  })

  readonly errors = $derived.by((): Partial<Record<Field, string>> => {
    const { refusal } = this
    const field = refusal && FIELDS.find(([start]) => refusal.field.startsWith(start))?.[1]
    return field ? { [field]: refusal.message, ...this.unread } : this.unread
  })
  /** What no field can show. */
  readonly problem = $derived(this.refusal && !FIELDS.some(([start]) => this.refusal?.field.startsWith(start)) ? this.refusal.message : '')
  /** Where the formula is wrong. */
  readonly place = $derived(this.refusal ? placeIn(this.refusal) : null)
  readonly ready = $derived(this.scene !== null && this.scene === this.wanted)

  private readonly latest = new Latest<FormulaScene>((scene) => this.try(scene))

  constructor(private readonly lab: Lab) {}

  /** Begins with the scene that there is, if it is a function. */
  begin(scene: Scene | null): void {
    if (scene?.kind === 'function' && 'expression' in scene) this.put(drafted(scene))
    else if (!this.draft || scene?.kind === 'function') {
      const same = scene?.kind === 'function' ? EXAMPLES.find(({ name }) => name === scene.function) : undefined
      const [first] = EXAMPLES
      if (same ?? first) this.put(drafted((same ?? first) as Example))
    } else this.put(this.draft)
  }

  choose = (name: string): void => {
    const example = EXAMPLES.find((candidate) => candidate.name === name)
    if (example) this.put(drafted(example))
  }

  /** One text is changed. What was known of an example does not hold any more. */
  write(field: Field | 'title', text: string): void {
    const { draft } = this
    if (!draft || draft[field] === text) return
    const changed = { ...draft, [field]: text }
    if (field === 'title') this.put(changed)
    else {
      const title = EXAMPLES.some((example) => example.title === draft.title) ? '' : draft.title
      const optimum = field === 'optimum' || draft.name === OWN ? changed.optimum : ''
      this.put({ ...changed, name: OWN, title, position: null, optimum })
    }
  }

  private put(draft: Draft): void {
    this.draft = draft
    this.wanted = null
    if (Object.keys(this.unread).length > 0) return
    const { name, title, expression, dimension, low, high, optimum, position } = draft
    const value = numbers(optimum)
    const scene: FormulaScene = {
      format: 'forage-scene',
      version: 1,
      kind: 'function',
      name,
      title: title.trim() || functions.unnamed,
      expression,
      dimension: Number(dimension),
      bounds: { min: numbers(low) ?? 0, max: numbers(high) ?? 1 },
    }
    if (typeof value === 'number') scene.optimum = position ? { value, position: [...position] } : value
    this.wanted = scene
    this.latest.want(scene)
  }

  private async try(scene: FormulaScene): Promise<void> {
    const { catalogue } = this.lab.setup
    const planner = catalogue?.planners.find(({ kinds }) => kinds.includes('function'))?.name
    if (!catalogue || planner === undefined) return
    const ramp = rampOf(catalogue.heights, this.lab.theme.dark)
    const answer = await this.lab.api.preview({ scene, ...extent(scene), width: SIDE, height: SIDE, ramp }, planner)
    this.refusal = answer.ok ? null : answer.refusal
    if (!answer.ok) return
    this.scene = scene
    this.picture?.bitmap.close()
    this.picture = answer.value
  }
}

export const writingOf = perLab((lab) => new WritingStore(lab))
