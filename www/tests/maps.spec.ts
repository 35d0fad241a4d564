import { readFile } from 'node:fs/promises'
import { exportScene, generateScene, type GridScene, importScene, type NamedFile, type Scene } from '../../pkg/node.js'
import { setup } from '../src/locales/en/setup'
import { hashOf, linkTo, sceneOf, verified } from './support/core'
import { en, expect, Lab, test } from './support/lab'

const SIDE = 8
const ROWS = ['........', '.######.', '.#....#.', '.#.##.#.', '.#.##.#.', '.#....#.', '.###.##.', '........']
const MAP = `type octile\nheight ${SIDE}\nwidth ${SIDE}\nmap\n${ROWS.join('\n').replaceAll('#', '@')}\n`
const problem = (bucket: number, ends: number[], length: number): string => [bucket, 'court.map', SIDE, SIDE, ...ends, length].join('\t')
const SCEN = `version 1\n${problem(0, [0, 0, 7, 7], 14)}\n${problem(1, [2, 2, 0, 7], 9.5)}\n`

const file = (name: string, content: string | Uint8Array): { name: string; mimeType: string; buffer: Buffer } => ({
  name,
  mimeType: 'application/octet-stream',
  buffer: Buffer.from(content as string),
})

async function choose(lab: Lab, files: ReturnType<typeof file>[]): Promise<void> {
  await lab.section('scene')
  await lab.page.getByTestId('scene-file').setInputFiles(files)
}

/** The scene that the page has, as its link tells it. */
async function shown(lab: Lab): Promise<GridScene> {
  const { scene } = verified(await lab.link(await lab.seek(2)))
  if (scene.kind !== 'grid') throw new Error(scene.kind)
  return scene
}

test('a random map is previewed, made, run, undone, and the same elsewhere by its link', async ({ lab, page, browser }) => {
  await lab.open(linkTo({}, 8))
  const before = await lab.settled(8)
  await lab.section('scene')
  await page.getByTestId('generate').click()
  const dialog = page.getByTestId('generate-dialog')
  await page.getByTestId('generator').selectOption('maze')
  await page.getByTestId('map-seed').fill('7')
  await page.getByTestId('map-seed').press('Enter')
  for (const [name, value] of [
    ['columns', '21'],
    ['rows', '15'],
  ] as const) {
    await dialog.locator(`[data-parameter="${name}"] input.typed`).fill(value)
    await dialog.locator(`[data-parameter="${name}"] input.typed`).press('Tab')
  }
  await expect(page.getByTestId('map-preview')).toHaveAccessibleName(/21 × 15/)
  await page.getByTestId('make').click()
  await expect(dialog).toHaveCount(0)
  await expect.poll(() => lab.iteration()).toBeLessThan(8)

  await expect(page.getByTestId('scene')).toHaveValue('Maze, 21 × 15, seed 7')

  const made = generateScene('maze', { columns: 21, rows: 15 }, 7)
  const hash = await lab.seek(5)
  const link = await lab.link(hash)
  const setup = verified(link)
  expect(setup.scene).toEqual(made)
  expect(hash).toBe(hashOf({ planner: setup.planner, scene: made }, 5))

  const elsewhere = await browser.newContext()
  const other = new Lab(await elsewhere.newPage())
  await other.open(link)
  expect(await other.settled(5)).toBe(hash)
  await elsewhere.close()

  await lab.press(en.bar.undo)
  await expect(page.getByTestId('scene')).toHaveAttribute('data-value', 'wcpso-discs')
  expect(await lab.seek(8)).toBe(before)
})

test('random discs and shifted functions are previewed, made and run', async ({ lab, page }) => {
  await lab.open(linkTo({}, 3))
  await lab.settled(3)
  await lab.section('scene')
  const make = async (generator: string, preview: string, name: RegExp): Promise<Scene> => {
    await page.getByTestId('generate').click()
    await page.getByTestId('generator').selectOption(generator)
    await expect(page.getByTestId(preview)).toHaveAccessibleName(name)
    await page.getByTestId('make').click()
    await expect(page.getByTestId('generate-dialog')).toHaveCount(0)
    await lab.restarted()
    return verified(await lab.link(await lab.seek(2))).scene as Scene
  }
  expect(await make('discs', 'discs-preview', /14 discs/)).toEqual(generateScene('discs', {}, 1))
  expect(await make('shifted', 'function-preview', /2 variables/)).toEqual(generateScene('shifted', {}, 1))
})

