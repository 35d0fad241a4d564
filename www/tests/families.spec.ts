import type { UncheckedSetup } from '../../pkg/node.js'
import { hashOf, linkTo } from './support/core'
import { expect, test } from './support/lab'

/* One planner of each family, or of each kind of scene. */
const SETUPS: UncheckedSetup[] = [
  { planner: 'wcpso', scene: 'wcpso-discs', seed: 3 },
  { planner: 'pso', scene: 'rastrigin', seed: 3 },
  { planner: 'ltqpso', scene: 'qpso-10m', seed: 3 },
  { planner: 'aco-wolf', scene: 'wolf-ant-20', seed: 3 },
  { planner: 'a-star', scene: 'ant-bat-30', seed: 3 },
  { planner: 'bat', scene: 'random-52', seed: 3 },
  { planner: 'rrt-star', scene: 'discs-gate', seed: 3 },
  { planner: 'rrt-guided', scene: 'arm-cuboid', seed: 3 },
  { planner: 'wolf-ant-drive', scene: 'crossing', seed: 3 },
]

test('every family has the core’s hash, reached by a link, a seek and steps', { tag: '@smoke' }, async ({ lab, page }) => {
  for (const [at, setup] of SETUPS.entries()) {
    // No two of them stand at the same iteration.
    const iteration = 10 + 3 * at
    const name = `${setup.planner} on ${String(setup.scene)}`
    await lab.open(linkTo(setup, iteration))
    await lab.restarted()
    expect(await lab.settled(iteration), name).toBe(hashOf(setup, iteration))
    await page.getByTestId('step-forward').click()
    expect(await lab.settled(iteration + 1), name).toBe(hashOf(setup, iteration + 1))
    expect(await lab.seek(2), name).toBe(hashOf(setup, 2))
  }
})
