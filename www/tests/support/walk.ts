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

const climber = template('hill-climber')

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
      const roots = [document, ...[...document.querySelectorAll('forage-run')].map(({ shadowRoot }) => shadowRoot)]
      for (const root of roots) {
        for (const fold of root?.querySelectorAll('details:not([open])') ?? []) fold.setAttribute('open', '')
        for (const button of root?.querySelectorAll<HTMLElement>('[aria-expanded=false]:not([aria-haspopup]):not([role=combobox])') ?? [])
          button.click()
      }
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
      const here = page.locator('li[aria-current="step"]')
      await expect(here).toBeVisible()
      const options = here.getByRole('radio')
      if (await options.count()) {
        await options.first().check({ force: true })
        await here.getByTestId('predict-answer').click()
        await expect(here.getByTestId('feedback')).toBeVisible({ timeout: 30_000 })
      }
      const next = page.getByTestId('lesson-next')
      if (await next.isDisabled()) break
      await next.click()
      await page.waitForTimeout(150)
    }
    await unfolded(page)
  },
})

/** The workshop with a code in its editor. */
const written = (name: string, code: string, act?: (page: Page) => Promise<void>): View => ({
  name,
  async open(page, spoken) {
    await page.goto('about:blank')
    await page.goto(`${spoken.site}course.html`)
    await page.evaluate((text) => localStorage.setItem('forage.workshop.draft', JSON.stringify({ code: text, foreign: false })), code)
    await opened('#view=workshop')(page, spoken)
    await page.getByTestId('editor').waitFor()
    await act?.(page)
    await unfolded(page)
  },
})

/** What is wrong is said. */
const refused = (name: string, hash: string, act?: (page: Page) => Promise<void>): View => ({
  name,
  async open(page, spoken) {
    await opened(hash)(page, spoken)
    await act?.(page)
    await settled(page)
  },
})

const file = (name: string, text: string) => ({ name, mimeType: 'text/plain', buffer: Buffer.from(text) })
const dropped =
  (name: string, text: string) =>
  async (page: Page): Promise<void> => {
    const data = await page.evaluateHandle(
      ([called, content]) => {
        const transfer = new DataTransfer()
        transfer.items.add(new File([content ?? ''], called ?? ''))
        return transfer
      },
      [name, text],
    )
    await page.dispatchEvent('[data-testid=app]', 'drop', { dataTransfer: data })
    await page.waitForTimeout(500)
  }

const GRID = run('a-star', 'wolf-ant-20')

export const VIEWS: readonly View[] = [
  { name: 'learn', open: opened('#view=learn') },
  {
    name: 'glossary',
    async open(page, spoken) {
      await opened('#view=learn')(page, spoken)
      await page.getByTestId('glossary').click()
      await settled(page)
    },
  },
  { name: 'lesson editor', open: opened('#view=learn&edit=lesson') },
  refused('lesson file refused', '#view=learn', (page) =>
    page.getByTestId('open-lesson-file').setInputFiles(file('wrong.json', '{"format": "forage-lesson", "version": 1, "name": "A B"}')),
  ),
  ...RUNS.flatMap(([planner, scene, item, at]) => runViews(planner, scene, item, at)),
  refused('link refused', run('psoo', 'sphere')),
  refused('parameter refused', `${run('pso', 'sphere')}&population=0`),
  refused('field refused', run('pso', 'sphere', 0, '&page.tab=setup'), async (page) => {
    await page.getByTestId('seed').fill('-3')
    await page.getByTestId('seed').press('Enter')
  }),
  refused('file refused', GRID, dropped('map.map', 'type octile\nheight 3\nwidth x\nmap\n')),
  refused('scene file refused', GRID, dropped('scene.json', '{"format": "forage-scene", "version": 1, "kind": "grid", "name": "x"}')),
  refused('file read', GRID, dropped('places.csv', 'x,y\n1,2\n3,4\n5,1\n')),
  {
    name: 'random scene',
    async open(page, spoken) {
      await opened(`${GRID}&page.tab=setup`)(page, spoken)
      await unfolded(page)
      await page.getByTestId('generate').first().click()
      await expect(page.getByTestId('generate-dialog')).toBeVisible()
      await unfolded(page)
    },
  },
  dialog('export', 'export'),
  dialog('embed', 'embed'),
  dialog('keys', 'keys'),
  {
    name: 'presentation',
    async open(page, spoken) {
      await opened(run('wcpso', 'wcpso-discs', 30))(page, spoken)
      await page.keyboard.press('p')
      await settled(page)
    },
  },
  {
    name: 'fork',
    async open(page, spoken) {
      await opened(run('wcpso', 'wcpso-discs', 30))(page, spoken)
      await page.getByTestId('seed').fill('5')
      await page.getByTestId('seed').press('Enter')
      await settled(page)
    },
  },
  ...['none', 'play', 'full'].map((controls) => ({
    name: `embed ${controls}`,
    open: opened(`?embed&controls=${controls}${run('wcpso', 'wcpso-discs', 20)}`),
  })),
  { name: 'embedded lesson', open: opened('?embed#lesson=pso') },
  {
    name: 'compare, watch',
    async open(page, spoken) {
      await opened('#view=compare&as=watch&scene=wcpso-discs&with=wcpso,pso&budget=2000')(page, spoken)
      await page.getByTestId('race-end').click()
      await unfolded(page)
    },
  },
  {
    name: 'compare, statistics',
    async open(page, spoken) {
      await opened('#view=compare&as=statistics&scene=wcpso-discs&seeds=1-6&with=wcpso,pso&budget=3000')(page, spoken)
      await page.getByTestId('batch-run').click()
      await expect(page.getByTestId('batch-bar')).toHaveAttribute('data-running', 'false', { timeout: 30_000 })
      await unfolded(page)
    },
  },
  {
    name: 'compare, random maps',
    open: opened('#view=compare&as=statistics&maps=rooms&seeds=1-2&with=a-star,theta-star&budget=own'),
  },
  {
    name: 'papers',
    async open(page, spoken) {
      await opened('#view=papers')(page, spoken)
      await unfolded(page)
    },
  },
  { name: 'workshop', open: opened('#view=workshop') },
  written('code that cannot be read', 'register({ name: "Mine", kinds: ["function"]'),
  written('code that is refused', 'register({ name: "Mine!", kinds: ["tours"] })'),
  written('code that runs', climber, async (page) => {
    await page.getByTestId('run-code').click()
    await page.waitForTimeout(1500)
    await page.getByTestId('tab-check').click()
    await page.getByTestId('check-own').click()
    await page.waitForTimeout(4000)
  }),
  written('code that fails', climber.replace('evaluate(', 'nothing.evaluate('), async (page) => {
    await page.getByTestId('run-code').click()
    await page.waitForTimeout(1500)
  }),
  ...lessonNames.map(lesson),
]

