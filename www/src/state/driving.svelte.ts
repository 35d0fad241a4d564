import type { ParameterValue } from 'forage'
import { panels } from '../i18n/panels.en'
import type { Answer, Driven } from '../worker/protocol'
import { stillness } from './theme.svelte'
import { Track } from './track'

export const PACES = [1, 4, 16] as const
export type Pace = (typeof PACES)[number]

/** Where motion is unwelcome, the picture changes this often, in milliseconds. */
const JUMP = 1000

type Ask = (params: Record<string, ParameterValue>) => Promise<Answer<Driven>>

/** The robot on its way along the present result: the drive that was computed, and the moment that is shown. */
export class Driving {
  params = $state.raw<Record<string, ParameterValue>>({})
  errors = $state.raw<Record<string, string>>({})
  /** Why there is no drive, where no parameter is to blame. */
  problem = $state('')
  track = $state.raw<Track | null>(null)
  /** Seconds since it set off. */
  time = $state(0)
  playing = $state(false)
  pace = $state<Pace>(4)
  /** The state of the run that it belongs to. */
  of = { generation: -1, iteration: -1 }
  private request = 0
  private asked = 0

  constructor(private readonly ask: Ask) {}

  get end(): number {
    return this.track?.end ?? 0
  }

  /** Computes the drive and sets off. */
  async begin(): Promise<void> {
    if (!(await this.renew(this.params))) return
    this.time = 0
    if (!stillness.matches) this.play()
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
    const answer = await this.ask(params)
    if (turn !== this.asked) return false
    if (!answer.ok) {
      const { field, message } = answer.refusal
      if (field === name && name) this.errors = { ...this.errors, [name]: message }
      else this.problem = message
      return false
    }
    const { drive, generation, iteration } = answer.value
    this.errors = {}
    this.problem = drive ? '' : panels.drive.nothing
    this.of = { generation, iteration }
    this.track = drive && new Track(drive)
    this.time = Math.min(this.time, this.end)
    return drive !== null
  }

  toggle = (): void => (this.playing ? this.pause() : this.play())

  play = (): void => {
    if (!this.track) return
    if (this.time >= this.end) this.time = 0
    this.playing = true
    cancelAnimationFrame(this.request)
    let last = performance.now()
    const tick = (now: number): void => {
      if (!this.playing) return
      if (!stillness.matches || now - last >= JUMP) {
        this.time = Math.min(this.end, this.time + (Math.max(0, now - last) / 1000) * this.pace)
        last = now
      }
      if (this.time >= this.end) this.playing = false
      else this.request = requestAnimationFrame(tick)
    }
    this.request = requestAnimationFrame(tick)
  }

  pause = (): void => {
    this.playing = false
    cancelAnimationFrame(this.request)
  }

  seek = (time: number): void => {
    this.pause()
    this.time = Math.min(Math.max(time, 0), this.end)
  }

  /** The picture goes back to the run; whatever is still asked for comes too late. */
  leave(): void {
    this.pause()
    this.asked += 1
    this.track = null
    this.problem = ''
    this.errors = {}
    this.time = 0
  }
}
