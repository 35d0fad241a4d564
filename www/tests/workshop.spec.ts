import type { Page } from '@playwright/test'
import { readFileSync } from 'node:fs'
import { violations } from './support/axe'
import { seeds } from './support/batch'
import { expect, pick, test } from './support/lab'

const template = (name: string): string => readFileSync(new URL(`../../templates/${name}.js`, import.meta.url), 'utf8')
const CLIMBER = template('hill-climber')

/** The Workshop, with this code in its editor. */
async function opened(page: Page, code: string): Promise<void> {
  await page.addInitScript((text) => {
    if (location.protocol === 'about:') return
    if (!sessionStorage.getItem('begun')) localStorage.setItem('forage.workshop.draft', JSON.stringify({ code: text, foreign: false }))
    sessionStorage.setItem('begun', 'yes')
  }, code)
  await page.goto('./#view=workshop')
  await page.getByTestId('editor').waitFor()
}

/** Puts the cursor behind a text. */
async function behind(page: Page, text: string): Promise<void> {
  await page.getByTestId('editor').click()
  await page.keyboard.press('Control+f')
  await page.keyboard.type(text)
  await page.keyboard.press('Enter')
  await page.keyboard.press('Escape')
  await page.keyboard.press('ArrowRight')
}

async function run(page: Page, said = 'The page runs this code'): Promise<void> {
  await page.getByTestId('run-code').click()
  await expect(page.getByTestId('state')).toContainText(said)
}

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

test('a link shows the code and its note before it runs', async ({ lab, page }) => {
  await opened(page, CLIMBER.replace("title: 'Hill climber'", "title: 'Theirs'"))
  await run(page)
  await page.getByTestId('play').click()
  const hash = await lab.seek(30)
  await page.getByTestId('view-lab').click()
  const link = await lab.link(hash)
  expect(link).toContain('page.code=')

  await page.evaluate(() => localStorage.clear())
  await page.goto('about:blank')
  await page.goto(`./${link}`)
  const dialog = page.getByTestId('offer-dialog')
  await expect(dialog.getByTestId('offer-note')).toHaveText(/^A hill climber: it takes a random step/)
  await expect(dialog.getByTestId('offer-code')).toContainText("name: 'my-hill-climber'")
  expect(await violations(lab)).toEqual([])
  // Left, it does not run; there is another run to look at.
  await dialog.getByTestId('offer-leave').click()
  await expect(lab.root).toHaveAttribute('data-iteration', /[1-9]/)
  await expect(page.getByTestId('planner')).toHaveValue('PSO: constant coefficients')

  await page.goto('about:blank')
  await page.goto(`./${link}`)
  await dialog.getByTestId('offer-run').click()
  await expect(lab.root).toHaveAttribute('data-hash', hash)
  await expect(page.getByTestId('verified')).toBeVisible()
  // What somebody else wrote never runs at full speed.
  await page.getByTestId('view-workshop').click()
  await expect(page.getByTestId('editor')).toContainText('my-hill-climber')
  await expect(page.getByTestId('full-speed')).toBeDisabled()
  await page.reload()
  await expect(page.getByTestId('editor')).toContainText("title: 'Theirs'")
  await expect(page.getByTestId('full-speed')).toBeDisabled()
  // Neither when it comes back later.
  await pick(page, 'template', 'pso')
  await expect(page.getByTestId('full-speed')).toBeEnabled()
  await page.getByTestId('editor').click()
  await page.keyboard.press('Control+z')
  await expect(page.getByTestId('editor')).toContainText('my-pso')
  await pick(page, 'template', 'last')
  await expect(page.getByTestId('full-speed')).toBeDisabled()
})

test('a file is shown before it runs, and what was written is kept', async ({ lab, page }) => {
  await opened(page, `${CLIMBER}// mine`)
  await page.getByTestId('code-file').setInputFiles({ name: 'swarm.js', mimeType: 'text/javascript', buffer: Buffer.from(template('pso')) })
  const dialog = page.getByTestId('offer-dialog')
  await expect(dialog).toContainText('swarm.js')
  await dialog.getByTestId('offer-run').click()
  await expect(page.getByTestId('editor')).toContainText('my-pso')
  await expect(lab.root).toHaveAttribute('data-status', /running|exhausted/)
  await expect(page.getByTestId('full-speed')).toBeDisabled()
  await pick(page, 'template', 'last')
  await expect(page.getByTestId('full-speed')).toBeEnabled()
  const download = page.waitForEvent('download')
  await page.getByTestId('save-code').click()
  const saved = await download
  expect(saved.suggestedFilename()).toBe('my-hill-climber.js')
  expect(readFileSync(await saved.path(), 'utf8')).toBe(`${CLIMBER}// mine`)
})

