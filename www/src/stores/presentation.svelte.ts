import type { Layer } from 'forage-lab'

/** On a projector everything is larger: this many times. On a telephone there is no room for that. */
const [LARGER, LARGE] = [1.8, 1.15]
const WIDE = 900
/** More layers than so many nobody can tell apart from the last row. */
const LAYERS = 3
/** Of the scene, not of a planner. */
const OTHERS = ['arm', 'moving', 'margin', 'height']

/** The stage and its time alone, for a room full of people. */
export class PresentationStore {
  on = $state(false)
  /** Nothing is shown: all look at who speaks. */
  blank = $state(false)
  /** The link is shown as a code to be read by telephones. */
  code = $state(false)

  /** How many times larger things are, on the stage and about it. */
  scale = $state(1)

  begin = (): void => {
    this.scale = innerWidth >= WIDE ? LARGER : LARGE
    this.on = true
    this.blank = this.code = false
  }

  end = (): void => {
    this.on = this.blank = this.code = false
    this.scale = 1
  }
}

/** What is part of the place: without it nobody sees what is planned for. */
const isThere = ({ look }: Layer): boolean => look.glyph === 'disc' || look.glyph === 'robot'

/** The layers that say most: the result, what it is measured by, and those that search; and what is there. */
export function foremost(layers: readonly Layer[]): ReadonlySet<string> {
  const weight = ({ look, role, pickable }: Layer): number => (look.result !== undefined ? 3 : role === 'exact' ? 2 : pickable ? 1 : 0)
  const few = layers
    .filter((layer) => !isThere(layer))
    .map((layer, at) => ({ layer, at }))
    .filter(({ layer }) => layer.on)
    .sort((a, b) => weight(b.layer) - weight(a.layer) || a.at - b.at)
    .slice(0, LAYERS)
    .map(({ layer }) => layer.role)
  return new Set([...few, ...layers.filter(isThere).map(({ role }) => role), ...OTHERS])
}
