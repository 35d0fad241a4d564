import { expect, type Page, test as base } from '@playwright/test'
import { brokenWords, misbroken } from './support/lines'
import { SITE } from './support/site'
import { cut, HOME, HOSTED, type Read, read, type Spoken, type View, VIEWS } from './support/walk'

/* What the page says in each language, wherever somebody comes. */

const CHINESE: Spoken = { tag: 'zh-CN', site: SITE }
/** English with accents, a third longer: what was forgotten has none, and what does not fit is cut off. */
const ACCENTED: Spoken = { tag: 'en-XA', site: `${SITE}pseudo/` }
const WIDTHS = [1440, 320]

/** So many views are one test. */
const GROUP = 12
/** These stand for all in a quick run. */
const SAMPLE = [
  'learn',
  'wcpso, explain',
  'a-star, setup',
  'rrt-guided, explain',
  'bat, explain',
  'link refused',
  'export',
  'papers',
  'code that is refused',
  'lesson inertia',
]

const groups = (views: readonly View[]): View[][] =>
  Array.from({ length: Math.ceil(views.length / GROUP) }, (_, k) => views.slice(k * GROUP, (k + 1) * GROUP))

/** What commands, formulas, addresses, names of files and values of parameters are made of is the same in all languages. */
const plain = (text: string): string =>
  text.replace(
    /forage [a-z]+ .*|`[^`]*`|[A-Z]\w*Error: [^”]*|\$[^$]*\$|https?:\S+|--[a-z]+[= ]\S*|\b\w+(?:\.\w+)+|\b\w+=\S*|(?:[a-z0-9-]+, ){2,}[a-z0-9-]+/g,
    '',
  )

const HAN = /[\u3400-\u9fff]/
/** Two words in small letters are no name, nor are punctuation marks of English between Han. */
const ENGLISH = /\b[a-z]{2,}[,;:.]? [a-z]{2,}/
const MARKS = /[\u3400-\u9fff](?:, |; |: |\.(?: |$))/
/** Titles, authors and names of people and programs that are as they are printed. */
const PRINTED = /^(?:[A-Z][\w.-]+(?:,? (?:and|et al\.|[A-Z][\w.-]*|\d{4}))*[;.,]? ?)+(?:\[[A-Z-]+\].*)?$/

/** Runs by their planners and parameters, as commands have them, and what an author says of an own planner. */
const NAMES = /^open-run|^workshop label/

const asWritten: Readonly<Record<string, (read: Read) => boolean>> = {
  'zh-CN': ({ text, where }) => !NAMES.test(where) && ((ENGLISH.test(plain(text)) && !PRINTED.test(text)) || MARKS.test(plain(text))),
  en: ({ text, where }) => HAN.test(text) && !where.startsWith('citation'),
  'en-XA': ({ text, where }) => !NAMES.test(where) && /\b[A-Za-z]{2,} [A-Za-z]{2,}\b/.test(plain(text)) && !PRINTED.test(text),
}

const test = base.extend<{ walk: (spoken: Spoken, views: readonly View[]) => Promise<void> }>({
  walk: async ({ context }, use) => {
    await use(async (spoken, views) => {
      for (const view of views) {
        const page = await context.newPage()
        await base.step(view.name, () => seen(page, spoken, view))
        await page.close({ runBeforeUnload: false })
      }
    })
  },
})

const softly = expect.configure({ soft: true })

/** Nothing is in another language, nothing is cut off. */
async function seen(page: Page, spoken: Spoken, view: View): Promise<void> {
  page.setDefaultTimeout(15_000)
  await page.setViewportSize({ width: WIDTHS[0] ?? 0, height: 900 })
  await view.open(page, spoken)
  expect(await page.evaluate(() => document.documentElement.lang)).toBe(spoken.tag)
  await expect.poll(async () => (await read(page)).length).toBeGreaterThan(3)
  // What no first view has comes after it; nothing else does once all is there.
  const others = async () => {
    const found = (await read(page)).filter((text) => asWritten[spoken.tag]?.(text))
    await page.waitForTimeout(found.length > 0 ? 0 : 300)
    return found.length > 0 ? found : (await read(page)).filter((text) => asWritten[spoken.tag]?.(text))
  }
  await softly.poll(others, { message: `${view.name}: in another language`, timeout: 15_000 }).toEqual([])
  for (const width of WIDTHS) {
    await page.setViewportSize({ width, height: 900 })
    // What is laid out by its size settles first.
    await softly.poll(() => cut(page), { message: `${view.name}: cut off at ${width} px`, timeout: 15_000 }).toEqual([])
    await softly
      .poll(() => misbroken(page), { message: `${view.name}: lines broken at a mark, at ${width} px`, timeout: 5_000 })
      .toEqual([])
    // Words with accents are longer than any.
    if (spoken !== ACCENTED)
      await softly.poll(() => brokenWords(page), { message: `${view.name}: words broken at ${width} px`, timeout: 5_000 }).toEqual([])
  }
}

const sample = VIEWS.filter(({ name }) => SAMPLE.includes(name))

for (const [name, spoken] of Object.entries({ 'in Chinese': CHINESE, 'in English': HOME, 'with accents': ACCENTED })) {
  test(`${name} a sample of views has no other language, and fits`, { tag: '@smoke' }, async ({ walk }) => {
    await walk(spoken, sample)
  })
  // The build with accents is a page only.
  const all = spoken === ACCENTED ? VIEWS : [...VIEWS, ...HOSTED]
  for (const [k, views] of groups(all).entries())
    test(`${name} views have no other language, and fit: ${k + 1}`, async ({ walk }) => {
      test.setTimeout(180_000)
      await walk(spoken, views)
    })
}
