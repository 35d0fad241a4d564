import { violations } from './support/axe'
import { expect, pick, test } from './support/lab'
import { CLIMBER, opened, behind, run } from './support/workshop'

test('a planner is written from a template, changed where the run is, and raced', async ({ lab, page }) => {
  await page.goto('./#view=workshop')
  await page.getByTestId('editor').waitFor()
  await pick(page, 'template', 'hill-climber')
  await expect(page.getByTestId('workshop-scene')).toHaveValue('Sphere, 2 variables')
  await expect(page.getByTestId('state')).toContainText('The page runs this code')
  await page.getByTestId('play').click()
  const before = await lab.seek(40)
  expect(await violations(lab)).toEqual([])

  // Another code: the same iteration and seed, and what was before as a ghost.
  await behind(page, '* normal()')
  await page.keyboard.type(' * 0.5')
  await expect(page.getByTestId('fork')).toContainText('iteration 40')
  const after = await lab.settled(40)
  expect(after).not.toBe(before)
  // Undone, the code of before runs again, with the same bits.
  await page.getByTestId('fork-undo').click()
  await expect(lab.root).toHaveAttribute('data-hash', before)
  await expect(page.getByTestId('editor')).not.toContainText('* 0.5')
  await page.getByTestId('redo').click()
  await expect(lab.root).toHaveAttribute('data-hash', after)
  await expect(page.getByTestId('template')).toHaveValue('Hill climber (edited)')
  await expect(page.getByTestId('state')).toContainText('The page runs this code')
  await behind(page, '* 0.5')
  await page.keyboard.type(' * 0.9')
  await expect(page.getByTestId('fork')).toContainText('iteration 40')
  await lab.settled(40)

  // Another room does not make it forget what can be undone.
  await page.getByTestId('view-lab').click()
  await page.getByTestId('view-workshop').click()
  await page.getByTestId('editor').click()
  await page.keyboard.press('Control+z')
  await expect(page.getByTestId('editor')).not.toContainText('* 0.9')
  await page.keyboard.press('Control+y')
  await expect(page.getByTestId('editor')).toContainText('* 0.9')
  // Keys of the page are the editor's there.
  await page.keyboard.type('?')
  await expect(page.getByTestId('keys-dialog')).toHaveCount(0)
  await page.keyboard.press('Backspace')
  await expect(page.getByTestId('state')).toContainText('The page runs this code')

  // Both codes are raced.
  await expect(page.getByTestId('fork')).toBeVisible()
  await page.getByTestId('fork-compare').click()
  await expect(page.getByTestId('lane')).toHaveCount(2)
  await expect(page.getByTestId('lane').first()).toContainText('Hill climber (before)')
  await page.getByTestId('view-workshop').click()

  await page.getByTestId('race-own').click()
  await expect(page.getByTestId('lane')).toHaveCount(2)
  await pick(page, 'compare-adds', 'wcpso')
  await expect(page.getByTestId('lane')).toHaveCount(3)
  await expect(page.getByTestId('compare-adds')).toHaveValue('')
  await page.getByTestId('race-end').click()
  await expect(page.getByTestId('lane').first()).toContainText('1001')
  await expect(page.getByTestId('lane-rank').filter({ hasText: 'won' })).toHaveCount(1)
})

test('what is wrong is said at its line, and what was there goes on', async ({ lab, page }) => {
  await opened(page, CLIMBER)
  await run(page)
  await page.getByTestId('play').click()
  const hash = await lab.seek(20)
  await behind(page, 'const cost = evaluate(tried)')
  await page.keyboard.type('\n)')
  const problem = page.getByTestId('problem')
  await expect(problem).toContainText('SyntaxError')
  await expect(problem).toContainText('a bracket')
  await expect(page.getByTestId('go-to-line')).toHaveText('Go to line 30')
  expect(await lab.settled(20)).toBe(hash)
  expect(await violations(lab)).toEqual([])
  // It throws only while it runs: the run says where.
  for (let k = 0; k < 3; k += 1) await page.keyboard.press('Backspace')
  await page.keyboard.type('\nconsole.log("step", state.kept)\nif (state.kept > 2) state.kept = missing')
  await expect(problem).toContainText('missing')
  await expect(problem).toContainText('There is no variable of this name here')
  await expect(page.getByTestId('go-to-line')).toHaveText('Go to line 32')
  await expect(lab.root).toHaveAttribute('data-status', 'failed')
  await expect(page.getByTestId('console')).toContainText('step 2')
  const lines = await page.getByTestId('console').getByRole('listitem').count()
  expect(lines).toBe(await lab.iteration())
  // Gone back, only what was printed until then is there; forwards it is printed once more, not twice.
  await page.getByTestId('restart').click()
  await page.getByTestId('step-forward').click()
  await expect(page.getByTestId('console').getByRole('listitem')).toHaveText(['1 step 0'])
})

