import { readdirSync, readFileSync } from 'node:fs'
import { expect, type Page } from '@playwright/test'
import { SITE } from './site'
import { template } from './workshop'

/* All that the page shows: each view, dialog, error and lesson, one after the other. */

/** A language of the page, and where the page is that speaks it. */
export interface Spoken {
  tag: string
  site: string
}

/** Something to look at, and how one comes there. */
export interface View {
  name: string
  open(page: Page, spoken: Spoken): Promise<void>
}

const opened =
  (hash: string) =>
  async (page: Page, { site, tag }: Spoken) => {
    // A dialog would stay open.
    if (await page.getByRole('dialog').count()) await page.goto('about:blank')
    const address = `${site}${hash}${hash.includes('#') ? '&' : '#'}page.lang=${tag}`
    await page.goto(address)
    await expect(page.getByTestId('app').first()).toHaveAttribute('data-phase', 'ready')
    await settled(page)
  }

/** What is loaded when it is asked for is there. */
async function settled(page: Page): Promise<void> {
  await page.waitForTimeout(350)
}

const run = (planner: string, scene: string, at = 12, more = ''): string => `#v=1&planner=${planner}&scene=${scene}&seed=1&at=${at}${more}`

/** A run, with one of its pieces explained, the chart, and all of Setup. */
function runViews(planner: string, scene: string, item: string, at = 12): View[] {
  const of = (tab: string) => ({ name: `${planner}, ${tab}`, open: opened(run(planner, scene, at, `&page.item=${item}&page.tab=${tab}`)) })
  return [
    {
      ...of('explain'),
      async open(page, spoken) {
        await of('explain').open(page, spoken)
        await unfolded(page)
      },
    },
    of('chart'),
    {
      name: `${planner}, setup`,
      async open(page, spoken) {
        await of('setup').open(page, spoken)
        await unfolded(page)
      },
    },
  ]
}

/** Everything that is folded is open. */
async function unfolded(page: Page): Promise<void> {
  for (const _ of [1, 2]) {
    await page.evaluate(() => {
      for (const fold of document.querySelectorAll('details:not([open])')) fold.setAttribute('open', '')
      for (const button of document.querySelectorAll<HTMLElement>('[aria-expanded=false]:not([aria-haspopup]):not([role=combobox])'))
        button.click()
    })
    await settled(page)
  }
}

const RUNS: readonly [planner: string, scene: string, item: string, at?: number][] = [
  ['wcpso', 'wcpso-discs', 'particles.3', 20],
  ['ltqpso', 'qpso-10m', 'particles.3', 20],
  ['pso', 'rastrigin', 'particles.3', 20],
  ['bat-continuous', 'ackley', 'particles.3', 20],
  ['cuckoo-search', 'ackley', 'particles.3', 20],
  ['pso-rrt', 'qpso-10m', 'particles.3', 5],
  ['aco-direction', 'ant-bat-30', 'ants.3', 5],
  ['aco-wolf', 'wolf-ant-20', 'ants.3', 5],
  ['a-star', 'wolf-ant-20', 'frontier.3', 40],
  ['theta-star', 'wolf-ant-20', 'frontier.3', 40],
  ['bat', 'random-52', 'bats.3', 5],
  ['hybrid-bat', 'ant-bat-30', 'bats.3', 2],
  ['ga', 'random-52', 'tours.3', 5],
  ['sa', 'random-52', 'tour.0', 20],
  ['two-opt', 'random-52', 'tour.0', 20],
  ['held-karp', 'open-12', 'tour.0', 2],
  ['rrt-guided', 'arm-bench', 'tree.5', 20],
  ['rrt-star', 'crossing', 'tree.5', 60],
  ['wolf-ant-drive', 'crossing', 'robot.0', 40],
  ['d-star-lite-drive', 'patrol', 'robot.0', 40],
  ['pso-tuning', 'wolf-ant-20', 'particles.1', 1],
]

const dialog = (name: string, id: string, hash = run('wcpso', 'wcpso-discs')): View => ({
  name,
  async open(page, spoken) {
    await opened(hash)(page, spoken)
    const button = page.getByTestId(id).first()
    if (!(await button.isVisible())) await page.getByTestId('more').click()
    await button.click()
    await expect(page.getByRole('dialog').first()).toBeVisible()
    await unfolded(page)
  },
})

