import type { ParameterValue } from 'forage-lab'
import { common } from '../locales/en/common'
import type { Followed } from '../engine/host/questions'
import type { Answer } from '../engine/protocol'
import { Clock } from './clock.svelte'

type Values = Record<string, ParameterValue>

/** Rows of moments. */
export interface Timed {
  readonly end: number
}

/** What is the same whoever follows. */
export interface Follower {
  readonly track: Timed | null
  /** What differs from the defaults. */
  readonly params: Values
  readonly of: { generation: number; iteration: number }
  begin(): Promise<void>
  leave(): void
}

/** The robot, or the arm, on its way along the present result: what was computed, and the moment that is shown. */
export class Following<Result, Track extends Timed> implements Follower {
  params = $state.raw<Values>({})
  errors = $state.raw<Record<string, string>>({})
  /** Why there is nothing to show, where no parameter is to blame. */
  problem = $state('')
  track = $state.raw<Track | null>(null)
  /** Seconds since it set off. */
  readonly clock: Clock
  /** The state of the run that it belongs to. */
  of = { generation: -1, iteration: -1 }
  /** The parameters with those that are still to be answered for. */
  private wanted: Values = {}
  private asked = 0

  /** `pace`: how many times as fast as it would be. */
  constructor(
    pace: number,
    private readonly ask: (params: Values) => Promise<Answer<Followed<Result>>>,
    private readonly read: (result: Result) => Track,
  ) {
    this.clock = new Clock(pace)
  }

  /** Computes it and sets off. */
  async begin(): Promise<void> {
    if (await this.renew()) this.clock.begin(this.clock.end)
  }

  setParameter = async (name: string, value: ParameterValue | string): Promise<void> => {
    this.wanted = { ...this.wanted, [name]: value as ParameterValue }
    await this.renew()
  }

  resetParameter = async (name?: string): Promise<void> => {
    const { [name ?? '']: _dropped, ...rest } = this.wanted
    this.wanted = name === undefined ? {} : rest
    await this.renew()
  }

  /** Asks with what is wanted. `errors`: those that remain if that is fine. */
  private async renew(errors: Record<string, string> = {}): Promise<boolean> {
    this.asked += 1
    const turn = this.asked
    const params = this.wanted
    const answer = await this.ask(params)
    const result = answer.ok ? answer.value.result : null
    const track = result && this.read(result)
    if (turn !== this.asked) return false
    if (!answer.ok) {
      const { field, message } = answer.refusal
      if (!(field in params) || params[field] === this.params[field]) {
        this.problem = message
        this.wanted = this.params
        return false
      }
      // That value takes no other with it.
      const { [field]: _refused, ...others } = params
      const before = this.params[field]
      this.errors = { ...this.errors, [field]: message }
      this.wanted = before === undefined ? others : { ...others, [field]: before }
      const names = Object.keys({ ...this.wanted, ...this.params })
      const open = names.some((name) => this.wanted[name] !== this.params[name])
      return open && this.renew(this.errors)
    }
    const { generation, iteration } = answer.value
    this.errors = errors
    this.problem = track ? '' : common.notices.nothing
    this.of = { generation, iteration }
    if (track) this.params = params
    else this.wanted = this.params
    this.track = track
    this.clock.end = this.track?.end ?? 0
    this.clock.time = Math.min(this.clock.time, this.clock.end)
    return track !== null
  }

  /** The picture goes back to the run; whatever is still asked for comes too late. */
  leave(): void {
    this.clock.pause()
    this.asked += 1
    this.wanted = this.params
    this.track = null
    this.problem = ''
    this.errors = {}
    this.clock.time = 0
  }
}
