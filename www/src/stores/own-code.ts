import type { Catalogue, Layer, Planner } from 'forage-lab'
import { isOwn, type OwnPlanner } from '../catalogue/own'
import type { Answer } from '../engine/protocol'
import { isKept } from './kept-run'
import { isShortened, restored } from './large-links'
import { type Offer, type OwnStore, withLines } from './own.svelte'
import { recall, remember } from './storage'

/** Where the browser keeps what is in the editor. */
export const DRAFT = 'workshop.draft'

/** A code in an editor. */
export interface Draft {
  code: string
  /** Somebody else wrote it, or what it was made of. */
  foreign: boolean
}

/** What the browser keeps of a code; nothing of it is somebody's own unless that stands there. */
export function recallDraft(key: string): Draft | null {
  try {
    const found = JSON.parse(recall(key) ?? 'null') as Partial<Draft> | null
    return typeof found?.code === 'string' ? { code: found.code, foreign: found.foreign !== false } : null
  } catch {
    return null
  }
}

/** Keeps a code, and whose it is, in one: another tab writes there too. */
export const rememberDraft = (key: string, { code, foreign }: Draft): void => remember(key, JSON.stringify({ code, foreign }))

const CODE = '&page.code='

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

/** The look of layers that no planner of the catalogue has. */
const OTHERWISE = 'particles'

/** As the catalogue has planners: its layers look as those of the same name do elsewhere. */
function ownPlanner({ planners }: Catalogue, described: Planner, of: Pick<OwnPlanner, 'code' | 'packed' | 'full'>): OwnPlanner {
  const known = planners.filter((planner) => !isOwn(planner)).flatMap(({ layers }) => layers)
  const lookOf = (role: string): Layer['look'] | undefined => known.find((layer) => layer.role === role)?.look
  const layers = described.layers.flatMap((layer): Layer[] => {
    const look = lookOf(layer.role) ?? lookOf(OTHERWISE)
    return look ? [{ ...layer, look } as Layer] : []
  })
  return { ...described, layers, ...of }
}

/** Reads a code in the run's thread, unless it was read before, and puts its planner into the catalogue. `full`: it runs without an interpreter. */
export async function readCode(own: OwnStore, code: string, full = false): Promise<Answer<OwnPlanner>> {
  const read = await plannerOf(own, code, full)
  if (read.ok) own.put(read.value)
  return read
}

/** The planner of a code. */
async function plannerOf(own: OwnStore, code: string, full: boolean): Promise<Answer<OwnPlanner>> {
  own.seen.add(code)
  const known = own.planners.get(code)
  if (known) {
    known.full = full
    return { ok: true, value: known }
  }
  const answer = await own.api.read(code)
  const { catalogue } = own.setup
  if (!answer.ok) return answer
  if (!catalogue) return { ok: false, refusal: { message: 'there is no catalogue', field: '' } }
  const { planner: described, packed } = answer.value
  const planner = ownPlanner(catalogue, described, { code, packed, full })
  own.planners.set(code, planner)
  return { ok: true, value: planner }
}

/** Where a code says what its planner is called. */
const NAME = /(\bname:\s*)(['"])([a-z][\w-]*)\2/
const TITLE = /(\btitle:\s*)(['"])((?:(?!\2)[^\\\n])*)\2/

/** Makes an earlier code known by another name, so that both can be compared; null where its name is not simply written out. */
export async function earlier(own: OwnStore, code: string, words: (title: string) => string): Promise<string | null> {
  if (NAME.exec(code)?.[3] !== own.planners.get(code)?.name) return null
  const renamed = code
    .replace(NAME, '$1$2$3-before$2')
    .replace(TITLE, (_, at: string, quote: string, title: string) => at + quote + words(title) + quote)
  if (own.foreign.has(code)) own.foreign.add(renamed)
  const read = await readCode(own, renamed)
  return read.ok ? read.value.name : null
}

/** What a link or an address brings. */
interface Brought {
  /** A code that the user has not seen: it is offered first. */
  offer: Offer | null
  /** The planner of a code that may run. */
  planner: OwnPlanner | null
}

/** Reads the code of a link, if that may run. Its planner is not in the catalogue yet: another one may be wanted by then. */
export const readLink = async (own: OwnStore, link: string): Promise<Answer<Brought>> =>
  readCarried(own, isShortened(link) ? await restored(link) : link, link)

/** What is to be offered before an address with several codes, as links have them, may be opened. */
export async function mayOpenAll(own: OwnStore, packed: readonly string[], address: string): Promise<Answer<Offer | null>> {
  for (const one of packed) {
    const read = await readCarried(own, `#${CODE}${one}`, address)
    if (!read.ok) return read
    const { offer, planner } = read.value
    if (offer) return { ok: true, value: offer }
    if (planner) own.put(planner)
  }
  return { ok: true, value: null }
}

/** The code in `carrier`, which came with a link. */
async function readCarried(own: OwnStore, carrier: string, link: string): Promise<Answer<Brought>> {
  const answer = await own.api.codeIn(carrier)
  if (!answer.ok) return answer
  if (answer.value === null) return { ok: true, value: { offer: null, planner: null } }
  const code = withLines(answer.value)
  const [draft, kept] = [recallDraft(DRAFT), isKept(link)]
  if (kept) own.resumed = code
  const isMine = kept || (draft?.code === code && !draft.foreign)
  if (!own.seen.has(code) && !isMine) return { ok: true, value: { offer: { code, link, file: null }, planner: null } }
  const read = await plannerOf(own, code, false)
  return read.ok ? { ok: true, value: { offer: null, planner: read.value } } : read
}

/** The offered code may run from now on. */
export function accept(own: OwnStore, { code }: Offer): void {
  own.seen.add(code)
  own.offer = null
}

/** It is looked at where it can be changed. */
export function edit(own: OwnStore, offer: Offer): void {
  own.pending = offer
  own.offer = null
}
