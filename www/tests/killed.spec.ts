import type { Point } from '../../pkg/node.js'
import { hashOf, linkTo, sceneOf, verified } from './support/core'
import { en, expect, pick, test } from './support/lab'
import { watchThreads } from './support/monkey'

/*
 * The thread of a run is ended at random moments: while it plays, seeks, steps or restarts. The page says so, and after a restart all that
 * was made is there: planner, parameters, seed, the edited scene. KILLED=9 is another seed, KILLS=50 as many of them.
 */

const KILLS = Number(process.env.KILLS ?? 5)

test('a thread that is ended at a random moment takes nothing along that was made', { tag: '@smoke' }, async ({ lab, page }) => {
  test.setTimeout(30_000 + KILLS * 15_000)
  let state = Number(process.env.KILLED ?? 27)
  const below = (n: number): number => {
    state = (Math.imul(state, 1_103_515_245) + 12_345) >>> 0
    return Math.floor((state / 2 ** 32) * n)
  }
  await watchThreads(page)
  await lab.open(linkTo({}, 20))
  await lab.settled(20)
  const shipped = sceneOf({})
  const disc: Point = shipped.kind === 'discs' ? (shipped.discs[0]?.center ?? [0, 0]) : [0, 0]
  await lab.dragFrom(await lab.whereIs(shipped, disc), 60, -30)
  await lab.restarted()
  const { scene } = verified(await lab.link(await lab.settled(20)))
  expect(scene).not.toEqual(shipped)

  let [planner, population, seed] = ['wcpso', 0, 1]
  const actions = ['play', 'seek', 'step', 'population', 'seed', 'planner']
  for (let kill = 0; kill < KILLS; kill += 1) {
    const action = actions[(kill + below(2)) % actions.length] ?? ''
    await test.step(`${action}, then its end`, async () => {
      if (action === 'play') await lab.press(en.transport.play)
      else if (action === 'seek') await lab.timeline.fill(String(below(500)))
      else if (action === 'step') await page.getByTestId('step-forward').click()
      else if (action === 'population') {
        population = 5 + below(50)
        const parameters = await lab.section('parameters')
        await parameters.locator('[data-parameter="population"] input.typed').fill(String(population))
        await page.keyboard.press('Enter')
      } else if (action === 'seed') {
        seed = 1 + below(1000)
        await page.getByTestId('seed').fill(String(seed))
        await page.keyboard.press('Enter')
      } else {
        planner = planner === 'pso' ? 'wcpso' : 'pso'
        await pick(page, 'planner', planner)
      }
      await page.waitForTimeout(below(300))
      await page.evaluate(() => {
        const thread = [...(window.liveThreads ?? [])].find((one) => one.name.includes('run.worker'))
        if (!thread) throw new Error('no thread of a run')
        thread.terminate()
        thread.dispatchEvent(new ErrorEvent('error', { message: 'out of memory', cancelable: true }))
      })
      await expect(page.getByTestId('crash')).toContainText('out of memory')
      await page.getByTestId('recover').click()
      await expect(lab.root).toHaveAttribute('data-phase', 'ready')
      const params: Record<string, number> = population > 0 ? { population } : {}
      expect(await lab.seek(15)).toBe(hashOf({ planner, params, seed, scene }, 15))
    })
  }
})
