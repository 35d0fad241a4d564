import * as Comlink from 'comlink'
import { armSlice, bands, carryOut, compare, generateScene, load, reachability, reached, ready, serveBy, suggest, Trial } from 'forage-lab'
import type { Finding, GeneratorName, Reachability, Scene, Setup } from 'forage-lab'
import type { RunSetup } from '../../catalogue/own'
import type { Files } from '../host'
import { from } from './files'
import { causeOf, refusalOf } from './refusal'
import { speakIn } from './rest'
import { AGAIN, iterationsFor, moreIterations, type Spending } from '../budget'
import { within } from './answers'
import { breathe, SLICE } from './pace'
import { codeInLinks, registered } from './setups'
import type { Answer, Refusal } from '../protocol'
import type { Answered, Conformance, Curve, Ending, Errand, Made, Maps, Measured, Question, Row } from '../trial.protocol'

const curves = new Map<string, Map<number, Measured>>()
let stopped = false
/** The checks of a planner take so many iterations each. */
const CONFORMANCE_STEPS = 20

/** How far above the optimum, as a share of it. */
function inGap({ evaluations, values, exact }: Measured): Curve {
  return { evaluations, values: exact ? values.map((value) => (value - exact) / exact) : values }
}

/** With a short message. The module's memory is in an unknown state then: another thread takes the place of this one. */
const broken = (error: unknown): Error => new Error(causeOf(error), { cause: error })

/** What the core refuses. Other errors are thrown. */
function refusedBy(error: unknown): Refusal {
  const refusal = refusalOf(error)
  if (!refusal) throw broken(error)
  return refusal
}

/**
 * Up to `pace` steps or, with a budget, parts of them; whether the run is over. `apart`: they are taken one by one, as long as there is
 * time: each may take much longer than the one before.
 */
function advance(trial: Trial, pace: number, budget: number | null, apart: boolean): boolean {
  const single = apart || budget !== null
  const until = performance.now() + 2 * SLICE
  for (let left = pace; left > 0; left -= 1) {
    const status = trial.advance(single ? 1 : pace)
    if (status !== 'running' && status !== 'partly') return true
    if (!single || (apart && performance.now() > until)) return false
    if (budget === null) continue
    // Within a step a planner may count what it has not evaluated yet.
    if (status === 'running' && trial.evaluations >= budget) return true
  }
  return false
}

/** Steps in slices, and long steps in parts, so that it can be called off; false if it was. */
async function stepToEnd(trial: Trial, budget: number | null, apart: boolean): Promise<boolean> {
  let pace = 1
  if (budget !== null && trial.evaluations >= budget) return true
  for (;;) {
    const began = performance.now()
    if (advance(trial, pace, budget, apart)) return true
    pace = Math.max(1, Math.floor(pace * Math.min(2, SLICE / Math.max(performance.now() - began, 0.1))))
    await breathe()
    if (stopped) return false
  }
}

/** What runs are compared by. Functions of several seeds have other optima: then it is how far above its own each came. */
function compared(trial: Trial, maps: Maps | null): Pick<Row, 'record' | 'original' | 'curve'> {
  const { evaluations, values } = trial.curve()
  const record = trial.record()
  const { exact, value, length } = record
  if (!maps || length !== null || exact === null || value === null) return { record, original: null, curve: { evaluations, values } }
  const curve = { evaluations, values: values.map((one) => one - exact) }
  return { record: { ...record, value: value - exact, exact: 0 }, original: { value, exact }, curve }
}

/** What a run spends that has just begun; null if it was called off. */
async function spendingOf(trial: Trial): Promise<Spending | null> {
  const { evaluations: start, limit } = trial
  for (;;) {
    const idle = trial.iteration
    let status = trial.advance(1)
    for (; status === 'partly' && !stopped; status = trial.advance(1)) await breathe()
    const step = trial.evaluations - start
    if (stopped) return null
    if (step > 0 || status !== 'running') return { start, idle, step, limit }
    await breathe()
  }
}

async function answered<T>(ask: () => T): Promise<Answer<T>> {
  try {
    return { ok: true, value: await ready(ask) }
  } catch (error) {
    return { ok: false, refusal: refusedBy(error) }
  }
}

