/*
 * What is loaded of the module, and how the rest of it comes. The first part holds what every run needs, and the swarms; other parts
 * share its memory and its functions. `host` says where files are read from: at once (Node), or over the network (a page).
 */
import { __wbg_reset_state as startAgain, add, addScenes as addScenesOf, bringBy, initSync, speakBy as speakByHost } from './glue.js'
import { sayDeadBy } from './guard.js'
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
  const fields = typeof scene === 'string' ? [] : Object.keys(scene ?? {}).flatMap((field) => holdersOf('field', field) ?? [])
  return [...new Set([...(holdersOf('planner', planner) ?? []), ...named, ...(place ?? []), ...fields])]
}

/** All parts but the first. */
export const PARTS = Object.keys(files)

const added = new Set()
/** The compiled code of the files that are linked. */
const linked = new Map()
/** The scenes of each part whose scenes are there, as texts. */
const scenes = new Map()
let shared
/** How messages are said, and whether that is the user's way. */
let said
let own = false
/** What the module asks for what is in other parts. */
let asked

/** What the other parts of the module are linked with: of the first one's exports. */
export function share({ memory, __indirect_function_table, __wasm_split_shared0 }) {
  const base = { memory, __indirect_function_table, __wasm_split_shared0 }
  shared = { base, __wasm_split: base }
  if (said) tell(said)
  if (asked) bringBy(asked)
}

/** Has messages said: by the module, once it is there, and of it, when it is dead. */
function tell(say) {
  said = say
  sayDeadBy(say)
  if (shared) speakByHost(say)
}

/**
 * Restarts the module with the parts that were loaded: after a `ModuleDead`. All sessions and trials that there were are gone.
 */
export function reset() {
  if (!shared) return
  startAgain()
  share(initSync())
  for (const texts of scenes.values()) addScenesOf(texts)
  const files = [...linked]
  const parts = [...added]
  // Not before: where memory is short it throws, and the next attempt needs them.
  linked.clear()
  added.clear()
  for (const [file, module] of files) linkFile(file, module)
  addParts(parts)
  for (const work of again) work()
}

/** The parts among these that are not there yet. */
export function missing(parts) {
  const unknown = parts.find((part) => !PARTS.includes(part))
  if (unknown !== undefined) throw new RangeError(`part: there is no \`${unknown}\`; known: ${PARTS.join(', ')}`)
  return parts.filter((part) => !added.has(part))
}

export const isAdded = (part) => added.has(part)

/** The files of these parts that are not there yet. */
export const filesOf = (parts) => [...new Set(parts.flatMap((part) => files[part]))].filter((file) => !linked.has(file))

/** Links a file's code with what is there. A file may have come twice. */
export function linkFile(file, module) {
  if (linked.has(file)) return
  new WebAssembly.Instance(module, shared)
  linked.set(file, module)
}

/** Adds parts whose files are linked. */
export function addParts(parts) {
  for (const part of missing(parts)) {
    if (!add(part)) throw new Error(`the module has no part \`${part}\``)
    added.add(part)
  }
}

/** What is done after a restart: what was given to the module since is given again. */
const again = []
export const afterReset = (work) => void again.push(work)

/** Adds the scenes that ship with a part, after the module is there. */
export function addScenes(part, list) {
  if (scenes.has(part)) return
  const texts = list.map((scene) => JSON.stringify(scene))
  scenes.set(part, texts)
  addScenesOf(texts)
}

/** What a call asks for may be in another part. */
export function askBy(bring) {
  asked = (field, value) => {
    const holders = holdersOf(field, value)
    // A name that nothing has: what there is to choose from is known only when all is here.
    const parts = missing(holders ?? (Object.hasOwn(holds, field) ? PARTS : []))
    return parts.length > 0 ? bring(parts, holders !== undefined) : undefined
  }
  bringBy(asked)
}

/**
 * Sets how messages are said: a function of a key and an object of arguments that returns the text, or undefined where it has no
 * words. Without it they are English.
 */
export function speakBy(say) {
  own = true
  tell(say)
}

/** Says messages by the package's own words, unless the user has brought some. */
export function speakOwn(say) {
  if (!own) tell(say)
}

export const speaksOwn = () => !own
