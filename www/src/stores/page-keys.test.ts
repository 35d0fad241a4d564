import { expect, test } from 'vitest'
import type { Item } from 'forage-lab'
import { NO_KEYS, type PageKeys, readPageKeys, writePageKeys } from './page-keys'

const item = (role: string, index: number): Item => ({ role, index }) as Item

test('what is written is read', () => {
  const keys: PageKeys = {
    item: item('personal-bests', 12),
    camera: { center: [1.5, -2.25], zoom: 3.5 },
    layers: { velocities: true, particles: false },
    tab: 'setup',
    marks: [3, 40],
  }
  const written = writePageKeys(keys)
  expect(written).toBe(
    '&page.item=personal-bests.12&page.camera=1.5,-2.25,3.5&page.layers=velocities,-particles&page.tab=setup&page.marks=3,40',
  )
  expect(readPageKeys(`#v=1&planner=wcpso${written}`)).toEqual(keys)
  expect(writePageKeys(NO_KEYS)).toBe('')
  expect(readPageKeys('#v=1&planner=wcpso')).toEqual(NO_KEYS)
})

test('a camera in space is read, too', () => {
  const camera = { target: [0.5, 0.25, 0.125] as [number, number, number], distance: 2.5, azimuth: -62, elevation: 27 }
  const written = writePageKeys({ ...NO_KEYS, camera })
  expect(written).toBe('&page.camera=0.5,0.25,0.125,2.5,-62,27')
  expect(readPageKeys(`#v=1${written}`)).toEqual({ ...NO_KEYS, camera })
})

test.each([
  'page.item=<img onerror>.1&page.camera=1,2&page.layers=',
  'page.item=particles.-1&page.camera=1,2,0&page.layers=__proto__,-constructor%00',
  'page.item=particles.1e3&page.camera=a,b,c&page.layers=%',
  'page.item=particles.9999999999999999&page.camera=1,2,3,4&page.layers=Infinity,javascript:alert(1)',
  'page.item=particles&page.camera=,,&page.layers=\u202eparticles',
])('what cannot be read is left out: %s', (keys) => {
  expect(readPageKeys(`#v=1&${keys}`)).toEqual(NO_KEYS)
  expect(({} as Record<string, unknown>).particles).toBeUndefined()
})
