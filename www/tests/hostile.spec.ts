import type { Page } from '@playwright/test'
import { linkTo, sceneOf } from './support/core'
import { expect, test } from './support/lab'

/* Links, scenes and files from somewhere: whatever their texts say, nothing of it runs and nothing is polluted. */

const IMAGE = '<img src=x onerror="globalThis.ran = 1">'
const SCRIPT = '"><script>globalThis.ran = 2</script>'
const ADDRESS = 'javascript:globalThis.ran=3'
/** Turns the order of letters around: what follows reads otherwise than it is. */
const OVERRIDE = '\u202egnp.exe'
const TEXTS = [IMAGE, SCRIPT, ADDRESS, OVERRIDE, '__proto__', 'constructor', '{{constructor}}']

interface Traces {
  ran: unknown
  polluted: string[]
  refused: string[]
}

test.beforeEach(({ page }) =>
  page.addInitScript(() => {
    const refused: string[] = []
    Object.assign(globalThis, { refused })
    addEventListener('securitypolicyviolation', ({ violatedDirective, sample }) => refused.push(`${violatedDirective}: ${sample}`))
  }),
)

/** What ran, what every object has now, and what the policy had to refuse. */
const tracesIn = (page: Page): Promise<Traces> =>
  page.evaluate(() => {
    const { ran, refused } = globalThis as unknown as Traces
    const polluted: string[] = []
    for (const name in {}) polluted.push(name)
    return { ran, polluted, refused }
  })

const CLEAN: Traces = { ran: undefined, polluted: [], refused: [] }

test('links', { tag: '@smoke' }, async ({ lab, page }) => {
  const good = linkTo({}, 10)
  const links = TEXTS.flatMap((text) => [
    good.replace('planner=wcpso', `planner=${encodeURIComponent(text)}`),
    good.replace('scene=wcpso-discs', `scene=${text}`),
    `${good}&p.${text}=${text}`,
    `${good}&${text}=1`,
    `${good}&page.layers=${text},-${text}&page.item=${text}.1&page.camera=${text}`,
    `#view=${text}`,
  ])
  await lab.open(good)
  await lab.settled(10)
  for (const link of links) await page.evaluate((hash) => (location.hash = hash), link)
  await page.evaluate((hash) => (location.hash = hash), linkTo({ seed: 5 }, 12))
  await lab.settled(12)
  expect(await tracesIn(page)).toEqual(CLEAN)
})

test('names, titles and notes of scenes, and names of files', { tag: '@smoke' }, async ({ lab, page }) => {
  await lab.open()
  await lab.section('scene')
  const scene = { ...sceneOf({}), name: 'mine' }
  for (const text of TEXTS) {
    const json = JSON.stringify({ ...scene, title: text, note: `${text} ${ADDRESS}` }).replace('{', '{"__proto__": {"polluted": true},')
    const buffer = Buffer.from(json)
    const plain = Buffer.from(JSON.stringify({ ...scene, title: text, note: text }))
    const name = `${text.replaceAll('/', '∕')}.json`
    await page.getByTestId('scene-file').setInputFiles({ name, mimeType: 'application/json', buffer })
    await page.getByTestId('scene-file').setInputFiles({ name, mimeType: 'application/json', buffer: plain })
    await lab.restarted()
    await expect(page.getByTestId('scene')).toHaveValue(text)
    await page.getByTestId('scene-file').setInputFiles({ name, mimeType: 'application/json', buffer: Buffer.from('{') })
    await expect(page.getByTestId('notice')).toContainText(name.slice(0, 4))
  }
  expect(await tracesIn(page)).toEqual(CLEAN)
})

test('what an embed is asked for', async ({ page }) => {
  for (const text of TEXTS) {
    const query = new URLSearchParams({ controls: text, theme: text, origin: text })
    await page.goto(`?embed&${query}${linkTo({}, 3)}`)
    await expect(page.locator('[data-hash]').first()).toHaveAttribute('data-iteration', '3')
    expect(await tracesIn(page)).toEqual(CLEAN)
  }
})
