import type { ParameterValue } from 'forage'
import { en } from '../i18n/en'
import type { Answer, Driven } from '../worker/protocol'
import { Clock } from './clock.svelte'
import type { Track } from './track'

/** How many times as fast as the robot. */
const PACE = 4

type Ask = (params: Record<string, ParameterValue>) => Promise<Answer<Driven>>

/** The robot on its way along the present result: the drive that was computed, and the moment that is shown. */
export class Driving {
  params = $state.raw<Record<string, ParameterValue>>({})
  errors = $state.raw<Record<string, string>>({})
  /** Why there is no drive, where no parameter is to blame. */
  problem = $state('')
  track = $state.raw<Track | null>(null)
  /** Seconds since it set off. */
  readonly clock = new Clock(PACE)
  /** The state of the run that it belongs to. */
  of = { generation: -1, iteration: -1 }
  private asked = 0

  constructor(private readonly ask: Ask) {}

  /** Computes the drive and sets off. */
  async begin(): Promise<void> {
    if (await this.renew(this.params)) this.clock.begin(this.clock.end)
  }

  setParameter = async (name: string, value: ParameterValue | string): Promise<void> => {
    const params = { ...this.params, [name]: value as ParameterValue }
    if (await this.renew(params, name)) this.params = params
  }

  resetParameter = async (name?: string): Promise<void> => {
    const { [name ?? '']: _dropped, ...rest } = this.params
    const params = name === undefined ? {} : rest
    if (await this.renew(params)) this.params = params
  }

  private async renew(params: Record<string, ParameterValue>, name = ''): Promise<boolean> {
    this.asked += 1
    const turn = this.asked
    const [answer, { Track }] = await Promise.all([this.ask(params), import('./track')])
    if (turn !== this.asked) return false
    if (!answer.ok) {
      const { field, message } = answer.refusal
      if (field === name && name) this.errors = { ...this.errors, [name]: message }
      else this.problem = message
      return false
    }
    const { drive, generation, iteration } = answer.value
    this.errors = {}
    this.problem = drive ? '' : en.notices.nothing
    this.of = { generation, iteration }
    this.track = drive && new Track(drive)
    this.clock.end = this.track?.end ?? 0
    this.clock.time = Math.min(this.clock.time, this.clock.end)
    return drive !== null
  }

  /** The picture goes back to the run; whatever is still asked for comes too late. */
  leave(): void {
    this.clock.pause()
    this.asked += 1
    this.track = null
    this.problem = ''
    this.errors = {}
    this.clock.time = 0
  }
}
