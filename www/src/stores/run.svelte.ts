import type { Outcome, Planner, Status } from 'forage-lab'
import { missing } from '../catalogue/stages'
import type { Refusal, Report, Run } from '../engine/protocol'
import type { RunClient } from '../engine/run-client'
import { common } from '../locales/en/common'
import { Course } from './history.svelte'
import type { NoticesStore } from './notices.svelte'
import type { SceneStore } from './scene.svelte'
import type { SetupStore } from './setup.svelte'
import { Suggested } from './suggested.svelte'

/** Which optimum results are measured by. Only in a grid and of tours there is more than one. */
export type Reference = 'plain' | Outcome['exact_by']

/** The run that is there, and what was reported of it. */
export class RunStore {
  present = $state.raw<Run | null>(null)
  /** The newest report; its frame is the renderer's. */
  report = $state.raw<Report | null>(null)
  computed = $state(0)
  status = $state<Status>('running')
  readings = $state.raw<Record<string, number>>({})
  outcome = $state.raw<Outcome | null>(null)
  /** The members' numbers, row by row, while somebody asks for them. */
  members = $state.raw<Float64Array | null>(null)
  /** The link of this run promised this hash at this iteration, and it came out. */
  verified = $state.raw<{ iteration: number; hash: string } | null>(null)
  readonly course = new Course()
  readonly suggested = new Suggested()

  /** Why the newest run did not start. */
  refusal = $state.raw<Refusal | null>(null)
  /** The newest run did not start: what runs is the run of before. */
  readonly failed = $derived.by(() => this.refusal !== null || this.notices.unloaded?.ask === this.startAgain)
  /** The planner that drew the frame: another one may have been chosen. */
  readonly drawer = $derived.by<Planner | undefined>(() => this.setup.catalogue?.planners.find(({ name }) => name === this.report?.planner))

  private readonly span = $derived(this.course.of(this.present))
  /** The iteration at which the run ends, or, while that is open, at which it ends at the latest. */
  readonly limit = $derived(this.span.end ?? this.present?.limit ?? 0)
  /** How many iterations the timeline shows. */
  readonly extent = $derived(this.span.extent)
  /** Where the run ends is not known yet. */
  readonly openEnded = $derived(this.span.end === null)
  readonly stages = $derived(this.span.stages)
  readonly finished = $derived(this.status !== 'running')
  readonly reference = $derived.by<Reference>(() =>
    (this.scene.grid || this.setup.touring) && this.outcome ? this.outcome.exact_by : 'plain',
  )
  /** The optimum that results are measured by, in words. */
  readonly optimum = $derived.by(() =>
    this.scene.arm ? common.result.tip : common.result[this.setup.planner?.stops ? 'tours' : 'optimum'][this.reference],
  )
  /** What is done before there can be a result: how many of the roads between the stops stand. */
  readonly building = $derived.by(() => missing(this.setup.planner, this.scene.grid, this.readings, this.outcome, this.finished))
  /** How often those want the members' numbers who read them. */
  private intervals: readonly { every: number }[] = []

  /** `startAgain`: what is offered where a part was missing for the start. */
  constructor(
    private readonly client: RunClient,
    private readonly scene: SceneStore,
    private readonly setup: SetupStore,
    private readonly notices: NoticesStore,
    private readonly startAgain: () => Promise<void>,
  ) {}

  /** The run that was wanted is there. */
  begin(run: Run): void {
    this.present = run
    this.refusal = null
    if (this.notices.unloaded?.ask === this.startAgain) this.notices.unloaded = null
  }

  receive(report: Report): void {
    this.course.receive(report)
    this.computed = report.furthest.iteration
    this.status = report.status
    this.readings = report.readings
    if (report.members || report.run) this.members = report.members
    if (report.outcome) this.outcome = report.outcome
  }

  /** The newest run is refused. A part that could not be loaded can be asked for once more. */
  refuse(refusal: Refusal): void {
    this.refusal = refusal.unloaded ? null : refusal
    if (refusal.unloaded) this.notices.warn(refusal, refusal.message, this.startAgain)
  }

  /** Reports bring the members' numbers, at most each `every` milliseconds, until the returned function is called. */
  readMembers = (every: number): (() => void) => {
    const reader = { every }
    this.setReaders([...this.intervals, reader])
    return () => this.setReaders(this.intervals.filter((other) => other !== reader))
  }

  private setReaders(readers: readonly { every: number }[]): void {
    this.intervals = readers
    this.client.want({ members: readers.length > 0 ? Math.min(...readers.map(({ every }) => every)) : null })
  }
}
