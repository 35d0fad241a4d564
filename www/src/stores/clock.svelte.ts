import { stillness } from './theme.svelte'

/** Where motion is unwelcome, the picture changes this often, in milliseconds. */
const JUMP = 1000

/** A time beside that of the run: of a drive along its result, of the steps within an iteration. */
export class Clock {
  time = $state(0)
  end = $state(0)
  playing = $state(false)
  /** How much of its time passes in a second. */
  pace = $state(1)
  private request = 0

  constructor(pace: number) {
    this.pace = pace
  }

  /** From the beginning, with another end. */
  begin(end: number): void {
    this.pause()
    this.end = end
    this.time = 0
    if (!stillness.matches) this.play()
  }

  toggle = (): void => (this.playing ? this.pause() : this.play())

  play = (): void => {
    if (this.end <= 0) return
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
}
