import { readFileSync } from 'node:fs'
import { catalogue, type Drive } from '../../pkg/node.js'
import palette from '../../src/describe/palette.json' with { type: 'json' }
import { closer } from '../src/locales/en/closer'
import { figures } from '../src/locales/en/figures'
import { number } from '../src/text/number'
import { Track } from '../src/scene/track'
import { linkTo, sessionAt } from './support/core'
import { en, expect, type Lab, test } from './support/lab'

const GRID = { planner: 'ltqpso', scene: 'qpso-10m' }
const text = closer.drive

/** What the core says of the drive along the result at an iteration. */
function driven(iteration: number, params = {}): Drive {
  const drive = sessionAt(GRID, iteration, (session) => session.drive(params))
  if (!drive) throw new Error('no drive')
  return drive
}

async function begin(lab: Lab, iteration: number): Promise<string> {
  await lab.open(linkTo(GRID, iteration))
  const hash = await lab.settled(iteration)
  await lab.section('drive')
  await lab.page.getByTestId('drive-begin').click()
  await expect(lab.page.getByTestId('drive-bar')).toBeVisible()
  return hash
}

async function figuresAre(lab: Lab, { outcome }: Drive): Promise<void> {
  const figure = (name: string) => lab.page.getByTestId('drive-figures').locator(`[data-figure="${name}"]`)
  await expect(figure('time')).toHaveText(`${number(outcome.time)} s`)
  await expect(figure('distance')).toHaveText(`${number(outcome.distance)} m`)
  await expect(figure('max_error')).toHaveText(`${number(outcome.max_error, 3)} m`)
  await expect(figure('rms_error')).toHaveText(`${number(outcome.rms_error, 3)} m`)
  await expect(figure('clearance')).toHaveText(`${number(outcome.clearance, 3)} m`)
  await expect(figure('counts')).toHaveText(outcome.counts.map((count) => number(Math.round(count))).join(' / '))
  const verdict = lab.page.getByTestId('drive-verdict')
  await expect(verdict).toHaveAttribute('data-arrived', String(outcome.arrived))
  await expect(verdict).toHaveAttribute('data-touched', String(outcome.touched))
}

/** How much of the layer over the stage is drawn on. */
const inked = (lab: Lab): Promise<number> =>
  lab.page.getByTestId('drive-layer').evaluate((layer: HTMLCanvasElement) => {
    const copy = new OffscreenCanvas(layer.width, layer.height).getContext('2d', { willReadFrequently: true })
    copy?.drawImage(layer, 0, 0)
    const pixels = copy?.getImageData(0, 0, layer.width, layer.height).data ?? []
    let sum = 0
    for (let at = 3; at < pixels.length; at += 4) if (pixels[at]) sum += 1
    return sum
  })

test('the robot drives along the result: played, scrubbed, and told as the core tells it', { tag: '@smoke' }, async ({ lab, page }) => {
  const hash = await begin(lab, 50)
  const drive = driven(50)
  const track = new Track(drive)
  await figuresAre(lab, drive)
  const time = page.getByTestId('drive-time')
  await expect.poll(async () => Number(await time.inputValue())).toBeGreaterThan(1)
  expect(await inked(lab)).toBeGreaterThan(500)
  await lab.press(text.pause)

  const middle = Math.round(track.end / 2)
  await time.fill(String(middle))
  const row = track.row(middle)
  for (const [name, value] of Object.entries(track.values(row))) {
    if (['time', 'x', 'y', 'heading'].includes(name)) continue
    await expect(page.getByTestId('drive').locator(`[data-now="${name}"]`)).toContainText(number(value))
  }
  await time.fill('0')
  const least = await inked(lab)
  await page.getByTestId('drive-chart').first().press('End')
  await expect.poll(() => inked(lab)).toBeGreaterThan(least)

  // The run stands where it stood.
  await lab.press(text.leave)
  await expect(page.getByTestId('drive-layer')).toHaveCount(0)
  expect(await lab.settled(50)).toBe(hash)
})

test('on the stage, keys are for the drive’s time; Escape leads back, a step of the run too', async ({ lab, page }) => {
  await begin(lab, 30)
  const time = page.getByTestId('drive-time')
  const now = async (): Promise<number> => Number(await time.inputValue())
  await lab.stage.focus()
  await page.keyboard.press('Home')
  expect(await now()).toBe(0)
  await page.keyboard.press('ArrowRight')
  await page.keyboard.press('Shift+ArrowRight')
  expect(await now()).toBe(11)
  await page.keyboard.press('Space')
  await expect.poll(now).toBeGreaterThan(12)
  await page.keyboard.press('Space')
  expect(await lab.iteration()).toBe(30)
  await page.keyboard.press('Escape')
  await expect(page.getByTestId('drive-bar')).toHaveCount(0)
  await expect(lab.button(en.transport.play)).toBeVisible()

  await page.getByTestId('tool-drive').click()
  await expect(page.getByTestId('drive-layer')).toHaveCount(1)
  await lab.tab('chart')
  await page.getByTestId('chart-plot').press('ArrowLeft')
  await expect(page.getByTestId('drive-layer')).toHaveCount(0)
  await lab.settled(29)
})

test('a drive that touches an obstacle says so, and where', async ({ lab, page }) => {
  await begin(lab, 50)
  await expect(page.getByTestId('drive-verdict')).toContainText(text.fine)
  // Who looks far ahead cuts corners.
  const params = { look_ahead: 2 }
  const { outcome } = driven(50, params)
  expect(outcome.touched).toBe(true)
  await page.getByText(text.parameters, { exact: true }).click()
  const field = page.getByTestId('drive').locator('[data-parameter="look_ahead"] input.typed')
  await field.fill('2')
  await field.press('Enter')
  await figuresAre(lab, { ...driven(50, params) })
  const [x = NaN, y = NaN] = outcome.touched_at ?? []
  await expect(page.getByTestId('drive-verdict')).toContainText(text.touched(number(x, 3), number(y, 3)))
})

