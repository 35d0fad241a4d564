import { type DBSchema, type IDBPDatabase, openDB } from 'idb'
import type { Row } from '../../../engine/trial.protocol'

interface Schema extends DBSchema {
  /** Runs that differ in their seeds only, by what they have in common. */
  groups: { key: number; value: { name: string }; indexes: { name: string } }
  rows: { key: [group: number, seed: number]; value: { group: number; seed: number; row: Row } }
}

interface Written {
  name: string
  seed: number
  row: Row
}

/** Rows are written together, at most so often, in milliseconds. */
const INTERVAL = 400

/** Runs of batches, kept by the browser until they are deleted. */
export class KeptRows {
  private database: Promise<IDBPDatabase<Schema>> | undefined
  private waiting: Written[] = []
  private timer: ReturnType<typeof setTimeout> | undefined
  private readonly groups = new Map<string, number>()

  /** `onfailed`: nothing can be kept here, nor could these be. `onwritten`: there are other rows than before. */
  constructor(
    private readonly onfailed: (rows: readonly Row[]) => void,
    private readonly onwritten: () => void,
  ) {}

  private open(): Promise<IDBPDatabase<Schema>> {
    this.database ??= openDB<Schema>('forage', 1, {
      upgrade(database) {
        database.createObjectStore('groups', { autoIncrement: true }).createIndex('name', 'name', { unique: true })
        database.createObjectStore('rows', { keyPath: ['group', 'seed'] })
      },
    })
    return this.database
  }

  /** The rows of a group, by seed. */
  async read(name: string): Promise<Map<number, Row>> {
    try {
      const database = await this.open()
      const group = await database.getKeyFromIndex('groups', 'name', name)
      if (group === undefined) return new Map()
      this.groups.set(name, group)
      const found = await database.getAll('rows', IDBKeyRange.bound([group, 0], [group, Infinity]))
      return new Map(found.map(({ seed, row }) => [seed, row]))
    } catch {
      this.onfailed([])
      return new Map()
    }
  }

  write(written: Written): void {
    this.waiting.push(written)
    this.timer ??= setTimeout(() => void this.flush(), INTERVAL)
  }

  /** Writes what waits. */
  async flush(): Promise<void> {
    clearTimeout(this.timer)
    this.timer = undefined
    const { waiting } = this
    this.waiting = []
    if (waiting.length === 0) return
    try {
      const transaction = (await this.open()).transaction(['groups', 'rows'], 'readwrite')
      for (const { name, seed, row } of waiting) {
        const known = this.groups.get(name) ?? (await transaction.objectStore('groups').index('name').getKey(name))
        const group = known ?? (await transaction.objectStore('groups').add({ name }))
        this.groups.set(name, group)
        void transaction.objectStore('rows').put({ group, seed, row })
      }
      await transaction.done
      this.onwritten()
    } catch {
      this.onfailed(waiting.map(({ row }) => row))
    }
  }

  /** How many rows there are. */
  async count(): Promise<number> {
    try {
      return await (await this.open()).count('rows')
    } catch {
      return 0
    }
  }

  async clear(): Promise<void> {
    this.waiting = []
    this.groups.clear()
    try {
      const transaction = (await this.open()).transaction(['groups', 'rows'], 'readwrite')
      void transaction.objectStore('groups').clear()
      void transaction.objectStore('rows').clear()
      await transaction.done
      this.onwritten()
    } catch {
      this.onfailed([])
    }
  }
}
