import { violations } from './support/axe'
import { linkTo, sceneOf, verified } from './support/core'
import { en, expect, test, pick } from './support/lab'

const screens = { desktop: { width: 1440, height: 900 }, phone: { width: 390, height: 844 } }

for (const colorScheme of ['light', 'dark'] as const) {
  for (const [screen, viewport] of Object.entries(screens)) {
    test.describe(`${screen}, ${colorScheme}`, () => {
      test.use({ colorScheme, viewport, hasTouch: screen === 'phone' })

      test('axe finds nothing wrong with any part of the page', {
        tag: screen === 'desktop' && colorScheme === 'light' ? ['@smoke'] : [],
      }, async ({ lab, page }) => {
        await lab.open(linkTo({}, 40))
        await lab.settled(40)
        for (const id of ['inspect', 'formulas']) await lab.section(id)
        expect(await violations(lab)).toEqual([])
        for (const id of ['chart', 'readings', 'result']) await lab.section(id)
        await page.getByText('The curve as a table').click()
        expect(await violations(lab)).toEqual([])
        for (const id of ['parameters', 'scene']) await lab.section(id)
        for (const about of await page.locator('[data-parameter] button[aria-expanded]').all()) await about.click()
        const field = page.getByLabel('Inertia weight at the start', { exact: true })
        await field.fill('7')
        await field.press('Enter')
        await expect(page.locator('[data-parameter="w_max"]').getByRole('alert')).toBeVisible()
        expect(await violations(lab)).toEqual([])

        await pick(page, 'scene', 'ackley')
        await expect.poll(() => lab.iteration()).toBeLessThan(40)
        expect(await violations(lab)).toEqual([])

        await lab.choose('export')
        await expect(page.getByTestId('export-dialog')).toBeVisible()
        expect(await violations(lab)).toEqual([])
      })

      test('axe finds nothing wrong with a grid, its fields, a particle’s leap and the drive; nothing is too wide', async ({
        lab,
        page,
      }) => {
        await lab.open(linkTo({ planner: 'ltqpso', scene: 'qpso-10m' }, 10))
        await lab.settled(10)
        await page.getByTestId('tool-paint').click()
        for (const id of ['result', 'inspect', 'parameters', 'scene', 'drive']) {
          await lab.section(id)
          expect(await violations(lab), id).toEqual([])
        }
        if (screen === 'phone') await lab.peek()
        await page.getByTestId('tool-paint').click()
        await lab.section('drive')

        await page.getByTestId('drive-begin').click()
        await expect(page.getByTestId('drive-bar')).toBeVisible()
        await page.getByTestId('drive-play').click()
        for (const details of await page.getByTestId('drive').locator('details > summary').all()) await details.click()
        expect(await violations(lab)).toEqual([])
        expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(viewport.width)
        await page.getByTestId('drive-leave').click()
        await expect(page.getByTestId('drive-bar')).toHaveCount(0)
      })

      test('axe finds nothing wrong with ants, a cell that is looked at and an unfolded iteration; nothing is too wide', async ({
        lab,
        page,
      }) => {
        await lab.open(linkTo({ planner: 'aco-direction', scene: 'wolf-ant-20' }, 12))
        await lab.settled(12)
        await page.getByTestId('tool-cells').click()
        await lab.stage.focus()
        await page.keyboard.press('ArrowDown')
        await page.keyboard.press('Space')
        await expect(page.getByTestId('cell-card')).toBeVisible()
        await expect(page.getByTestId('inspect').getByTestId('compass')).toBeVisible()
        expect(await violations(lab)).toEqual([])

        if (screen === 'phone') await lab.peek()
        await page.getByTestId('unfold').click()
        await expect(page.getByTestId('walk-bar')).toBeVisible()
        await page.getByTestId('walk-play').click()
        expect(await violations(lab)).toEqual([])
        expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(viewport.width)
        if (screen !== 'phone') return
        const low = await page
          .getByTestId('walk-bar')
          .locator('button, input[type=range]')
          .evaluateAll((controls) => controls.filter((control) => control.getBoundingClientRect().height < 43.5).length)
        expect(low).toBe(0)
      })

      test('axe finds nothing wrong with a tuning, a map that was read and a random one; nothing is too wide or too low', async ({
        lab,
        page,
      }) => {
        const wrong = async (): Promise<string[]> => {
          const width = await page.evaluate(() => document.documentElement.scrollWidth)
          const low = await page
            .locator('[data-testid="tuned"], [data-testid="imported"], dialog')
            .locator('button, select, input:not([type=checkbox])')
            .evaluateAll((controls) =>
              controls.filter((control) => control.getBoundingClientRect().height < 43.5).map((control) => control.outerHTML),
            )
          return [...(await violations(lab)), ...(width > viewport.width ? [`${width} wide`] : []), ...(screen === 'phone' ? low : [])]
        }
        const params = { population: 3, seeds: 1, colony_iterations: 5 }
        await lab.open(linkTo({ planner: 'pso-tuning', scene: 'wolf-ant-20', params }, 2))
        await lab.settled(2)
        await lab.tab('chart')
        await expect(page.getByTestId('tuned')).toBeVisible()
        expect(await wrong()).toEqual([])
        await lab.section('parameters')
        await page.locator('[data-parameter="tune"] button[aria-expanded]').click()
        expect(await wrong()).toEqual([])

        await lab.section('scene')
        const map = Buffer.from('type octile\nheight 2\nwidth 3\nmap\n..@\n...\n')
        await page.getByTestId('scene-file').setInputFiles({ name: 'nook.map', mimeType: 'text/plain', buffer: map })
        await expect(page.getByTestId('imported')).toBeVisible()
        expect(await wrong()).toEqual([])

        await page.getByTestId('generate').click()
        await expect(page.getByTestId('map-preview')).toBeVisible()
        expect(await wrong()).toEqual([])
      })
    })
  }
}

