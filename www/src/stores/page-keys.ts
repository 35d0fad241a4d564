import type { Item, Point, Point3 } from 'forage-lab'
import { MOST_BOOKMARKS } from './bookmarks.svelte'
import { type Tab, TABS } from './column.svelte'

/* Keys of a link that say how the page shows the run. The core skips all that begin with `page.`. */

/** Of a scene in space: what is looked at, how far away, and from where, in degrees about z from x and above the floor. */
export interface SpaceCamera {
  target: Point3
  distance: number
  azimuth: number
  elevation: number
}

/** Of the plane: the middle of what is seen, and how many times larger it is than with the whole scene in view. */
export interface PlaneCamera {
  center: Point
  zoom: number
}

export type Camera = PlaneCamera | SpaceCamera

export interface PageKeys {
  /** The item that is explained. */
  item: Item | null
  camera: Camera | null
  /** Layers that are shown or hidden although their standard is otherwise. */
  layers: Readonly<Record<string, boolean>>
  /** What the column holds, where it is not what it holds first. */
  tab: Tab | null
  /** Iterations to come back to. */
  marks: readonly number[]
}

export const NO_KEYS: PageKeys = { item: null, camera: null, layers: {}, tab: null, marks: [] }

const PREFIX = 'page.'
/** Of more no link is made. */
const MOST_LAYERS = 64
const NAME = /^[a-z][a-z0-9-]{0,63}$/
/** Digits of a coordinate: finer than a pixel of any stage. */
const DIGITS = 6

const brief = (value: number): string => String(Number(value.toPrecision(DIGITS)))

/** As they are added to a link. */
export function writePageKeys({ item, camera, layers, tab, marks }: PageKeys): string {
  const entries: [string, string][] = []
  if (item) entries.push(['item', `${item.role}.${item.index}`])
  if (camera) entries.push(['camera', numbersOf(camera).map(brief).join()])
  const changed = Object.entries(layers)
  if (changed.length > 0) entries.push(['layers', changed.map(([role, on]) => (on ? role : `-${role}`)).join()])
  if (tab) entries.push(['tab', tab])
  if (marks.length > 0) entries.push(['marks', marks.join()])
  return entries.map(([key, value]) => `&${PREFIX}${key}=${value}`).join('')
}

const numbersOf = (camera: Camera): number[] =>
  'zoom' in camera ? [...camera.center, camera.zoom] : [...camera.target, camera.distance, camera.azimuth, camera.elevation]

/** What a link says; what cannot be read is left out, for the run matters more. */
export function readPageKeys(link: string): PageKeys {
  const pairs = link.split('&').map((pair) => pair.split('=') as [string, string?])
  const read = (key: string): string => decoded(pairs.find(([name]) => name === PREFIX + key)?.[1] ?? '')
  const tab = TABS.find((known) => known === read('tab')) ?? null
  return {
    item: itemOf(read('item')),
    camera: cameraOf(read('camera')),
    layers: layersOf(read('layers')),
    tab,
    marks: marksOf(read('marks')),
  }
}

function decoded(value: string): string {
  try {
    return decodeURIComponent(value)
  } catch {
    return ''
  }
}

function itemOf(value: string): Item | null {
  const [, role = '', digits = ''] = /^(.+)\.(\d{1,15})$/.exec(value) ?? []
  return NAME.test(role) ? ({ role, index: Number(digits) } as Item) : null
}

const marksOf = (value: string): number[] =>
  value
    .split(',')
    .slice(0, MOST_BOOKMARKS)
    .filter((part) => /^\d{1,7}$/.test(part))
    .map(Number)

function cameraOf(value: string): Camera | null {
  const numbers = value.split(',').map((part) => (part === '' ? Number.NaN : Number(part)))
  if (!numbers.every(Number.isFinite)) return null
  const [x = 0, y = 0, third = 0, fourth = 0, azimuth = 0, elevation = 0] = numbers
  if (numbers.length === 3) return third > 0 ? { center: [x, y], zoom: third } : null
  if (numbers.length === 6) return fourth > 0 ? { target: [x, y, third], distance: fourth, azimuth, elevation } : null
  return null
}

function layersOf(value: string): Record<string, boolean> {
  const all = value.split(',').slice(0, MOST_LAYERS)
  const named = all.map((entry): [string, boolean] => (entry.startsWith('-') ? [entry.slice(1), false] : [entry, true]))
  return Object.fromEntries(named.filter(([role]) => NAME.test(role)))
}
