import type { Progress, Report } from '../engine/protocol'
import { Requests } from '../engine/requests'
import { RunClient } from '../engine/run-client'
import { Awaited } from './awaited.svelte'
import { catalogueIn, withOwn } from './catalogue'
import { ColumnStore } from './column.svelte'
import type { Standard } from '../catalogue/standard'
import { language, type Tag } from '../locales/language.svelte'
import { common } from '../locales/en/common'
import { ExperimentsStore } from './experiments.svelte'
import { Followers } from './followers.svelte'
import { FollowStore } from './follow'
import { LayersStore } from './layers.svelte'
import { NoticesStore } from './notices.svelte'
import { ParametersStore } from './parameters.svelte'
import { PictureStore } from './picture.svelte'
import { PlaybackStore } from './playback.svelte'
import { PresentationStore } from './presentation.svelte'
import { questionsTo, worded } from './questions'
import { RunStore } from './run.svelte'
import { SceneStore } from './scene.svelte'
import { SelectionStore } from './selection.svelte'
import { SetupStore } from './setup.svelte'
import { OwnStore } from './own.svelte'
import { Starts } from './starts'
import type { Subject } from './subjects'
import { stillness, type Theme } from './theme.svelte'

export type Phase = 'loading' | 'ready' | 'crashed'

/** Where a lab's run has its address. */
export interface Address {
  /** The link that it begins with. */
  readonly first: string | null
  /** A run without a link is watched from its beginning. */
  readonly watched: boolean
  /** The newest link of the run: at once where it stays, seldom while it plays. */
  write(link: string, when: 'now' | 'soon'): void
}

/** One run and all that is known and wanted of it: stores of one subject each, and what connects them. */
export class Lab {
  phase = $state<Phase>('loading')
  crash = $state('')
  /** A random map is being made. */
  making = $state(false)
  /** A function is being written. */
  writing = $state(false)
  /** The thread is there. */
  private opened = false
  /** All is in the language of the page, or on its way. */
  private worded = false
  /** The language of the catalogue. */
  private catalogued: Tag = 'en'

  private readonly client = new RunClient({
    onopen: () => this.receiveOpen(),
    onreport: (report) => this.receive(report),
    onpicture: (picture) => this.picture.pass(picture),
    onaccepted: (version) => this.parameters.take(version),
    onrefused: (refusal, version) => {
      this.completeWords()
      this.starts.refuse(worded(refusal), version)
    },
    onprogress: (progress) => this.receiveProgress(progress),
    onbroken: (message) => this.breakDown(message),
    onreplaced: (slowed) => this.replaced(slowed),
    onstuck: () => (this.notices.text = common.notices.stopped),
  })
  /** What runs, or is to run, is code without an interpreter around it. */
  get atFullSpeed(): boolean {
    return this.client.desired.start?.setup.full ?? false
  }
  /** For questions to the run. */
  readonly api = questionsTo(this.client, (link) => this.own.codeFor(link))
  private readonly requests = new Requests<Subject>()
  private readonly awaited = new Awaited()
  readonly notices = new NoticesStore()
  readonly column = new ColumnStore()
  readonly presentation = new PresentationStore()
  readonly followers = new Followers()
  readonly selection = new SelectionStore(this.client, this.api, this.requests)
  readonly parameters = new ParametersStore(() => this.starts.again())
  readonly scene = new SceneStore(this.selection, this.requests, (continued) => this.starts.again(continued ? 'on' : 'here'))
  readonly setup = new SetupStore(this.scene, this.parameters, this.notices, this.awaited, this.requests, this.api, {
    again: (where, since) => this.starts.again(where, since),
    restart: (opening) => this.starts.begin(opening),
  })
  /** Planners that somebody wrote. */
  readonly own: OwnStore = new OwnStore(this.api, this.setup)
  readonly run = new RunStore(
    this.client,
    this.scene,
    this.setup,
    this.notices,
    async () => void this.starts.restart(this.playback.requested),
  )
  readonly playback = new PlaybackStore(this.client, this.requests, this.awaited, this.run, this.followers)
  readonly following = new FollowStore(this.followers, this.playback, this.selection, this.api)
  readonly layers = new LayersStore(this.scene, this.setup, this.parameters, this.run)
  readonly picture = new PictureStore(this.client, this.layers)

  readonly experiments = new ExperimentsStore(
    () => this.run,
    () => this.playback,
  )

  private readonly starts: Starts = new Starts(this, this.client, this.requests, this.awaited)
  readonly openLink = this.starts.openLink
  readonly openMoment = this.starts.openMoment
  readonly undo = (): void => this.starts.travel('undo')
  readonly redo = (): void => this.starts.travel('redo')

