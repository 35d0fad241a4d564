import { describe, expect, test } from 'vitest'
import { type Setup, suggest } from '../../../pkg/node.js'
import { extent } from '../../src/engine/host/extent'
import type { Picture, Report } from '../../src/engine/protocol'
import {
  ANTS,
  all,
  DRIVE,
  eachByItself,
  host,
  LONG,
  reports,
  returning,
  said,
  session,
  settled,
  start,
  SWARM,
  transferred,
  until,
  want,
} from '../hosted'

/* The loop that hosts a run, with the core: what it says on the way is what a session says. */

eachByItself()

test('the first report of a run says what it turned out to be, and no other does', async () => {
  const begin = want({ start: start(), budget: 50 })
  await settled()
  want({ target: { at: 4, play: false } })
  await settled()
  const [first, ...others] = reports()
  const expected = session(SWARM, 0, (run) => {
    const { planner, scene, seed, limit, parameters, evaluations, stages } = run
    return {
      generation: begin,
      planner,
      scene,
      seed,
      limit,
      parameters,
      evaluations,
      exact: run.exact(),
      skeleton: [],
      span: { end: run.end ?? null, extent: extent(run, 0), stages },
    }
  })
  expect(first?.run).toEqual(expected)
  expect(others.length).toBeGreaterThan(0)
  for (const report of others) expect([report.run, report.generation, report.planner]).toEqual([null, begin, 'wcpso'])
  expect([host.generation, host.budget, host.session?.iteration]).toEqual([begin, 50, 4])
})

test('an arm comes with its skeleton at home', async () => {
  want({ start: start({ planner: 'rrt', scene: 'arm-cuboid', params: {}, seed: 1 } as never) })
  const { thinning } = await settled()
  expect(reports()[0]?.run?.skeleton).toHaveLength(5)
  expect(thinning).toBe(1)
})

test('where it stays it says all that a session says there', async () => {
  want({ start: start(), links: true, item: { role: 'particles', index: 2 } })
  host.link()
  await settled()
  want({ target: { at: 17, play: false } })
  const report = await until(() => {
    const last = reports().at(-1)
    if (!last?.arrived || last.iteration !== 17 || !last.inspection?.summary || !last.link) throw new Error('not yet')
    return last
  })
  session(SWARM, 17, (run) => {
    expect([report.iteration, report.evaluations, report.status, report.hash]).toEqual([17, run.evaluations, 'running', run.hash()])
    expect([report.readings, report.outcome]).toEqual([run.readings(), run.outcome()])
    expect([report.link, host.linkOf(run)]).toEqual([run.link(), { ok: true, value: run.link() }])
    expect(report.inspection?.values).toEqual(run.inspect({ role: 'particles', index: 2 })?.values)
    expect([report.supposed, report.curve, report.members, report.playing, report.repeats]).toEqual([null, null, null, false, false])
  })
  expect(report.furthest).toMatchObject({ iteration: 17, ended: false, tail: false })
})

test('traces and events add up to those of the whole run, and come once', async () => {
  want({ start: start(DRIVE, 0, true), speed: Infinity })
  const { iteration, status } = await settled()
  expect(status).toBe('solved')
  session(DRIVE, iteration, (run) => {
    const whole = run.trace(-1)
    expect(reports().flatMap(({ trace }) => [...trace.iterations])).toEqual([...whole.iterations])
    expect(reports().flatMap(({ trace }) => [...trace.rows])).toEqual([...whole.rows])
    expect(reports().flatMap(({ events }) => events).length).toBe(run.events(0).length)
    expect(reports().flatMap(({ events }) => events.map(({ time }) => time))).toEqual(run.events(0).map(({ time }) => time))
  })
  const before = reports().length
  want({ target: { at: 5, play: false } })
  await settled()
  want({ target: { at: iteration, play: false } })
  await settled()
  expect(
    reports()
      .slice(before)
      .flatMap(({ events, trace }) => [...events, ...trace.iterations]),
  ).toEqual([])
  // Its end was not known at first, and is said when it is.
  const spans = reports().flatMap(({ span }) => (span ? [span] : []))
  expect(spans.at(-1)).toMatchObject({ end: iteration, extent: iteration })
})

test('a timeline that grows is said when it grows', async () => {
  want({ start: start({ ...ANTS, planner: 'dijkstra' }) })
  await settled()
  want({ target: { at: 99, play: false }, underway: false })
  expect((await settled()).span).toBe(null)
  want({ target: { at: 100, play: false } })
  const { span, status } = await settled()
  expect([status, span]).toMatchObject(['running', { end: null, extent: 200 }])
})