test('the state is told to those who don’t see it', async ({ lab, page }) => {
  await lab.open(linkTo({}, 500))
  await lab.settled(500)
  await expect(page.locator('[aria-live="polite"], [role="status"]').filter({ hasText: /500/ }).first()).toContainText(/12\.\d+/)
})

test.describe('on a phone', () => {
  test.use({ viewport: screens.phone, hasTouch: true, isMobile: true })

  test('the stage comes first, then the time, and nothing is wider than the screen', { tag: '@smoke' }, async ({ lab, page }) => {
    await lab.open(linkTo({}, 40))
    await lab.settled(40)
    const stage = await lab.stage.boundingBox()
    const play = await lab.button(en.transport.play).boundingBox()
    const panels = await page.getByTestId('column').boundingBox()
    if (!stage || !play || !panels) throw new Error('something is missing')
    expect(stage.y).toBeLessThan(200)
    expect(stage.height).toBeGreaterThan(250)
    expect(play.y).toBeGreaterThan(stage.y + stage.height - 1)
    expect(panels.y).toBeGreaterThan(play.y)
    for (const id of ['parameters', 'scene', 'result', 'readings', 'chart']) {
      await lab.section(id)
      expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(390)
    }
  })

  test('whatever is touched is at least 44 pixels high', { tag: '@smoke' }, async ({ lab, page }) => {
    await lab.open(linkTo({}, 40))
    await lab.settled(40)
    for (const id of ['parameters', 'scene', 'result', 'readings', 'chart']) {
      await lab.section(id)
      const small = await page.evaluate(() =>
        [...document.querySelectorAll<HTMLElement>('button, select, summary, input:not([type=checkbox], [type=radio], [hidden])')]
          .map((element) => ({
            what: element.getAttribute('aria-label') ?? element.id + element.textContent,
            box: element.getBoundingClientRect(),
          }))
          .filter(({ box }) => box.width > 0 && box.height < 43.5)
          .map(({ what, box }) => `${what}: ${box.height}`),
      )
      expect(small, id).toEqual([])
    }
  })

  test('a touch plays and pauses, and a finger drags a disc', async ({ lab, page }) => {
    await lab.open(linkTo({}, 40))
    await lab.settled(40)
    await lab.button(en.transport.play).tap()
    await expect.poll(() => lab.iteration()).toBeGreaterThan(42)
    await lab.button(en.transport.pause).tap()
    await lab.settled()

    const scene = sceneOf({})
    if (scene.kind !== 'discs') throw new Error(scene.kind)
    const [disc] = scene.discs
    const { x, y } = await lab.whereIs(scene, disc?.center ?? [0, 0])
    const finger = await page.context().newCDPSession(page)
    await finger.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints: [{ x, y }] })
    for (let at = 5; at <= 40; at += 5) {
      await finger.send('Input.dispatchTouchEvent', { type: 'touchMove', touchPoints: [{ x: x + at, y }] })
    }
    await finger.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] })
    await lab.restarted()
    const moved = verified(await lab.link(await lab.seek(4))).scene
    expect(moved.kind === 'discs' && (moved.discs[0]?.center[0] ?? 0) - (disc?.center[0] ?? 0)).toBeGreaterThan(0.5)
  })
})
