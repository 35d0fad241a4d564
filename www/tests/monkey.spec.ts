import { linkTo } from './support/core'
import { expect, test } from './support/lab'
import { monkey } from './support/monkey'
import { SITE } from './support/site'

/*
 * Random actions, 2,000 in all. Nothing may break: no error, no warning, nothing asked of any other host, and afterwards the page answers.
 * MONKEY=9 is another seed, MONKEY_ACTIONS=10000 as many more.
 */

const SEED = Number(process.env.MONKEY ?? 1)
const ACTIONS = Number(process.env.MONKEY_ACTIONS ?? 2000)

const BEGINNINGS: Record<string, string> = {
  'a run': linkTo({}, 20),
  'a comparison': '#view=compare',
  'a lesson': '#view=learn&lesson=pso',
  'the Workshop': '#view=workshop',
}

for (const [k, [name, link]] of Object.entries(BEGINNINGS).entries()) {
  test(`${ACTIONS / 4} random actions from ${name} on break nothing`, { tag: '@smoke' }, async ({ lab, page }) => {
    test.setTimeout(60_000 + ACTIONS * 60)
    page.on('dialog', (dialog) => void (dialog.type() === 'beforeunload' ? dialog.accept() : dialog.dismiss()))
    await page.goto(SITE + link)
    await expect(lab.root).toBeAttached()
    const { counts, last } = await monkey(page, SEED * 100 + k, ACTIONS / 4)
    expect(Object.keys(counts).length, `${JSON.stringify(counts)}, at last ${last.join(', ')}`).toBeGreaterThan(3)
    // The page still answers: the same state is there after it was read again.
    await lab.open(`?afterwards${linkTo({}, 20)}`)
    await lab.settled(20)
  })
}