test.describe('without motion', () => {
  test.use({ reducedMotion: 'reduce' })

  test('a drive stands at its beginning until it is played', async ({ lab, page }) => {
    await begin(lab, 50)
    await expect(lab.button(text.play)).toBeVisible()
    await expect(page.getByTestId('drive-time')).toHaveValue('0')
  })
})

test('a drive is saved as the core’s rows', async ({ lab, page }) => {
  await begin(lab, 50)
  const [download] = await Promise.all([page.waitForEvent('download'), page.getByTestId('drive-csv').click()])
  const lines = readFileSync(await download.path(), 'utf8')
    .trimEnd()
    .split('\n')
  const { columns, rows } = driven(50)
  expect(lines[0]).toBe(columns.join(','))
  expect(lines).toHaveLength(1 + rows.length / columns.length)
  expect(lines.at(-1)).toBe([...rows.subarray(-columns.length)].join(','))
})

test('a run that was going on stands still for the drive and goes on after it', async ({ lab, page }) => {
  await lab.open(linkTo(GRID, 2))
  await lab.settled(2)
  await page.getByTestId('speed').selectOption('5')
  await lab.press(en.transport.play)
  await expect.poll(() => lab.iteration()).toBeGreaterThan(3)
  await page.getByTestId('tool-drive').click()
  await lab.section('drive')
  await expect(page.getByTestId('drive-figures')).toBeVisible()
  await lab.settled()
  const stood = await lab.iteration()
  await figuresAre(lab, driven(stood))
  expect(await lab.iteration()).toBe(stood)
  await page.getByTestId('drive-leave').click()
  await expect.poll(() => lab.iteration()).toBeGreaterThan(stood + 1)
})

test('the drive’s parameters make another drive; what the core refuses is said beside them', async ({ lab, page }) => {
  await begin(lab, 50)
  const parameter = catalogue().drive.parameters.find(({ type, max }) => type === 'number' && max !== undefined)
  if (!parameter) throw new Error('no parameter')
  await page.getByText(text.parameters, { exact: true }).click()
  const row = page.getByTestId('drive').locator(`[data-parameter="${parameter.name}"]`)
  const field = row.locator('input.typed')
  await field.fill(String((parameter.max ?? 0) + 1))
  await field.press('Enter')
  await expect(row.getByRole('alert')).toContainText(parameter.name)
  await figuresAre(lab, driven(50))

  const value = Number(parameter.default) * 0.8
  await field.fill(String(value))
  await field.press('Enter')
  await expect(row.getByRole('alert')).toHaveCount(0)
  await figuresAre(lab, driven(50, { [parameter.name]: value }))
})

test('by keyboard: the drive takes the focus of the button that is gone, and the stage gets it back', async ({ lab, page }) => {
  await lab.open(linkTo(GRID, 50))
  await lab.settled(50)
  await lab.section('drive')
  await page.getByTestId('drive-begin').press('Enter')
  await expect(page.getByTestId('drive-play')).toBeFocused()
  await page.getByTestId('drive-leave').press('Enter')
  await expect(lab.stage).toBeFocused()
})

test('other parameters of the drive: the result’s own figures say that they are the default’s', async ({ lab, page }) => {
  await begin(lab, 50)
  await lab.section('result')
  const told = page.getByTestId('result-drive')
  await expect(told).not.toContainText(closer.result.driveDefault)
  await lab.section('drive')
  await page.getByText(text.parameters, { exact: true }).click()
  const field = page.getByTestId('drive').locator('[data-parameter="look_ahead"] input.typed')
  await field.fill('2')
  await field.press('Enter')
  await lab.section('result')
  await expect(told).toContainText(closer.result.driveDefault)
})

for (const width of [360, 920, 1000]) {
  test(`the bar of the drive fits ${width} pixels, with its time`, async ({ lab, page }) => {
    await page.setViewportSize({ width, height: 900 })
    await lab.open(linkTo(GRID, 50))
    await lab.settled(50)
    await page.getByTestId('tool-drive').click()
    const bar = page.getByTestId('drive-bar')
    await expect(bar.locator('p')).toBeVisible()
    expect(
      await bar.evaluate((node) =>
        [node.scrollWidth, ...[...node.children].map((child) => child.getBoundingClientRect().right)].every(
          (edge) => edge <= node.getBoundingClientRect().right,
        ),
      ),
    ).toBe(true)
  })
}

test('the driving robot is in files, too: in the page’s colours, and in those of print', async ({ lab, page }) => {
  await page.emulateMedia({ colorScheme: 'dark' })
  await begin(lab, 50)
  await lab.press(text.pause)
  await lab.choose('export')
  const drawing = async (look: string): Promise<string> => {
    await page.getByRole('radio', { name: look }).check({ force: true })
    const [saved] = await Promise.all([page.waitForEvent('download'), page.getByTestId('export-svg').click()])
    return (
      readFileSync(await saved.path(), 'utf8')
        .split(/<svg width="\d+" height="\d+"><g class="drive">/)[1]
        ?.split('</g>')[0] ?? 'not there'
    )
  }
  for (const [look, column] of [
    [figures.asShown, 1],
    [figures.print, 0],
  ] as const) {
    const [shown, ...others] = [column, 1 - column].map((at) => String(palette.robot[at]))
    const drive = await drawing(look)
    expect(drive, look).toContain(shown)
    for (const other of others) expect(drive, look).not.toContain(other)
  }
})
