import { describe, expect, test, vi } from 'vitest'
import { DEFAULTS, type Progress } from '../../src/engine/protocol'
import {
  all,
  broken,
  DRIVE,
  eachByItself,
  forgiven,
  host,
  reports,
  type Said,
  said,
  session,
  settled,
  start,
  SWARM,
  TOURS,
  transferred,
  TUNING,
  until,
  want,
} from '../hosted'

/* What reports of a run have when that is wanted, what other runs it needs, and its end. */

eachByItself()

test('members come as often as they are wanted, at once when they are wanted, and where it stays', async () => {
  want({ start: start(TOURS, 0, true), speed: 30, members: 10_000 })
  await until(() => expect(reports().at(-1)?.iteration).toBeGreaterThan(3))
  expect(reports().flatMap(({ members }, at) => (members ? [at] : []))).toEqual([0])
  const asked = want({ members: 9000 })
  await until(() => expect(reports().find((report) => report.version >= asked)?.members).toBeTruthy())
  want({ target: { play: false } })
  const { members, frame, iteration } = await settled()
  expect([...(members ?? [])]).toEqual(session(TOURS, iteration, (run) => [...run.members()]))
  expect(members?.length).toBeGreaterThan(0)
  const at = said.findLastIndex(({ is }) => is === 'report')
  expect(transferred[at]).toEqual([frame.buffer, members?.buffer])
  want({ members: null })
  expect((await settled()).members).toBe(null)
})

test('what is supposed of an item is said if its explanation knows it', async () => {
  const item = { role: 'particles', index: 0 } as const
  want({ start: start(SWARM, 3), item, supposition: { name: 'other-numbers', draw: 1 } })
  const { inspection } = await until(() => {
    const report = reports().at(-1)
    if (!report?.inspection) throw new Error('no words yet')
    return report
  })
  const [known] = inspection?.suppositions ?? []
  expect(known).toBeTruthy()
  want({ supposition: { name: known?.name ?? '', draw: 2 } })
  const expected = session(SWARM, 3, (run) => run.suppose(item, known?.name as never, 2))
  const { supposed } = await settled()
  expect(supposed?.values).toEqual(expected?.values)
  want({ supposition: { name: 'nobody knows it', draw: 2 } })
  expect((await settled()).supposed).toBe(null)
})

test('without a summary where it stays there is neither hash nor link', async () => {
  want({ start: start(SWARM, 3), summary: false, links: true })
  const { hash, arrived } = await settled()
  expect([hash, arrived]).toEqual([null, true])
})

test('links come with the part that makes them, for a run that is settled, too', async () => {
  want({ start: start(SWARM, 3), links: true })
  expect((await settled()).link).toBe(null)
  const count = reports().length
  host.link()
  await until(() => expect(reports().length).toBeGreaterThan(count))
  expect(reports().at(-1)?.link).toBe(session(SWARM, 3, (run) => run.link()))
  host.link()
})

test('in another language all is said once more', async () => {
  want({ start: start(DRIVE, 0, true), speed: Infinity })
  const { iteration } = await settled()
  const english = reports().flatMap(({ events }) => events)
  want({ language: 'zh-CN' })
  const report = await until(() => {
    const last = reports().at(-1)
    if (!last?.repeats) throw new Error('not yet')
    return last
  })
  expect([report.iteration, report.events.length, report.span?.end]).toEqual([iteration, english.length, iteration])
  expect(report.events.map(({ reason }) => reason)).not.toEqual(english.map(({ reason }) => reason))
  const count = reports().length
  want({ language: 'zh-CN' })
  await settled()
  expect(
    reports()
      .slice(count)
      .some(({ repeats }) => repeats),
  ).toBe(false)
  want({ language: 'en' })
  await until(() =>
    expect(
      reports()
        .at(-1)
        ?.events.map(({ reason }) => reason),
    ).toEqual(english.map(({ reason }) => reason)),
  )
})

describe('runs of other planners', () => {
  const requests = (): Said<'subtasks'>[] => all('subtasks')

  test('are asked for before the step that needs them, which carries them out itself where nobody does', async () => {
    want({ start: start(TUNING, 0, true), speed: Infinity })
    const answered = new Set<number>()
    const { hash, iteration } = await until(() => {
      for (const { id } of requests())
        if (!answered.has(id)) {
          answered.add(id)
          // An answer to another request says nothing.
          host.provide(id + 1000, null)
          host.provide(id, null)
        }
      const report = reports().findLast(({ arrived }) => arrived)
      if (!report) throw new Error('it is still on its way')
      return report
    })
    expect(hash).toBe(session(TUNING, iteration, (run) => run.hash()))
    const [first] = requests()
    const jobs = session(TUNING, 0, (run) => run.jobs())
    expect(first).toMatchObject({ id: 1, generation: 1, step: 1, planner: 'pso-tuning', tasks: jobs })
    expect(requests().map(({ step }) => step)).toEqual(requests().map((_, at) => at + 1))
    // It took long while it waited, and then no more.
    const progress = all('progress') as Progress[]
    expect(progress.at(-1)).toMatchObject({ done: 0, total: 0 })
  })

  test('are called off when another run is wanted', async () => {
    want({ start: start(TUNING, 0, true), speed: Infinity })
    await until(() => expect(requests()).toHaveLength(1))
    const tasks = requests()[0]?.tasks.length
    expect(tasks).toBeGreaterThan(0)
    want({ start: start(SWARM, 2) })
    expect(requests().at(-1)).toMatchObject({ id: 1, tasks: [] })
    const { planner, iteration } = await settled()
    expect([planner, iteration, requests().length]).toEqual(['wcpso', 2, 2])
  })
})

test('there is something to ask of a run when it is there and no step is half taken', async () => {
  expect(await host.untilStepEnds()).toBe(false)
  want({ start: start(SWARM, 3) })
  expect(await host.untilStepEnds()).toBe(true)
  expect(host.session?.planner).toBe('wcpso')
  want({ start: start({ ...SWARM, params: { population: 0 } }) })
  expect(await host.untilStepEnds()).toBe(true)
  expect(all('refused')).toHaveLength(1)
})

test('what breaks the core down is said, and not in silence', async () => {
  want({ start: start(SWARM, 3) })
  await settled()
  const { session: run } = host
  if (!run) throw new Error('no run')
  const failing = new Error('unreachable')
  vi.spyOn(run, 'readings').mockImplementation(() => {
    throw failing
  })
  want({ target: { at: 5, play: false } })
  await until(() => expect(broken).toEqual([failing]))
  forgiven()
  vi.restoreAllMocks()
})

test('nobody has wanted anything: there is no run, and all is as it is by default', () => {
  expect([host.session, host.generation, host.budget]).toEqual([undefined, 0, DEFAULTS.budget])
  want({ target: { at: 5, play: true } })
  host.provide(1, null)
  expect(said).toEqual([])
})
