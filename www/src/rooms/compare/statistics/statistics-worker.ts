import type { RunSetup } from '../../../catalogue/own'
import type { Refusal } from '../../../engine/protocol'
import type { Answered, Made, Maps, Question, Row, Values } from '../../../engine/trial.protocol'
import { type Task, Thread } from '../../../engine/pool'

export interface Group {
  slot: number
  label: string
  key: string
  planner: string
  /** As far as they differ from the defaults. */
  params: Values
  /** In the order of their seeds. */
  rows: Row[]
  /** Not all of its runs are the same run. */
  lots: boolean
}

/** A thread that sums up and checks, so that nobody waits for a run. */
export class StatisticsWorker {
  private thread: Thread | undefined
  private told = new WeakSet<Row>()

  check(setup: RunSetup): Promise<Refusal | null> {
    return this.ask((api) => api.check(setup))
  }

  /** A map for a seed, or what the generator refuses. */
  map(maps: Maps, seed: number): Promise<Made> {
    return this.ask((api) => api.map({ ...maps, params: { ...maps.params } }, seed))
  }

  /** `relative`: by the gaps to the optimum instead of the values. */
  async summarise(groups: readonly Group[], relative: boolean): Promise<Answered> {
    const first = groups[0]?.rows ?? []
    const shared = new Set(first.map(({ record }) => record.seed))
    for (const { rows } of groups.slice(1)) {
      const seeds = new Set(rows.map(({ record }) => record.seed))
      for (const seed of shared) if (!seeds.has(seed)) shared.delete(seed)
    }
    const valuesOf = (rows: readonly Row[]): (number | null)[] =>
      rows.map(({ record }) => (relative && record.value !== null ? record.gap : record.value))
    const question = (): Question => ({
      relative,
      curves: groups.flatMap(({ key, rows }) =>
        rows
          .filter((row) => !this.told.has(row))
          .map((row) => ({ key, seed: row.record.seed, curve: { ...row.curve, exact: row.record.exact } })),
      ),
      groups: groups.map(({ label, key, rows, lots }) => ({
        name: label,
        key,
        deterministic: !lots,
        seeds: rows.map(({ record }) => record.seed),
        values: valuesOf(rows),
        reached: rows.map(({ record }) => record.reached),
        spent: rows.map(({ record }) => record.evaluations),
        settled: rows.flatMap(({ record: { feasible, settled } }) => (feasible ? (settled ?? []) : [])),
        end: rows.reduce((end, { record }) => Math.max(end, record.evaluations), 0),
      })),
      common: groups.map(({ label, rows, lots }) => ({
        name: label,
        deterministic: !lots,
        values: valuesOf(rows.filter(({ record }) => shared.has(record.seed))),
      })),
    })
    const answer = await this.ask((api) => api.summarise(question()))
    for (const { rows } of groups) for (const row of rows) this.told.add(row)
    return answer
  }

  forget(key: string): void {
    void this.thread?.api.forget([key])
  }

  /** A thread that broke down is replaced once; the new one is told everything again. */
  private async ask<T>(question: Task<T>): Promise<T> {
    try {
      return await this.put(question)
    } catch {
      return this.put(question)
    }
  }

  private async put<T>(question: Task<T>): Promise<T> {
    this.thread ??= new Thread()
    const { thread } = this
    try {
      return await thread.run(question)
    } catch (cause) {
      const error = cause instanceof Error ? cause : new Error(String(cause))
      thread.end(error)
      if (thread === this.thread) {
        this.thread = undefined
        this.told = new WeakSet()
      }
      throw error
    }
  }
}
