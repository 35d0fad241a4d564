/*
 * Code in links: deflated, in base64url, behind the key `page.code`. What does not run it skips it, as all that begins with `page.`.
 */
import { refused } from '../../crates/isolate/src/js/describe.js'

const KEY = 'page.code='
/** How many bytes a code may have in a link, deflated; and how many otherwise. */
const MOST_IN_LINK = 8192
const LONGEST = 200_000

const through = (bytes, stream) => new Blob([bytes]).stream().pipeThrough(stream)
const bytesOf = async (stream) => new Uint8Array(await new Response(stream).arrayBuffer())

/** The bytes of a stream, as far as there may be so many. */
async function limited(stream, most) {
  const parts = []
  let size = 0
  for (const reader = stream.getReader(); ; ) {
    const { done, value } = await reader.read()
    if (done) break
    size += value.length
    if (size > most) {
      await reader.cancel()
      throw refused('code', `more than ${most} bytes`, `a code of at most ${most} bytes`)
    }
    parts.push(value)
  }
  return new Blob(parts).text()
}

/** The link with a code; in the place of another one that it has. */
export async function withCode(link, code) {
  const deflated = await bytesOf(through(new TextEncoder().encode(code), new CompressionStream('deflate-raw')))
  if (deflated.length > MOST_IN_LINK) throw refused('code', `${deflated.length} bytes`, `a code of at most ${MOST_IN_LINK} bytes, deflated`)
  let binary = ''
  for (const byte of deflated) binary += String.fromCharCode(byte)
  const packed = btoa(binary).replaceAll('+', '-').replaceAll('/', '_').replaceAll('=', '')
  const kept = link.split('&').filter((part) => !part.startsWith(KEY))
  return [...kept, `${KEY}${packed}`].join('&')
}

/** The code in a link; undefined where it has none. */
export async function codeIn(link) {
  const packed = link
    .split('&')
    .find((part) => part.startsWith(KEY))
    ?.slice(KEY.length)
  if (packed === undefined) return undefined
  if (packed.length > (MOST_IN_LINK / 3) * 4 + 4)
    throw refused('code', `${packed.length} characters`, `a code of at most ${MOST_IN_LINK} bytes, deflated`)
  try {
    const binary = atob(packed.replaceAll('-', '+').replaceAll('_', '/'))
    return await limited(
      through(
        Uint8Array.from(binary, (char) => char.charCodeAt(0)),
        new DecompressionStream('deflate-raw'),
      ),
      LONGEST,
    )
  } catch (error) {
    if (error.code === 'refused') throw error
    throw refused('code', packed, 'a code that is not damaged')
  }
}
