/* For a page around an embedded run (`?embed`): what is posted to it, and what it posts. */

/** The mark of messages between the two, with the version of what they say. */
const VERSION = 1

/**
 * Speaks with the run in an iframe. Only messages of that very frame, from the origin of its address, are listened to, and messages
 * go to that origin only.
 */
export function connect(frame, { origin = new URL(frame.src, location.href).origin } = {}) {
  const listeners = new Set()
  const receive = ({ source, origin: from, data }) => {
    if (source !== frame.contentWindow || from !== origin || data?.forage !== VERSION) return
    const { forage: _, ...event } = data
    for (const listener of [...listeners]) listener(event)
  }
  addEventListener('message', receive)
  const post = (command) => frame.contentWindow?.postMessage({ forage: VERSION, ...command }, origin)
  return {
    play: () => post({ is: 'play' }),
    pause: () => post({ is: 'pause' }),
    step: (by = 1) => post({ is: 'step', by }),
    seek: (to) => post({ is: 'seek', to }),
    open: (link) => post({ is: 'open', link }),
    listen(listener) {
      listeners.add(listener)
      return () => listeners.delete(listener)
    },
    close() {
      removeEventListener('message', receive)
      listeners.clear()
    },
  }
}
