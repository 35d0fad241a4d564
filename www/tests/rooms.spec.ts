import { learn as text } from '../src/locales/en/learn'
import { FAMILIES } from '../src/catalogue/families'
import { STANDARD } from '../src/catalogue/standard'
import { violations } from './support/axe'
import { hashOf, linkTo, sceneOf, verified } from './support/core'
import { en, expect, pick, test } from './support/lab'

const PARTICLE = `${linkTo({ planner: 'pso', params: { population: 20 } }, 40)}&page.item=particles.17`

const ROOMS = {
  learn: '#view=learn',
  lab: PARTICLE,
  'lab on a grid': linkTo({ planner: 'aco-wolf', scene: 'ant-bat-30' }, 4),
  'lab in space': linkTo({ planner: 'rrt-guided', scene: 'arm-cuboid' }, 40),
  compare: '#view=compare',
  statistics: '#view=compare&as=statistics',
  papers: '#view=papers',
}

const WIDTHS = [320, 390, 540, 720, 781, 900, 901, 1024, 1280, 1440, 1920, 2560]

for (const [room, address] of Object.entries(ROOMS)) {
  test(`nothing scrolls sideways from 320 to 2560 px: ${room}`, async ({ lab, page }) => {
    await page.setViewportSize({ width: 320, height: 800 })
    await lab.open(address)
    for (const width of WIDTHS) {
      await page.setViewportSize({ width, height: 800 })
      const wide = (): Promise<string[]> =>
        page.evaluate(() =>
          [document.documentElement, ...document.querySelectorAll('header, main, aside, main > *')]
            .filter((node) => node.scrollWidth > node.clientWidth + 1 && getComputedStyle(node).overflowX !== 'hidden')
            .filter((node) => node === document.documentElement || node.clientWidth > 0)
            .map(({ tagName, className, scrollWidth, clientWidth }) => `${tagName}.${className}: ${scrollWidth} > ${clientWidth}`),
        )
      await expect.poll(wide, `${room}, ${width} px`).toEqual([])
    }
  })

  test(`texts at 200 % fit: ${room}`, async ({ lab, page }) => {
    await page.setViewportSize({ width: 1280, height: 800 })
    await lab.open(address)
    const browser = await page.context().newCDPSession(page)
    await browser.send('Page.setFontSizes', { fontSizes: { standard: 32, fixed: 26 } })
    await expect.poll(() => page.evaluate(() => Number.parseFloat(getComputedStyle(document.documentElement).fontSize))).toBe(32)
    for (const width of [1280, 768, 390, 320]) {
      await page.setViewportSize({ width, height: 800 })
      await expect.poll(() => page.evaluate(() => document.documentElement.scrollWidth), String(width)).toBeLessThanOrEqual(width)
      // What leads elsewhere is in view as a whole, and a stage is large enough to see something.
      const cut = (): Promise<string[]> =>
        page.locator('header button, nav button, [role="tab"]').evaluateAll((buttons) =>
          buttons
            .filter((button) => button.checkVisibility())
            .filter((button) => button.getBoundingClientRect().right > innerWidth + 1 || button.scrollWidth > button.clientWidth + 1)
            .map(({ textContent, ariaLabel }) => ariaLabel ?? textContent),
        )
      await expect.poll(cut, String(width)).toEqual([])
      if (room.startsWith('lab')) await expect.poll(async () => (await lab.stage.boundingBox())?.height, String(width)).toBeGreaterThan(180)
    }
  })
}

for (const [width, height] of [
  [1366, 768],
  [390, 844],
] as const) {
  test(`the explanation is in view after a click, ${width} × ${height}`, async ({ lab, page }) => {
    await page.setViewportSize({ width, height })
    const setup = { planner: 'pso', params: { population: 17 } }
    await lab.open(linkTo(setup, 0))
    await lab.settled(0)
    // The middle of some particle's path.
    await lab.stage.focus()
    const box = await lab.stage.boundingBox()
    if (!box) throw new Error('no stage')
    const heading = page.getByTestId('inspect').getByRole('heading', { name: /^Particle \d+$/ })
    for (let at = 1; at < 20 && !(await heading.isVisible()); at += 1) {
      await page.mouse.click(box.x + box.width * (0.3 + 0.02 * at), box.y + box.height * 0.5)
      await page.waitForTimeout(150)
    }
    await expect(heading).toBeInViewport()
    await expect(page.getByTestId('inspect').locator('.summary')).toBeInViewport({ ratio: 1 })
    // So is what it is about.
    await expect(lab.stage).toBeInViewport()
    expect((await lab.stage.boundingBox())?.height).toBeGreaterThan(150)
  })
}

