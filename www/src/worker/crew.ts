import type { Finding, Job, Scene, Setup } from 'forage'

/** Somebody who carries runs out, one at a time. */
export interface Hand {
  carryOut(setup: Setup): Promise<Finding>
  dismiss(): void
}

interface Round {
  keys: string[]
  /** Jobs that nobody has taken up. */
  waiting: string[]
  tell(done: number): void
  /** With nothing if the round was dropped or cannot be carried out. */
  end(found: Finding[] | null): void
}

/** Hands without work leave after so many milliseconds. */
const PATIENCE = 30_000
/** Findings that are kept, so that a run can go back and forth without carrying its jobs out again. */
const KEPT = 5_000

const keyOf = ({ planner, params, seed }: Job): string => JSON.stringify([planner, params, seed])

/** Carries out the runs that a planner of planners needs, side by side. What they find doesn't depend on who they are. */
export class Crew {
  private scene: Scene | undefined
  private planner = ''
  private readonly jobs = new Map<string, Job>()
  private readonly found = new Map<string, Finding>()
  private readonly busy = new Map<Hand, string>()
  private idle: Hand[] = []
  private round: Round | undefined
  private leaving: ReturnType<typeof setTimeout> | undefined

  constructor(
    private readonly size: number,
    /** Somebody from another thread; throws where there can be none. */
    private readonly hire: () => Hand,
    /** Takes the place of all others when they fail. */
    private readonly oneself: Hand,
  ) {}

  /** Another run: what is known of the one before doesn't count any more. */
  begin(planner: string, scene: Scene): void {
    this.drop()
    for (const hand of this.busy.keys()) hand.dismiss()
    this.busy.clear()
    this.jobs.clear()
    this.found.clear()
    if (planner !== this.planner) this.dismiss()
    this.planner = planner
    this.scene = scene
  }

  /** What the jobs find, in their order, whoever was first; null if they were dropped or cannot be carried out. */
  carryOut(jobs: readonly Job[], tell: (done: number) => void): Promise<Finding[] | null> {
    this.drop()
    clearTimeout(this.leaving)
    if (this.found.size > KEPT) this.found.clear()
    const keys = jobs.map(keyOf)
    keys.forEach((key, index) => {
      const job = jobs[index]
      if (job) this.jobs.set(key, job)
    })
    const taken = new Set(this.busy.values())
    const waiting = [...new Set(keys)].filter((key) => !this.found.has(key) && !taken.has(key))
    return new Promise((end) => {
      this.round = { keys, waiting, tell, end }
      this.staff(waiting.length)
      this.goOn()
    })
  }

  /** Nobody waits for the round any more. Runs that are going on come to their end, in case they are asked for again. */
  drop(): void {
    this.end(null)
  }

  private end(found: Finding[] | null): void {
    const { round } = this
    if (!round) return
    this.round = undefined
    this.leaving = setTimeout(() => this.dismiss(), PATIENCE)
    round.end(found)
  }

  private dismiss(): void {
    clearTimeout(this.leaving)
    for (const hand of [...this.idle, ...this.busy.keys()]) hand.dismiss()
    this.idle = []
    this.busy.clear()
  }

  private staff(work: number): void {
    try {
      while (this.idle.length < work && this.idle.length + this.busy.size < this.size) this.idle.push(this.hire())
    } catch {
      // Threads that can't start threads: whoever is there does it.
    }
    if (this.idle.length + this.busy.size === 0) this.idle.push(this.oneself)
  }

  /** Hands out what waits, and ends the round when all of it has been found. */
  private goOn(): void {
    const { round } = this
    if (!round) return
    while (this.idle.length > 0 && round.waiting.length > 0) {
      const [hand, key] = [this.idle.pop(), round.waiting.shift()]
      if (hand && key !== undefined) void this.work(hand, key)
    }
    const found = round.keys.flatMap((key) => this.found.get(key) ?? [])
    if (found.length === round.keys.length) this.end(found)
    else round.tell(found.length)
  }

  private async work(hand: Hand, key: string): Promise<void> {
    const job = this.jobs.get(key)
    if (!job || !this.scene) return
    this.busy.set(hand, key)
    const found = await hand.carryOut({ ...job, scene: this.scene }).catch(() => null)
    // It was dismissed meanwhile.
    if (this.busy.get(hand) !== key) return
    this.busy.delete(hand)
    if (found) {
      this.found.set(key, found)
      this.idle.push(hand)
    } else {
      this.fail(hand, key)
    }
    this.goOn()
  }

  /** Another hand takes up what one has failed at; when nobody is left, whoever asked has to do it. */
  private fail(hand: Hand, key: string): void {
    hand.dismiss()
    if (hand === this.oneself) {
      this.end(null)
      return
    }
    if (this.round?.keys.includes(key)) this.round.waiting.unshift(key)
    if (this.idle.length + this.busy.size === 0) this.idle.push(this.oneself)
  }
}
