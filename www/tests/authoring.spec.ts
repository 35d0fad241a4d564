import { readFileSync } from 'node:fs'
import { authoring as text } from '../src/locales/en/authoring'
import { readLesson } from '../src/lessons/read'
import { violations } from './support/axe'
import { hashOf, linkTo } from './support/core'
import { expect, test } from './support/lab'

const SETUP = { planner: 'pso', scene: 'sphere-2', seed: 2, params: { population: 12 } } as const

test('a lesson is captured, written, read, saved, opened and shared', { tag: '@smoke' }, async ({ lab, page, context }) => {
  await context.grantPermissions(['clipboard-read', 'clipboard-write'])
  await lab.open(`${linkTo(SETUP, 4)}&page.item=particles.1`)
  await lab.settled(4)
  await expect(page.getByTestId('inspect')).toContainText('Particle 1')
  await page.getByTestId('capture').click()
  await expect(page.getByText(text.captured(1))).toBeVisible()
  await lab.seek(9)
  await page.getByTestId('capture').click()
  await expect(page.getByText(text.captured(2))).toBeVisible()

  await page.getByTestId('view-learn').click()
  await page.getByTestId('write-lesson').click()
  await expect(page.getByTestId('editor-wrong')).toContainText('texts.en.title')
  await page.getByTestId('lesson-title').fill('My swarm')
  await page.getByTestId('lesson-summary').fill('A swarm in two steps.')
  await page.getByTestId('lesson-goals').fill('see a step\nsay why')
  await page.getByTestId('step-text-1').fill('Where does $\\omega$ lead? <img src=x onerror=alert(1)> **Here**.')
  const preview = page.getByTestId('step-preview-1')
  await expect(preview.locator('math')).toHaveCount(1)
  await expect(preview.locator('strong')).toHaveText('Here')
  // Tags are text.
  await expect(preview.locator('img')).toHaveCount(0)
  await expect(preview).toContainText('<img src=x onerror=alert(1)>')
  await page.getByTestId('step-text-2').fill('Later.')
  await page.getByTestId('question-kind-1').selectOption('arrow')
  await page.getByTestId('question-text-1').fill('Where does it go?')
  await page.getByTestId('question-kind-2').selectOption('run')
  await page.getByTestId('question-at-2').fill('20')
  await page.getByTestId('option-text-2-1').fill('Below 1')
  await page.getByTestId('option-text-2-2').fill('1 or more')
  await expect(page.getByTestId('editor-wrong')).toHaveCount(0)
  expect(await violations(lab)).toEqual([])

  // It is still there after a reload.
  await expect.poll(() => page.evaluate(() => localStorage.getItem('forage.draft') ?? '')).toContain('1 or more')
  await page.reload()
  await expect(page.getByTestId('lesson-title')).toHaveValue('My swarm')

  const saved = page.waitForEvent('download')
  await page.getByTestId('editor-save').click()
  const file = await (await saved).path()
  const lesson = readLesson(readFileSync(file, 'utf8'))
  expect(lesson).toMatchObject({ name: 'my-swarm', steps: [{ at: 4, run: SETUP, item: { role: 'particles', index: 1 } }, { at: 9 }] })

  await page.getByTestId('editor-read').click()
  await expect(page.getByTestId('lesson')).toHaveAttribute('data-lesson', 'my-swarm')
  expect(await lab.settled(4)).toBe(hashOf(SETUP, 4))
  await expect(page.getByTestId('predict')).toHaveClass(/active/)

  await page.getByTestId('lesson-close').click()
  await page.getByTestId('step-down-1').click()
  await expect(page.getByTestId('step-text-1')).toHaveValue('Later.')
  await page.getByTestId('editor-share').click()
  await expect(page.getByText(text.shared)).toBeVisible()
  const link = await page.evaluate(() => navigator.clipboard.readText())
  expect(link).toMatch(/#lesson=~[\w-]+$/)

  await page.getByTestId('editor-close').click()
  await page.getByTestId('open-lesson-file').setInputFiles(file)
  await expect(page.getByTestId('lesson')).toHaveAttribute('data-lesson', 'my-swarm')
  expect(await lab.settled(4)).toBe(hashOf(SETUP, 4))

  await page.goto(link)
  await page.reload()
  await expect(page.getByTestId('lesson')).toHaveAttribute('data-lesson', 'my-swarm')
  await expect(page.getByTestId('lesson')).toHaveAttribute('data-step', 'step-2')
  expect(await lab.settled(9)).toBe(hashOf(SETUP, 9))
})

test('a file that is no lesson is refused with the place', async ({ lab, page }) => {
  await lab.open('#view=learn')
  const file = page.getByTestId('open-lesson-file')
  await file.setInputFiles({ name: 'x.json', mimeType: 'application/json', buffer: Buffer.from('{"format":"forage-lesson"}') })
  await expect(page.getByRole('alert')).toContainText('x.json: `version` is missing')
  await file.setInputFiles({ name: 'y.json', mimeType: 'application/json', buffer: Buffer.from('{') })
  await expect(page.getByRole('alert')).toContainText('y.json: The lesson is not JSON')
})

test('a draft is deleted only when asked twice', async ({ lab, page }) => {
  await lab.open()
  await page.getByTestId('capture').click()
  await page.getByTestId('view-learn').click()
  await page.getByTestId('write-lesson').click()
  await page.getByTestId('editor-delete').click()
  await expect(page.getByTestId('edit-step-1')).toBeVisible()
  await page.getByTestId('editor-delete').click()
  await expect(page.getByTestId('edit-step-1')).toHaveCount(0)
  expect(await page.evaluate(() => localStorage.getItem('forage.draft'))).toBeNull()
})
