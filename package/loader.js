/*
 * What is loaded of the module, and how the rest of it comes. The first part holds what every run needs, and the swarms; other parts
 * share its memory and its functions. `host` says where files are read from: at once (Node), or by and by (a page).
 */
import { add, bringBy, speakBy as speakByHost } from './glue.js'
import { files, holds } from './parts.js'

/** The parts that hold what a field asks for by name; undefined where none does. */
export const holdersOf = (field, value) => {
  const names = Object.hasOwn(holds, field) ? holds[field] : undefined
  return names && Object.hasOwn(names, value) ? names[value] : undefined
}

/**
 * The parts that a run needs: its planner's and those of planners that it names in parameters, and the scene's.
 * What it does not know is nothing's: whoever makes the run says what is wrong.
 */
export function partsOf({ planner, scene, params = {} }) {
  const named = Object.values(params ?? {}).flatMap((value) => (typeof value === 'string' ? (holdersOf('planner', value) ?? []) : []))
  const place = typeof scene === 'string' ? holdersOf('scene', scene) : holdersOf('kind', scene?.kind)
  return [...new Set([...(holdersOf('planner', planner) ?? []), ...named, ...(place ?? [])])]
}

/** All parts but the first. */
export const PARTS = Object.keys(files)

const added = new Set()
const instantiated = new Set()
let shared
/** How the user has messages said. */
let own

/** What the other parts of the module are linked with: of the first one's exports. */
export function share({ memory, __indirect_function_table, __wasm_split_shared0 }) {
  const base = { memory, __indirect_function_table, __wasm_split_shared0 }
  shared = { base, __wasm_split: base }
  if (own) speakByHost(own)
}

/** The parts among these that are not there yet. */
export function missing(parts) {
  const unknown = parts.find((part) => !PARTS.includes(part))
  if (unknown !== undefined) throw new RangeError(`part: there is no \`${unknown}\`; known: ${PARTS.join(', ')}`)
  return parts.filter((part) => !added.has(part))
}

export const isAdded = (part) => added.has(part)

/** The files of these parts that are not there yet. */
export const filesOf = (parts) => [...new Set(parts.flatMap((part) => files[part]))].filter((file) => !instantiated.has(file))

/** Links a file's code with what is there. A file may have come twice. */
export function linkFile(file, module) {
  if (instantiated.has(file)) return
  new WebAssembly.Instance(module, shared)
  instantiated.add(file)
}

/** Adds parts whose files are linked. */
export function addParts(parts) {
  for (const part of missing(parts)) {
    add(part)
    added.add(part)
  }
}

/** What a call asks for may be in another part. */
export function askBy(bring) {
  bringBy((field, value) => {
    const holders = holdersOf(field, value)
    // A name that nothing has: what there is to choose from is known only when all is here.
    const parts = missing(holders ?? (Object.hasOwn(holds, field) ? PARTS : []))
    return parts.length > 0 ? bring(parts, holders !== undefined) : undefined
  })
}

/**
 * Sets how messages are said: a function of a key and an object of arguments that returns the text, or undefined where it has no
 * words. Without it they are English.
 */
export function speakBy(say) {
  own = say
  if (shared) speakByHost(say)
}

/** Says messages by words of our own, unless the user has brought some. */
export function speakEnglish(say) {
  if (!own) speakByHost(say)
}

export const speaksEnglish = () => !own
