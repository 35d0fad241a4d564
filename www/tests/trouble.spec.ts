import { hashOf, linkTo } from './support/core'
import { panels } from '../src/locales/en/panels'
import { en, expect, test, pick } from './support/lab'

test('a parameter of one kind of scene waits while another is open, and is back afterwards', async ({ lab, page }) => {
  await lab.open(linkTo({ params: { waypoints: 5, population: 40 } }, 10))
  expect(await lab.settled(10)).toBe(hashOf({ params: { waypoints: 5, population: 40 } }, 10))
  await pick(page, 'scene', 'ackley')
  expect(await lab.seek(10)).toBe(hashOf({ scene: 'ackley', params: { population: 40 } }, 10))
  await pick(page, 'planner', 'pso')
  expect(await lab.seek(10)).toBe(hashOf({ planner: 'pso', scene: 'ackley', params: { population: 40 } }, 10))
  await pick(page, 'scene', 'wcpso-discs')
  expect(await lab.seek(10)).toBe(hashOf({ planner: 'pso', params: { waypoints: 5, population: 40 } }, 10))
})

test('after the core broke down, a restart goes on with what was made', async ({ lab, page }) => {
  await page.addInitScript(() => {
    const made: Worker[] = []
    const { Worker: Real } = window
    window.Worker = class extends Real {
      constructor(url: string | URL, options?: WorkerOptions) {
        super(url, options)
        if (String(url).includes('run.worker')) made.push(this)
      }
    }
    Object.assign(window, { breakDown: () => made.at(-1)?.dispatchEvent(new ErrorEvent('error', { message: 'unreachable' })) })
  })
  await lab.open(linkTo({ params: { population: 40 } }, 20))
  const hash = await lab.settled(20)
  // In the middle of a start: the answer never comes.
  await page.getByTestId('seed').fill('9')
  await page.evaluate(() => {
    document.querySelector('[data-testid="seed"]')?.dispatchEvent(new Event('change', { bubbles: true }))
    const { breakDown } = window as unknown as { breakDown(): void }
    breakDown()
  })
  await expect(page.getByTestId('crash')).toContainText('unreachable')
  await expect(lab.button(en.transport.play)).toBeDisabled()
  await page.getByTestId('recover').click()
  await expect(lab.root).toHaveAttribute('data-phase', 'ready')
  expect(await lab.seek(20)).toBe(hashOf({ params: { population: 40 }, seed: 9 }, 20))
  await page.getByTestId('seed').fill('1')
  await page.getByTestId('seed').press('Enter')
  expect(await lab.seek(20)).toBe(hash)
  // The curve is the new thread's alone: nothing of the old one is left among its rows.
  const chart = await lab.section('chart')
  await chart.getByText(panels.chart.table).click()
  const first = chart.locator('tbody tr > :first-child')
  await expect(first.first()).toHaveText('0')
  const iterations = (await first.allTextContents()).map(Number)
  expect(iterations).toEqual([...iterations].sort((a, b) => a - b))
  expect(iterations.at(-1)).toBe(20)
})

test('where the thread that draws breaks down, or there can be none, the page draws', async ({ lab, page }) => {
  await page.addInitScript(() => {
    const { Worker: Real } = window
    window.Worker = class extends Real {
      constructor(url: string | URL, options?: WorkerOptions) {
        if (String(url).includes('render.worker') && sessionStorage.getItem('none')) throw new Error('no thread')
        super(url, options)
        if (String(url).includes('render.worker'))
          Object.assign(window, { breakDown: () => this.dispatchEvent(new ErrorEvent('error', { message: 'gone', cancelable: true })) })
      }
    }
  })
  await lab.open(linkTo({}, 20))
  const hash = await lab.settled(20)
  await page.evaluate(() => (window as unknown as { breakDown(): void }).breakDown())
  await expect.poll(async () => (await lab.picture()).colours).toBeGreaterThan(200)
  // A canvas of the page has other shades at edges than one of a thread.
  const { digest } = await lab.wholePicture()
  // Frames go on, more of them than there are buffers.
  await lab.press(en.transport.play)
  await expect.poll(() => lab.iteration()).toBeGreaterThan(40)
  await lab.press(en.transport.pause)
  expect(await lab.seek(20)).toBe(hash)
  expect((await lab.wholePicture()).digest).toBe(digest)

  // The address is not written at once.
  await expect(page).toHaveURL(/at=20&/)
  await page.evaluate(() => sessionStorage.setItem('none', 'yes'))
  await page.reload()
  await lab.settled(20)
  expect((await lab.wholePicture()).digest).toBe(digest)
})
