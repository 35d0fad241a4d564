import { readFile } from 'node:fs/promises'
import { exportScene, generateScene, importScene, type NamedFile, type Outcome } from '../../pkg/node.js'
import { closer } from '../src/locales/en/closer'
import { tours } from '../src/locales/en/tours'
import { number, percent } from '../src/text/number'
import { sorted } from '../src/ui/rows'
import { violations } from './support/axe'
import { hashOf, linkTo, sessionAt, verified } from './support/core'
import { en, expect, type Lab, test } from './support/lab'

/** Roads by ants take a while; those by A* are there at once. */
const ANTS = { planner: 'bat', scene: 'ant-bat-30', params: { local_search: 'none' }, seed: 4 }
const SETUP = { ...ANTS, params: { ...ANTS.params, roads: 'a-star' } }
/** Steps of the roads, and the first with differing tours and gains. */
const [ROADS, AT] = [11, 15]
const END = ROADS + 100

const COLUMNS = ['length', 'loudness', 'pulse_rate', 'different', 'operator', 'gain'] as const

function membersAt(setup: Parameters<typeof hashOf>[0], iteration: number): Record<(typeof COLUMNS)[number], number>[] {
  return sessionAt(setup, iteration, (session) => {
    const rows = session.members()
    return Array.from({ length: rows.length / COLUMNS.length }, (_, member) =>
      Object.fromEntries(COLUMNS.map((name, column) => [name, rows[member * COLUMNS.length + column] ?? NaN])),
    ) as Record<(typeof COLUMNS)[number], number>[]
  })
}

async function begin(lab: Lab, iteration = AT, setup: Parameters<typeof hashOf>[0] = SETUP): Promise<string> {
  await lab.open(linkTo(setup, iteration))
  return lab.settled(iteration)
}

test('roads in several threads, then bats: one run, both parts told, the same state as without threads, also back and forth', async ({
  lab,
  page,
}) => {
  await page.addInitScript(() => {
    Object.defineProperty(navigator, 'hardwareConcurrency', { get: () => 4 })
    const told = new Set<string>()
    Object.assign(window, { told })
    const look = (): void => {
      const text = document.querySelector('[data-testid="step-progress"] span')?.textContent
      if (text) told.add(text)
      requestAnimationFrame(look)
    }
    look()
  })
  let workers = 0
  page.on('worker', (worker) => (workers += worker.url().includes('render.worker') ? 0 : 1))
  await begin(lab, 0, ANTS)
  await expect(page.getByTestId('result-strip')).toContainText(en.result.roads('0', '66'))
  await expect(page.getByTestId('transport-count')).toHaveText(`Roads 0 / ${ROADS}`)
  await page.getByTestId('speed').selectOption('Infinity')
  await lab.press(en.transport.play)
  expect(await lab.settled(END)).toBe(hashOf(ANTS, END))
  expect(workers).toBe(1 + 4)
  const told = await page.evaluate(() => [...(window as unknown as { told: Set<string> }).told])
  expect(told.length).toBeGreaterThan(0)
  for (const text of told) expect(text).toMatch(/^Roads \d+ of 11: \d+ of \d+ runs$/)
  await expect(page.getByTestId('step-progress')).toHaveCount(0)
  await expect(lab.timeline).toHaveAttribute(
    'aria-valuetext',
    `${en.transport.of(String(END), String(END), false)}, ${en.transport.part('Tour', '100', '100')}`,
  )
  await expect(page.getByTestId('parts').locator('.now')).toHaveAttribute('data-part', 'tour')

  expect(await lab.seek(5)).toBe(hashOf(ANTS, 5))
  await expect(lab.timeline).toHaveAttribute(
    'aria-valuetext',
    `${en.transport.of('5', String(END), false)}, ${en.transport.part('Roads', '5', '11')}`,
  )
  const { roads } = sessionAt(ANTS, 5, (session) => session.readings())
  await expect(page.getByTestId('result-strip')).toContainText(en.result.roads(String(roads), '66'))
  expect(await lab.seek(40)).toBe(hashOf(ANTS, 40))
  await expect(page.getByTestId('count')).toHaveText('Tour 29 / 100')
  await expect(page.getByTestId('live')).toContainText('tour 29 of 100')
})

