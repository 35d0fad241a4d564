import type { Page } from '@playwright/test'
import { readFileSync } from 'node:fs'
import { violations } from './support/axe'
import { expect, pick, test } from './support/lab'
import { template, CLIMBER, opened, behind, run } from './support/workshop'

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
  await expect(dialog.getByTestId('offer-note')).toHaveText(/^Hill climber: takes a random step/)
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