  /** There is a path of this very scene to follow. */
  readonly followable = $derived.by(
    () => this.run.outcome?.length != null && !this.playback.stale && !this.run.failed && this.playback.target === null,
  )
  readonly drivable = $derived.by(() => this.scene.hasRobot && this.followable)

  constructor(
    private readonly address: Address,
    readonly theme: Theme,
    /** What is shown where nothing else is asked for. */
    private readonly standard: Standard,
  ) {}

  /** Starts a thread. It begins with the run of a link; after a crash, with what the user had made. */
  async open(): Promise<void> {
    this.crash = ''
    this.phase = 'loading'
    language.listeners.add(this.translate)
    void this.client.open()
    if (!this.setup.catalogue) {
      try {
        await this.catalogue(language.isComplete ? language.tag : 'en')
      } catch (error) {
        this.breakDown(error instanceof Error ? error.message : String(error))
        return
      }
      if (this.opened) this.phase = 'ready'
      this.setup.begin(this.standard)
    }
    // Nothing was wanted before it broke down.
    if (!this.client.desired.start) await this.openFirst()
  }

  /** What the first picture does not wait for: the language of the page, except what its first view says. */
  private completeWords(): void {
    if (this.worded) return
    this.worded = true
    void language.complete().catch((error: unknown) => console.warn(error))
    if (this.catalogued !== language.tag) this.translate()
  }

  /** The catalogue in the language of the page. Where its words cannot be loaded it stays as it is. */
  private readonly translate = (): void => {
    this.catalogue(language.tag).catch((error: unknown) => console.warn(error))
  }

  private async catalogue(tag: Tag): Promise<void> {
    const { catalogue, titles } = await catalogueIn(tag)
    // Another language may be wanted by now.
    if (this.setup.catalogue && tag !== language.tag) return
    this.setup.catalogue = withOwn(catalogue, this.setup.catalogue)
    language.titles = titles
    this.catalogued = tag
  }

  /** An offered code does not run. There is always a run to look at. */
  leaveOffer = (): void => {
    this.own.offer = null
    if (!this.client.desired.start) this.startStandard()
  }

  /** Ends it: nothing is computed any more. */
  close(): void {
    language.listeners.delete(this.translate)
    this.followers.stop()
    this.client.close()
  }

  /** The run of the address, or the one that is shown where nothing else is asked for. */
  private async openFirst(): Promise<void> {
    const { first } = this.address
    const opened = first !== null && (await this.starts.openLink(first))
    if (!opened) this.startStandard()
  }

  private startStandard(): void {
    this.starts.restart({ at: 0, play: this.address.watched && !stillness.matches })
  }

  // What the thread says

  private receiveOpen(): void {
    this.opened = true
    if (this.setup.catalogue) this.phase = 'ready'
  }

  private breakDown(message: string): void {
    this.completeWords()
    this.crash = message
    this.leaveThread('crashed')
    this.parameters.forget()
    this.playback.forget()
  }

  private replaced(slowed: boolean): void {
    if (slowed) {
      this.own.disableFullSpeed()
      this.notices.text = common.notices.slowed
    }
    this.leaveThread('loading')
  }

  /** Another thread goes on with what is wanted, at once or when the user says so. */
  private leaveThread(phase: 'crashed' | 'loading'): void {
    this.phase = phase
    this.opened = false
    this.followers.stop()
    this.playback.underway = null
    this.playback.showHeading()
  }

  private receive(report: Report): void {
    const { client, picture, playback, run } = this
    run.report = report
    picture.pass(report)
    this.completeWords()
    if (report.run) {
      run.begin(report.run)
      this.parameters.take(report.run.generation)
      const { start } = client.desired
      if (start) void run.suggested.ask(this.api, start.setup, report.run.scene.kind)
    }
    run.receive(report)
    this.selection.receive(report)
    playback.showReport(report)
    if (playback.restarting || !client.follows(report)) return
    // What stands in the address and is being read, or could not be loaded, is not the run's that is still shown.
    if (report.link !== null && this.starts.opening === 0 && !this.notices.unloaded)
      this.address.write(report.link, report.hash === null ? 'soon' : 'now')
    if (report.hash === null) return
    playback.underway = null
    this.followers.heed(report)
    this.starts.compare(report)
  }

  private receiveProgress(progress: Progress | null): void {
    const { playback } = this
    playback.underway = progress?.generation === this.run.present?.generation ? progress : null
    // Pictures may be ahead of reports.
    if (playback.underway) playback.iteration = playback.underway.step - 1
  }
}