test('the page keys go from part to part, on the stage and on the slider', async ({ lab, page }) => {
  await begin(lab, 5)
  await lab.stage.focus()
  await page.keyboard.press('PageUp')
  await lab.settled(ROADS)
  await page.keyboard.press('PageUp')
  expect(await lab.settled(END)).toBe(hashOf(SETUP, END))
  await lab.timeline.focus()
  await page.keyboard.press('PageDown')
  await lab.settled(ROADS)
  await page.keyboard.press('PageDown')
  await lab.settled(0)

  // A run of one part has nowhere to go: the slider's own keys stay.
  await lab.open()
  await lab.open(linkTo({}, 30))
  await lab.settled(30)
  await expect(page.getByTestId('parts')).toHaveCount(0)
  await lab.timeline.focus()
  await page.keyboard.press('PageUp')
  await expect.poll(() => lab.iteration()).toBe(80)
})

test('the bats’ numbers are the core’s: bars, words and lengths; a head sorts them, once more the other way round', async ({
  lab,
  page,
}) => {
  await begin(lab)
  await lab.tab('explain')
  const members = membersAt(SETUP, AT)
  const table = page.getByRole('grid', { name: 'Bats' })
  await expect(table).toHaveAttribute('aria-rowcount', String(members.length + 1))
  const [first] = members
  if (!first) throw new Error('no bats')
  const row = table.locator('[data-member="0"]')
  await expect(row.getByRole('gridcell')).toHaveText([
    number(first.length, 5),
    number(first.loudness, 3),
    number(first.pulse_rate, 3),
    number(first.different, 5),
    ['start', 'PMX', '2-opt'][first.operator] ?? '',
    number(first.gain, 5),
  ])
  expect(await row.locator('[data-share]').evaluateAll((bars) => bars.map((bar) => Number((bar as HTMLElement).dataset.share)))).toEqual([
    Number(first.loudness.toFixed(4)),
    Number(first.pulse_rate.toFixed(4)),
  ])
  const counts = [1, 2].map((word) => members.filter(({ operator }) => operator === word).length)
  for (const [at, word] of ['PMX', '2-opt'].entries())
    if (counts[at]) await expect(page.getByTestId('words-operator')).toContainText(`${word} ${counts[at]}`)
  await expect(page.getByTestId('strip-loudness')).toContainText(number(Math.min(...members.map(({ loudness }) => loudness)), 3))

  const shown = (): Promise<(string | undefined)[]> =>
    table.locator('[data-member]').evaluateAll((rows) =>
      rows
        .sort((a, b) => Number(a.ariaRowIndex) - Number(b.ariaRowIndex))
        .slice(0, 8)
        .map((node) => (node as HTMLElement).dataset.member),
    )
  const head = table.getByRole('columnheader').filter({ has: page.getByRole('button', { name: 'Loudness', exact: true }) })
  const by = (descending: boolean): string[] =>
    sorted(members.length, (member) => members[member]?.loudness ?? NaN, descending)
      .slice(0, 8)
      .map(String)
  await expect(head).toHaveAttribute('aria-sort', 'none')
  await head.getByRole('button').click()
  await expect(head).toHaveAttribute('aria-sort', 'ascending')
  expect(await shown()).toEqual(by(false))
  await head.getByRole('button').click()
  await expect(head).toHaveAttribute('aria-sort', 'descending')
  expect(await shown()).toEqual(by(true))
})

