import type { Catalogue, EventKind, Outcome, RunEvent } from 'forage-lab'
import { cell } from '../text/cells'

export type Tone = EventKind['tone']

/** The gravest last. */
const GRAVITY: readonly Tone[] = ['plain', 'good', 'decision', 'warning', 'bad']

/** What those must hear of who see nothing. */
const LOUD: readonly Tone[] = ['warning', 'decision', 'bad']

/** Events that lie so near to each other on the timeline that they are shown as one. */
export interface Cluster {
  /** Where it is, in pixels. */
  x: number
  /** The gravest of its events’. */
  tone: Tone
  /** The event of that tone that comes first. */
  head: RunEvent
  events: RunEvent[]
}

/** What is known of a run’s kinds of events; a kind that nobody described is plain. */
export class Kinds {
  private readonly known: ReadonlyMap<string, EventKind>

  constructor(readonly list: readonly EventKind[]) {
    this.known = new Map(list.map((kind) => [kind.name, kind]))
  }

  of({ kind }: RunEvent): EventKind {
    return this.known.get(kind) ?? { name: kind, title: kind, help: '', tone: 'plain' }
  }

  loud(event: RunEvent): boolean {
    return LOUD.includes(this.of(event).tone)
  }

  /** The gravest first, otherwise as they happened. */
  byGravity(events: readonly RunEvent[]): RunEvent[] {
    const gravity = (event: RunEvent): number => GRAVITY.indexOf(this.of(event).tone)
    return [...events].sort((a, b) => gravity(b) - gravity(a))
  }
}

/** The planner that is chosen may be another one already: a run's events are of the planner that it is of. */
export const kindsOf = (catalogue: Catalogue | null, run: { planner: string } | null): Kinds =>
  new Kinds(catalogue?.planners.find(({ name }) => name === run?.planner)?.events ?? [])

/**
 * Events as marks on a line of so many pixels, no two nearer than `least`. Marks stand where their first event is, so that none
 * moves when later ones are added.
 */
export function clusters(events: readonly RunEvent[], kinds: Kinds, limit: number, width: number, least: number): Cluster[] {
  const groups: { x: number; events: RunEvent[] }[] = []
  for (const event of events) {
    const x = limit > 0 ? (width * event.iteration) / limit : 0
    const last = groups.at(-1)
    if (last && x - last.x < least) last.events.push(event)
    else groups.push({ x, events: [event] })
  }
  return groups.flatMap((group) => {
    const [head] = kinds.byGravity(group.events)
    return head ? [{ ...group, head, tone: kinds.of(head).tone }] : []
  })
}

/** The number of the last event that has happened by an iteration; −1 before the first. */
export const present = (events: readonly RunEvent[], iteration: number): number =>
  events.findLastIndex((event) => event.iteration <= iteration)

/** The iteration of the next event, or of the one before; several of one iteration are one stop on the way. */
export function neighbour(events: readonly RunEvent[], iteration: number, onwards: boolean): number | null {
  const found = onwards ? events.find((event) => event.iteration > iteration) : events.findLast((event) => event.iteration < iteration)
  return found?.iteration ?? null
}

/** The next event within a group of events, round and round. */
export function nextWithin(group: readonly RunEvent[], iteration: number): number | null {
  return neighbour(group, iteration, true) ?? group[0]?.iteration ?? null
}

/** Obstacles are counted from 1 wherever somebody reads it. */
export const obstacleNumber = ({ obstacle }: RunEvent): number | null => (obstacle === undefined ? null : obstacle + 1)

/** A row for each event. */
export function csv(events: readonly RunEvent[]): string {
  const rows = events.map((event) => [
    event.iteration,
    event.time,
    ...event.place,
    event.kind,
    obstacleNumber(event) ?? '',
    cell(event.reason),
  ])
  return `${[['iteration', 'time', 'x', 'y', 'kind', 'obstacle', 'reason'], ...rows].map((row) => row.join(',')).join('\n')}\n`
}

/** How a drive stands. */
export interface Fate {
  /** In simulated time. */
  driving: boolean
  /** Nothing more comes. */
  over: boolean
  arrived: boolean
  /** The way that it took was checked and touches nothing. */
  free: boolean
  collisions: number
  time: number | null
}

type Now = Readonly<Record<string, number>>

/** Readings are told more often than outcomes: what is said to be over is only so when both say it. */
export function fateOf({ status, feasible, iterations }: Outcome, now: Now, iteration: number): Fate {
  const { time = null, collisions = 0 } = now as { time?: number; collisions?: number }
  const over = status !== 'running' && iterations === iteration
  return { driving: (time ?? 0) > 0, over, arrived: over && status === 'solved', free: feasible, collisions, time }
}
