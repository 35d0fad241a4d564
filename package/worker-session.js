/*
 * A session in a thread of its own: the same methods, asynchronous. What differs between pages and Node is given by worker.js and
 * worker.node.js.
 */
import { wrap } from 'comlink'
import { errorOf } from './thrown.js'

/** The class, by how a worker is opened: it, what is sent through, and a function that hears how it broke down. */
export function sessionIn(open) {
  const key = Symbol('start')
  class WorkerSession {
    #worker
    #api
    /** What a call throws that comes too late. */
    #over
    #freed
    #waiting = new Set()

    constructor(given, worker) {
      if (given !== key) throw new TypeError('WorkerSession: call `await WorkerSession.start(setup)`')
      const { worker: opened, endpoint, failed } = open(worker)
      this.#worker = opened
      this.#api = wrap(endpoint)
      failed((cause) =>
        this.#end(new Error(`WorkerSession: the worker broke down: ${cause?.message ?? 'its script cannot be loaded'}`, { cause })),
      )
    }

    static start(setup, options) {
      const code = ['objective', 'objectives'].find((name) => typeof setup?.scene?.[name] === 'function')
      if (code !== undefined) {
        const error = new TypeError(`scene.${code}: a function cannot go to a thread; use a Session, or write it as an expression`)
        return Promise.reject(Object.assign(error, { field: `scene.${code}` }))
      }
      return WorkerSession.#made('start', setup, options)
    }

    static fromLink(link, options) {
      return WorkerSession.#made('fromLink', link, options)
    }

    static async #made(how, from, { worker, words, code } = {}) {
      const session = new WorkerSession(key, worker)
      try {
        session.#freed = await session.#ask((api) => api.open(how, from, words, code))
      } catch (error) {
        session.#end(error)
        throw error
      }
      return session
    }

    /** What the worker answers, unless it ends before. Node goes on as long as an answer is waited for. */
    #ask(call) {
      return new Promise((resolve, reject) => {
        if (this.#over) {
          reject(this.#over)
          return
        }
        this.#waiting.add(reject)
        this.#worker.ref?.()
        const answered = () => {
          this.#waiting.delete(reject)
          if (this.#waiting.size === 0) this.#worker.unref?.()
        }
        call(this.#api).then(resolve, reject).finally(answered)
      })
    }

    #end(why) {
      if (this.#over) return
      this.#over = why
      void this.#worker.terminate()
      for (const reject of this.#waiting) reject(why)
      this.#waiting.clear()
    }

    free() {
      this.#end(errorOf(this.#freed))
    }

    async paintField(context, min, max, ramp) {
      // Only the page knows the canvas: the worker paints one of its own of that size.
      const { width, height } = context?.canvas ?? {}
      const painted = await this.#ask((api) => api.paint(typeof context?.drawImage === 'function' && { width, height }, min, max, ramp))
      if (!painted) return false
      context.drawImage(painted, 0, 0)
      painted.close()
      return true
    }

    static {
      const all = (names, make) => {
        for (const name of names) Object.defineProperty(WorkerSession.prototype, name, { ...make(name), configurable: true })
      }
      all(METHODS, (name) => ({
        value(...given) {
          return this.#ask((api) => api.call(name, given))
        },
        writable: true,
      }))
      all(GETTERS, (name) => ({
        get() {
          return this.#ask((api) => api.get(name))
        },
      }))
    }
  }
  if (Symbol.dispose) WorkerSession.prototype[Symbol.dispose] = WorkerSession.prototype.free
  return WorkerSession
}