describe('a start', () => {
  test('that is to be checked is accepted before the run begins; without asking nothing is said', async () => {
    const begin = want({ start: { ...start(), check: true } })
    await settled()
    expect(all('accepted')).toEqual([{ is: 'accepted', version: begin }])
    expect(said.findIndex(({ is }) => is === 'accepted')).toBeLessThan(said.findIndex(({ is }) => is === 'report'))
    want({ start: start() })
    await settled()
    expect(all('accepted')).toHaveLength(1)
  })

  test.each([true, false])('that is refused leaves the run of before where it is (checked: %s)', async (check) => {
    const wrong = { ...SWARM, params: { population: 0 } }
    expect(() => suggest(wrong as Setup)).toThrow()
    want({ start: start(SWARM, 6) })
    await settled()
    const begin = want({ start: { ...start(wrong, 9, true), check } })
    await until(() => expect(all('refused')).toHaveLength(1))
    expect(all('refused')[0]).toMatchObject({ version: begin, refusal: { field: 'population' } })
    expect([await settled().then(({ iteration, generation }) => [iteration, generation]), all('accepted')]).toEqual([[6, 1], []])
    // Where it was wanted meanwhile it goes, though.
    want({ start: start(wrong, 0), target: null })
    want({ target: { at: 8, play: false } })
    expect((await settled()).iteration).toBe(8)
  })

  test('of which another one is wanted meanwhile is not begun', async () => {
    want({ start: start(SWARM, 5) })
    const second = want({ start: start(ANTS, 2) })
    const report = await settled()
    expect([report.generation, report.planner, report.iteration]).toEqual([second, 'aco', 2])
    expect(reports().filter(({ run }) => run)).toHaveLength(1)
  })

  test('begins where it says, and plays from there', async () => {
    want({ start: start(SWARM, 12, true), speed: Infinity })
    const { iteration, status } = await settled()
    expect([status === 'running', iteration > 12]).toEqual([false, true])
    expect(
      Math.min(
        ...reports()
          .filter(({ playing }) => playing)
          .map((report) => report.iteration),
      ),
    ).toBeGreaterThanOrEqual(0)
  })

  test('keeps an item that is chosen with it or later, and drops one of before', async () => {
    const item = { role: 'particles', index: 1 } as const
    const inspected = (): Promise<unknown> => until(() => expect(reports().at(-1)?.inspection?.title).toBeTruthy())
    want({ start: start(SWARM, 1), item })
    await inspected()
    want({ start: start(SWARM, 1) })
    expect((await settled()).inspection).toBe(null)
    want({ item })
    await inspected()
  })
})

