import type { Session } from 'forage-lab/core'
import type { ClockUnit, Furthest } from '../protocol'
import { extent } from './extent'

/** So many first steps say how much a step evaluates. */
const PROBES = 3

/** Where a run was, by its clock. */
export class Places {
  private furthest = 0
  private ended: boolean
  private most = 0
  /** Iterations in which something was evaluated, and how much there was then; by the clock of iterations only the last. */
  private readonly marks: { iteration: number; evaluations: number }[]

  constructor(
    private readonly session: Session,
    private readonly clock: ClockUnit,
  ) {
    this.marks = [{ iteration: 0, evaluations: session.evaluations }]
    this.ended = session.status !== 'running'
    if (clock === 'iterations') return
    this.most = probe(session)
    // From here on the feasible best is kept.
    session.curve()
  }

  /** The run was never farther than now. */
  get isFurthest(): boolean {
    return this.session.iteration >= this.furthest
  }

  /** A step was taken. */
  note(): void {
    const { iteration, evaluations, status } = this.session
    if (iteration <= this.furthest) return
    this.furthest = iteration
    this.ended = status !== 'running'
    const before = this.marks.at(-1)?.evaluations ?? 0
    if (evaluations === before) return
    if (this.clock === 'iterations') this.marks.length = 0
    this.marks.push({ iteration, evaluations })
    this.most = Math.max(this.most, evaluations - before)
  }

  /** The iteration of a place; null: farther than the run ever was. */
  iterationAt(place: number): number | null {
    if (this.clock === 'iterations') return place <= this.furthest ? Math.ceil(place) : this.ended ? this.furthest : null
    let [low, high] = [0, this.marks.length]
    while (low < high) {
      const middle = (low + high) >> 1
      if ((this.marks[middle]?.evaluations ?? 0) < place) low = middle + 1
      else high = middle
    }
    return this.marks[low]?.iteration ?? (this.ended ? this.furthest : null)
  }

  /** Whether the run is at a place where it never was before, or beyond it. */
  reaches(place: number): boolean {
    const { iteration, evaluations, status } = this.session
    return status !== 'running' || (this.clock === 'iterations' ? iteration : evaluations) >= place
  }

  get report(): Furthest {
    const last = this.marks.at(-1) ?? { iteration: 0, evaluations: 0 }
    return {
      iteration: this.furthest,
      evaluations: last.evaluations,
      extent: extent(this.session, this.furthest),
      most: this.most,
      ended: this.ended,
      tail: this.ended && last.iteration < this.furthest,
    }
  }
}

/** The most evaluations of one of the first steps. A step that is long or needs runs of other planners is not taken for that. */
function probe(session: Session): number {
  let most = 0
  for (let step = 0; step < PROBES && session.jobs().length === 0; step += 1) {
    const before = session.evaluations
    const partly = session.advance() === 'partly'
    most = Math.max(most, session.evaluations - before)
    if (partly) break
  }
  session.rewind(0)
  return most
}
