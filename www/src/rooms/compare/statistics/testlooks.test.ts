import { expect, test } from 'vitest'
import type { Row } from '../../../engine/trial.protocol'
import { TestLooks } from './testlooks'

test('a test shown with fewer seeds is remembered for the same groups', () => {
  const looks = new TestLooks()
  const groups = (length: number, ...keys: string[]) =>
    keys.map((key) => ({ key, lots: true, rows: Array.from({ length }, (): Row => ({}) as Row) }))
  const at = (count: number, rows: number, ...keys: string[]) => looks.at({ from: 1, count }, groups(rows, ...keys))
  expect(at(50, 20, 'a', 'b'), 'on the way').toEqual([])
  expect(at(50, 50, 'a', 'b')).toEqual([])
  expect(at(50, 50, 'a', 'b')).toEqual([])
  expect(at(100, 70, 'a', 'b')).toEqual([50])
  expect(at(100, 100, 'a', 'b')).toEqual([50])
  expect(at(150, 150, 'a', 'c')).toEqual([50, 100])
  expect(at(20, 20, 'a', 'b'), 'fewer').toEqual([])
  expect(at(100, 100, 'c', 'd'), 'others').toEqual([])
  expect(looks.at({ from: 500, count: 200 }, groups(200, 'a', 'b')), 'other seeds').toEqual([])
  expect(looks.at({ from: 1, count: 200 }, groups(200, 'a')), 'nothing is tested').toEqual([])
})
