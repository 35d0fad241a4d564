import type { Report } from '../../../engine/protocol'
import type { Lane } from './lane.svelte'
import { extent, onwards } from './ticks'

/** How long a stretch without a picture lasts at most, in milliseconds. */
const STRETCH = 60
/** After a pause of the machine it goes on from here instead of catching up. */
const LATE = 200
/** What is drawn needs its time, too. */
const LEAST = 12
/** Whoever wants to stop waits so long for those who are still on their way. */
const PATIENCE = 250

const wait = (milliseconds: number): Promise<void> => new Promise((resolve) => setTimeout(resolve, milliseconds))

/** The race's clock, in evaluations, and how the lanes are led from one of its times to another: always all together. */
export abstract class Times {
  lanes = $state.raw<readonly Lane[]>([])
  clock = $state(0)
  /** Where a seek is on its way to. */
  goal = $state<number | null>(null)
  playing = $state(false)
  starting = $state(false)
  /** Notches a second. */
  speed = $state(10)
  /** Evaluations of a notch, if they were chosen. */
  chosen = $state<number | null>(null)

  readonly racing = $derived(this.lanes.filter(({ racing }) => racing))
  /** A step is a planner's smallest move: a notch is the largest step of all, unless it was chosen. */
  readonly usual = $derived(Math.max(1, ...this.racing.map(({ run, picture }) => picture?.furthest.most ?? run?.most ?? 1)))
  readonly notch = $derived(this.chosen ?? this.usual)
  readonly begin = $derived(this.racing.length > 0 ? Math.min(...this.racing.map(({ run }) => run?.evaluations ?? 0)) : 0)
  readonly extent = $derived.by(() =>
    Math.min(
      this.most ?? Infinity,
      extent(
        this.clock,
        this.racing.map(({ end }) => end),
      ),
    ),
  )
  readonly over = $derived.by(
    () => this.racing.length > 0 && (this.clock >= (this.most ?? Infinity) || this.racing.every(({ over }) => over)),
  )
  readonly busy = $derived(this.playing || this.goal !== null || this.starting)
  /** Everything stands still, and all that there is to tell was told. */
  readonly still = $derived(!this.busy && this.racing.length > 0 && this.racing.every(({ settled }) => settled !== null))

  /** Where the clock stops; null: where all have come to their end. */
  protected abstract get most(): number | null

  private looping = false
  /** When the next picture is due. */
  private due = 0
  /** Notches that take about as long as a stretch may. */
  private stretch = 1
  /** How far the clock has come. */
  private known = 0
  /** Where they are on their way to; grows with each way. */
  private heading = 0
  private ways = 0
  /** How often all have begun. */
  started = $state(0)
  protected turns = 0

  /** To the beginning of a race that is new, and from there where the user wanted it meanwhile. */
  protected rewind(): void {
    this.known = 0
    this.stretch = 1
    this.clock = this.begin
    this.goal = Math.max(this.goal ?? this.begin, this.begin)
    void this.loop()
  }

  /** Somebody is new: while the race goes on, they catch up with the next notch. */
  protected gather(): void {
    if (!this.busy) this.goal = this.clock
    void this.loop()
  }

  toggle = (): void => (this.playing ? this.pause() : this.play())

  play = (): void => {
    // While the race starts anew, it plays from where it is to go.
    if (!this.starting) this.goal = this.over ? this.begin : null
    this.playing = true
    void this.loop()
  }

  /** All stand at the same time: at the next picture, or where it takes too long at the last. */
  pause = (): void => {
    this.stop()
    this.hurry()
  }

  protected stop(): void {
    this.playing = false
    this.goal = null
  }

  seek = (to: number): void => {
    this.playing = false
    this.goal = this.within(Math.max(to, this.begin))
    if (this.goal < this.heading) this.hurry()
    void this.loop()
  }

  /** Calls them back from a way that takes long. */
  private hurry(): void {
    const { ways } = this
    if (!this.looping) return
    setTimeout(() => {
      if (this.looping && ways === this.ways) for (const lane of this.racing) lane.halt()
    }, PATIENCE)
  }