describe('playing', () => {
  test('takes as many steps a second as it is to', async () => {
    want({ start: start(ANTS, 0, true), speed: 50 })
    await until(() => expect(reports().some(({ iteration }) => iteration > 0)).toBe(true))
    const [from, at] = [performance.now(), host.session?.iteration ?? 0]
    await new Promise((passed) => setTimeout(passed, 600))
    const [seconds, steps] = [(performance.now() - from) / 1000, (host.session?.iteration ?? 0) - at]
    // A machine that is busy may be late.
    expect(steps).toBeLessThanOrEqual(50 * (seconds + 0.2) + 1)
    expect(steps).toBeGreaterThan(5)
    expect(reports().at(-1)?.playing).toBe(true)
    want({ target: { play: false } })
    const { iteration, playing, hash } = await settled()
    expect([playing, hash]).toEqual([false, session(ANTS, iteration, (run) => run.hash())])
  })

  test('begins again from the start when it has ended, but not where it is to go somewhere first', async () => {
    want({ start: start(SWARM, 0, true), speed: Infinity })
    const { iteration: end } = await settled()
    const count = said.length
    want({ target: { play: true }, speed: 1000 })
    await until(() => expect(said.slice(count).some((message) => message.is === 'report' && message.iteration < end / 2)).toBe(true))
    want({ speed: Infinity })
    expect((await settled()).iteration).toBe(end)
    const later = said.length
    want({ target: { at: end, play: true } })
    expect((await settled()).iteration).toBe(end)
    expect(said.slice(later).every((message) => message.is !== 'report' || message.iteration === end)).toBe(true)
  })

  test('fast it shows more pictures than it makes reports', async () => {
    want({ start: start(LONG, 0, true), speed: 2000 })
    await until(() => expect(all('picture').length).toBeGreaterThan(6))
    want({ target: { play: false } })
    await settled()
    const pictures = all('picture') as Picture[]
    expect(pictures.length).toBeGreaterThan(reports().length)
    for (const picture of pictures) expect([picture.generation, picture.planner]).toEqual([1, 'pso'])
    const at = said.findIndex(({ is }) => is === 'picture')
    expect(transferred[at]).toEqual([(said[at] as Picture).frame.buffer])
  })

  test('at a legible speed each picture is a report', async () => {
    want({ start: start(ANTS, 0, true), speed: 30 })
    await until(() => expect(reports().at(-1)?.iteration).toBeGreaterThan(5))
    expect(all('picture')).toEqual([])
  })

  test('waits for a buffer to come back', async () => {
    returning(false)
    want({ start: start(ANTS, 0, true), speed: 1000 })
    const shown = (): Report[] => said.filter((message): message is Report => message.is === 'report' || message.is === 'picture')
    await until(() => expect(shown()).toHaveLength(3))
    const at = host.session?.iteration ?? 0
    await until(() => expect(host.session?.iteration).toBeGreaterThan(at + 30))
    expect(shown()).toHaveLength(3)
    returning(true)
    for (const { frame } of shown()) host.giveBack(frame.buffer)
    want({ target: { play: false } })
    expect((await settled()).hash).toBeTruthy()
  })

  test('summaries come a few times a second only; where it stays there is one', async () => {
    want({ start: start(ANTS, 0, true), speed: 30 })
    await until(() => expect(reports().at(-1)?.iteration).toBeGreaterThan(12))
    const playing = reports().filter((report) => report.playing)
    expect(playing.filter(({ outcome }) => outcome).length).toBeLessThan(playing.length / 2)
    expect(playing.every(({ hash }) => hash === null)).toBe(true)
    want({ target: { play: false } })
    const { outcome, hash } = await settled()
    expect([outcome === null, hash === null]).toEqual([false, false])
  })
})

describe('on its way to a place', () => {
  test('it shows where it is, or only where it was to go', async () => {
    want({ start: start(LONG) })
    await settled()
    let count = said.length
    want({ target: { at: 4000, play: false } })
    await settled()
    expect(said.slice(count).filter((m) => m.is === 'report' || m.is === 'picture').length).toBeGreaterThan(2)
    count = said.length
    want({ target: { at: 8000, play: false }, underway: false })
    await settled()
    const shown = said.slice(count).filter((m): m is Report => m.is === 'report')
    expect(shown.every(({ iteration }) => iteration === 4000 || iteration === 8000)).toBe(true)
    // What was seen before is not shown again on the way.
    count = said.length
    want({ target: { at: 30, play: false }, underway: true })
    await settled()
    want({ target: { at: 7000, play: false } })
    await settled()
    const again = said.slice(count).flatMap((m) => (m.is === 'report' || m.is === 'picture' ? [m.iteration] : []))
    expect(again.every((iteration) => [30, 7000, 8000].includes(iteration))).toBe(true)
  })

  test('a newer place counts', async () => {
    want({ start: start(ANTS) })
    want({ target: { at: 90, play: false } })
    want({ target: { at: 7, play: false } })
    const { iteration, hash } = await settled()
    expect([iteration, hash]).toEqual([7, session(ANTS, 7, (run) => run.hash())])
  })

  test('beyond its end it is at its end', async () => {
    want({ start: start({ ...SWARM, params: { iterations: 30 } }) })
    want({ target: { at: 1000, play: false } })
    const { iteration, status, furthest } = await settled()
    expect([status === 'running', iteration <= 30, furthest.ended, furthest.iteration]).toEqual([false, true, true, iteration])
  })
})

test('by the clock of evaluations the best so far comes when it has grown', async () => {
  want({ start: start(), clock: 'evaluations' })
  await settled()
  want({ target: { at: 3000, play: false } })
  const { iteration, evaluations } = await settled()
  const curves = reports().flatMap(({ curve }) => (curve ? [curve] : []))
  session(SWARM, 0, (run) => {
    run.curve()
    run.step(iteration)
    expect([evaluations, curves.at(-1)]).toEqual([run.evaluations, run.curve()])
  })
  const grown = curves.map(({ values }) => values.length)
  expect(new Set(grown).size).toBe(grown.length)
})
