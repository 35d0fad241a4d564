import { readFile, writeFile } from 'node:fs/promises'
import { test } from './support/lab'
for (const [name, link] of [['bat', '#v=1&planner=bat-continuous&scene=rastrigin&seed=1&at=20'], ['aco', '#v=1&planner=aco&scene=rooms-20&seed=1&at=20'], ['arm', '#v=1&planner=rrt&scene=arm-cuboid&seed=1&at=60']] as const)
  test(`zz ${name}`, async ({ lab, page }) => {
    test.setTimeout(120000)
    page.on('console', (m) => m.type() === 'error' && console.log(m.text()))
    page.on('pageerror', (e) => console.log(e.message))
    await page.emulateMedia({ colorScheme: 'dark' })
    await page.setViewportSize({ width: 1366, height: 768 })
    await lab.open(`./${link}`)
    await page.waitForTimeout(800)
    const get = async (button: () => Promise<void>, to: string) => {
      const [d] = await Promise.all([page.waitForEvent('download', { timeout: 60000 }), button()])
      const bytes = await readFile((await d.path()) ?? '')
      await writeFile(to + d.suggestedFilename().replace(/.*\./, '.'), bytes)
      console.log(to, d.suggestedFilename(), bytes.length)
    }
    await page.getByTestId('export').click()
    await page.waitForTimeout(300)
    await page.screenshot({ path: `/tmp/f-${name}-export.png` })
    await page.getByRole('radio', { name: 'For print' }).check({ force: true })
    await get(() => page.getByTestId('export-png').click(), `/tmp/f-${name}`)
    await get(() => page.getByTestId('export-svg').click(), `/tmp/f-${name}`)
    await page.getByTestId('record-every').fill('4')
    for (const f of ['GIF', 'WebM']) {
      await page.getByRole('radio', { name: f }).check({ force: true })
      const t = Date.now()
      await get(() => page.getByTestId('record').click(), `/tmp/f-${name}-${f}`).catch(async (e) => console.log(f, String(e).slice(0, 100), await page.getByTestId('record-told').textContent()))
      console.log(Date.now() - t)
    }
  })