  /** Notches on or back. */
  stepBy = (notches: number): void => {
    const from = this.goal !== null && Number.isFinite(this.goal) ? this.goal : this.clock
    if (notches < 0) this.seek(from + notches * this.notch)
    else this.seek(this.onwards(from) + (notches - 1) * this.notch)
  }

  private onwards(from: number): number {
    const runners = this.racing.flatMap(({ picture, over }) => (picture ? [{ evaluations: picture.evaluations, over }] : []))
    return Math.max(onwards(from, this.notch, runners), from)
  }

  toEnd = (): void => this.seek(Infinity)

  private async loop(): Promise<void> {
    if (this.looping) return
    this.looping = true
    this.due = performance.now()
    try {
      for (let next = this.next(); next !== null; next = this.next()) {
        const began = performance.now()
        await this.arrive(next)
        const took = Math.max(performance.now() - began, 1)
        this.stretch = Math.max(1, this.stretch * Math.min(Math.max(STRETCH / took, 0.5), 2))
        await wait(Math.max(this.playing && this.goal === null ? this.due - performance.now() : 0, LEAST))
      }
    } finally {
      this.looping = false
    }
    await Promise.all(this.racing.map((lane) => lane.settle()))
  }

  /** The time that comes next; null where it is to stand. */
  private next(): number | null {
    // What is wanted of a race that starts waits until it has.
    if (this.starting) return null
    if (this.racing.length === 0) {
      this.stop()
      return null
    }
    if (this.goal !== null) return this.towards(this.goal)
    if (this.over) this.playing = false
    return this.playing ? this.within(this.onwards(this.clock) + (this.more() - 1) * this.notch) : null
  }

  private within(clock: number): number {
    return Math.min(clock, this.most ?? clock)
  }

  /** How many notches are due. */
  private more(): number {
    const now = performance.now()
    if (!Number.isFinite(this.speed) || now - this.due > LATE) this.due = now
    if (!Number.isFinite(this.speed)) return Math.floor(this.stretch)
    const notches = 1 + Math.floor(((now - this.due) * this.speed) / 1000)
    this.due += (notches * 1000) / this.speed
    return notches
  }

  /** Where nobody was yet, there are pictures on the way to a goal. */
  private towards(goal: number): number | null {
    const placed = this.racing.every(({ picture }) => picture !== null)
    if (!placed) return Math.min(goal, this.clock)
    if (goal < this.clock) return goal
    if (goal > this.clock && !this.over) return Math.min(goal, Math.max(this.known, this.clock + Math.floor(this.stretch) * this.notch))
    this.goal = null
    return this.playing ? this.next() : null
  }

  /** All go there; they are shown together. Whoever was called back waits where the others are. */
  private async arrive(clock: number): Promise<void> {
    const { turns, racing } = this
    this.heading = clock
    const pictures = await Promise.all(racing.map((lane) => lane.go(clock)))
    this.ways += 1
    if (turns !== this.turns) {
      // Nobody shows them: their buffers go back.
      for (const [at, lane] of racing.entries()) lane.pass(pictures[at] ?? null)
      return
    }
    if (racing.some((lane, at) => pictures[at] === null && lane.halted)) {
      for (const [at, lane] of racing.entries()) lane.pass(pictures[at] ?? null)
      const back = await Promise.all(racing.map((lane) => lane.go(this.clock)))
      if (turns === this.turns) this.show(racing, back)
      else for (const [at, lane] of racing.entries()) lane.pass(back[at] ?? null)
      return
    }
    this.show(racing, pictures)
    this.known = Math.max(this.known, clock)
    // Where all have come to their end, there is no time beyond.
    this.clock = this.over ? Math.min(this.goal ?? clock, Math.max(this.begin, ...racing.map(({ end }) => end))) : clock
  }

  private show(racing: readonly Lane[], pictures: readonly (Report | null)[]): void {
    racing.forEach((lane, at) => {
      const picture = pictures[at]
      if (picture) lane.show(picture)
    })
  }
}