test('what fails while it is typed costs neither the iteration nor the run that it is compared with', async ({ lab, page }) => {
  await opened(page, CLIMBER)
  await run(page)
  await page.getByTestId('play').click()
  const good = await lab.seek(40)
  const fork = page.getByTestId('fork')
  const [problem, state] = [page.getByTestId('problem'), page.getByTestId('state')]
  // In each iteration, then before the first one.
  await behind(page, 'const cost = evaluate(tried)')
  await page.keyboard.type('\nmissing()')
  await expect(lab.root).toHaveAttribute('data-status', 'failed')
  await expect(problem).toContainText('missing')
  await expect(fork).toHaveCount(0)
  for (let k = 0; k < 9; k += 1) await page.keyboard.press('Backspace')
  await page.keyboard.type('state.kept += 1')
  await expect(state).toContainText('The page runs this code')
  const mended = await lab.settled(40)
  expect(mended).not.toBe(good)
  await expect(fork).toContainText('iteration 40')
  await behind(page, 'kept: 0')
  await page.keyboard.type(' + missing')
  await expect(problem).toContainText('missing')
  for (let k = 0; k < 7; k += 1) await page.keyboard.press('Backspace')
  await page.keyboard.type('1')
  await expect(state).toContainText('The page runs this code')
  const other = await lab.settled(40)
  expect([good, mended]).not.toContain(other)
  await expect(fork).toContainText('iteration 40')
  // Back to what ran, not to what failed.
  await fork.getByTestId('fork-undo').click()
  await expect(lab.root).toHaveAttribute('data-hash', mended)
  await page.getByTestId('undo').click()
  await expect(lab.root).toHaveAttribute('data-hash', good)
})

test('loaded again, the page has the run and what was written since', async ({ lab, page }) => {
  await opened(page, CLIMBER)
  await run(page)
  await pick(page, 'workshop-scene', 'ackley-2')
  await page.getByTestId('play').click()
  const hash = await lab.seek(40)
  await behind(page, '* normal()')
  await page.keyboard.type(' +')
  await expect(page.getByTestId('problem')).toContainText('SyntaxError')
  await page.reload()
  await expect(lab.root).toHaveAttribute('data-hash', hash)
  await expect(page.getByTestId('workshop-scene')).toHaveValue('Ackley, 2 variables')
  await behind(page, '* normal() +')
  await expect(page.getByTestId('editor')).toContainText('* normal() +')
  await expect(page.getByTestId('offer-code')).toHaveCount(0)
})

test('what a planner says of itself is refused at its line', async ({ page }) => {
  await opened(page, CLIMBER.replace("'my-hill-climber'", "'pso'"))
  await run(page, 'a name that no planner of the package has')
  await expect(page.getByTestId('go-to-line')).toHaveText('Go to line 5')
})

test('what is wrong in draw is printed, and the run goes on', async ({ lab, page }) => {
  await opened(page, CLIMBER.replace("pen.points('particles', [tried])", 'pen.points(layer, [tried])'))
  await run(page)
  await page.getByTestId('play').click()
  await lab.seek(5)
  await expect(page.getByTestId('console')).toContainText("draw: ReferenceError: 'layer' is not defined (line 36)")
  await expect(lab.root).toHaveAttribute('data-status', 'running')
})

test('what is not a number is said at once', async ({ page }) => {
  await opened(page, CLIMBER.replace('params.step *', 'state.step *'))
  await run(page, 'NaN')
  await expect(page.getByTestId('problem')).toContainText('evaluate: number 0 is not a number (NaN)')
  await expect(page.getByTestId('problem')).toContainText('Is a field misspelled')
})

test('at each iteration the variables that changed are shown', async ({ lab, page }) => {
  await opened(page, CLIMBER)
  await run(page)
  await page.getByTestId('play').click()
  await lab.seek(0)
  await page.getByTestId('tab-variables').click()
  const table = page.getByTestId('variables')
  await expect(table).toContainText('The state at the beginning')
  await page.getByTestId('step-into').click()
  await expect(table).toContainText('What iteration 1 changed')
  await expect(table.getByRole('row')).toContainText([/Variable/, /tried\[0\]/, /tried\[1\]/])
  const hash = await lab.settled(1)
  // To look changes nothing.
  await page.getByTestId('tab-parameters').click()
  const step = page.getByTestId('parameters').getByRole('textbox', { name: /^Step/ })
  await step.fill('0.2')
  await step.press('Enter')
  await expect(lab.root).not.toHaveAttribute('data-hash', hash)
  await page.getByTestId('undo').click()
  await expect(lab.root).toHaveAttribute('data-hash', hash)
})