/** The page where it is not a page: in one file, and in somebody else's. */
export const HOSTED: readonly View[] = [
  {
    name: 'in one file',
    async open(page, spoken) {
      await opened(`single-file.html${run('wcpso', 'wcpso-discs', 20, '&page.tab=setup')}`)(page, spoken)
      await unfolded(page)
    },
  },
  ...['none', 'play', 'full'].map((controls) => ({
    name: `element with ${controls}`,
    async open(page: Page, { site, tag }: Spoken) {
      await page.goto(`${site}course.html`)
      const link = run('wcpso', 'wcpso-discs', 20).replaceAll('&', '&amp;')
      const element = `<forage-run src="${link}" lang="${tag}" controls="${controls}" style="height: 30rem"></forage-run>`
      await page.setContent(
        `<!doctype html><html lang="${tag}"><title>A</title><meta name="viewport" content="width=device-width"><style>body { margin: 0 }</style><script src="element.js"></script>${element}`,
      )
      await expect(page.locator('forage-run')).toHaveAttribute('data-iteration', '20')
      await expect(page.locator('forage-run .run')).toHaveAttribute('lang', tag)
      await unfolded(page)
    },
  })),
]

export const HOME: Spoken = { tag: 'en', site: SITE }
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

/** Texts that do not fit where they are, and how far the page is wider than its window. */
export const cut = (page: Page): Promise<Read[]> =>
  page.evaluate(() => {
    const found: { text: string; where: string }[] = []
    const wide = document.documentElement.scrollWidth - innerWidth
    if (wide > 0) found.push({ text: `${wide} px`, where: 'the page is too wide' })
    /** Its text goes on where somebody can scroll, or is there for those who hear it only. */
    const apart = (element: Element): boolean => {
      for (let at: Element | null = element; at; at = at.parentElement) {
        const { overflowX, clipPath, clip } = getComputedStyle(at)
        if (overflowX === 'auto' || overflowX === 'scroll' || clipPath !== 'none' || clip !== 'auto') return true
      }
      return false
    }
    const all = (root: ParentNode): HTMLElement[] =>
      [...root.querySelectorAll<HTMLElement>('*')].flatMap((element) => [element, ...(element.shadowRoot ? all(element.shadowRoot) : [])])
    for (const element of all(document.body)) {
      const root = element.getRootNode()
      // An element of ours is as wide as somebody else's page wants it.
      const [start, end] =
        root instanceof ShadowRoot ? [root.host.getBoundingClientRect().left, root.host.getBoundingClientRect().right] : [0, innerWidth]
      const own = [...element.childNodes].some((node) => node.nodeType === Node.TEXT_NODE && node.textContent?.trim())
      if (!own || !element.checkVisibility() || element.closest('svg, canvas, .cm-editor, option, .brief, .visually-hidden')) continue
      const { overflowX } = getComputedStyle(element)
      const { left, right, width } = element.getBoundingClientRect()
      // For those who hear it only.
      if (width <= 1.5) continue
      const hidden = (overflowX === 'hidden' || overflowX === 'clip') && element.scrollWidth > element.clientWidth + 1
      const outside = width > 1 && (right > end + 1 || left < start - 1)
      if ((hidden || outside) && !apart(element.parentElement ?? element)) {
        const { testid } = (element.closest<HTMLElement>('[data-testid]')?.dataset ?? {}) as { testid?: string }
        found.push({
          text: (element.textContent ?? '').trim().slice(0, 80),
          where: `${testid} ${element.tagName.toLowerCase()}.${element.className}`,
        })
      }
    }
    return found
  })
