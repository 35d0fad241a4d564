import type { Finding, Job, Scene } from 'forage-lab'
import { Aborted, pool, type WorkerPool } from './pool'

/** A run that needs runs of other planners. */
export interface Needing {
  planner: string
  scene: Scene
}

interface Round {
  keys: string[]
  /** Of what nothing is known yet. */
  missing: Set<string>
  /** Calls off what has not begun. */
  waiting: AbortController
  report(done: number): void
  /** With nothing if the round was dropped or cannot be carried out. */
  end(found: Finding[] | null): void
}

/** Results that are kept, so that a run can go back and forth without carrying its subtasks out again. */
const KEPT = 5_000
/** So often a subtask is tried whose thread breaks. */
const TRIES = 2

const keyOf = ({ planner, params, seed, ends }: Job): string => JSON.stringify([planner, params, seed, ends])

/** Carries out the runs that a planner of planners needs, side by side. What they find doesn't depend on how many there are. */
export class SubtaskRunner {
  private scene = ''
  private found = new Map<string, Finding>()
  /** Begun, or waiting for a thread. */
  private taken = new Set<string>()
  /** Calls off what is of another scene. */
  private ofScene = new AbortController()
  private round: Round | undefined

  constructor(private readonly threads: () => WorkerPool = pool) {}

  /** What the tasks find, in their order; null if they were dropped or cannot be carried out. A new call drops the one before. */
  carryOut({ scene }: Needing, tasks: readonly Job[], report: (done: number) => void): Promise<Finding[] | null> {
    this.drop()
    this.begin(scene)
    if (this.found.size > KEPT) this.found.clear()
    const keys = tasks.map(keyOf)
    return new Promise((end) => {
      this.round = {
        keys,
        missing: new Set(keys.filter((key) => !this.found.has(key))),
        waiting: new AbortController(),
        report,
        end,
      }
      for (const task of tasks) void this.find(scene, task)
      this.goOn()
    })
  }

  /** Nobody waits for the round any more. Runs that are going on come to their end, in case they are asked for again. */
  drop(): void {
    this.end(null)
  }

  /** On the same scene what was found still counts: other planners may ask for the same. */
  private begin(scene: Scene): void {
    const text = JSON.stringify(scene)
    if (text === this.scene) return
    this.ofScene.abort()
    this.ofScene = new AbortController()
    this.scene = text
    this.found = new Map()
    this.taken = new Set()
  }

  private end(found: Finding[] | null): void {
    const { round } = this
    this.round = undefined
    round?.waiting.abort()
    round?.end(found)
  }

  /** Ends the round when all of it has been found. */
  private goOn(): void {
    const { round } = this
    if (!round) return
    if (round.missing.size === 0) this.end(round.keys.flatMap((key) => this.found.get(key) ?? []))
    else round.report(round.keys.length - round.missing.size)
  }

  private async find(scene: Scene, task: Job, tries = TRIES): Promise<void> {
    const { found, taken, round, ofScene } = this
    const key = keyOf(task)
    if (found.has(key) || taken.has(key) || !round) return
    taken.add(key)
    try {
      const signals = { signal: ofScene.signal, waiting: round.waiting.signal }
      found.set(key, await this.threads().run((api) => api.carryOut({ ...task, scene }), signals))
      taken.delete(key)
      if (found !== this.found) return
      this.round?.missing.delete(key)
      this.goOn()
    } catch (error) {
      taken.delete(key)
      if (found !== this.found || !this.round?.missing.has(key)) return
      // Called off by the round before, and wanted by this one.
      if (error instanceof Aborted) void this.find(scene, task)
      else if (tries > 1) void this.find(scene, task, tries - 1)
      else this.end(null)
    }
  }
}