/** The longest time between two pictures of the page while something happens, in milliseconds. */
async function longestPause(page: Page, happens: () => Promise<void>): Promise<number> {
  await page.evaluate(() => {
    const watched = globalThis as unknown as { pauses: number[] }
    watched.pauses = []
    let last = performance.now()
    const look = (now: number): void => {
      watched.pauses.push(now - last)
      last = now
      requestAnimationFrame(look)
    }
    requestAnimationFrame(look)
  })
  await happens()
  return page.evaluate(() => Math.max(...(globalThis as unknown as { pauses: number[] }).pauses.slice(1)))
}

for (const [title, code, message] of [
  ['an endless loop', 'for (;;) evaluate(tried)', /took longer than 900 ms and was stopped \(line \d+\)/],
  ['a memory hog', 'const all = []; for (;;) all.push(new Float64Array(1e5))', /64 MB/],
] as const) {
  test(`${title} is stopped with a message; the page does not stand still`, async ({ lab, page }) => {
    await opened(page, CLIMBER)
    await run(page)
    await page.getByTestId('play').click()
    const hash = await lab.seek(20)
    await behind(page, 'const cost = evaluate(tried)')
    const pause = await longestPause(page, async () => {
      await page.keyboard.type('\n')
      await page.keyboard.insertText(code)
      await expect(page.getByTestId('problem')).toContainText(message)
    })
    expect(pause).toBeLessThan(500)
    // Nothing is lost: neither the code nor the run of before.
    await expect(page.getByTestId('editor')).toContainText('for (;;)')
    await page.getByTestId('undo').click()
    await expect(lab.root).toHaveAttribute('data-hash', hash)
  })
}

test('where something built in does not end, the run of before stays', async ({ lab, page }) => {
  await opened(page, CLIMBER)
  await run(page)
  await page.getByTestId('play').click()
  const hash = await lab.seek(20)
  await behind(page, 'const cost = evaluate(tried)')
  await page.keyboard.type('\n')
  await page.keyboard.insertText('const all = Object.fromEntries(Array.from({ length: 1e5 }, (_, k) => [k, k])); for (;;) Object.keys(all)')
  await expect(page.getByTestId('problem')).toContainText('could not be stopped', { timeout: 20_000 })
  await expect(page.getByTestId('editor')).toContainText('for (;;)')
  expect(await lab.settled(20)).toBe(hash)
  // Neither is that so of code that does not end when it is read.
  await page.keyboard.press('Control+z')
  await expect(page.getByTestId('state')).toContainText('The page runs this code')
  await page.keyboard.press('Control+Home')
  await page.keyboard.insertText(
    'const all = Object.fromEntries(Array.from({ length: 1e5 }, (_, k) => [k, k])); for (;;) Object.keys(all)\n',
  )
  await expect(page.getByTestId('problem')).toContainText('could not be stopped', { timeout: 20_000 })
  expect(await lab.settled(20)).toBe(hash)
  // Mended, it runs.
  await page.keyboard.press('Control+z')
  await expect(page.getByTestId('state')).toContainText('The page runs this code')
  expect(await lab.settled(20)).toBe(hash)
})

test('at full speed, after a question, the bits are the same, and an endless loop goes back to the interpreter', async ({ lab, page }) => {
  await opened(page, template('pso'))
  await run(page)
  await page.getByTestId('play').click()
  const hash = await lab.seek(50)
  await page.getByTestId('full-speed').click()
  await page.getByTestId('full-speed-no').click()
  await expect(page.getByTestId('full-speed')).not.toBeChecked()
  await page.getByTestId('full-speed').click()
  expect(await violations(lab)).toEqual([])
  await page.getByTestId('full-speed-yes').click()
  await expect(page.getByTestId('full-speed')).toBeChecked()
  await lab.restarted()
  expect(await lab.settled(50)).toBe(hash)
  await behind(page, 'advance({ particles, g }, { box, evaluate, random, params: { w, c1, c2 } }) {')
  await page.keyboard.insertText('\nif (particles.length > 2) missing()')
  await expect(page.getByTestId('problem')).toContainText('missing')
  await page.keyboard.press('End')
  await page.keyboard.press('Shift+Home')
  await page.keyboard.press('Backspace')
  await page.keyboard.insertText('for (;;) {}')
  await expect(page.getByTestId('problem')).toContainText('took longer than', { timeout: 15_000 })
  await expect(page.getByTestId('full-speed')).not.toBeChecked()
})

