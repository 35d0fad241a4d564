import { expect, test, vi } from 'vitest'
import { LARGEST, nameOf, shortened } from './large-links'

const kept = vi.hoisted(() => new Map<string, string>())
vi.mock('./kept-scenes', () => ({ keep: async (name: string, text: string) => kept.set(name, text) }))

test('every scene of a long address is kept apart, under its own name; a short address stays as it is', async () => {
  const scenes = ['~a', '~b', '~c'].map((begin) => begin + 'x'.repeat(LARGEST / 2))
  const [all, own, other] = scenes.map((scene) => `@${nameOf(scene)}`)
  const address = (first = '', second = '', third = ''): string =>
    `#compare&scene=${first}&with=pso;@=${second};w=0.5,wpso,pso;@=${third}&n=20`
  expect(shortened(address(...scenes))).toBe(address(all, own, other))
  await vi.waitFor(() => expect(kept).toEqual(new Map(scenes.map((scene) => [nameOf(scene), scene]))))
  const short = address('~a', '~b', 'sphere')
  expect(shortened(short)).toBe(short)
  // A scene that ships has a name already.
  expect(shortened(address(scenes[0], 'sphere', scenes[2]))).toBe(address(all, 'sphere', other))
})