test('what a random map can’t be is said beside the control, and the last map that can stays', async ({ lab, page }) => {
  await lab.open(linkTo({}, 3))
  await lab.settled(3)
  await lab.section('scene')
  await page.getByTestId('generate').click()
  const row = page.getByTestId('generate-dialog').locator('[data-parameter="share"]')
  await row.locator('input.typed').fill('3')
  await row.locator('input.typed').press('Tab')
  await expect(row.getByRole('alert')).toContainText('share')
  await expect(row.locator('input.typed')).toHaveValue('3')
  await expect(page.getByTestId('make')).toBeDisabled()
  await expect(page.getByTestId('map-preview')).toBeVisible()
  await row.locator('input.typed').fill('0.1')
  await row.locator('input.typed').press('Enter')
  await expect(row.getByRole('alert')).toHaveCount(0)
  await expect(page.getByTestId('make')).toBeEnabled()

  await page.getByTestId('map-seed').fill('none')
  await page.getByTestId('map-seed').press('Tab')
  await expect(page.getByRole('alert').filter({ hasText: setup.seedHint })).toBeVisible()
  await page.getByTestId('map-new-seed').click()
  await expect(page.getByTestId('map-seed')).not.toHaveValue('none')
  await expect(page.getByTestId('make')).toBeEnabled()
  await page.keyboard.press('Escape')
  await expect(page.getByTestId('generate-dialog')).toHaveCount(0)
})

test('the largest random map is made without keeping the page from moving', async ({ lab, page }) => {
  await lab.open(linkTo({}, 3))
  await lab.settled(3)
  await lab.section('scene')
  await page.getByTestId('generate').click()
  const dialog = page.getByTestId('generate-dialog')
  await page.evaluate(() => {
    const gaps = Object.assign(window, { longest: 0 })
    let last = performance.now()
    const look = (now: number): void => {
      gaps.longest = Math.max(gaps.longest, now - last)
      last = now
      requestAnimationFrame(look)
    }
    requestAnimationFrame(look)
  })
  for (const name of ['columns', 'rows']) {
    await dialog.locator(`[data-parameter="${name}"] input.typed`).fill('512')
    await dialog.locator(`[data-parameter="${name}"] input.typed`).press('Tab')
  }
  await expect(page.getByTestId('map-preview')).toHaveAccessibleName(/512 × 512/)
  expect(await page.evaluate(() => (window as unknown as { longest: number }).longest)).toBeLessThan(1000)
})

test('a map opens with its problems, of which one is chosen; what was read is told', async ({ lab, page }) => {
  await lab.open(linkTo({}, 8))
  await lab.settled(8)
  await choose(lab, [file('court.scen', SCEN), file('court.map', MAP)])
  const told = page.getByTestId('imported')
  await expect(told).toContainText('court.scen + court.map')
  const last = await shown(lab)
  expect(last.rows).toEqual(ROWS)
  expect([last.start, last.goal]).toEqual([
    [2.5, 2.5],
    [0.5, 7.5],
  ])

  const problems = page.getByTestId('problem')
  await expect(problems.locator('option')).toHaveCount(2)
  await expect(problems.locator('option').first()).toContainText('0: (0.5, 0.5) → (7.5, 7.5), 14 cells')
  await problems.selectOption('0')
  await expect(problems).toHaveValue('0')
  const first = await shown(lab)
  expect([first.start, first.goal]).toEqual([
    [0.5, 0.5],
    [7.5, 7.5],
  ])

  await told.getByRole('button', { name: en.notices.dismiss }).click()
  await expect(told).toHaveCount(0)
})