test('a bat that is picked tells what it did; where its tour differs is marked', async ({ lab, page }) => {
  await begin(lab)
  await lab.tab('explain')
  const members = membersAt(SETUP, AT)
  const member = members.findIndex(({ different }) => different > 1)
  const inspection = sessionAt(SETUP, AT, (session) => session.inspect({ role: 'tours', index: member }))
  if (!inspection) throw new Error('nothing there')
  const table = page.getByTestId('member-table')
  const row = table.locator(`[data-member="${member}"]`)
  await row.click()
  await expect(row).toHaveAttribute('aria-selected', 'true')
  await expect(page.getByTestId('member-told')).toContainText(inspection.summary)
  const panel = page.getByTestId('inspect')
  await expect(panel.getByRole('heading', { level: 2 })).toHaveText(inspection.title)
  await lab.section('inspect-table')
  await expect(panel.locator('caption')).toHaveText(closer.inspect.tables.place.title(inspection.title))
  const differing = inspection.table.rows.flatMap((cells, at) => (cells.at(-1) === 1 ? [inspection.table.labels[at] ?? ''] : []))
  expect(differing.length).toBeGreaterThan(1)
  await expect(panel.locator('tr.differs').getByRole('rowheader')).toHaveText(differing)
  await expect(panel.locator('tr.differs').first()).toContainText('≠')
  await expect(panel.getByTestId('inspect-key').locator('[data-role="different"]')).toHaveText(closer.inspect.roles.different ?? '')

  // It is told of in the roads too, without having them built once more; and again when the bats fly.
  await lab.seek(5)
  await expect(panel).toContainText('There is no tour yet')
  await expect(page.getByTestId('members')).toContainText(tours.members.waiting)
  expect(await lab.seek(AT)).toBe(hashOf(SETUP, AT))
  await expect(row).toHaveAttribute('aria-selected', 'true')
  await row.click()
  await expect(row).toHaveAttribute('aria-selected', 'false')

  // A bar of the strips is a bat as well.
  const strip = page.getByTestId('strip-loudness').locator('canvas')
  const box = await strip.boundingBox()
  if (!box) throw new Error('no strip')
  await page.mouse.click(box.x + (box.width * (member + 0.5)) / members.length, box.y + 20)
  await expect(row).toHaveAttribute('aria-selected', 'true')
})

test('with the keyboard alone: rows, both ends, pages, and looking closer', async ({ lab, page }) => {
  await begin(lab)
  await lab.tab('explain')
  const table = page.getByTestId('member-table')
  await table.focus()
  const active = async (): Promise<string | null> => {
    const id = await table.getAttribute('aria-activedescendant')
    return id === null ? null : page.locator(`[id="${id}"]`).getAttribute('data-member')
  }
  await expect.poll(active).toBe('0')
  await page.keyboard.press('End')
  await expect.poll(active).toBe('49')
  await page.keyboard.press('Home')
  await page.keyboard.press('ArrowDown')
  await page.keyboard.press('ArrowDown')
  await expect.poll(active).toBe('2')
  await page.keyboard.press('Enter')
  await expect(page.getByTestId('inspect').getByRole('heading', { level: 2 })).toHaveText('Bat 3')
  await page.keyboard.press('PageDown')
  await expect.poll(async () => Number(await active())).toBeGreaterThan(6)
  await page.keyboard.press('Escape')
  await expect(table.locator('[aria-selected="true"]')).toHaveCount(0)
  expect(await lab.iteration()).toBe(AT)
  await page.keyboard.press('Shift+Tab')
  await page.keyboard.press('Space')
  await expect(page.getByTestId('layer-tours')).toBeChecked()
})

test('all tours are shown on demand, and the legend agrees', async ({ lab, page }) => {
  await begin(lab)
  await lab.tab('explain')
  const { digest } = await lab.wholePicture()
  await page.getByTestId('members-layer').check()
  await expect(page.getByTestId('layer-tours')).toBeChecked()
  expect((await lab.wholePicture()).digest).not.toBe(digest)
  await lab.layer('tours', false)
  await expect(page.getByTestId('members-layer')).not.toBeChecked()
  expect((await lab.wholePicture()).digest).toBe(digest)
})

test('the result is told as a tour: its gap, by which optimum, its order, which can be copied', async ({ lab, page, context }) => {
  await context.grantPermissions(['clipboard-read', 'clipboard-write'])
  await begin(lab, 60)
  const outcome: Outcome = sessionAt(SETUP, 60, (session) => session.outcome())
  await expect(page.getByTestId('result-strip')).toContainText(en.result.tours['any-angle'])
  await expect(page.getByTestId('result-strip')).toContainText(percent(outcome.gap ?? NaN))
  await lab.section('result')
  const order = (outcome.order ?? []).map((stop) => stop + 1)
  await expect(page.getByTestId('tour-order')).toContainText([...order, order[0]].join(' → '))
  await page.getByTestId('copy-order').click()
  await expect(page.getByTestId('tour-order')).toContainText(tours.order.copied)
  expect(await page.evaluate(() => navigator.clipboard.readText())).toBe(order.join(' '))

  await lab.seek(3)
  await expect(page.getByTestId('result')).toContainText(
    en.result.roads(String(sessionAt(SETUP, 3, (session) => session.readings().roads)), '66'),
  )
})

