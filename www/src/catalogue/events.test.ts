import type { EventKind, RunEvent } from 'forage-lab'
import { expect, test } from 'vitest'
import { clusters, csv, Kinds, neighbour, nextWithin, present } from './events'

const event = (iteration: number, kind: string, more: Partial<RunEvent> = {}): RunEvent => ({
  iteration,
  time: iteration / 10,
  place: [iteration, 0.5],
  kind,
  reason: `${kind}.`,
  ...more,
})
const KINDS: EventKind[] = [
  { name: 'seen', title: 'Seen', help: '', tone: 'plain' },
  { name: 'turn', title: 'Turns', help: '', tone: 'decision' },
  { name: 'hit', title: 'Collision', help: '', tone: 'bad' },
]
const ROW = [event(10, 'seen'), event(12, 'turn'), event(12, 'hit'), event(13, 'turn'), event(60, 'seen')]

test('close events share one mark, with the gravest tone and the place of the first', () => {
  const kinds = new Kinds(KINDS)
  const marks = clusters(ROW, kinds, 100, 500, 26)
  expect(marks.map(({ x, tone, events }) => [x, tone, events.length])).toEqual([
    [50, 'bad', 4],
    [300, 'plain', 1],
  ])
  expect(marks[0]?.head).toBe(ROW[2])
  // None moves when others follow.
  expect(clusters(ROW.slice(0, 2), kinds, 100, 500, 26).map(({ x }) => x)).toEqual([50])
  expect(clusters([event(3, 'unheard of')], kinds, 100, 500, 26)[0]?.tone).toBe('plain')
})

test('stepping from event to event counts those of one iteration as one', () => {
  expect([neighbour(ROW, 0, true), neighbour(ROW, 10, true), neighbour(ROW, 12, true), neighbour(ROW, 60, true)]).toEqual([
    10,
    12,
    13,
    null,
  ])
  expect([neighbour(ROW, 99, false), neighbour(ROW, 13, false), neighbour(ROW, 10, false)]).toEqual([60, 12, null])
  expect([nextWithin(ROW.slice(0, 4), 12), nextWithin(ROW.slice(0, 4), 50)]).toEqual([13, 10])
  expect([present(ROW, 9), present(ROW, 12), present(ROW, 1000)]).toEqual([-1, 2, 4])
})

test('the CSV of events quotes commas and quotes', () => {
  const rows = csv([event(10, 'seen', { obstacle: 0, reason: 'Near, "very" near.' }), ROW[1] as RunEvent])
  expect(rows).toBe('iteration,time,x,y,kind,obstacle,reason\n10,1,10,0.5,seen,1,"Near, ""very"" near."\n12,1.2,12,0.5,turn,,turn.\n')
})
