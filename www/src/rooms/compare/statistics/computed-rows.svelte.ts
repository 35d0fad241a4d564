import type { Row } from '../../../engine/trial.protocol'
import { KeptRows } from './kept-rows'

/** Rows beyond so many leave the memory, unless they are of the present plan. */
const MOST_ROWS = 20_000

const stay = (event: BeforeUnloadEvent): void => event.preventDefault()

/** Which runs: by a key of this page, and by a name that means the same in every page. */
export interface RowsOf {
  key: string
  name: string
}

/** The rows that were computed, here or in a page before this one. */
export class ComputedRows {
  private readonly rows = new Map<string, Map<number, Row>>()
  private size = 0
  /** Rows that are neither in a file nor kept by the browser. */
  private readonly unsaved = new Set<Row>()
  /** How many rows the browser keeps, of all plans; null: it keeps none. */
  kept = $state<number | null>(0)
  private running = false
  private readonly store = new KeptRows(
    (unkept) => {
      this.kept = null
      for (const row of unkept) this.unsaved.add(row)
      this.guard(this.running)
    },
    () => void this.count(),
  )
  /** Keys of which what is kept was read. */
  private readonly read = new Set<string>()

  /** `leave`: rows with this key have left the memory. */
  constructor(private readonly leave: (key: string) => void) {}

  of(key: string): ReadonlyMap<number, Row> | undefined {
    return this.rows.get(key)
  }

  add({ key, name }: RowsOf, seed: number, row: Row): void {
    this.put(key, seed, row)
    if (this.kept === null) this.unsaved.add(row)
    else this.store.write({ name, seed, row })
  }

  private put(key: string, seed: number, row: Row): void {
    const of = this.rows.get(key) ?? new Map<number, Row>()
    if (!of.has(seed)) this.size += 1
    this.rows.set(key, of.set(seed, row))
  }

  /** Takes in what the browser keeps; whether there was anything. */
  async restore(wanted: readonly RowsOf[]): Promise<boolean> {
    let any = false
    for (const { key, name } of wanted) {
      if (this.read.has(key)) continue
      this.read.add(key)
      for (const [seed, row] of await this.store.read(name)) {
        any = true
        if (!this.rows.get(key)?.has(seed)) this.put(key, seed, row)
      }
    }
    await this.count()
    return any
  }

  /** Rows of plans that were left, the oldest first. */
  forgetBut(keys: readonly string[]): void {
    for (const [key, of] of this.rows) {
      if (this.size <= MOST_ROWS) return
      if (keys.includes(key)) continue
      this.rows.delete(key)
      this.read.delete(key)
      for (const row of of.values()) this.unsaved.delete(row)
      this.size -= of.size
      this.leave(key)
    }
  }

  private async count(): Promise<void> {
    const count = await this.store.count()
    if (this.kept !== null) this.kept = count
  }

  /** Deletes all, here and what the browser keeps, of this plan and of others. */
  async clear(): Promise<void> {
    for (const key of this.rows.keys()) this.leave(key)
    this.rows.clear()
    this.unsaved.clear()
    this.size = 0
    await this.store.clear()
  }

  /** These are in a file now. */
  saved(rows: readonly Row[]): void {
    for (const row of rows) this.unsaved.delete(row)
  }

  /** What was computed isn't dropped without asking. */
  guard(running: boolean): void {
    this.running = running
    if (!running) void this.store.flush()
    if (running || this.unsaved.size > 0) addEventListener('beforeunload', stay)
    else removeEventListener('beforeunload', stay)
  }
}
