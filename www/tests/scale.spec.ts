import { hashOf, linkTo } from './support/core'
import { en, expect, test } from './support/lab'

const crowd = { params: { population: 100_000 } }

test('with 100,000 particles the page keeps answering while the core computes', async ({ lab, page }) => {
  test.setTimeout(90_000)
  await lab.open(linkTo(crowd, 1))
  expect(await lab.settled(1)).toBe(hashOf(crowd, 1))
  await page.getByTestId('speed').selectOption('Infinity')

  // Counted, not timed: a page that computed itself would paint at most once for an iteration.
  const counting = lab.root.evaluate(async (root) => {
    const iteration = (): number => Number(root.getAttribute('data-iteration'))
    while (iteration() < 3) await new Promise(requestAnimationFrame)
    const first = iteration()
    let [frames, answered] = [0, 0]
    const channel = new MessageChannel()
    channel.port1.onmessage = () => (answered += 1)
    while (iteration() < first + 12) {
      channel.port2.postMessage(0)
      await new Promise(requestAnimationFrame)
      frames += 1
    }
    channel.port1.close()
    return { frames, answered, iterations: iteration() - first }
  })
  await lab.press(en.transport.play)
  const { frames, answered, iterations } = await counting
  expect(frames).toBeGreaterThan(iterations)
  expect(answered).toBeGreaterThan(iterations)

  await lab.press(en.transport.pause)
  await lab.settled()
  expect(await lab.seek(2)).toBe(hashOf(crowd, 2))
  await expect(page.getByText(/1 of \d+/).first()).toBeVisible()
})