test('pasted code runs in the interpreter, and what came from elsewhere stays so', async ({ page }) => {
  const pasted = async (code: string): Promise<void> => {
    await page.getByTestId('editor').evaluate((editor, text) => {
      const clipboardData = new DataTransfer()
      clipboardData.setData('text/plain', text)
      editor.dispatchEvent(new ClipboardEvent('paste', { clipboardData, bubbles: true, cancelable: true }))
    }, code)
  }
  const full = page.getByTestId('full-speed')
  const atFullSpeed = async (): Promise<void> => {
    await full.click()
    await page.getByTestId('full-speed-yes').click()
    await expect(full).toBeChecked()
  }
  await opened(page, CLIMBER)
  await page.getByTestId('code-file').setInputFiles({ name: 'swarm.js', mimeType: 'text/javascript', buffer: Buffer.from(template('pso')) })
  await page.getByTestId('offer-run').click()
  await expect(page.getByTestId('editor')).toContainText('my-pso')

  await pick(page, 'template', 'hill-climber')
  await atFullSpeed()
  const part =
    'for (const one of particles) one.velocity = one.velocity.map((v, i) => w * v + c1 * random() * (one.best[i] - one.position[i]))'
  await page.getByTestId('editor').click()
  await pasted(`/* ${part} */`)
  await expect(full).not.toBeChecked()
  await expect(page.getByTestId('notice')).toContainText('Code was pasted')
  // Copied here it is one's own.
  await atFullSpeed()
  await expect(page.getByTestId('notice')).toBeHidden()
  await pasted(`/* ${part} */`)
  await expect(full).toBeChecked()

  await page.getByTestId('editor').click()
  await page.keyboard.press('Control+a')
  await pasted(`${template('pso')}\n`)
  await expect(full).toBeDisabled()
  await expect(full).not.toBeChecked()
  await expect(page.getByTestId('state')).toContainText('The page runs this code')
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

test('many runs of a planner that was written here are compared; the address carries its code', async ({ lab, page }) => {
  await opened(page, CLIMBER)
  await run(page)
  await page.getByTestId('race-own').click()
  await expect(page.getByTestId('lane')).toHaveCount(2)
  await page.getByRole('radio', { name: 'Statistics' }).check()
  await seeds(page, 5)
  await page.getByTestId('batch-run').click()
  await expect(page.getByTestId('batch-summary').first()).toContainText('Hill climber')
  await expect(page.getByTestId('batch-summary').first()).toContainText('5')
  await expect(page).toHaveURL(/&codes=/)
  const address = new URL(page.url()).hash
  await page.reload()
  await expect(page.getByTestId('entrant').first()).toHaveAttribute('data-planner', 'my-hill-climber')
  // Elsewhere the code is shown first.
  await page.evaluate(() => {
    localStorage.clear()
    sessionStorage.removeItem('forage.comparison')
  })
  await page.goto('about:blank')
  await page.goto(`./${address}`)
  await expect(page.getByTestId('offer-code')).toContainText("name: 'my-hill-climber'")
  await page.getByTestId('offer-run').click()
  await expect(page.getByTestId('entrant').first()).toHaveAttribute('data-planner', 'my-hill-climber')
  await expect(page.getByTestId('batch-size')).toContainText('5 seeds')
  await lab.restarted()
})

test('runs of a comparison whose code does not end are ended, and it says so', async ({ page }) => {
  const endless = 'const all = Object.fromEntries(Array.from({ length: 1e5 }, (_, k) => [k, k])); for (;;) Object.keys(all)'
  await opened(
    page,
    CLIMBER.replace('const cost = evaluate(tried)', `const cost = evaluate(tried)\nif (tried.length === 4) { ${endless} }`),
  )
  await run(page)
  await page.getByTestId('race-own').click()
  await page.getByRole('radio', { name: 'Statistics' }).check()
  await pick(page, 'compare-scene', 'sphere-4')
  await seeds(page, 2)
  await page.getByTestId('batch-run').click()
  await expect(page.getByText('could not be stopped').first()).toBeVisible({ timeout: 30_000 })
})

test('a race has the newest code of a planner, and those that it is compared with stay', async ({ page }) => {
  await opened(page, CLIMBER)
  await run(page)
  await page.getByTestId('race-own').click()
  await expect(page.getByTestId('lane')).toHaveCount(2)
  // Those that it is compared with stay when its code is another one.
  await pick(page, 'compare-adds', 'wcpso')
  await expect(page.getByTestId('lane-best').first()).toHaveText(/\d/)
  await page.getByTestId('race-end').click()
  await expect(page.getByTestId('race')).toHaveAttribute('data-over', 'true')
  const slow = await page.getByTestId('lane-best').first().innerText()
  await page.getByTestId('view-workshop').click()
  await behind(page, '* normal()')
  await page.keyboard.type(' * 0.5')
  await expect(page.getByTestId('race-own')).toBeEnabled()
  await page.getByTestId('view-compare').click()
  await expect(page.getByTestId('lane')).toHaveCount(3)
  await expect(page.getByTestId('race')).toHaveAttribute('data-over', 'true')
  await expect(page.getByTestId('lane-best').first()).not.toHaveText(slow)
})
