import { expect, test } from 'vitest'
import { catalogue, type FormulaScene, Session } from '../../../pkg/node.js'
import { SYNTAX } from '../../src/catalogue/syntax'
import { extent } from '../../src/render/view'
import { EXAMPLES } from '../../src/scene/functions'

const sceneOf = (of: Omit<FormulaScene, 'format' | 'version' | 'kind'>): FormulaScene => ({
  format: 'forage-scene',
  version: 1,
  kind: 'function',
  ...of,
})

const open = (of: Omit<FormulaScene, 'format' | 'version' | 'kind'>, params = {}) =>
  new Session({ planner: 'pso', scene: sceneOf(of), params, seed: 1 })

test('each example is a function whose minimum is where it is said to be', () => {
  expect(new Set(EXAMPLES.map(({ name }) => name)).size).toBe(EXAMPLES.length)
  for (const example of EXAMPLES) {
    // The core compares the value at the position with the stated one.
    const session = open(example)
    session.step(1e9)
    const { cost, exact, exact_by, status } = session.outcome()
    const minimum = typeof example.optimum === 'object' ? example.optimum.value : example.optimum
    expect([example.name, status, exact]).toEqual([example.name, 'exhausted', minimum ?? null])
    if (minimum === undefined) continue
    // A swarm may miss it, and nothing is below it.
    expect(exact_by).toBe('stored')
    expect((cost ?? Infinity) - minimum).toBeGreaterThan(-1e-4 * Math.max(1, Math.abs(minimum)))
    session.free()
  }
})

test('examples that ship as test functions are the same ones', () => {
  for (const scene of catalogue().scenes) {
    if (scene.kind !== 'function' || 'expression' in scene || scene.dimension !== 2) continue
    const example = EXAMPLES.find(({ name }) => name === scene.function)
    expect(example, scene.function).toBeDefined()
    if (!example) continue
    expect(extent(sceneOf(example))).toEqual(extent(scene))
    const params = { iterations: 30 }
    const [named, written] = [new Session({ planner: 'pso', scene, params, seed: 1 }), open(example, params)]
    for (const session of [named, written]) session.step(30)
    expect(written.outcome().cost).toBeCloseTo(named.outcome().cost ?? NaN, 12)
  }
})

test('the reference lists all functions that the core knows, and what it lists can be used', () => {
  const unknown = (): string => {
    try {
      return String(open({ name: 'a', title: 'A', expression: 'nothing(x)', dimension: 1, bounds: { min: 0, max: 1 } }))
    } catch (error) {
      return (error as Error).message
    }
  }
  const known = /known: (.*)$/.exec(unknown())?.[1]?.split(', ') ?? []
  expect([...SYNTAX.functions].sort()).toEqual(known.filter((name) => !['sum', 'prod', 'if'].includes(name)).sort())
  const { variables, numbers, sums, choices } = SYNTAX
  const whole = [...variables.filter((name) => name !== 'x[i]'), ...numbers, ...sums, ...choices.filter((choice) => /x/.test(choice))]
  for (const expression of whole) open({ name: 'a', title: 'A', expression, dimension: 3, bounds: { min: 0, max: 1 } }).free()
  for (const sign of [...SYNTAX.operators, ...choices.filter((choice) => !/x/.test(choice) && choice !== '!')])
    open({ name: 'a', title: 'A', expression: `x ${sign} 2`, dimension: 1, bounds: { min: 0, max: 1 } }).free()
})