test('the curve of a run of two parts begins where there is a tour, and every reading has one', async ({ lab }) => {
  await begin(lab, 30)
  const panel = await lab.section('readings')
  for (const [name, value] of Object.entries(sessionAt(SETUP, 30, (session) => session.readings()))) {
    await expect(panel.locator(`[data-reading="${name}"]`)).toHaveText(number(value))
  }
  const { columns, rows } = sessionAt(SETUP, 30, (session) => session.trace(-1))
  const best = (row: number): number => rows[row * columns.length + columns.indexOf('best')] ?? 0
  expect(columns).toContain('loudness')
  expect(rows).toHaveLength(31 * columns.length)
  expect([0, 10].map(best)).toEqual([NaN, NaN])
  expect(best(30)).toBeGreaterThan(100)
})

test('thousands of bats: only the rows that are seen are there', async ({ lab, page }) => {
  const setup = { ...SETUP, params: { ...SETUP.params, population: 4000 } }
  await begin(lab, 12, setup)
  await lab.tab('explain')
  const table = page.getByTestId('member-table')
  await expect(table).toHaveAttribute('aria-rowcount', '4001')
  expect(await table.locator('[data-member]').count()).toBeLessThan(40)
  await table.focus()
  await page.keyboard.press('End')
  await expect(table.locator('[data-member="3999"]')).toBeVisible()
  expect(await table.locator('[data-member]').count()).toBeLessThan(40)
})

for (const colorScheme of ['light', 'dark'] as const) {
  for (const [screen, viewport] of Object.entries({ desktop: { width: 1440, height: 900 }, phone: { width: 390, height: 844 } })) {
    test.describe(`${screen}, ${colorScheme}`, () => {
      test.use({ colorScheme, viewport, hasTouch: screen === 'phone' })

      test('axe finds nothing wrong with bats, one that is looked at and a tour’s order; nothing is too wide or too low', async ({
        lab,
        page,
      }) => {
        await begin(lab)
        for (const id of ['readings', 'result']) await lab.section(id)
        await expect(page.getByTestId('tour-order')).toBeVisible()
        expect(await violations(lab)).toEqual([])
        await lab.section('members')
        await page.getByTestId('member-table').locator('[data-member="2"]').click()
        await lab.section('inspect-table')
        await expect(page.getByTestId('inspect').locator('table')).toBeVisible()
        expect(await violations(lab)).toEqual([])
        expect(await page.evaluate(() => document.documentElement.scrollWidth)).toBeLessThanOrEqual(viewport.width)
        if (screen !== 'phone') return
        const low = await page
          .locator('[data-testid="members"]')
          .locator('button, label, [data-member]')
          .evaluateAll((controls) =>
            controls.filter((control) => control.getBoundingClientRect().height < 43.5).map((control) => control.outerHTML),
          )
        expect(low).toEqual([])
        await lab.peek()
        const [label, buttons] = [await page.getByTestId('parts').boundingBox(), await page.getByTestId('play').boundingBox()]
        expect((label?.y ?? 0) + (label?.height ?? 0)).toBeLessThanOrEqual(buttons?.y ?? 0)
      })
    })
  }
}

const TSP = `NAME : five\nTYPE : TSP\nDIMENSION : 5\nEDGE_WEIGHT_TYPE : EUC_2D\nNODE_COORD_SECTION\n1 0 0\n2 30 0\n3 0 40\n4 30 40\n5 15 60\nEOF\n`
const TOUR = `NAME : five.opt.tour\nTYPE : TOUR\nDIMENSION : 5\nTOUR_SECTION\n1\n2\n4\n5\n3\n-1\nEOF\n`

const bytes = (text: string): Uint8Array => new TextEncoder().encode(text)

