import { readFileSync, writeFileSync } from 'node:fs'
import { createServer } from 'node:http'
import type { AddressInfo } from 'node:net'
import { test as base, expect, type Frame, type FrameLocator, type Page } from '@playwright/test'
import { linkTo, verified } from './support/core'
import { en, HASH, Lab, pick } from './support/lab'
import { SITE } from './support/site'

/* A run on another page, in a file and in the page: each shows what the core computes for the link. */

const FILE = new URL('../dist-single/forage.html', import.meta.url)
const ELEMENT = readFileSync(new URL('../dist-element/element.js', import.meta.url), 'utf8')
const SPEAKER = readFileSync(new URL('../../pkg/embed.js', import.meta.url), 'utf8')

const SWARM = linkTo({ seed: 3 }, 20)
const ANTS = linkTo({ planner: 'aco-direction', scene: 'ant-bat-30', seed: 2 }, 5)
const ARM = linkTo({ planner: 'rrt-guided', scene: 'arm-cuboid', seed: 1 }, 60)

interface Watched {
  /** Errors, and what the page's policy did not let happen. */
  wrongs: string[]
  /** Opens a page of somebody else, with these scripts beside it. */
  course(body: string, scripts?: Record<string, string>): Promise<void>
}

const test = base.extend<{ watched: Watched }>({
  watched: async ({ page }, use) => {
    const wrongs: string[] = []
    page.on('pageerror', (error) => wrongs.push(`error: ${error.message}`))
    page.on('console', (message) => {
      if (message.type() === 'error' && !message.text().includes('ReadPixels')) wrongs.push(message.text())
    })
    // Somebody else's site: another port is another origin.
    const files: Record<string, string> = {}
    const server = createServer(({ url = '' }, response) => {
      response.setHeader('content-type', url.endsWith('.js') ? 'text/javascript' : 'text/html')
      response.end(files[url.slice(1)])
    })
    await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve))
    await use({
      wrongs,
      course: async (body, scripts = {}) => {
        const head = '<meta charset="utf-8"><title>Course</title><link rel="icon" href="data:,">'
        Object.assign(files, scripts, { '': `<!doctype html>${head}${body}` })
        await page.goto(`http://127.0.0.1:${(server.address() as AddressInfo).port}/`)
      },
    })
    server.close()
    expect(wrongs).toEqual([])
  },
})

const hashIn = (of: Page | Frame | FrameLocator) => expect(of.locator('[data-hash]').first())
const embedIn = (page: Page): FrameLocator => page.frameLocator('iframe[src*="?embed"]')

for (const [width, height] of [
  [480, 320],
  [320, 240],
] as const) {
  test(`an embed of ${width} × ${height} has a stage and what plays it, and nothing scrolls`, { tag: '@smoke' }, async ({
    page,
    watched,
  }) => {
    void watched
    await page.setViewportSize({ width, height })
    await page.goto(`${SITE}?embed${SWARM}`)
    await hashIn(page).toHaveAttribute('data-hash', verified(SWARM).hash ?? '')
    await expect(page.locator('nav, aside, [role="tab"]')).toHaveCount(0)
    const stage = await page.getByTestId('stage').boundingBox()
    expect(stage?.width).toBe(width)
    expect(stage?.height).toBeGreaterThan(height / 2.2)
    for (const name of ['play', 'step-back', 'step-forward', 'timeline', 'speed', 'whole']) {
      const box = await page.getByTestId(name).boundingBox()
      expect(box && box.x >= 0 && box.y >= 0 && box.x + box.width <= width && box.y + box.height <= height, name).toBe(true)
    }
    const beyond = await page.evaluate(() => [document.documentElement.scrollWidth, document.documentElement.scrollHeight])
    expect(beyond).toEqual([width, height])
    await page.getByTestId('step-forward').click()
    await hashIn(page).toHaveAttribute('data-iteration', '21')
    await expect(page.getByTestId('whole')).toHaveAttribute('href', /planner=wcpso.*at=21/)
  })
}

