import { expect, test } from 'vitest'
import { Requests } from './requests'

test('a request is replaced by a newer one about the same subject, and by no other', () => {
  const requests = new Requests<'run' | 'scene' | 'item'>()
  const scene = requests.note('scene')
  expect(requests.replaced(scene, 'scene', 'run', 'item')).toBe(false)
  const run = requests.note('run')
  expect(run).toBeGreaterThan(scene)
  expect([requests.replaced(scene, 'scene'), requests.replaced(run, 'run')]).toEqual([false, false])
  // One of them is enough.
  expect(requests.replaced(scene, 'scene', 'run')).toBe(true)
  const both = requests.note('scene', 'item')
  expect([requests.replaced(scene, 'scene'), requests.replaced(run, 'run'), requests.replaced(run, 'item')]).toEqual([true, false, true])
  expect(requests.replaced(both, 'scene', 'item')).toBe(false)
})
