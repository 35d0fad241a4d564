import type { carryOut, Finding, Job, Scene } from 'forage-lab'

/** A job with the scene that it belongs to. */
export type Errand = Parameters<typeof carryOut>[0]

/** Somebody who carries runs out, one at a time. */
export interface Hand {
  carryOut(errand: Errand): Promise<Finding>
  dismiss(): void
}

/** A run that needs others. */
export interface Task {
  planner: string
  scene: Scene
}

/** A job in somebody's hands. */
interface Turn {
  key: string
}

interface Round {
  keys: string[]
  jobs: ReadonlyMap<string, Job>
  /** Jobs that nobody has taken up. */
  waiting: string[]
  /** Jobs of which nothing is known yet. */
  missing: Set<string>
  tell(done: number): void
  /** With nothing if the round was dropped or cannot be carried out. */
  end(found: Finding[] | null): void
}

/** Hands without work leave after so many milliseconds. */
const PATIENCE = 30_000
/** Findings that are kept, so that a run can go back and forth without carrying its jobs out again. */
const KEPT = 5_000

const keyOf = ({ planner, params, seed, ends }: Job): string => JSON.stringify([planner, params, seed, ends])

/** Carries out the runs that a planner of planners needs, side by side. What they find doesn't depend on who they are. */
export class Crew {
  private task: Task | undefined
  private scene = ''
  private readonly found = new Map<string, Finding>()
  private readonly busy = new Map<Hand, Turn>()
  private idle: Hand[] = []
  private round: Round | undefined
  private leaving: ReturnType<typeof setTimeout> | undefined

  constructor(
    private size: number,
    /** Somebody from another thread; throws where there can be none. */
    private readonly hire: () => Hand,
    /** Takes the place of all others when they fail. */
    private readonly oneself: Hand,
  ) {}

  /** Another run. On the same scene what was found still counts: other planners may ask for the same roads. */
  begin(task: Task): void {
    if (task === this.task) return
    this.drop()
    const scene = JSON.stringify(task.scene)
    if (scene !== this.scene) {
      for (const hand of this.busy.keys()) hand.dismiss()
      this.busy.clear()
      this.found.clear()
      this.scene = scene
    }
    if (task.planner !== this.task?.planner) this.dismiss()
    this.task = task
  }

  /** What the jobs find, in their order, whoever was first; null if they were dropped or cannot be carried out. */
  carryOut(task: Task, jobs: readonly Job[], tell: (done: number) => void): Promise<Finding[] | null> {
    this.begin(task)
    this.drop()
    clearTimeout(this.leaving)
    if (this.found.size > KEPT) this.found.clear()
    const keys = jobs.map(keyOf)
    const known = new Map(jobs.map((job, index) => [keys[index] ?? '', job]))
    const missing = new Set(keys.filter((key) => !this.found.has(key)))
    const taken = new Set([...this.busy.values()].map(({ key }) => key))
    const waiting = [...missing].filter((key) => !taken.has(key))
    return new Promise((end) => {
      this.round = { keys, jobs: known, waiting, missing, tell, end }
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
      const hand = this.idle.pop()
      const job = round.jobs.get(round.waiting.shift() ?? '')
      if (hand && job) void this.work(hand, job)
    }
    if (round.missing.size === 0) this.end(round.keys.flatMap((key) => this.found.get(key) ?? []))
    else round.tell(round.keys.length - round.missing.size)
  }

  private async work(hand: Hand, job: Job): Promise<void> {
    if (!this.task) return
    const turn = { key: keyOf(job) }
    this.busy.set(hand, turn)
    const found = await hand.carryOut({ ...job, scene: this.task.scene }).catch(() => null)
    // It was dismissed meanwhile.
    if (this.busy.get(hand) !== turn) return
    this.busy.delete(hand)
    if (found) {
      this.found.set(turn.key, found)
      this.round?.missing.delete(turn.key)
      this.idle.push(hand)
    } else {
      this.fail(hand, turn)
    }
    this.goOn()
  }

  /** Another hand takes up what one has failed at; when nobody is left, whoever asked has to do it. */
  private fail(hand: Hand, { key }: Turn): void {
    hand.dismiss()
    if (hand === this.oneself) {
      this.end(null)
      return
    }
    this.size -= 1
    if (this.round?.missing.has(key)) this.round.waiting.unshift(key)
    if (this.idle.length + this.busy.size === 0) this.idle.push(this.oneself)
  }
}