test('a page around an embed plays, steps and seeks it, and receives its events; no other frame does', async ({ page, watched }) => {
  await watched.course(
    `<iframe id="run" src="${SITE}?embed${SWARM.replaceAll('&', '&amp;')}" width="480" height="320"></iframe>
     <iframe id="other" srcdoc="<script>setInterval(() => parent.frames[0].postMessage({ forage: 1, is: 'seek', to: 90 }, '*'), 50)</script>"></iframe>
     <script type="module">
       import { connect } from './embed.js'
       globalThis.told = []
       globalThis.run = connect(document.getElementById('run'))
       globalThis.stop = run.listen((event) => told.push(event))
     </script>`,
    { 'embed.js': SPEAKER },
  )
  const told = () =>
    page.evaluate(() => (globalThis as unknown as { told: { is: string; state?: { iteration: number; hash: string } }[] }).told)
  const ask = (text: string): Promise<unknown> =>
    page.evaluate((source) => new Function('run', source)((globalThis as unknown as { run: unknown }).run), text)
  const settles = (iteration: number, hash: string | undefined) =>
    expect.poll(async () => (await told()).findLast(({ state }) => state?.hash)?.state).toMatchObject({ iteration, hash })
  await settles(20, verified(SWARM).hash)
  expect((await told())[0]).toMatchObject({ is: 'ready', state: { planner: 'wcpso', scene: 'wcpso-discs', seed: 3 } })
  await ask('run.step(-2)')
  await settles(18, verified(linkTo({ seed: 3 }, 18)).hash)
  await ask('run.seek(30)')
  await settles(30, verified(linkTo({ seed: 3 }, 30)).hash)
  await ask(`run.open(${JSON.stringify(ANTS)})`)
  await settles(5, verified(ANTS).hash)
  await ask('run.play()')
  await expect.poll(async () => (await told()).at(-1)?.state?.iteration).toBeGreaterThan(7)
  await ask('run.pause()')
  await ask('run.seek(Infinity)')
  await expect.poll(async () => (await told()).some(({ is }) => is === 'end')).toBe(true)
  await ask('run.seek(1.5)')
  await expect.poll(told).toContainEqual({ is: 'error', message: 'to: 1.5 is not a whole number.' })
  await page.evaluate(() => {
    const { stop, told } = globalThis as unknown as { stop(): void; told: unknown[] }
    stop()
    told.length = 0
  })
  await ask('run.seek(3)')
  await hashIn(embedIn(page)).toHaveAttribute('data-iteration', '3')
  expect(await told()).toEqual([])
})

const escaped = (link: string): string => link.replaceAll('&', '&amp;')

test('a page of 20 lines has two elements and an iframe, each with the run that the core computes', { tag: '@smoke' }, async ({
  page,
  watched,
}) => {
  await page.setViewportSize({ width: 800, height: 900 })
  await watched.course(
    `<script src="element.js"></script>
     <p><forage-run id="swarm" src="${escaped(SWARM)}" style="width: 480px; height: 320px"></forage-run>
     <p><forage-run id="ants" planner="aco-direction" scene="ant-bat-30" seed="2" at="5" controls="none" theme="dark" style="width: 320px; height: 240px"></forage-run>
     <iframe src="${SITE}?embed${escaped(ARM)}" width="320" height="240"></iframe>`,
    { 'element.js': ELEMENT },
  )
  await expect(page.locator('#swarm')).toHaveAttribute('data-hash', verified(SWARM).hash ?? '')
  await expect(page.locator('#ants')).toHaveAttribute('data-hash', verified(ANTS).hash ?? '')
  await hashIn(embedIn(page)).toHaveAttribute('data-hash', verified(ARM).hash ?? '')
  await expect(page.locator('#ants').getByTestId('play')).toHaveCount(0)
  // The page's own styles and those of the elements leave each other alone.
  expect(await page.evaluate(() => getComputedStyle(document.body).margin)).toBe('8px')
  const canvas = page.locator('#swarm').getByTestId('stage')
  await canvas.focus()
  await page.keyboard.press('ArrowRight')
  await expect(page.locator('#swarm')).toHaveAttribute('data-iteration', '21')
  await expect(page.locator('#ants')).toHaveAttribute('data-iteration', '5')
})

