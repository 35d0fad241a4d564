import { test as base } from '@playwright/test'
import { expect, pick, test } from './support/lab'
import { linkTo } from './support/core'
import { behind } from './support/workshop'

/* Which language the page speaks, and that it changes while things run. */

const HAN = /[\u3400-\u9fff]/
const DRIVE = '#v=1&planner=a-star-drive&scene=crossing&seed=1&at=200'

test.describe('under a Chinese browser', () => {
  test.use({ locale: 'zh-CN' })

  test('the page is Chinese, switches, and its link and the browser remember that', { tag: '@smoke' }, async ({ lab, page }) => {
    await lab.open('')
    const html = page.locator('html')
    await expect(html).toHaveAttribute('lang', 'zh-CN')
    await expect(page).toHaveTitle(HAN)
    await expect(page.locator('link[rel=manifest]')).toHaveAttribute('href', './manifest.zh-CN.webmanifest')
    const manifest = await (await page.request.get(new URL('manifest.zh-CN.webmanifest', page.url()).href)).json()
    expect([manifest.lang, HAN.test(manifest.name), HAN.test(manifest.description)]).toEqual(['zh-CN', true, true])

    await page.getByTestId('view-lab').click()
    await expect(page.getByTestId('view-lab')).toHaveText(HAN)
    await expect(page).toHaveURL(/&page\.lang=zh-CN$/)
    await page.getByTestId('language').click()
    await expect(html).toHaveAttribute('lang', 'en')
    await expect(page.getByTestId('view-lab')).toHaveText('Lab')
    await expect(page).toHaveURL(/&page\.lang=en$/)
    await page.goto('about:blank')
    await lab.open('')
    await expect(html).toHaveAttribute('lang', 'en')
    await page.goto(`${page.url().split('#')[0]}#view=papers&page.lang=zh-CN`)
    await expect(html).toHaveAttribute('lang', 'zh-CN')
  })

  test('an embedded run asks for a language, and its reader may choose another one', async ({ page }) => {
    await page.goto(`./?embed&lang=en${linkTo({}, 5)}`)
    await expect(page.getByTestId('app')).toHaveAttribute('data-iteration', '5')
    await expect(page.locator('html')).toHaveAttribute('lang', 'en')
    await page.getByTestId('language').click()
    await expect(page.locator('html')).toHaveAttribute('lang', 'zh-CN')
    await expect(page.getByTestId('whole')).toHaveText(HAN)
    await expect(page.getByTestId('whole')).toHaveAttribute('href', /&page\.lang=zh-CN$/)
  })
})

test('templates are in the language that is chosen, as long as nobody has changed them; the run stays as it is', async ({ lab, page }) => {
  await page.goto('./#view=workshop&page.lang=zh-CN')
  const editor = page.getByTestId('editor')
  await editor.waitFor()
  for (const name of ['two-opt', 'rrt', 'ants', 'pso', 'random-search', 'hill-climber']) {
    await pick(page, 'template', name)
    await expect(page.getByTestId('template')).toHaveValue(HAN)
    await expect(editor.locator('.cm-line').first()).toHaveText(/^\/\/ .*[\u3400-\u9fff].*。|^\/\/ .*？/)
    await expect(page.getByTestId('state')).toContainText('页面正在运行这段代码')
  }
  // Chinese has no italics.
  await expect(editor.locator('.cm-line').first().locator('span').first()).toHaveCSS('font-style', 'normal')
  await page.locator('input.timeline').fill('20')
  const hash = await lab.settled(20)
  // That the template before was another planner is a change; its language is none.
  await page.getByTestId('fork-dismiss').click()
  await expect(page.getByTestId('fork')).toHaveCount(0)
  await page.getByTestId('language').click()
  await expect(editor).toContainText('Takes a random step')
  await expect(page.getByTestId('template')).toHaveValue('Hill climber')
  await expect(editor.locator('.cm-line').first().locator('span').first()).toHaveCSS('font-style', 'italic')
  await expect(page.getByTestId('state')).toContainText('The page runs this code')
  expect(await lab.settled(20)).toBe(hash)
  await expect(page.getByTestId('fork')).toHaveCount(0)
  await behind(page, '* normal()')
  await page.keyboard.type(' * 0.5')
  await page.getByTestId('language').click()
  await expect(page.getByTestId('template')).toHaveValue(/爬山法/)
  await expect(editor).toContainText('Takes a random step')
  await expect(editor).toContainText('* normal() * 0.5')
})

test('a template that somebody sent stays in the language in which it was sent, and is the run that the link has', async ({
  lab,
  page,
}) => {
  await page.goto('./#view=workshop')
  await page.getByTestId('editor').waitFor()
  await pick(page, 'template', 'hill-climber')
  await expect(page.getByTestId('state')).toContainText('The page runs this code')
  const hash = await lab.seek(20)
  await page.getByTestId('view-lab').click()
  const link = await lab.link(hash)
  await page.evaluate(() => localStorage.clear())
  await page.goto('about:blank')
  await page.goto(`./${link}&page.lang=zh-CN`)
  await page.getByTestId('offer-edit').click()
  await expect(page.locator('html')).toHaveAttribute('lang', 'zh-CN')
  await expect(page.getByTestId('editor')).toContainText('Takes a random step')
  await page.getByTestId('run-code').click()
  await expect(page.getByTestId('state')).toContainText('页面正在运行这段代码')
  expect(await lab.settled(20)).toBe(hash)
  await expect(page.getByTestId('editor')).toContainText('Takes a random step')
})

test('what the core said is said in the language that is chosen, and the run stays as it is', async ({ lab, page }) => {
  await lab.open(`${DRIVE}&page.tab=chart`)
  const hash = await lab.settled(200)
  const seek = async (iteration: number): Promise<string> => {
    await page.locator('input.timeline').fill(String(iteration))
    return lab.settled(iteration)
  }
  const events = page.getByTestId('events').getByRole('listitem')
  await expect(events.first()).toBeVisible()
  const count = await events.count()
  await seek(20)
  await page.getByTestId('language').click()
  await expect(events.first()).toContainText(HAN)
  expect(await seek(200)).toBe(hash)
  await expect(events).toHaveCount(count)
  for (const event of await events.all()) await expect(event).toContainText(HAN)
  await page.getByTestId('language').click()
  await expect(events.first()).not.toContainText(HAN)
  await expect(events).toHaveCount(count)
})

test('an explanation is said in the language that is chosen, which the link has', async ({ lab, page }) => {
  await lab.open(`${linkTo({}, 10)}&page.item=particles.3&page.lang=zh-CN`)
  await lab.settled(10)
  const explained = page.getByTestId('section-inspect')
  await expect(explained).toContainText('粒子 3')
  await page.getByTestId('language').click()
  await expect(explained).toContainText('Particle 3')
  await expect(page).toHaveURL(/&page\.item=particles\.3$/)
})

base('where the words of a language cannot be loaded the page is English', async ({ page }) => {
  await page.route(/zh-CN/, (route) => route.abort())
  const wrong: string[] = []
  page.on('pageerror', (error) => wrong.push(error.message))
  await page.goto('./#view=learn&page.lang=zh-CN')
  await expect(page.getByTestId('app')).toHaveAttribute('data-phase', 'ready')
  await expect(page.locator('html')).toHaveAttribute('lang', 'en')
  expect(wrong).toEqual([])
})
