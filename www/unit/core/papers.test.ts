import { expect, test } from 'vitest'
import { catalogue } from '../../../pkg/node.js'
import { EXPERIMENTS, offered } from '../../src/papers/experiments'
import { hashOf } from '../../tests/support/core'

test('every experiment of a paper runs here', () => {
  const known = catalogue()
  for (const experiment of Object.values(EXPERIMENTS).flat()) {
    for (const on of experiment.cases) {
      expect(offered(known, on), `${experiment.name}: ${on.scene}`).toBe(true)
      for (const { planner, params } of on.runs) expect(hashOf({ planner, params, scene: on.scene }, 0)).toMatch(/^[0-9a-f]{16}$/)
    }
  }
})
