/*
 * Planners by their code, in an interpreter of its own: it has no network, no clock, no document and no storage, takes a second for a
 * step and 64 MB at most. For code that comes from somebody else.
 */
import { QuickJSFFI } from '@jitl/quickjs-wasmfile-release-sync/ffi'
import load from '@jitl/quickjs-wasmfile-release-sync/emscripten-module'
import { newQuickJSWASMModuleFromVariant, newVariant } from 'quickjs-emscripten-core'
import { lent, lentList } from './glue.js'
import { add, describe } from './own.js'

/** Written by package/complete.mjs: the script crates/isolate/src/js/inside.js. */
const PRELUDE = INSIDE

/** In pages of a memory. */
const MEGABYTE = 16
/** In MB. */
const MEMORY = 64
/** In bytes. */
const STACK = 256 * 1024
/** How long a step may take, and what only shows something; in milliseconds. */
const STEP = 900
/** For our own code, which has an end: its first steps are slow while an engine still compiles the interpreter, or is busy. */
const READ = 10_000
const LOOK = 300
/** How long a code may be, in characters. */
const LONGEST = 200_000
/** Of an error's message, in characters. */
const LONGEST_MESSAGE = 500
/** How many lines are kept of what a step prints. */
const LINES = 200
const FILE = 'planner.js'
const SHAPES = ['points', 'polyline', 'segments']

const LANGUAGE = {
  BaseObjects: true,
  Eval: true,
  StringNormalize: true,
  RegExp: true,
  RegExpCompiler: true,
  JSON: true,
  Proxy: true,
  MapSet: true,
  TypedArrays: true,
  Promise: true,
  BigInt: true,
}

let module_

/** An interpreter with a memory of its own: whatever becomes of it, the next code finds a new one. `compiled` promises its code. */
async function interpreterBy(compiled) {
  module_ ??= compiled().catch((error) => {
    module_ = undefined
    throw error
  })
  const variant = { type: 'sync', importFFI: async () => QuickJSFFI, importModuleLoader: async () => load }
  // The interpreter's own limit counts no more than the number of things: this one is the engine's.
  const memory = new WebAssembly.Memory({ initial: 16 * MEGABYTE, maximum: MEMORY * MEGABYTE })
  return { memory, quickjs: await newQuickJSWASMModuleFromVariant(newVariant(variant, { wasmModule: await module_, wasmMemory: memory })) }
}

const refused = (message, more = {}) => Object.assign(new RangeError(message), { code: 'refused', field: 'code', ...more })

const tooMuch = `it needs more than ${MEMORY} MB`
const tooLong = (limit) => `it took longer than ${limit} ms and was stopped`

/** What went wrong, in words, with the line of the code where it did. */
function faultOf(error, limit) {
  const said = typeof error === 'object' && error !== null ? error : { message: error }
  const name = String(said.name ?? 'Error').slice(0, 60)
  const message = String(said.message ?? '').slice(0, LONGEST_MESSAGE)
  const stack = String(said.stack ?? '').slice(0, 10 * LONGEST_MESSAGE)
  const [, line, column] = String(stack).match(new RegExp(`${FILE}:(\\d+)(?::(\\d+))?`)) ?? []
  const at = line && { line: Number(line), ...(column && { column: Number(column) }) }
  const where = line ? ` (line ${line})` : ''
  if (name === 'InternalError' && message === 'interrupted') return { message: `${tooLong(limit)}${where}`, ...at, stopped: 'time' }
  if (name === 'InternalError' && message === 'out of memory') return { message: `${tooMuch}${where}`, ...at, stopped: 'memory' }
  if (name === 'InternalError' && message === 'stack overflow') return { message: `its calls are nested too deeply${where}`, ...at }
  return { message: `${name === 'Error' ? '' : `${name}: `}${message}${where}`, ...at }
}

/** A code in an interpreter. Nobody frees it: when another one of its planner's name has come and its last run is over, it goes as a whole. */
class Isolate {
  constructor({ quickjs, memory }, onprint) {
    this.memory = memory
    this.onprint = onprint
    this.deadline = Number.POSITIVE_INFINITY
    this.lines = 0
    this.runtime = quickjs.newRuntime()
    this.runtime.setMaxStackSize(STACK)
    this.runtime.setInterruptHandler(() => performance.now() > this.deadline)
    this.runtime.setModuleLoader((name) =>
      name === 'forage-lab'
        ? 'export const register = globalThis.register'
        : { error: new Error(`\`${name}\` can't be imported: only forage-lab is here`) },
    )
    this.context = this.runtime.newContext({ intrinsics: LANGUAGE })
    this.lend(onprint)
    this.run(PRELUDE, 'inside.js', READ)
    const inside = this.context.getProp(this.context.global, 'inside')
    this.context.unwrapResult(this.context.evalCode('delete globalThis.inside')).dispose()
    this.inside = inside
    this.functions = new Map()
  }

