import type { Catalogue, Planner } from 'forage-lab'
import { isOwn, type OwnPlanner, ownPlanner, withPlanner } from '../catalogue/own'
import type { Questions } from '../engine/host/questions'
import type { Answer } from '../engine/protocol'
import { isShortened, restored } from './large-links'
import { recall } from './storage'

/** A code that somebody else brings, by a link or a file: nothing of it runs before the user has seen it. */
export interface Offer {
  code: string
  /** The link of a run, or the name of a file. */
  link: string | null
  file: string | null
}

/** Where the browser keeps what is in the editor. */
export const DRAFT = 'workshop'

const CODE = '&page.code='

/** A link brings the code of its planner. */
export const carriesCode = (link: string): boolean => link.includes(CODE)

/** Codes of planners, as addresses of several have them. */
export const packedOf = (planners: readonly Planner[]): string[] =>
  planners.flatMap((planner) => (isOwn(planner) && planner.packed !== null ? planner.packed.slice(CODE.length) : []))

/** What an author says of a code: the comment that it begins with. */
export function noteOf(code: string): string {
  const [comment = ''] = /^\s*(?:\/\/[^\n]*(?:\n|$)\s*|\/\*[\s\S]*?\*\/\s*)+/.exec(code) ?? []
  return comment
    .split('\n')
    .map((line) => line.replace(/^\s*(?:\/\/+|\/\*+|\*+\/|\*+)\s?/, '').replace(/\s*\*+\/\s*$/, ''))
    .join('\n')
    .trim()
}

/** Planners that somebody wrote: in the catalogue as soon as their code was read. */
export class OwnStore {
  /** By their codes. */
  private readonly planners = new Map<string, OwnPlanner>()
  /** Codes that came from elsewhere. */
  private readonly foreign = new Set<string>()
  /** What the user writes runs without an interpreter. */
  full = $state(false)
  /** Codes that may run: the user has seen them. */
  private readonly seen = new Set<string>()
  offer = $state.raw<Offer | null>(null)
  /** It is in the editor, and has not run yet. */
  pending: Offer | null = null

  constructor(
    private readonly api: Questions,
    private readonly setup: { catalogue: Catalogue | null },
  ) {}

  /** Reads a code in the run's thread: its planner is in the catalogue then, in the place of another one of its name. `full`: it runs without an interpreter. */
  async read(code: string, full = false): Promise<Answer<OwnPlanner>> {
    this.seen.add(code)
    const known = this.planners.get(code)
    if (known) {
      known.full = full
      this.put(known)
      return { ok: true, value: known }
    }
    const answer = await this.api.read(code)
    const { catalogue } = this.setup
    if (!answer.ok) return answer
    if (!catalogue) return { ok: false, refusal: { message: 'there is no catalogue', field: '' } }
    const { planner: described, packed } = answer.value
    const planner = ownPlanner(catalogue, described, { code, packed, full })
    this.planners.set(code, planner)
    this.put(planner)
    return { ok: true, value: planner }
  }

  private put(planner: OwnPlanner): void {
    const { catalogue } = this.setup
    if (catalogue && !catalogue.planners.includes(planner)) this.setup.catalogue = withPlanner(catalogue, planner)
  }

  isForeign = (code: string): boolean => this.foreign.has(code)

  /** From now on all runs in an interpreter. */
  disableFullSpeed(): void {
    this.full = false
    for (const planner of this.planners.values()) planner.full = false
  }

  /** The planner of a code that was read before is the one of its name again. */
  take(code: string | undefined): void {
    const known = code === undefined ? undefined : this.planners.get(code)
    if (known) this.put(known)
  }

  /** The code of the planner that a link names, if it is one that was read here. */
  codeFor = (link: string): string | undefined => {
    const name = /[#&]planner=([^&]*)/.exec(link)?.[1]
    const planner = this.setup.catalogue?.planners.find((one) => one.name === name)
    return isOwn(planner) ? planner.code : undefined
  }

  /** Whether a link's run may begin. A code that the user has not seen is offered first. */
  async admits(link: string): Promise<Answer<boolean>> {
    return this.admit(isShortened(link) ? await restored(link) : link, link)
  }

  /** The same of an address with several codes, as links have them. */
  async admitAll(packed: readonly string[], link: string): Promise<Answer<boolean>> {
    for (const one of packed) {
      const admitted = await this.admit(`#${CODE}${one}`, link)
      if (!admitted.ok || !admitted.value) return admitted
    }
    return { ok: true, value: true }
  }

  /** The code in `carrier`, which came with a link. */
  private async admit(carrier: string, link: string): Promise<Answer<boolean>> {
    const answer = await this.api.codeIn(carrier)
    if (!answer.ok) return answer
    const code = answer.value
    if (code === null) return { ok: true, value: true }
    if (!this.seen.has(code) && code !== recall(DRAFT)) {
      this.offer = { code, link, file: null }
      return { ok: true, value: false }
    }
    const read = await this.read(code)
    return read.ok ? { ok: true, value: true } : read
  }

  /** The offered code may run from now on. */
  accept({ code }: Offer): void {
    this.seen.add(code)
    this.foreign.add(code)
    this.offer = null
  }

  /** It is looked at where it can be changed. */
  edit(offer: Offer): void {
    this.foreign.add(offer.code)
    this.pending = offer
    this.offer = null
  }
}
