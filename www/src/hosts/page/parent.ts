import type { RunCommand, RunEvent } from 'forage-lab/embed'
import { obey, tell } from '../../rooms/embed/remote.svelte'
import type { Lab } from '../../stores/lab.svelte'

/** The mark of messages between an embedded run and the page around it, with the version of what they say. */
export const MARK = { forage: 1 } as const

/** The origin of the page around: messages come from there and go there only. */
function originOf(): string | null {
  const [around] = location.ancestorOrigins ?? []
  if (around) return around
  try {
    return new URL(document.referrer).origin
  } catch {
    return null
  }
}

/**
 * Posts to the page around what happens, and does what it asks for, until the returned function is called. A page is known by its
 * origin: with one that hides it, and with one opened from a disk, no messages are exchanged.
 */
export function speakWith(parent: Window, lab: Lab): () => void {
  const origin = originOf()
  if (parent === window || origin === null || origin === 'null') return () => undefined
  const post = (event: RunEvent): void => parent.postMessage({ ...MARK, ...event }, origin)
  const receive = ({ source, origin: from, data }: MessageEvent<unknown>): void => {
    if (source !== parent || from !== origin) return
    if (typeof data !== 'object' || data === null || (data as Partial<typeof MARK>).forage !== MARK.forage) return
    try {
      obey(lab, data as RunCommand)
    } catch (error) {
      post({ is: 'error', message: error instanceof Error ? error.message : String(error) })
    }
  }
  addEventListener('message', receive)
  const silence = tell(lab, post)
  return () => {
    removeEventListener('message', receive)
    silence()
  }
}
