import type { Catalogue } from 'forage-lab'
import { isOwn, type OwnPlanner, withPlanner } from '../catalogue/own'
import type { Questions } from '../engine/host/questions'

/** A code that somebody else brings, by a link or a file: nothing of it runs before the user has seen it. */
export interface Offer {
  code: string
  /** The link of a run, or the name of a file. */
  link: string | null
  file: string | null
}

/** A text with the line ends of an editor. */
export const withLines = (text: string): string => text.replace(/\r\n?/g, '\n')

/** A link brings the code of its planner. */
export const carriesCode = (link: string): boolean => link.includes('&page.code=')

/** Planners that somebody wrote: in the catalogue as soon as their code was read, which `own-code` does. */
export class OwnStore {
  /** By their codes. */
  readonly planners = new Map<string, OwnPlanner>()
  /** Codes that may run: the user has seen them. */
  readonly seen = new Set<string>()
  /** Codes that came from elsewhere, whether they may run or not. */
  readonly foreign = new Set<string>()
  /** The code of the run that the browser had kept: what is in the editor may be newer. */
  resumed = ''
  /** What the user writes runs without an interpreter. */
  full = $state(false)
  offer = $state.raw<Offer | null>(null)
  /** It is in the editor, and has not run yet. */
  pending: Offer | null = null

  constructor(
    readonly api: Questions,
    readonly setup: { catalogue: Catalogue | null },
  ) {}

  /** Shows a code that somebody else brings. Its lines end as those of an editor do: so it is known again. */
  bring(offer: Offer): void {
    const code = withLines(offer.code)
    this.foreign.add(code)
    this.offer = { ...offer, code }
  }

  /** Puts a planner into the catalogue, in the place of another one of its name. */
  put(planner: OwnPlanner): void {
    const { catalogue } = this.setup
    if (catalogue && !catalogue.planners.includes(planner)) this.setup.catalogue = withPlanner(catalogue, planner)
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

  /** From now on all runs in an interpreter. */
  disableFullSpeed(): void {
    this.full = false
    for (const planner of this.planners.values()) planner.full = false
  }
}
