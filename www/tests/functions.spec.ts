import { readFileSync } from 'node:fs'
import { functions } from '../src/locales/en/functions'
import { common as en } from '../src/locales/en/common'
import { violations } from './support/axe'
import { expect, pick, test } from './support/lab'

test('a function is written with its heat map, searched, and travels in a link', async ({ lab, page }) => {
  await lab.open('#v=1&planner=pso&scene=sphere-2&seed=1&at=0')
  await pick(page, 'scene', 'function')
  const dialog = page.getByTestId('function-dialog')
  const formula = dialog.getByTestId('function-expression')
  // It begins with the function that there is.
  await expect(formula).toHaveValue('sum(x[i]^2)')
  const heights = dialog.getByTestId('function-heights')
  const picture = () => heights.evaluate((canvas: HTMLCanvasElement) => canvas.toDataURL())
  await expect(dialog.getByTestId('use-function')).toBeEnabled()
  const before = await picture()

  expect(await violations(lab)).toEqual([])
  await formula.fill('(x - 30)^2 + (y + 20)^2 +')
  await expect(dialog.getByTestId('function-error')).toContainText('character 26')
  await expect(dialog.getByTestId('use-function')).toBeDisabled()
  expect(await picture()).toBe(before)
  expect(await violations(lab)).toEqual([])
  await formula.fill('(x - 30)^2 + (y + 20)^2 + 5')
  await expect(dialog.getByTestId('function-error')).toHaveCount(0)
  await expect.poll(picture).not.toBe(before)
  // What was known of the sphere does not hold any more.
  await expect(dialog.getByTestId('function-optimum')).toHaveValue('')
  await dialog.getByTestId('function-high').fill('100, 50')
  await dialog.getByTestId('function-optimum').fill('5')
  // What is typed last counts, however soon the button is pressed; what was typed of the minimum stays.
  await formula.fill('(x - 30)^2 + (y + 20)^2 + 5.0')
  await dialog.getByTestId('function-title').fill('Off the middle')
  await dialog.getByTestId('use-function').click()
  await expect(dialog).toHaveCount(0)
  await expect(page.getByTestId('scene')).toHaveValue('Off the middle')

  await lab.button(en.transport.end).click()
  await expect(lab.root).toHaveAttribute('data-status', 'exhausted')
  await lab.section('result')
  await expect(page.getByTestId('result-value')).toHaveText('5')
  await expect(page.getByTestId('result-gap')).toContainText('5')
  const hash = await lab.settled()
  await page.reload()
  await expect(lab.root).toHaveAttribute('data-hash', hash)
  await lab.section('scene')
  await expect(page.getByTestId('formula')).toHaveText('(x - 30)^2 + (y + 20)^2 + 5.0')

  // The editor opens with what there is, and its fields are refused one by one.
  await page.getByTestId('write-function').click()
  await expect(formula).toHaveValue('(x - 30)^2 + (y + 20)^2 + 5.0')
  await expect(dialog.getByTestId('function-high')).toHaveValue('100, 50')
  for (const [field, wrong] of [
    ['low', 'left'],
    ['high', '-200'],
    ['dimension', '1.5'],
    ['optimum', 'none'],
  ] as const) {
    const input = dialog.getByTestId(`function-${field}`)
    const right = await input.inputValue()
    await input.fill(wrong)
    await expect(input).toHaveAttribute('aria-invalid', 'true')
    await expect(dialog.getByTestId('use-function')).toBeDisabled()
    await input.fill(right)
  }
  await dialog.getByTestId('function-optimum').fill('')
  await expect(dialog.getByTestId('use-function')).toBeEnabled()
  await dialog.getByRole('button', { name: functions.cancel }).click()
})

test('a function that is not defined everywhere ends the run, and the page says where', async ({ lab, page }) => {
  await lab.open('#v=1&planner=pso&scene=sphere-2&seed=1&at=0')
  await lab.section('scene')
  await page.getByTestId('write-function').click()
  await page.getByTestId('function-expression').fill('sqrt(x) + y^2')
  await page.getByTestId('use-function').click()
  await lab.button(en.transport.end).click()
  await expect(lab.root).toHaveAttribute('data-status', 'failed')
  await expect(page.getByTestId('trouble')).toContainText('is not a number, at (')
  await lab.section('result')
  await expect(page.getByTestId('result-trouble')).toContainText('is not a number')
  // It is right again: the run is, too.
  await page.getByTestId('tab-setup').click()
  await page.getByTestId('write-function').click()
  await page.getByTestId('function-expression').fill('sqrt(abs(x)) + y^2')
  await page.getByTestId('use-function').click()
  await lab.button(en.transport.end).click()
  await expect(lab.root).toHaveAttribute('data-status', 'exhausted')
  await lab.section('result')
  await expect(page.getByTestId('result-trouble')).toHaveCount(0)
})

test('a file with a formula opens like any other, and a wrong one is refused with its place', async ({ lab, page }) => {
  await lab.open()
  await lab.section('scene')
  const scene = JSON.parse(readFileSync(new URL('../../scenes/sphere.json', import.meta.url), 'utf8'))
  const { function: _named, ...head } = scene
  const file = (expression: string) => ({
    name: 'own.json',
    mimeType: 'application/json',
    buffer: Buffer.from(JSON.stringify({ ...head, name: 'own', expression, bounds: { min: -1, max: 1 } })),
  })
  await page.getByTestId('scene-file').setInputFiles(file('sum(x[i]^4)'))
  await expect(page.getByTestId('formula')).toHaveText('sum(x[i]^4)')
  await page.getByTestId('scene-file').setInputFiles(file('sum(x[i]^4'))
  await expect(page.getByTestId('notice')).toContainText('character 11')
})