/** What is saved by one of the export's buttons, file by file. */
async function saved(lab: Lab, id: string, count: number): Promise<NamedFile[]> {
  const downloads: NamedFile[] = []
  lab.page.on('download', async (download) => {
    const content = await readFile(await download.path())
    downloads.push({ name: download.suggestedFilename(), bytes: new Uint8Array(content) })
  })
  await lab.page.getByTestId(`export-${id}`).click()
  await expect.poll(() => downloads.length).toBe(count)
  lab.page.removeAllListeners('download')
  return downloads.sort((a, b) => a.name.localeCompare(b.name))
}

test('stops are read from TSPLIB’s files and from a table, toured, and saved again, as is the tour', async ({ lab, page }) => {
  const named = [
    { name: 'five.tsp', bytes: bytes(TSP) },
    { name: 'five.opt.tour', bytes: bytes(TOUR) },
  ]
  const { scene } = importScene(named)
  await begin(lab)
  await lab.section('scene')
  const file = ({ name, bytes: content }: NamedFile) => ({ name, mimeType: 'application/octet-stream', buffer: Buffer.from(content) })
  await page.getByTestId('scene-file').setInputFiles(named.map(file))
  await expect(lab.root).toHaveAttribute('data-limit', '100')
  await expect(page.getByTestId('parts')).toHaveCount(0)
  await lab.restarted()
  const hash = await lab.seek(7)
  expect(verified(await lab.link(hash)).scene).toEqual(scene)
  await expect(page.getByTestId('result-strip')).toContainText(en.result.equal(en.result.tours.matrix))
  await expect(page.getByTestId('result-strip')).not.toContainText(en.result.free)

  await lab.press(en.bar.exports)
  for (const id of ['movingai', 'ros']) await expect(page.getByTestId(`export-${id}`)).toHaveCount(0)
  const written = exportScene(scene, 'tsplib').sort((a, b) => a.name.localeCompare(b.name))
  expect(written.map(({ name }) => name)).toEqual(['five.opt.tour', 'five.tsp'])
  expect(await saved(lab, 'tsplib', 2)).toEqual(written)
  expect(await saved(lab, 'points', 1)).toEqual(exportScene(scene, 'csv'))
  const [tour] = await saved(lab, 'tour', 1)
  expect(tour).toEqual(sessionAt({ planner: 'bat', scene, seed: ANTS.seed }, 7, (session) => session.tourFile()))
  await page.keyboard.press('Escape')

  await page.getByTestId('scene-file').setInputFiles([file({ name: 'three.csv', bytes: bytes('x,y\n0,0\n3,0\n0,4\n') })])
  await expect(page.getByTestId('result-strip')).toContainText('12')
  await expect(page.getByTestId('result-strip')).toContainText(en.result.equal(en.result.tours.matrix))
})

test('where the file knows the optimum, that is the reference', async ({ lab, page }) => {
  const setup = { planner: 'bat', scene: 'random-52', params: { local_search: 'none' } }
  await begin(lab, 5, setup)
  const outcome: Outcome = sessionAt(setup, 5, (session) => session.outcome())
  expect(outcome.exact_by).toBe('stored')
  await expect(page.getByTestId('result-strip')).toContainText(en.result.above(percent(outcome.gap ?? NaN), en.result.tours.stored))
})

test('random stops are previewed and made; of more than are toured exactly no optimum is claimed', async ({ lab, page }) => {
  await begin(lab)
  await lab.section('scene')
  await page.getByTestId('generate').click()
  await page.getByTestId('generator').selectOption('stops')
  await page.getByTestId('map-seed').fill('3')
  await page.getByTestId('map-seed').press('Enter')
  const stops = page.getByTestId('generate-dialog').locator('[data-parameter="stops"] input.typed')
  await stops.fill('20')
  await stops.press('Tab')
  await expect(page.getByTestId('stops-preview').locator('circle')).toHaveCount(20)
  await page.getByTestId('make').click()
  await expect(lab.root).toHaveAttribute('data-limit', '100')
  const scene = generateScene('stops', { stops: 20 }, 3)
  const hash = await lab.seek(9)
  expect(verified(await lab.link(hash)).scene).toEqual(scene)
  expect(hash).toBe(hashOf({ ...ANTS, scene }, 9))
  await lab.section('result')
  await expect(page.getByTestId('result-gap')).toHaveText(closer.result.noTour)
  await expect(page.getByTestId('tour-order')).toContainText(tours.order.title('20'))
})
