import type { RunState } from './embed.js'

/**
 * `<forage-run>`: a run on a page. It begins when it comes into view, and pauses while it is out of sight. To import the script
 * defines it.
 *
 * Attributes: `src` (a link of a run), or `planner`, `scene`, `seed`, `params` (`w=0.7; c1=2`) and `at`; `layers`
 * (`best,-particles`); `controls` (`none`, `play`, `full`), `theme` (`light`, `dark`, `system`), `autoplay`.
 *
 * Events: `ready`, `step` and `end` have a `RunState` as their `detail`, `error` has `{ message }`.
 */
export interface ForageRun extends HTMLElement {
  /** Where the run is; undefined before it has come into view. */
  readonly state: RunState | undefined
  play(): void
  pause(): void
  /** Steps so many iterations on, or back. */
  step(by?: number): void
  /** Goes to an iteration; `Infinity`: to the end. */
  seek(to: number): void
}

declare global {
  interface HTMLElementTagNameMap {
    'forage-run': ForageRun
  }
}