  /** What the inside may call. An error that is thrown here is thrown there. */
  lend(onprint) {
    const { context } = this
    const outside = context.newObject()
    const offer = (name, call) => {
      const offered = context.newFunction(name, (...given) => {
        try {
          return call(...given)
        } catch (error) {
          return { error: context.newError({ name: 'Error', message: error instanceof Error ? error.message : String(error) }) }
        }
      })
      context.setProp(outside, name, offered)
      offered.dispose()
    }
    offer('lent', (what, a, b) => context.newNumber(lent(context.getNumber(what), context.getNumber(a), context.getNumber(b))))
    offer('list', (what, buffer) => context.newNumber(lentList(context.getNumber(what), this.numbersOf(buffer))))
    offer('print', (text) => {
      this.lines += 1
      if (this.lines <= LINES) onprint?.(context.getString(text))
    })
    context.setProp(context.global, 'outside', outside)
    outside.dispose()
  }

  numbersOf(handle) {
    const view = this.context.getArrayBuffer(handle)
    try {
      return new Float64Array(view.value.slice().buffer)
    } finally {
      view.dispose()
    }
  }

  /** Throws what the inside threw. */
  valueOf(result, limit) {
    if (!result.error) return result.value
    const fault = faultOf(this.context.dump(result.error), limit)
    // With no memory left there are no words either.
    if (fault.message === '' && this.memory.buffer.byteLength > (MEMORY - 1) * 1024 * 1024)
      Object.assign(fault, { message: tooMuch, stopped: 'memory' })
    result.error.dispose()
    throw Object.assign(new Error(fault.message), fault, { isFault: true })
  }

  within(limit, work) {
    this.deadline = performance.now() + limit
    this.lines = 0
    try {
      return work()
    } catch (error) {
      if ('stopped' in error || error.isFault) throw error
      // The interpreter itself gave up: its own calls were nested too deeply for the engine, or it is out of order.
      const deep = error instanceof RangeError || /recursion/.test(error.message)
      throw Object.assign(new Error(deep ? 'its calls are nested too deeply' : `the interpreter broke down: ${error.message}`), {
        isFault: true,
      })
    } finally {
      this.deadline = Number.POSITIVE_INFINITY
    }
  }

  run(code, file, limit, type = 'global') {
    this.within(limit, () => {
      const value = this.valueOf(this.context.evalCode(code, file, { type }), limit)
      // What it awaits is done now: nothing comes from outside.
      while (this.runtime.hasPendingJob()) {
        const done = this.runtime.executePendingJobs(1)
        if (done.error) this.valueOf(done, limit)
        if (performance.now() > this.deadline) throw Object.assign(new Error(tooLong(limit)), { stopped: 'time' })
      }
      const state = type === 'module' ? this.context.getPromiseState(value) : undefined
      // Without memory a promise is never kept.
      if (state?.type === 'pending') throw Object.assign(new Error(`it awaits what never comes, or ${tooMuch}`), { isFault: true })
      if (state?.type === 'rejected') {
        const error = state.error
        this.valueOf({ error }, limit)
      }
      value.dispose()
    })
  }

  /** A function of the inside; its result is read by `read`. */
  call(name, given, limit, read) {
    const { context } = this
    let called = this.functions.get(name)
    if (!called) {
      called = context.getProp(this.inside, name)
      this.functions.set(name, called)
    }
    const handles = given.map((value) => this.handleOf(value))
    return this.within(limit, () => {
      try {
        const value = this.valueOf(context.callFunction(called, context.undefined, ...handles), limit)
        try {
          return read(value)
        } finally {
          value.dispose()
        }
      } finally {
        for (const handle of handles) handle.dispose()
      }
    })
  }

  /** What only shows something ends no run when it throws: it is printed, once. */
  shown(name, work) {
    try {
      return work()
    } catch (error) {
      if (this.complaint !== error.message) this.onprint?.(`${name}: ${error.message}`)
      this.complaint = error.message
      throw error
    }
  }

  handleOf(value) {
    const { context } = this
    if (typeof value === 'number') return context.newNumber(value)
    if (typeof value === 'string') return context.newString(value)
    if (value instanceof Float64Array) return context.newArrayBuffer(value.slice().buffer)
    return context.undefined.dup()
  }

