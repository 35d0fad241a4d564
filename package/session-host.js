/* What a worker does for a WorkerSession: it has a session, and answers one call after another. */
import { transfer } from 'comlink'
import { dataOf } from './thrown.js'
import { speaker } from './words.js'

/** A result with its buffers. They are no one else's: they need not be copied. */
function sent(result) {
  if (typeof result !== 'object' || result === null) return result
  const arrays = (ArrayBuffer.isView(result) ? [result] : Object.values(result)).filter(ArrayBuffer.isView)
  return transfer(
    result,
    arrays.map(({ buffer }) => buffer),
  )
}

export function host({ freed, ready, Session, speakBy, isolate }) {
  let session
  let last = Promise.resolve()

  // A call may wait for a part of the module: none may overtake it.
  function inTurn(call) {
    const answer = last.then(() => ready(call))
    last = answer.catch(() => undefined)
    return answer
  }

  const makers = { start: (setup) => new Session(setup), fromLink: (link) => Session.fromLink(link) }
  const calls = {
    // The views of a frame show the module's memory.
    frame(...given) {
      const { vertices, spans, ...rest } = session.frame(...given)
      return { vertices: vertices.slice(), spans: spans.slice(), ...rest }
    },
  }

  return {
    /** Returns what is thrown once the session is freed. */
    async open(how, from, words, code) {
      if (words) speakBy(speaker(words.locale, words.patterns))
      if (code !== undefined) await (await isolate()).registerCode(code)
      session = await inTurn(makers[how].bind(null, from))
      return dataOf(freed('WorkerSession', false))
    },
    call: async (name, given) => sent(await inTurn(() => (calls[name] ? calls[name](...given) : session[name](...given)))),
    get: (name) => inTurn(() => session[name]),
    /** A picture of a scene's heights; null if it has none. */
    async paint(size, min, max, ramp) {
      const canvas = size && new OffscreenCanvas(size.width, size.height)
      const context = canvas ? canvas.getContext('2d') : undefined
      if (!(await inTurn(() => session.paintField(context, min, max, ramp)))) return null
      const picture = canvas.transferToImageBitmap()
      return transfer(picture, [picture])
    },
  }
}