test('the checks say in words what a planner does not keep to', async ({ page }) => {
  await opened(page, CLIMBER.replace('state.kept + 1 }', 'Math.floor(state.kept) + (globalThis.count = (globalThis.count ?? 0) + 1) }'))
  await run(page)
  await page.getByTestId('tab-check').click()
  await page.getByTestId('check-own').click()
  const checked = page.getByTestId('checked')
  await expect(checked).toContainText('the same seed is the same run', { timeout: 20_000 })
  await expect(checked).toContainText('(sphere-2, seed 7)')
  await pick(page, 'template', 'hill-climber')
  await expect(page.getByTestId('state')).toHaveCount(0)
  await page.getByTestId('check-own').click()
  await expect(checked).toContainText('It keeps to all 13 checks.', { timeout: 20_000 })
})

test('help while typing comes from the contract', async ({ page }) => {
  await opened(page, CLIMBER)
  await behind(page, 'const tried = state.position.map((x, k) => {')
  await page.keyboard.type('\nmath.hy')
  await expect(page.locator('.cm-tooltip-autocomplete')).toContainText('hypot(x, y)')
  // Enter takes it as soon as it has been there for a moment.
  await page.waitForTimeout(200)
  await page.keyboard.press('Enter')
  await expect(page.getByTestId('editor')).toContainText('math.hypot(')
  await behind(page, "kinds: ['function'],")
  await page.keyboard.type('\nform')
  await expect(page.locator('.cm-tooltip-autocomplete')).toContainText('formulas')
  await page.keyboard.press('Escape')
  const place = await page.locator('.cm-line', { hasText: 'start({ box' }).evaluate((line) => {
    const text = document.createTreeWalker(line, NodeFilter.SHOW_TEXT)
    for (let node = text.nextNode(); node; node = text.nextNode()) {
      const at = (node.textContent ?? '').indexOf('evaluate')
      if (at < 0) continue
      const range = document.createRange()
      range.setStart(node, at)
      range.setEnd(node, at + 8)
      const { x, y, width, height } = range.getBoundingClientRect()
      return { x: x + width / 2, y: y + height / 2 }
    }
    throw new Error('there is no such text')
  })
  await page.mouse.move(place.x, place.y)
  await expect(page.locator('.cm-help')).toContainText('The cost of a candidate')
  await behind(page, "kinds: ['function'")
  await page.keyboard.type(", 'gr")
  await expect(page.locator('.cm-tooltip-autocomplete')).toContainText('grid')
})

test('a task asks for a planner that is written for it', async ({ lab, page }) => {
  const lesson = {
    format: 'forage-lesson',
    version: 1,
    name: 'climb',
    language: 'en',
    title: 't',
    summary: 't',
    steps: [{ name: 'one', text: 't', run: { planner: 'pso', scene: 'sphere-2', params: {}, seed: 1 }, at: 0 }],
    task: { text: 't', goal: { cost: 500 }, budget: { evaluations: 1000 }, own: true, scene: 'sphere-2' },
    texts: { en: { t: 'Climb down' } },
  }
  await lab.open('#view=learn')
  const buffer = Buffer.from(JSON.stringify(lesson))
  await page.getByTestId('open-lesson-file').setInputFiles({ name: 'climb.json', mimeType: 'application/json', buffer })
  // Planners of the page do not count.
  await expect(page.getByTestId('task')).toContainText('With a planner that you write')
  await lab.seek(100)
  await expect(page.getByTestId('task-standing')).toContainText('another planner')
  await expect(page.getByTestId('task-hand-in')).toBeDisabled()
  await page.getByTestId('task-begin').click()
  await expect(page.getByTestId('workshop')).toBeVisible()
  await pick(page, 'template', 'hill-climber')
  await expect(page.getByTestId('tab-task')).toHaveAttribute('aria-selected', 'true')
  await expect(page.getByTestId('race-own')).toBeEnabled()
  await page.getByTestId('play').click()
  const hash = await lab.seek(60)
  await expect(page.getByTestId('task')).toHaveAttribute('data-reached', 'true')
  await page.context().grantPermissions(['clipboard-read', 'clipboard-write'])
  await page.getByTestId('task-hand-in').click()
  await expect.poll(() => page.evaluate(() => navigator.clipboard.readText())).toContain(`hash=${hash}&page.code=`)
  await page.getByTestId('task-back').click()
  await expect(page.getByTestId('lesson')).toHaveAttribute('data-lesson', 'climb')
  await expect(page.getByTestId('task')).toHaveAttribute('data-reached', 'true')
})