test('an element begins when it comes into view, rests out of sight, and follows its attributes', async ({ page, watched }) => {
  await watched.course(
    `<script src="element.js"></script><script src="element.js"></script><div style="height: 3000px"></div>
     <forage-run planner="pso" scene="sphere-2" seed="4" params="population=30; w=0.8" autoplay></forage-run>
     <div style="height: 3000px"></div>`,
    { 'element.js': ELEMENT },
  )
  const run = page.locator('forage-run')
  await page.evaluate(() => {
    const told: string[] = []
    Object.assign(globalThis, { told })
    for (const is of ['ready', 'step', 'end', 'error'])
      document
        .querySelector('forage-run')
        ?.addEventListener(is, (event) => told.push(`${is} ${JSON.stringify((event as CustomEvent).detail)}`))
  })
  await page.waitForTimeout(300)
  expect(await run.getAttribute('data-phase')).toBeNull()
  await run.scrollIntoViewIfNeeded()
  await expect(run).toHaveAttribute('data-playing', 'true')
  await expect.poll(async () => Number(await run.getAttribute('data-iteration'))).toBeGreaterThan(3)
  await page.evaluate(() => scrollTo(0, 0))
  await expect(run).toHaveAttribute('data-playing', 'false')
  await run.scrollIntoViewIfNeeded()
  await expect(run).toHaveAttribute('data-playing', 'true')
  await run.evaluate((element) => (element as unknown as { pause(): void }).pause())
  await run.evaluate((element) => (element as unknown as { seek(to: number): void }).seek(12))
  const setup = { planner: 'pso', scene: 'sphere-2', seed: 4, params: { population: 30, w: 0.8 } }
  await expect(run).toHaveAttribute('data-hash', verified(linkTo(setup, 12)).hash ?? '')
  const told = await page.evaluate(() => (globalThis as unknown as { told: string[] }).told)
  expect(told[0]).toMatch(/^ready \{"planner":"pso"/)
  expect(told.at(-1)).toContain('"iteration":12')
  await run.evaluate((element, link) => {
    element.removeAttribute('autoplay')
    element.setAttribute('src', link)
  }, ANTS)
  await expect(run).toHaveAttribute('data-hash', verified(ANTS).hash ?? '')
  await run.evaluate((element) => element.setAttribute('src', '#v=1&planner=nobody&scene=sphere&seed=1&at=0'))
  await expect
    .poll(async () => (await page.evaluate(() => (globalThis as unknown as { told: string[] }).told)).at(-1))
    .toMatch(/^error .*nobody/)
  // One that is taken away leaves no thread behind.
  await run.evaluate((element) => element.remove())
  await expect.poll(() => page.workers().length).toBeLessThanOrEqual(1)
  // Nor does one that is gone before it has begun.
  await page.evaluate(async () => {
    const run = Object.assign(document.createElement('forage-run'), { style: 'position: fixed; inset: 0' })
    document.body.append(run)
    while (run.dataset.phase === undefined) await new Promise(requestAnimationFrame)
    run.remove()
  })
  await page.waitForTimeout(500)
  expect(page.workers().length).toBeLessThanOrEqual(1)
})

test(
  'the page in one file opens from a disk, with the run that it was saved with, and asks for nothing',
  { tag: '@smoke' },
  async ({ page, watched, context }, info) => {
    void watched
    const lab = new Lab(page)
    await lab.open(ARM)
    await lab.settled(60)
    await lab.press(en.bar.exports)
    const [download] = await Promise.all([page.waitForEvent('download'), page.getByTestId('export-file').click()])
    const saved = info.outputPath('saved.html')
    await download.saveAs(saved)
    expect(readFileSync(saved).length).toBeLessThan(4_000_000)

    const file = await context.newPage()
    const [asked, wrongs]: string[][] = [[], []]
    file.on('request', (request) => asked?.push(request.url()))
    file.on('console', (message) => {
      if (message.type() === 'error') wrongs?.push(message.text())
    })
    await file.goto(`file://${saved}`)
    await hashIn(file).toHaveAttribute('data-hash', verified(ARM).hash ?? '')
    await expect(file.getByTestId('space-words')).not.toBeEmpty()
    // It goes on from there, with another part of the core, and can be saved again.
    await pick(file, 'planner', 'aco')
    await hashIn(file).toHaveAttribute('data-stale', 'false')
    await file.getByTestId('play').click()
    await expect.poll(async () => Number(await file.locator('[data-iteration]').first().getAttribute('data-iteration'))).toBeGreaterThan(1)
    await file.getByTestId('play').click()
    await hashIn(file).toHaveAttribute('data-hash', HASH)
    const hash = await file.locator('[data-hash]').first().getAttribute('data-hash')
    await file.getByRole('button', { name: en.bar.exports, exact: true }).click()
    const [again] = await Promise.all([file.waitForEvent('download'), file.getByTestId('export-file').click()])
    const second = info.outputPath('second.html')
    await again.saveAs(second)
    await file.goto(`file://${second}`)
    await hashIn(file).toHaveAttribute('data-hash', hash ?? '')
    // Its lessons are a click away.
    await file.getByTestId('view-learn').click()
    await file.getByTestId('open-lesson-pso').click()
    await file.getByTestId('lesson-next').click()
    await expect(file.getByTestId('lesson')).toHaveAttribute('data-step', 'best')
    await expect(file.locator('[data-iteration]').first()).toHaveAttribute('data-iteration', '2')
    expect(asked?.filter((url) => !url.startsWith('file:') && !url.startsWith('blob:') && !url.startsWith('data:'))).toEqual([])
    expect(wrongs?.filter((text) => !text.includes('ReadPixels'))).toEqual([])
  },
)

test('the file of the build opens a link that is put after its name', async ({ page, watched }) => {
  void watched
  await page.goto(`${FILE.href}${ANTS}`)
  await hashIn(page).toHaveAttribute('data-hash', verified(ANTS).hash ?? '')
})

test('the dialog gives what shows this run on another page', async ({ page, watched }, info) => {
  const lab = new Lab(page)
  await lab.open(SWARM)
  await lab.settled(20)
  await page.getByTestId('embed').click()
  const code = page.getByTestId('embed-code')
  await expect(code).toHaveValue(/^<iframe src="[^"]*\?embed#v=1/)
  await page.getByRole('radio', { name: 'None' }).check()
  await page.getByTestId('embed-width').fill('100')
  await expect(page.getByTestId('embed-width')).toHaveAttribute('aria-invalid', 'true')
  await page.getByTestId('embed-width').fill('500')
  await expect(code).toHaveValue(/embed&amp;controls=none#v=1.* width="500"/)
  const preview = page.frameLocator('[data-testid="embed-preview"]')
  await expect(preview.locator('[data-hash]').first()).toHaveAttribute('data-hash', verified(SWARM).hash ?? '')
  await expect(preview.getByTestId('play')).toHaveCount(0)
  const iframe = await code.inputValue()
  await page.getByRole('radio', { name: 'The element' }).check()
  const element = await code.inputValue()
  writeFileSync(info.outputPath('texts.txt'), `${iframe}\n${element}`)
  await watched.course(`${iframe}${element.replace(/src="[^"]*element\.js"/, 'src="element.js"')}`, { 'element.js': ELEMENT })
  await hashIn(embedIn(page)).toHaveAttribute('data-hash', verified(SWARM).hash ?? '')
  await expect(page.locator('forage-run')).toHaveAttribute('data-hash', verified(SWARM).hash ?? '')
})

test('the example page shows what its links and attributes say', async ({ page, watched }) => {
  void watched
  await page.setViewportSize({ width: 800, height: 2400 })
  await page.goto(`${SITE}course.html`)
  const [swarm, ants] = [page.locator('forage-run').first(), page.locator('forage-run').last()]
  await expect(swarm).toHaveAttribute(
    'data-hash',
    verified(linkTo({ planner: 'pso', scene: 'sphere-2', seed: 4, params: { population: 30 } }, 0)).hash ?? '',
  )
  await expect(ants).toHaveAttribute('data-hash', verified(ANTS).hash ?? '')
  await hashIn(embedIn(page)).toHaveAttribute('data-hash', verified(ARM).hash ?? '')
  // On a phone nothing is wider than the screen.
  await page.setViewportSize({ width: 390, height: 844 })
  const widths = await page.locator('forage-run').evaluateAll((all) => all.map((run) => run.getBoundingClientRect().right))
  expect(Math.max(...widths)).toBeLessThanOrEqual(390)
})
