import type { RunEvent } from 'forage-lab'
import type { Report, Run, Span } from '../engine/protocol'
import { Curve } from './curve'

/** What the pictures of a run add up to: each tells only what is new. */
export class Course {
  private readonly traced = new Curve()
  /** A new object with each change; its arrays grow in place. */
  curve = $state.raw<Pick<Curve, 'columns' | 'iterations' | 'rows'>>({ columns: [], iterations: [], rows: [] })
  version = $state(0)
  /** In simulated time, and what comes after the present iteration too, once it was computed. */
  events = $state.raw<readonly RunEvent[]>([])
  /** Some runs only learn on their way where they end. */
  private span = $state.raw<(Span & { generation: number }) | null>(null)

  receive({ generation, run, trace, events, repeats, span }: Report): void {
    if (run) this.clear()
    if (this.traced.add(trace) || run) {
      const { columns, iterations, rows } = this.traced
      this.curve = { columns, iterations, rows }
      this.version += 1
    }
    // Those that come later than where the run is are as they were said.
    if (repeats) this.events = [...events, ...this.events.slice(events.length)]
    else if (events.length > 0) this.events = [...this.events, ...events]
    if (span) this.span = { ...span, generation }
  }

  clear(): void {
    this.traced.clear()
    this.events = []
    this.span = null
  }

  /** Where a run ends, and its parts, as far as is known. */
  of(run: Run | null): Span {
    return this.span && this.span.generation === run?.generation ? this.span : (run?.span ?? { end: 0, extent: 0, stages: [] })
  }
}
