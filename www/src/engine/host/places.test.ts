import type { Session } from 'forage-lab/core'
import { expect, test } from 'vitest'
import type { ClockUnit } from '../protocol'
import { Places } from './places'

/** A run that evaluates as much as a list says, a step after the other, and ends with the list. */
class Run {
  iteration = 0
  partly = false
  rewound: number[] = []
  curves = 0
  /** What a first part has evaluated; the others evaluate more. */
  private before = 0
  readonly limit = 1000

  constructor(
    private readonly costs: readonly number[],
    private readonly options: { start?: number; needs?: number; parts?: number } = {},
  ) {}

  get evaluations(): number {
    return this.costs.slice(0, this.iteration).reduce((sum, cost) => sum + cost, (this.options.start ?? 0) + this.before)
  }

  get status(): string {
    return this.iteration < this.costs.length ? 'running' : 'solved'
  }

  /** Other runs are needed before this iteration. */
  jobs(): unknown[] {
    return this.iteration === this.options.needs ? [1] : []
  }

  advance(): string {
    if (this.iteration === this.options.parts && this.before === 0) {
      this.before = 10
      return 'partly'
    }
    if (this.iteration < this.costs.length) this.iteration += 1
    return 'over'
  }

  rewind(to: number): void {
    this.rewound.push(to)
    this.iteration = to
  }

  curve(): void {
    this.curves += 1
  }
}

const placesOf = (run: Run, clock: ClockUnit): Places => new Places(run as unknown as Session, clock)

function went(run: Run, clock: ClockUnit, steps: number): Places {
  const places = placesOf(run, clock)
  for (let k = 0; k < steps; k += 1) {
    run.iteration += 1
    places.note()
  }
  return places
}

test('by evaluations the first steps say how much one evaluates, and are taken back', () => {
  const most = (run: Run): number => placesOf(run, 'evaluations').report.most
  const run = new Run([3, 9, 5, 50, 50])
  expect([most(run), run.iteration, run.rewound, run.curves]).toEqual([9, 0, [0], 1])
  expect(most(new Run([3, 9, 5, 50], { start: 100 }))).toBe(9)
  // A step that needs other runs, or has parts, is not taken for that.
  expect(most(new Run([3, 9, 50], { needs: 1 }))).toBe(3)
  expect(most(new Run([3, 9, 50], { parts: 2 }))).toBe(10)
  expect(most(new Run([], {}))).toBe(0)
  const other = new Run([3])
  expect([placesOf(other, 'iterations').report.most, other.rewound, other.curves]).toEqual([0, [], 0])
})

test('by iterations a place is its iteration: the next whole one, or the end', () => {
  const places = went(new Run([1, 1, 1, 1]), 'iterations', 2)
  expect([0, 0.5, 1, 1.5, 2].map((place) => places.iterationAt(place))).toEqual([0, 1, 1, 2, 2])
  expect([2.5, 3].map((place) => places.iterationAt(place))).toEqual([null, null])
  const ended = went(new Run([1, 1]), 'iterations', 2)
  expect([2, 3, 1000].map((place) => ended.iterationAt(place))).toEqual([2, 2, 2])
  expect(went(new Run([]), 'iterations', 0).iterationAt(7)).toBe(0)
})

test('by evaluations a place is the first iteration at or beyond it', () => {
  const run = new Run([10, 0, 5, 5, 1])
  const places = went(run, 'evaluations', 4)
  expect([0, 1, 10, 11, 15, 16, 20].map((place) => places.iterationAt(place))).toEqual([0, 1, 1, 3, 3, 4, 4])
  expect(places.iterationAt(21)).toBe(null)
  run.iteration += 1
  places.note()
  expect([21, 22].map((place) => places.iterationAt(place))).toEqual([5, 5])
})

test('a run that was taken back notes nothing until it is farther than it ever was', () => {
  const run = new Run([2, 2, 2, 2])
  const places = went(run, 'evaluations', 3)
  expect(places.isFurthest).toBe(true)
  run.rewind(1)
  expect(places.isFurthest).toBe(false)
  run.iteration = 2
  places.note()
  expect([places.isFurthest, places.report.iteration, places.report.evaluations]).toEqual([false, 3, 6])
  run.iteration = 3
  places.note()
  expect([places.isFurthest, places.iterationAt(6), places.iterationAt(7)]).toEqual([true, 3, null])
})

test('a run reaches a place at it or beyond, by its clock, or at its end', () => {
  const run = new Run([5, 5, 5])
  const [iterations, evaluations] = [placesOf(run, 'iterations'), placesOf(run, 'evaluations')]
  run.iteration = 2
  expect([1, 2, 3].map((place) => iterations.reaches(place))).toEqual([true, true, false])
  expect([9, 10, 11].map((place) => evaluations.reaches(place))).toEqual([true, true, false])
  run.iteration = 3
  expect([iterations.reaches(1000), evaluations.reaches(1000)]).toEqual([true, true])
})

test('it reports how far it came, what that took, and whether the last steps evaluated nothing', () => {
  const run = new Run([4, 7, 0])
  const places = placesOf(run, 'evaluations')
  expect(places.report).toEqual({ iteration: 0, evaluations: 0, extent: 100, most: 7, ended: false, tail: false })
  run.iteration = 2
  places.note()
  expect(places.report).toMatchObject({ iteration: 2, evaluations: 11, most: 11, ended: false, tail: false })
  run.iteration = 3
  places.note()
  expect(places.report).toMatchObject({ iteration: 3, evaluations: 11, most: 11, ended: true, tail: true })
  const whole = went(new Run([4, 7]), 'evaluations', 2)
  expect(whole.report).toMatchObject({ iteration: 2, evaluations: 11, ended: true, tail: false })
  expect(went(new Run([4, 7, 0, 0]), 'evaluations', 3).report).toMatchObject({ iteration: 3, tail: false })
  expect(went(new Run([4, 7], { start: 3 }), 'iterations', 1).report).toMatchObject({ iteration: 1, evaluations: 7, most: 4 })
  expect(went(new Run([], { start: 3 }), 'iterations', 0).report).toMatchObject({ evaluations: 3, ended: true })
})

test('by iterations no more than the last place is kept', () => {
  const places = went(new Run(Array(500).fill(1)), 'iterations', 400)
  expect(places['marks']).toEqual([{ iteration: 400, evaluations: 400 }])
})