const api = {
  /** Where a thread cannot find the package's files, it is given them before anything else. */
  open(files: Files): void {
    serveBy(from(files))
  },

  speakIn,

  /** A sign of life. */
  beat: (): void => undefined,

  /** A run that a planner of planners needs. */
  carryOut: (subtask: Parameters<typeof carryOut>[0]): Promise<Finding> => ready(() => carryOut(subtask)),

  /** Where the tip of an arm can come, on a lattice of this step. */
  reach: (scene: Scene, step: number): Promise<Answer<Reachability>> => answered(() => reachability(scene, step)),

  /** Where an arm touches something while two of its joints turn. */
  slice: (...given: Parameters<typeof armSlice>): Promise<Answer<Uint8Array>> => answered(() => armSlice(...given)),

  /** Carries out a run to its end, or until `stop`. */
  async run(errand: Errand): Promise<Ending> {
    const { setup, maps, seed, budget, most } = errand
    stopped = false
    const plain = await registered(setup)
    if (!plain.ok) return { is: 'refused', refusal: plain.refusal }
    const code = await codeInLinks(setup)
    let given: Setup
    let trial: Trial
    try {
      await load('links')
      given = await ready(() => {
        const scene = maps ? generateScene(maps.generator as GeneratorName, { ...maps.params }, seed) : plain.value.scene
        return { ...plain.value, scene } as Setup
      })
      trial = await ready(() => new Trial(given, undefined))
    } catch (error) {
      return { is: 'refused', refusal: refusedBy(error) }
    }
    try {
      let iterations: number | null = null
      if (budget !== null && most !== null) {
        const spending = await spendingOf(trial)
        if (!spending) return { is: 'stopped' }
        iterations = iterationsFor(spending, budget, most)
      }
      for (let again = 0; ; again += 1) {
        if (iterations !== null) {
          let longer: Trial
          try {
            longer = new Trial({ ...given, params: { ...given.params, iterations } } as Setup, undefined)
          } catch (error) {
            const refusal = refusalOf(error)
            if (!refusal) throw error
            return { is: 'refused', refusal }
          }
          trial.free()
          trial = longer
        }
        if (stopped || !(await stepToEnd(trial, budget, setup.code !== undefined))) return { is: 'stopped' }
        if (iterations === null || budget === null || most === null || again === AGAIN) break
        iterations = moreIterations(trial, iterations, budget, most)
        if (iterations === null) break
      }
      const row: Row = { ...compared(trial, maps), link: trial.link() + (code.ok ? code.value : '') }
      return Comlink.transfer<Ending>({ is: 'over', row }, [row.curve.evaluations.buffer, row.curve.values.buffer])
    } catch (error) {
      throw broken(error)
    } finally {
      trial.free()
    }
  },

  stop(): void {
    stopped = true
  },

  /** A generator's map for a seed. */
  async map({ generator, params }: Maps, seed: number): Promise<Made> {
    try {
      return { scene: await ready(() => generateScene(generator as GeneratorName, { ...params }, seed)) }
    } catch (error) {
      return { refused: refusedBy(error) }
    }
  },

  /** What a run spends; null if that was called off. */
  async spends(setup: RunSetup): Promise<Answer<Spending | null>> {
    stopped = false
    const plain = await registered(setup)
    if (!plain.ok) return plain
    let trial: Trial
    try {
      trial = await ready(() => new Trial(plain.value, undefined))
    } catch (error) {
      return { ok: false, refusal: refusedBy(error) }
    }
    try {
      return { ok: true, value: await spendingOf(trial) }
    } catch (error) {
      throw broken(error)
    } finally {
      trial.free()
    }
  },

  /** What a planner does not keep to whose code this is, on a scene that ships. */
  async conform(code: string, scene: string | null): Promise<Answer<Conformance>> {
    const [{ loadPlanner }, { conform }] = await Promise.all([import('./own'), import('forage-lab/testing')])
    return within(async () => {
      const { described } = await loadPlanner(code)
      const { checks, violations } = await conform(described.name, { steps: CONFORMANCE_STEPS, ...(scene !== null && { scenes: [scene] }) })
      return { checks, violations }
    })
  },

  /** What is wrong with a setup. */
  async check(setup: RunSetup): Promise<Refusal | null> {
    const plain = await registered(setup)
    if (!plain.ok) return plain.refusal
    try {
      await ready(() => suggest(plain.value))
      return null
    } catch (error) {
      return refusedBy(error)
    }
  },

  /** Summaries and tests. Curves that were told before need not be told again. */
  async summarise({ relative, curves: told, groups, common }: Question): Promise<Answered> {
    await load('statistics')
    for (const { key, seed, curve } of told) {
      const of = curves.get(key) ?? new Map<number, Measured>()
      curves.set(key, of.set(seed, curve))
    }
    const runs = groups
      .map(({ key, seeds }) => seeds.flatMap((seed) => curves.get(key)?.get(seed) ?? []))
      .map((some) => (relative ? some.map(inGap) : some))
    const settled = compare(groups.map((group) => ({ name: group.name, values: group.settled })))
    return {
      comparison: compare(groups),
      friedman: compare(common).friedman,
      settled: settled.groups.map(({ summary }) => summary?.median ?? null),
      bands: bands(
        runs,
        groups.map(({ end }) => end),
      ),
      reached: groups.map((group) => reached(group.reached, group.spent)),
    }
  },

  /** Forgets the curves of groups that are not asked for any more. */
  forget(keys: string[]): void {
    for (const key of keys) curves.delete(key)
  },
}

export type TaskApi = typeof api
Comlink.expose(api)
