import type { Controls } from '../../catalogue/embedding'
import type { Elsewhere } from '../../engine/host'

/** How a run is to be shown on another page. */
export interface Embedding {
  controls: Controls
  theme: 'system' | 'light' | 'dark'
  /** A language of the page; none: the reader’s. */
  language: string
  autoplay: boolean
  width: number
  height: number
}

/** What a page may be asked for, in pixels. */
export const SIZE = { width: [320, 2000], height: [240, 2000] } as const

const ESCAPES: Readonly<Record<string, string>> = { '&': '&amp;', '"': '&quot;', '<': '&lt;', '>': '&gt;' }

/** As the value of an attribute. */
export const escaped = (text: string): string => text.replace(/[&"<>]/g, (letter) => ESCAPES[letter] ?? letter)

/** What differs from what is usual, as pairs. */
function optionsOf({ controls, theme, language, autoplay }: Embedding): [string, string][] {
  const all: [string, string, boolean][] = [
    ['controls', controls, controls !== 'play'],
    ['theme', theme, theme !== 'system'],
    ['lang', language, language !== ''],
    ['autoplay', '', autoplay],
  ]
  return all.filter(([, , told]) => told).map(([name, value]) => [name, value])
}

/** The address that an iframe shows. */
export function addressOf({ page }: Elsewhere, embedding: Embedding, link: string): string {
  const query = ['embed', ...optionsOf(embedding).map(([name, value]) => (value ? `${name}=${value}` : name))]
  return `${page}?${query.join('&')}${link}`
}

export const iframeOf = (elsewhere: Elsewhere, embedding: Embedding, link: string, title: string): string =>
  `<iframe src="${escaped(addressOf(elsewhere, embedding, link))}" width="${embedding.width}" height="${embedding.height}" title="${escaped(title)}" style="border: 0" loading="lazy"></iframe>`

export function elementOf({ element }: Elsewhere, embedding: Embedding, link: string): string {
  const options = optionsOf(embedding).map(([name, value]) => (value ? ` ${name}="${value}"` : ` ${name}`))
  const size = `style="width: ${embedding.width}px; height: ${embedding.height}px"`
  return `<script src="${escaped(element)}" async></script>\n<forage-run src="${escaped(link)}"${options.join('')} ${size}></forage-run>`
}

/** The page in one file, with a run to begin with. */
export function withLink(page: string, link: string): string {
  const place = ' data-link=""'
  const at = page.indexOf(place)
  if (at < 0) throw new Error('the file has no place for a link')
  return `${page.slice(0, at)} data-link="${escaped(link)}"${page.slice(at + place.length)}`
}
