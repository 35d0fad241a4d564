import { linkTo } from './support/core'
import { en, test } from './support/lab'
test('probe', async ({ lab, page }) => {
  test.setTimeout(90000)
  await lab.open(linkTo({ params: { population: 100_000 } }, 1))
  await lab.settled(1)
  await page.getByTestId('speed').selectOption('Infinity')
  await lab.press(en.transport.play)
  console.log(await lab.root.evaluate(async (root) => {
    const out: string[] = []; let last = performance.now()
    for (let i = 0; i < 25; i++) { await new Promise(requestAnimationFrame); const now = performance.now(); out.push(`${root.getAttribute('data-iteration')}:${Math.round(now - last)}`); last = now }
    return out.join(' ')
  }))
})
test('zoom', async ({ lab, page }) => {
  await lab.open(linkTo({}, 30)); await lab.settled(30); await lab.stage.focus()
  console.log(JSON.stringify(await lab.picture())); await page.screenshot({ path: '/tmp/panels-lab/shots/z1.png' })
  await page.keyboard.press('0'); console.log(JSON.stringify(await lab.picture())); await page.screenshot({ path: '/tmp/panels-lab/shots/z2.png' })
})