  /**
   * The functions that the core calls. What comes out is looked at here: an author's code may change whatever the inside is made of.
   */
  host() {
    const { context } = this
    const number = (value) => context.getNumber(value)
    const text = (value) => context.getString(value)
    const list = (value) => this.numbersOf(value)
    const isNull = (value) => context.typeof(value) === 'object' && context.sameValue(value, context.null)
    return {
      start: (scene, params, seed, low, high) =>
        this.call('start', [JSON.stringify(scene), JSON.stringify(params), seed, low, high], STEP, number),
      advance: (id) => this.call('advance', [id], STEP, number),
      best: (id) =>
        this.call('best', [id], LOOK, (value) => {
          if (isNull(value)) return null
          const [cost, kind, ...rest] = list(value)
          return [cost, kind, Float64Array.from(rest)]
        }),
      readings: (id) => this.call('readings', [id], LOOK, list),
      draw: (id) => {
        const all = this.shown('draw', () => this.call('draw', [id], LOOK, list))
        const pieces = []
        for (let at = 0; at < all.length; ) {
          const [layer, shape, count] = all.subarray(at, at + 3)
          const end = at + 3 + Math.max(0, Math.trunc(count) || 0)
          pieces.push([layer, SHAPES[shape], all.slice(at + 3, end)])
          at = end
        }
        return pieces
      },
      explain: (id, layer, index) => {
        const said = JSON.parse(this.shown('explain', () => this.call('explain', [id, layer, index], LOOK, text)))
        if (!Array.isArray(said) || typeof said[0] !== 'string' || typeof said[1] !== 'string') return null
        const values = Array.isArray(said[2]) ? said[2] : []
        return [
          said[0],
          said[1],
          values.filter((pair) => Array.isArray(pair) && typeof pair[0] === 'string' && typeof pair[1] === 'number'),
        ]
      },
      copy: (id) => this.call('copy', [id], STEP, number),
      forget: (id) => this.call('forget', [id], LOOK, () => undefined),
      digest: (id) => Uint32Array.from(this.call('digest', [id], STEP, list)),
      size: (id) => this.call('size', [id], LOOK, number),
      state: (id) => JSON.parse(this.call('state', [id], LOOK, text)),
    }
  }
}

/** Members of a planner that are functions. */
const FUNCTIONS = ['start', 'advance', 'best', 'draw', 'explain']

/** What was written of a planner, with functions where there is code. */
function plannerOf(written) {
  const isCode = (value) => value === 'code'
  const planner = { ...written }
  for (const name of FUNCTIONS) if (isCode(planner[name])) planner[name] = () => undefined
  if (Array.isArray(planner.readings))
    planner.readings = planner.readings.map((one) => (isCode(one?.value) ? { ...one, value: () => 0 } : one))
  return planner
}

const textOr = (value, otherwise) => (typeof value === 'string' ? value.slice(0, LONGEST_MESSAGE) : otherwise)

/**
 * Adds a planner by its code. `compiled` promises the interpreter's module, `loadCode` loads the part of the core that runs planners
 * from code, `onprint` is given what the code prints.
 */
export async function registerCodeBy(code, { compiled, loadCode, onprint }) {
  if (typeof code !== 'string' || code.length > LONGEST) throw refused(`code: it must be a text of at most ${LONGEST} characters`)
  const [interpreter] = await Promise.all([interpreterBy(compiled), loadCode()])
  const isolate = new Isolate(interpreter, onprint)
  try {
    const portable = isolate.call('portable', [code], READ, (value) => isolate.context.getString(value))
    isolate.run(portable, FILE, STEP, 'module')
  } catch (error) {
    // Where powers were written as calls the columns are others.
    const isElsewhere = code.split('\n')[error.line - 1]?.includes('**')
    throw refused(`code: ${error.message}`, { line: error.line, column: isElsewhere ? undefined : error.column, stopped: error.stopped })
  }
  const text = (value) => isolate.context.getString(value)
  try {
    const said = JSON.parse(isolate.call('described', [], STEP, text))
    if (said?.code === 'refused') {
      const { field, value, allowed, message } = said
      throw refused(textOr(message, 'the code is refused'), {
        field: textOr(field, 'code'),
        value: textOr(value),
        allowed: textOr(allowed),
      })
    }
    return add(describe(plannerOf(JSON.parse(isolate.call('written', [], STEP, text)))), isolate.host())
  } catch (error) {
    if (error.code === 'refused') throw error
    throw refused(`code: ${error.message}`, { line: error.line, column: error.column, stopped: error.stopped })
  }
}
