import { hashOf, linkTo } from './support/core'
import { en, expect, test } from './support/lab'

const crowd = { params: { population: 100_000 } }

test('with 100,000 particles the core computes beside the page, and the page keeps answering', async ({ lab, page }) => {
  test.setTimeout(90_000)
  await lab.open(linkTo(crowd, 1))
  expect(await lab.settled(1)).toBe(hashOf(crowd, 1))
  await expect(page.getByText(/1 of \d+/).first()).toBeVisible()
  await page.getByTestId('speed').selectOption('Infinity')
  await lab.press(en.transport.play)
  await expect.poll(() => lab.iteration()).toBeGreaterThan(2)

  // Were the iterations computed here, there would be none while this thread is busy. An iteration takes longer than a
  // slice of the worker's loop, so each picture is one further; only a busy page lets pictures be left out. The first few
  // after the wait were drawn at its beginning.
  const PICTURES = 6
  const computed = await lab.root.evaluate(async (root, pictures) => {
    const iteration = (): number => Number(root.getAttribute('data-iteration'))
    const before = iteration()
    const until = performance.now() + 8000
    while (performance.now() < until);
    for (let seen = 0, last = before; seen < pictures; ) {
      await new Promise(requestAnimationFrame)
      if (iteration() !== last) seen += 1
      last = iteration()
    }
    return iteration() - before
  }, PICTURES)
  expect(computed).toBeGreaterThan(PICTURES + 4)

  // Frames and iterations go on side by side, and what is pressed happens while it plays.
  const [first = 0, last = 0] = await lab.root.evaluate(async (root) => {
    const iteration = (): number => Number(root.getAttribute('data-iteration'))
    const before = iteration()
    for (let frames = 0; frames < 30; frames += 1) await new Promise(requestAnimationFrame)
    return [before, iteration()]
  })
  expect(last).toBeGreaterThan(first)
  await expect(lab.root).toHaveAttribute('data-playing', 'true')
  await lab.press(en.transport.pause)
  await lab.settled()
  expect(await lab.seek(2)).toBe(hashOf(crowd, 2))
})