test('a map of map_server opens by being dropped, and what is unknown in it is told', async ({ lab, page }) => {
  await lab.open(linkTo({}, 8))
  await lab.settled(8)
  // Unknown is what is neither light nor dark.
  const shades = [254, 254, 205, 254, 0, 254, 254, 254, 254]
  const pgm = [...new TextEncoder().encode('P5\n3 3\n255\n'), ...shades]
  const yaml = 'image: yard.pgm\nresolution: 0.5\norigin: [0.0, 0.0, 0.0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n'
  const dropped = await page.evaluateHandle(
    ([text, bytes]) => {
      const transfer = new DataTransfer()
      transfer.items.add(new File([text], 'yard.yaml'))
      transfer.items.add(new File([new Uint8Array(bytes)], 'yard.pgm'))
      return transfer
    },
    [yaml, pgm] as const,
  )
  await page.getByTestId('stage').dispatchEvent('drop', { dataTransfer: dropped })
  await expect(page.getByTestId('imported')).toContainText(/unknown/i)
  const scene = await shown(lab)
  expect(scene.rows).toEqual(['..#', '.#.', '...'])
  expect(scene.cell).toBe(0.5)
})

test('files that can’t be read change nothing: file, line and reason are told, or the file that is missing', async ({ lab, page }) => {
  await lab.open(linkTo({}, 8))
  const hash = await lab.settled(8)
  const notice = page.getByTestId('notice')
  await choose(lab, [file('court.map', MAP.replace('.@@@@@@.', '.@@@@@.'))])
  await expect(notice).toContainText(/court\.map.*line 6.*7/)
  await choose(lab, [file('court.scen', SCEN)])
  await expect(notice).toContainText(/court\.scen.*court\.map/)
  await choose(lab, [file('yard.yaml', 'image: yard.pgm\nresolution: 1\norigin: [0, 0, 0]\n')])
  await expect(notice).toContainText(/yard\.yaml.*yard\.pgm/)
  await choose(lab, [file('scene.json', '{"format":')])
  await expect(notice).toContainText(/scene\.json.*JSON/)
  await choose(lab, [file('notes.txt', 'hello')])
  await expect(notice).toContainText('notes.txt')
  expect(await lab.settled(8)).toBe(hash)
})

const SETUP = { planner: 'aco', scene: 'wolf-ant-20' }
const cells = ({ rows, cell, start, goal, y_axis }: GridScene): unknown => ({ rows, cell, start, goal, y_axis })
const grid = (scene: Scene): GridScene => {
  if (scene.kind !== 'grid') throw new Error(scene.kind)
  return scene
}

for (const [format, id] of [
  ['movingai', 'movingai'],
  ['ros', 'ros'],
] as const) {
  test(`a grid that is written as ${format} and read again is the same`, async ({ lab, page }) => {
    await lab.open(linkTo(SETUP, 2))
    await lab.settled(2)
    await lab.press(en.bar.exports)
    const downloads: NamedFile[] = []
    page.on('download', async (download) => {
      downloads.push({ name: download.suggestedFilename(), bytes: new Uint8Array(await readFile(await download.path())) })
    })
    await page.getByTestId(`export-${id}`).click()
    await expect.poll(() => downloads.length).toBe(2)
    const expected = exportScene(sceneOf(SETUP), format)
    expect(downloads.map(({ name }) => name)).toEqual(expected.map(({ name }) => name))

    await page.keyboard.press('Escape')
    await choose(
      lab,
      downloads.map(({ name, bytes }) => file(name, bytes)),
    )
    // The run of before stands where this one is sought: it must be gone first.
    await expect(lab.root).toHaveAttribute('data-iteration', '0')
    const again = grid(importScene(expected).scene)
    expect(cells(await shown(lab))).toEqual(cells(again))
    // What these formats can't say, a cell's size or where a path ends, is left out of the comparison.
    expect(again.rows).toEqual(grid(sceneOf(SETUP)).rows)
  })
}

test('only grids are written as maps', async ({ lab, page }) => {
  await lab.open(linkTo({}, 2))
  await lab.settled(2)
  await lab.press(en.bar.exports)
  await expect(page.getByTestId('export-scene')).toBeVisible()
  await expect(page.getByTestId('export-movingai')).toHaveCount(0)
})