test('a newcomer sees a swarm at work, drags a disc, and finds six families', async ({ lab, page }) => {
  await lab.open('')
  await expect(page.getByRole('heading', { name: text.title })).toBeVisible()
  await expect.poll(() => lab.iteration()).toBeGreaterThan(3)
  const disc = sceneOf({ scene: STANDARD.scene })
  if (disc.kind !== 'discs' || !disc.discs[0]) throw new Error('no discs')
  await lab.dragFrom(await lab.whereIs(disc, disc.discs[0].center, true), 30, 10)
  await expect(page.getByText(text.dragged)).toBeVisible()
  await expect.poll(() => lab.iteration()).toBeGreaterThan(3)
  // A clicked particle has a sentence, and a way on.
  await lab.press(en.transport.pause)
  await lab.settled()
  await lab.stage.click({ position: { x: 5, y: 5 } })
  const goal = await lab.whereIs(disc, disc.goal, true)
  await page.mouse.click(goal.x - 16, goal.y + 16)
  await expect(page.getByTestId('learn-sentence')).toContainText(/^Particle \d+/)
  await page.getByTestId('learn-why').click()
  await expect(page.getByTestId('inspect').getByRole('heading', { level: 2 })).toHaveText(/^Particle \d+$/)
  await page.goBack()
  for (const { name } of FAMILIES) {
    const card = page.getByTestId(`family-${name}`)
    await card.scrollIntoViewIfNeeded()
    await expect(card.locator('canvas')).toHaveAttribute('data-drawn', 'true')
    const picture = await card.getAttribute('data-picture')
    await expect(card).not.toHaveAttribute('data-picture', picture ?? '')
  }
  await page.getByTestId('learn-open').click()
  await expect(page.getByTestId('planner')).toHaveAttribute('data-value', STANDARD.planner)
  await page.goBack()
  await page.getByTestId('family-ants').click()
  await expect(page).toHaveURL(/planner=aco&/)
  await expect(page.getByTestId('planner')).toHaveAttribute('data-value', 'aco')
  await page.goBack()
  await expect(page.getByRole('heading', { name: text.title })).toBeVisible()
})

test.describe('with less motion', () => {
  test.use({ contextOptions: { reducedMotion: 'reduce' } })

  test('cards stand still', async ({ lab, page }) => {
    await lab.open('')
    for (const { name, pictures } of FAMILIES) {
      const card = page.getByTestId(`family-${name}`)
      await card.scrollIntoViewIfNeeded()
      await expect(card).toHaveAttribute('data-picture', String(pictures - 1))
    }
    expect(await lab.iteration()).toBe(0)
  })
})

