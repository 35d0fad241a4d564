import { readFileSync } from 'node:fs'
import { expect, test } from 'vitest'
import { catalogue } from '../../../pkg/node.js'
import { caseOf, claimsOf } from '../../src/rooms/papers/claims'
import { offered } from '../../src/rooms/papers/cases'
import { hashOf } from '../../tests/support/core'

const FILE = 'REPRODUCTION.claims.json'

test('every run of every claim on a shipped scene starts', () => {
  const { claims } = claimsOf(readFileSync(new URL(`../../../${FILE}`, import.meta.url), 'utf8'), FILE)
  const known = catalogue()
  const cases = claims.flatMap(({ id, parts }) => parts.map((part) => ({ id, on: caseOf(part) })))
  expect(cases.filter(({ on }) => on !== null).length).toBeGreaterThan(100)
  for (const { id, on } of cases) {
    if (on === null) continue
    expect(offered(known, on), `${id}: ${on.scene}`).toBe(true)
    for (const { planner, params } of on.runs) expect(hashOf({ planner, params, scene: on.scene }, 0)).toMatch(/^[0-9a-f]{16}$/)
  }
})