const LESSONS = JSON.parse(readFileSync(new URL('../../../lessons/order.json', import.meta.url), 'utf8')) as string[]
const lessonNames = readdirSync(new URL('../../../lessons', import.meta.url))
  .filter((file) => /^[a-z-]+\.json$/.test(file) && file !== 'order.json')
  .map((file) => file.slice(0, -5))
  .sort((a, b) => LESSONS.indexOf(a) - LESSONS.indexOf(b))

/** A lesson from step to step; every prediction is answered with its first option. */
const lesson = (name: string): View => ({
  name: `lesson ${name}`,
  async open(page, spoken) {
    await opened(`#view=learn&lesson=${name}`)(page, spoken)
    await expect(page.getByTestId('lesson')).toHaveAttribute('data-lesson', name)
    for (;;) {
      const here = page.locator('article[data-step][data-current=true], article.current').first()
      const options = here.getByRole('radio')
      if (
        await options
          .first()
          .isVisible()
          .catch(() => false)
      ) {
        await options
          .first()
          .check({ force: true })
          .catch(() => undefined)
        await here
          .getByTestId('predict-answer')
          .click({ timeout: 2000 })
          .catch(() => undefined)
        await settled(page)
      }
      const next = page.getByTestId('lesson-next')
      if (!(await next.isVisible().catch(() => false)) || (await next.isDisabled())) break
      await next.click()
      await page.waitForTimeout(150)
    }
    await unfolded(page)
  },
})

export const VIEWS: readonly View[] = [
  { name: 'learn', open: opened('#view=learn') },
  ...RUNS.flatMap(([planner, scene, item, at]) => runViews(planner, scene, item, at)),
  dialog('export', 'export'),
  dialog('embed', 'embed'),
  dialog('keys', 'keys'),
  {
    name: 'compare, watch',
    async open(page, spoken) {
      await opened('#view=compare&as=watch&scene=wcpso-discs&with=wcpso,pso&budget=2000')(page, spoken)
      await unfolded(page)
    },
  },
  {
    name: 'compare, statistics',
    async open(page, spoken) {
      await opened('#view=compare&as=statistics&scene=wcpso-discs&seeds=1-4&with=wcpso,pso&budget=1000')(page, spoken)
      await page
        .getByTestId('batch-run')
        .click()
        .catch(() => undefined)
      await page.waitForTimeout(4000)
      await unfolded(page)
    },
  },
  {
    name: 'papers',
    async open(page, spoken) {
      await opened('#view=papers')(page, spoken)
      await unfolded(page)
      await unfolded(page)
    },
  },
  {
    name: 'workshop',
    async open(page, spoken) {
      await opened('#view=workshop')(page, spoken)
      await unfolded(page)
    },
  },
  ...lessonNames.map(lesson),
]

export const HOME: Spoken = { tag: 'en', site: SITE }
export const climber = template('hill-climber')

/** A text that somebody reads, hears or finds under the pointer, and where. */
export interface Read {
  text: string
  where: string
}

/** All texts of the page that are not in another language than the page's own, and are neither code nor formulas. */
export const read = (page: Page): Promise<Read[]> =>
  page.evaluate(() => {
    const found: { text: string; where: string }[] = []
    const APART = 'script, style, code, pre, kbd, samp, math, svg text, [translate=no], .cm-editor, noscript'
    const own = document.documentElement.lang
    const whole = (element: Element): string => {
      const id = element.closest('[data-testid]')?.getAttribute('data-testid') ?? ''
      return `${id} ${element.tagName.toLowerCase()}${element.className && typeof element.className === 'string' ? `.${element.className.split(' ')[0]}` : ''}`
    }
    const walk = (root: ParentNode): void => {
      for (const element of root.querySelectorAll('*')) {
        if (element.shadowRoot) walk(element.shadowRoot)
        if (element.closest(APART) || (element.closest('[lang]')?.getAttribute('lang') ?? own) !== own) continue
        if (!element.checkVisibility()) continue
        for (const name of ['aria-label', 'title', 'placeholder', 'alt', 'aria-description', 'aria-valuetext', 'aria-roledescription']) {
          const text = element.getAttribute(name)
          if (text) found.push({ text, where: `${whole(element)}@${name}` })
        }
        const text = [...element.childNodes]
          .filter((node) => node.nodeType === Node.TEXT_NODE)
          .map((node) => node.textContent?.trim())
          .filter(Boolean)
          .join(' ')
        if (text) found.push({ text, where: whole(element) })
      }
    }
    walk(document)
    found.push({ text: document.title, where: 'title' })
    return found
  })