test('older addresses lead to their heirs', async ({ lab, page }) => {
  await lab.open('#view=race&scene=wcpso-discs&seed=3&with=pso,wpso&at=600')
  await expect(page.getByTestId('race')).toHaveAttribute('data-still', 'true')
  await expect(page).toHaveURL(/#view=compare&as=watch&scene=wcpso-discs&seeds=3-\d+&budget=own&with=pso,wpso&at=600$/)
  await lab.open('#view=batch&scene=wcpso-discs&seeds=2-5&limit=30&with=pso')
  await expect(page).toHaveURL(/#view=compare&as=statistics&scene=wcpso-discs&seeds=2-5&budget=own&with=pso;iterations=30$/)
  await lab.open('#view=stage')
  await expect(lab.stage).toBeVisible()
  await expect(page.getByTestId('tab-setup')).toBeVisible()
})

test('a presentation goes by keyboard and clicker alone', async ({ lab, page }) => {
  await lab.open(PARTICLE)
  await lab.settled(40)
  const letters = await page.evaluate(() => Number.parseFloat(getComputedStyle(document.body).fontSize))
  await page.keyboard.press('p')
  await expect(page.getByTestId('lab')).toHaveAttribute('data-presenting', 'true')
  await expect(page.getByTestId('present-sentence')).toContainText('Particle 17')
  await expect(page.getByRole('navigation')).toHaveCount(0)
  expect(await page.evaluate(() => Number.parseFloat(getComputedStyle(document.body).fontSize))).toBeCloseTo(1.8 * letters, 3)
  await expect(page.getByTestId('tab-setup')).toBeHidden()
  await page.keyboard.press('PageDown')
  expect(await lab.settled(41)).toBe(hashOf({ planner: 'pso', params: { population: 20 } }, 41))
  await page.keyboard.press('PageUp')
  await lab.settled(40)
  await page.keyboard.press('q')
  await expect(page.getByTestId('present-qr').locator('path')).toHaveAttribute('d', /^M/)
  expect(await violations(lab)).toEqual([])
  await page.keyboard.press('b')
  await expect(page.getByTestId('present-blank')).toBeVisible()
  await page.keyboard.press('Escape')
  await expect(page.getByTestId('present-blank')).toHaveCount(0)
  await expect(page.getByTestId('present-qr')).toHaveCount(0)
  await page.keyboard.press('Space')
  await expect.poll(() => lab.iteration()).toBeGreaterThan(41)
  await page.keyboard.press('Space')
  await page.keyboard.press('p')
  await expect(page.getByTestId('lab')).toHaveAttribute('data-presenting', 'false')
  expect(verified(await lab.link(await lab.settled())).planner).toBe('pso')
})

test('bookmarks are in the link, on the timeline and under the digits of a presentation', async ({ lab, page }) => {
  await lab.open(`${PARTICLE}&page.marks=10,90`)
  await lab.settled(40)
  await page.keyboard.press('m')
  await expect(page.getByTestId('bookmark')).toHaveAttribute('aria-pressed', 'true')
  await expect(page.getByTestId('bookmarks').getByRole('button')).toHaveText(['1', '2', '3'])
  await page.getByRole('button', { name: en.transport.bookmark('1', '10') }).click()
  await lab.settled(10)
  await page.keyboard.press('p')
  await expect(page.getByTestId('present-end')).toBeVisible()
  await page.keyboard.press('2')
  await lab.settled(40)
  await page.keyboard.press('3')
  await lab.settled(90)
  await page.keyboard.press('4')
  await page.keyboard.press('m')
  await expect(page.getByTestId('bookmarks').getByRole('button')).toHaveText(['1', '2'])
  await expect.poll(() => page.url()).toContain('page.marks=10,40')
  await page.keyboard.press('Escape')
  // Another planner has others.
  await pick(page, 'planner', 'qpso')
  await expect(page.getByTestId('bookmarks')).toHaveCount(0)
})

for (const scheme of ['light', 'dark'] as const) {
  for (const [width, height] of [
    [1440, 900],
    [390, 844],
  ] as const) {
    test(`axe finds nothing wrong in any room, in the tabs and in a list that is open, ${scheme}, ${width} px`, async ({ lab, page }) => {
      await page.emulateMedia({ colorScheme: scheme, reducedMotion: 'reduce' })
      await page.setViewportSize({ width, height })
      await lab.open('')
      await expect(page.getByTestId('family-arm')).toBeVisible()
      expect(await violations(lab)).toEqual([])
      await lab.open(PARTICLE)
      for (const tab of ['explain', 'chart', 'setup'] as const) {
        await lab.tab(tab)
        expect(await violations(lab), tab).toEqual([])
      }
      // In a wide window it is above the stage, otherwise on the last tab.
      await page.getByTestId('planner').click()
      await page.keyboard.type('ants')
      await expect(page.locator('.picker-list [data-option="aco"]')).toBeVisible()
      expect(await violations(lab), 'list').toEqual([])
      await page.keyboard.press('Escape')
      await lab.open('#view=papers')
      await expect(page.locator('details[id^="claim-"]').nth(4)).toBeVisible()
      await page.locator('details[id^="claim-"] > summary').first().click()
      expect(await violations(lab), 'papers').toEqual([])
      await lab.open('#view=compare')
      await expect(page.getByTestId('compare-scene')).toBeVisible()
      expect(await violations(lab), 'compare').toEqual([])
    })
  }
}

test('rooms, panels and dialogs that are left keep nothing of the page', async ({ lab, page }) => {
  test.setTimeout(120_000)
  const devtools = await page.context().newCDPSession(page)
  const kept = async (): Promise<number> => {
    for (let k = 0; k < 3; k += 1) await devtools.send('HeapProfiler.collectGarbage')
    const { nodes } = (await devtools.send('Memory.getDOMCounters')) as { nodes: number }
    return nodes
  }
  const round = async (): Promise<void> => {
    for (const room of ['learn', 'compare', 'workshop', 'papers', 'lab']) {
      await page.getByTestId(`view-${room}`).click()
      await expect(page).toHaveURL(room === 'lab' ? /#v=1/ : new RegExp(`view=${room}`))
      await page.waitForTimeout(150)
    }
    for (const tab of ['explain', 'chart', 'setup'] as const) await lab.tab(tab)
    for (const dialog of ['export', 'keys'] as const) {
      await lab.choose(dialog)
      await page.locator('dialog[open], [role=dialog]').first().waitFor()
      await page.keyboard.press('Escape')
      await expect(page.locator('dialog[open], [role=dialog]')).toHaveCount(0)
    }
  }
  await lab.open(PARTICLE)
  for (let k = 0; k < 6; k += 1) await round()
  const before = await kept()
  for (let k = 0; k < 5; k += 1) await round()
  // Each room has some 2,000.
  expect(await kept()).toBeLessThan(before + 500)
})
