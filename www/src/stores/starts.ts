import type { LinkSetup } from 'forage-lab'
import type { OwnPlanner } from '../catalogue/own'
import type { Questions } from '../engine/host/questions'
import type { Opening, Refusal, Report } from '../engine/protocol'
import type { Requests } from '../engine/requests'
import type { RunClient } from '../engine/run-client'
import { common } from '../locales/en/common'
import type { Again } from './again'
import type { Awaited } from './awaited.svelte'
import type { Followers } from './followers.svelte'
import type { LayersStore } from './layers.svelte'
import type { NoticesStore } from './notices.svelte'
import { isShortened, restored } from './large-links'
import type { ColumnStore } from './column.svelte'
import type { ExperimentsStore } from './experiments.svelte'
import { type PageKeys, readPageKeys } from './page-keys'
import { carriesCode, type OwnStore } from './own.svelte'
import type { ParametersStore } from './parameters.svelte'
import type { PictureStore } from './picture.svelte'
import type { PlaybackStore } from './playback.svelte'
import type { RunStore } from './run.svelte'
import type { SceneStore } from './scene.svelte'
import type { SelectionStore } from './selection.svelte'
import type { SetupStore } from './setup.svelte'
import type { Subject } from './subjects'
import { stillness } from './theme.svelte'

/** What a start is made of and what it changes. */
interface Stores {
  readonly api: Questions
  readonly column: ColumnStore
  readonly experiments: ExperimentsStore
  readonly followers: Followers
  readonly layers: LayersStore
  readonly notices: NoticesStore
  readonly own: OwnStore
  readonly parameters: ParametersStore
  readonly picture: PictureStore
  readonly playback: PlaybackStore
  readonly run: RunStore
  readonly scene: SceneStore
  readonly selection: SelectionStore
  readonly setup: SetupStore
}

/** How runs begin: from links, after changes, and after one that was refused. */
export class Starts {
  /** The fingerprint that an opened link promises, and where. */
  private promised: { hash: string; at: number } | undefined
  /** So many links are being read. */
  opening = 0

  constructor(
    private readonly stores: Stores,
    private readonly client: RunClient,
    private readonly requests: Requests<Subject>,
    private readonly awaited: Awaited,
  ) {}

  openLink = async (link: string): Promise<boolean> => {
    const request = this.requests.note('setup', 'seed')
    let opened = true
    let planner: OwnPlanner | null = null
    this.opening += 1
    const read = this.awaited.add(
      async () => {
        const brought = carriesCode(link) ? await (await import('./own-code')).readLink(this.stores.own, link) : null
        if (brought?.ok === false) return brought
        if (brought?.value.offer) return brought.value.offer
        planner = brought?.value.planner ?? null
        return this.stores.api.parseLink(isShortened(link) ? await restored(link) : link, planner?.code)
      },
      (answer) => {
        // A code is to be seen first.
        if ('code' in answer) {
          if (!this.requests.replaced(request, 'setup')) this.stores.own.bring(answer)
          return
        }
        opened = answer.ok
        if (!answer.ok) this.stores.notices.warn(answer.refusal, common.notices.link(answer.refusal.message), () => this.openLink(link))
        else if (!this.requests.replaced(request, 'setup')) {
          if (planner) this.stores.own.put(planner)
          this.openSetup(answer.value, request)
          this.applyPageKeys(readPageKeys(link))
        }
      },
    )
    await read.finally(() => (this.opening -= 1))
    return opened
  }

  /** Opens a run where it is wanted to be. */
  openMoment = (setup: LinkSetup): void => this.openSetup(setup, this.requests.note('setup', 'seed'))

  private openSetup(setup: LinkSetup, request: number): void {
    const { iteration, hash } = setup
    this.stores.experiments.leave({ compares: false })
    this.stores.setup.take(setup)
    this.promised = hash === undefined ? undefined : { hash, at: iteration }
    this.restart({ at: iteration, play: false }, request)
  }

  private applyPageKeys({ item, camera, layers, tab, marks }: PageKeys): void {
    this.stores.playback.bookmarks.open(marks)
    if (tab) this.stores.column.show(tab)
    this.stores.layers.chosen = { ...this.stores.layers.chosen, ...layers }
    this.stores.picture.wantedCamera = camera
    if (item && this.stores.setup.planner?.layers.some(({ role, pickable }) => role === item.role && pickable))
      this.stores.selection.inspect(item)
  }

  /** Starts a new run; the number of that change, or 0 if there is no scene yet. */
  restart(opening: Opening, since?: number): number {
    this.stores.followers.stop()
    this.stores.run.verified = null
    const { present } = this.stores.scene
    if (!present) return 0
    const setup = this.stores.setup.wanted(present)
    this.stores.experiments.want(setup)
    return this.stores.playback.start(setup, this.stores.parameters.checks, opening, since)
  }

  begin(opening: Opening): number {
    this.stores.experiments.leave({ compares: false })
    this.promised = undefined
    return this.restart(opening)
  }

  again(where: Again = 'here', since?: number): number {
    this.promised = undefined
    const { experiments, playback, run } = this.stores
    const scene = this.stores.scene.present
    const mends = where === 'code' && (playback.restarting || run.refusal !== null || run.status === 'failed')
    if (where !== 'on' && where !== 'words') experiments.leave({ compares: true, mends })
    // An edit that leaves the planner too little is refused, and undone: nothing takes its place.
    if (scene && (scene.kind !== run.present?.scene.kind || scene.name !== run.present.scene.name)) this.stores.setup.suit(scene)
    if (where === 'on' || (where !== 'begin' && playback.restarting)) return this.restart(playback.requested, since)
    // It failed on its way to there, or after that.
    const { at, play } = playback.requested
    if (mends) return this.restart({ at: Math.max(at, playback.iteration), play }, since)
    if (where !== 'begin' && run.present) return this.restart({ at: playback.target ?? playback.iteration, play: playback.playing }, since)
    return this.restart({ at: 0, play: playback.playing || !run.present || (run.finished && !stillness.matches) }, since)
  }

  /** Back to another experiment, where it stood. */
  travel(by: 'undo' | 'redo'): void {
    const found = this.stores.experiments.travel(by)
    if (!found || typeof found.setup.scene !== 'object') return
    const { planner, code, params = {}, seed = 0, scene } = found.setup
    this.stores.own.take(code)
    this.stores.setup.take({ planner, scene, params: params as LinkSetup['params'], seed } as LinkSetup)
    this.promised = undefined
    this.restart({ at: found.iteration, play: false })
  }

  /** The run that change number `version` wanted is refused. */
  refuse(refusal: Refusal, version: number): void {
    const { parameters, playback, run, setup } = this.stores
    playback.showHeading()
    if (refusal.unloaded || !setup.planner?.parameters.some(({ name }) => name === refusal.field)) {
      run.refuse(refusal)
      return
    }
    // What else was wanted with a value that is taken back is still wanted.
    const back = parameters.refuse(refusal, version)
    const { present } = this.stores.scene
    if (back && present) this.stores.experiments.want(setup.wanted(present))
    if (back && !this.client.starting && setup.differsFrom(this.client.desired.start?.setup)) this.restart(playback.requested)
  }

  /** Whether the run of a link is the one that the link promises. */
  compare({ iteration, hash }: Report): void {
    if (this.promised?.at !== iteration) return
    const { hash: promised } = this.promised
    if (promised === hash) this.stores.run.verified = { iteration, hash }
    else this.stores.notices.text = common.notices.hash(String(iteration), promised, hash ?? '')
    this.promised = undefined
  }
}
