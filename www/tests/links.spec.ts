import { generateScene } from '../../pkg/node.js'
import { linkTo, sceneOf, verified } from './support/core'
import { en, expect, Lab, test, pick } from './support/lab'
import { Race } from './support/race'
import { SITE } from './support/site'

test('a link opened elsewhere shows the same state and the same picture', { tag: '@smoke' }, async ({ lab, browser }) => {
  await lab.open(linkTo({ planner: 'wpso', seed: 7, params: { population: 40, w_max: 0.8 } }, 30))
  await lab.settled(30)
  const scene = sceneOf({})
  if (scene.kind !== 'discs') throw new Error(scene.kind)
  await lab.dragFrom(await lab.whereIs(scene, scene.discs[2]?.center ?? [0, 0]), -30, 60)
  await lab.restarted()
  const hash = await lab.seek(45)
  const link = await lab.link(hash)
  const setup = verified(link)
  expect(setup).toMatchObject({ planner: 'wpso', seed: 7, iteration: 45, params: { population: 40, w_max: 0.8 } })

  const elsewhere = await browser.newContext({ viewport: { width: 1440, height: 900 }, colorScheme: 'light' })
  const other = new Lab(await elsewhere.newPage())
  await other.open(link)
  expect(await other.settled(45)).toBe(hash)

  // Neither what is selected nor the run before belongs to a link.
  await lab.page.getByTestId('fork-dismiss').click()
  await lab.stage.focus()
  await lab.page.keyboard.press('Escape')
  expect(await lab.wholePicture()).toEqual(await other.wholePicture())
  await elsewhere.close()
})

test('a link put into the address of the open page opens', async ({ lab, page }) => {
  await lab.open(linkTo({}, 10))
  await lab.settled(10)
  const other = linkTo({ planner: 'cpso', scene: 'ackley', seed: 3 }, 22)
  await page.evaluate((hash) => (location.hash = hash), other)
  expect(await lab.settled(22)).toBe(verified(other).hash)
  await expect(page.getByTestId('planner')).toHaveAttribute('data-value', 'cpso')
  await expect(page.getByTestId('scene')).toHaveAttribute('data-value', 'ackley')
})

test('a link that can’t be opened says why, and the page works on', { tag: '@smoke' }, async ({ lab, page }) => {
  await lab.open('#v=1&planner=nobody&scene=wcpso-discs&seed=1&at=5')
  await expect(page.getByTestId('notice')).toContainText('nobody')
  await expect.poll(() => lab.iteration()).toBeGreaterThan(2)
})

test('a link to an iteration beyond what a number can be says why, and the page works on', async ({ lab, page }) => {
  await lab.open('#v=1&planner=pso&scene=wcpso-discs&seed=1&at=9007199254740993')
  await expect(page.getByTestId('notice')).toContainText('at: 9007199254740993')
  await expect.poll(() => lab.iteration()).toBeGreaterThan(2)
})

test('a link whose hash isn’t what is computed says so', async ({ lab, page }) => {
  const link = linkTo({}, 12)
  await lab.open(link.replace(/hash=.{4}/, 'hash=0000'))
  await lab.settled(12)
  const { hash = '' } = verified(link)
  await expect(page.getByTestId('notice')).toContainText(en.notices.hash('12', `0000${hash.slice(4)}`, hash))
  await expect(page.getByTestId('verified')).toBeHidden()
})

test('a link whose hash comes out again is verified, until something is changed', async ({ lab, page }) => {
  const link = linkTo({}, 12)
  await lab.open(link)
  await lab.settled(12)
  await expect(page.getByTestId('verified')).toHaveText(en.result.verified)
  await lab.seek(13)
  await expect(page.getByTestId('verified')).toBeHidden()
  await lab.seek(12)
  await expect(page.getByTestId('verified')).toBeVisible()
  await page.getByTestId('new-seed').click()
  await lab.restarted()
  await lab.seek(12)
  await expect(page.getByTestId('verified')).toBeHidden()
})

test('the link can be copied', async ({ lab, page, context }) => {
  await context.grantPermissions(['clipboard-read', 'clipboard-write'], { origin: new URL(SITE).origin })
  await lab.open(linkTo({}, 33))
  const link = await lab.link(await lab.settled(33))
  await lab.press(en.bar.copy)
  await expect(page.getByText(en.bar.copied)).toBeVisible()
  expect(await page.evaluate(() => navigator.clipboard.readText())).toBe(SITE + link)
})

test('a view has an address that outlasts a reload, and the browser goes back to the run', async ({ lab, page }) => {
  await lab.open(linkTo({ seed: 7 }, 30))
  const hash = await lab.settled(30)
  await page.getByTestId('view-compare').click()
  await expect(page).toHaveURL(/#view=compare/)
  await expect(page.getByTestId('race')).toBeVisible()
  await page.getByTestId('view-papers').click()
  await page.goBack()
  await expect(page.getByTestId('race')).toBeVisible()
  await page.goBack()
  expect(await lab.settled(30)).toBe(hash)
  await expect(lab.stage).toBeVisible()
  await page.goForward()
  await expect(page.getByTestId('race')).toBeVisible()

  await page.reload()
  await expect(lab.root).toHaveAttribute('data-phase', 'ready')
  await expect(page.getByTestId('race')).toHaveAttribute('data-still', 'true')
  // The run behind it is there by now, with a link of its own.
  await lab.settled()
  await expect(page).toHaveURL(/#view=compare&as=watch&/)
  await page.goBack()
  expect(await lab.settled(30)).toBe(hash)
})

test('back from a link leads to the run of before', async ({ lab, page }) => {
  await lab.open(linkTo({ seed: 7 }, 30))
  const first = await lab.settled(30)
  await lab.link(first)
  await page.evaluate(
    (link) => {
      location.hash = link
    },
    linkTo({ seed: 8 }, 20),
  )
  const second = await lab.settled(20)
  await lab.link(second)
  await page.goBack()
  expect(await lab.settled(30)).toBe(first)
  await page.goForward()
  expect(await lab.settled(20)).toBe(second)
})

test('a link says what is explained, which layers are shown, and what is in view', async ({ lab, page }) => {
  const plain = linkTo({ seed: 7 }, 30)
  await lab.open(`${plain}&page.item=particles.3&page.camera=4,5,3&page.layers=velocities,-particles`)
  const hash = await lab.settled(30)
  await expect(page.getByTestId('inspect').getByRole('heading', { level: 2 })).toHaveText('Particle 3')
  await expect(page.getByTestId('layer-velocities')).toBeChecked()
  await expect(page.getByTestId('layer-particles')).not.toBeChecked()

  // The address stays what it was, also after a reload.
  await lab.link(hash)
  await expect(page).toHaveURL(/&page\.item=particles\.3&page\.camera=4,5,3&page\.layers=velocities,-particles$/)
  const near = await lab.picture()
  await page.reload()
  expect(await lab.settled(30)).toBe(hash)
  await expect(page.getByTestId('inspect').getByRole('heading', { level: 2 })).toHaveText('Particle 3')
  // The thread that draws may be later than what is said of it.
  await expect.poll(async () => (await lab.picture()).digest).toBe(near.digest)

  // What is changed is changed there, and the core takes the link as it is.
  await lab.press(en.stage.fit)
  await page.getByRole('button', { name: 'Close the inspection' }).click()
  await expect(page).toHaveURL(/hash=[0-9a-f]{16}&page\.layers=velocities,-particles&page\.tab=explain$/)
  expect(verified(new URL(page.url()).hash)).toMatchObject({ seed: 7, iteration: 30 })
})

test('a link that says nonsense of the page opens its run', async ({ lab, page }) => {
  const keys =
    '&page.item=<img src=x onerror=alert(1)>.1&page.camera=NaN,1,0&page.layers=__proto__,-constructor&page.other=javascript:alert(1)'
  await lab.open(linkTo({ seed: 7 }, 30) + keys)
  await lab.settled(30)
  await expect(page.getByTestId('notice')).toHaveCount(0)
  expect(await page.evaluate(() => Object.keys(Object.prototype).length)).toBe(0)
  await expect(page.getByTestId('layer-particles')).toBeChecked()
})

test('a race has an address: its scene, seed, lanes and time; it can be copied, and opens elsewhere', async ({
  lab,
  page,
  context,
  browser,
}) => {
  await context.grantPermissions(['clipboard-read', 'clipboard-write'], { origin: new URL(SITE).origin })
  await lab.open(linkTo({ planner: 'cpso', seed: 9, params: { population: 40 } }, 5))
  await lab.settled(5)
  // A scene that doesn't ship goes with the address, as the core packs it.
  const scene = sceneOf({})
  if (scene.kind !== 'discs') throw new Error(scene.kind)
  await lab.dragFrom(await lab.whereIs(scene, scene.discs[2]?.center ?? [0, 0]), -30, 60)
  await lab.settled()
  await page.getByTestId('view-compare').click()
  const race = new Race(page)
  await expect(race.root).toHaveAttribute('data-still', 'true')
  const before = await race.seek(3000)
  await expect(page).toHaveURL(/#view=compare&as=watch&scene=[^&]{50,}&seeds=9-58&with=cpso;population=40(,\w+){3}&at=3000$/)
  await lab.press(en.bar.copy)
  const clipboard = () => page.evaluate(() => navigator.clipboard.readText())
  await expect.poll(clipboard).toBe(page.url())
  const copied = await clipboard()

  const elsewhere = await browser.newContext({ serviceWorkers: 'block' })
  const other = new Race(await elsewhere.newPage())
  await other.page.goto(copied)
  expect(await other.at(3000)).toEqual(before)
  await elsewhere.close()

  // Another address in the open page; who can't be had is said.
  await page.evaluate(() => (location.hash = '#view=race&scene=sphere&seed=2&with=pso,nobody,qpso&at=900'))
  await expect(page.getByTestId('compare')).toContainText('nobody')
  await expect(race.lanes).toHaveCount(2)
  await expect(page).toHaveURL(/scene=sphere&seeds=2-51&budget=own&with=pso,qpso&at=900$/)
  await page.reload()
  await expect(race.lanes).toHaveCount(2)
  await expect(race.root).toHaveAttribute('data-clock', '900')
})

test('open claims of a paper have an address', async ({ lab, page }) => {
  await lab.open('#view=papers')
  await expect(page.locator('details[id^="claim-"]').nth(4)).toBeVisible()
  const [first, second] = (await page.locator('details[id^="claim-"]').evaluateAll((all) => all.map(({ id }) => id))).slice(2)
  await page.locator(`#${first} > summary`).click()
  await page.locator(`#${second} > summary`).click()
  await expect(page).toHaveURL(new RegExp(`#view=papers&claims=${first?.slice(6)},${second?.slice(6)}$`))
  await page.reload()
  await expect(page.locator(`#${first}[open], #${second}[open]`)).toHaveCount(2)
  await expect(page.locator(`#${first}`)).toBeInViewport()
})

test('a scene too large for a link stays in this browser; its run is offered as a file, and elsewhere the link says so', async ({
  lab,
  page,
  browser,
}) => {
  const scene = generateScene('random', { columns: 300, rows: 300, cell: 1, share: 0.3, stops: 0, moving: 0 }, 1)
  await lab.open()
  await lab.section('scene')
  const buffer = Buffer.from(JSON.stringify({ ...scene, name: 'large', title: 'Large' }))
  await page.getByTestId('scene-file').setInputFiles({ name: 'large.json', mimeType: 'application/json', buffer })
  await expect(page.getByTestId('scene')).toHaveValue('Large')
  await pick(page, 'planner', 'dijkstra')
  const hash = await lab.seek(20)
  await expect(page).toHaveURL(/#v=1&planner=dijkstra&scene=@[0-9a-f]{16}&.*at=20/)
  expect(page.url().length).toBeLessThan(300)
  await lab.press(en.bar.copy)
  await expect(page.getByTestId('export-why')).toHaveText(en.bar.tooLarge)
  await page.keyboard.press('Escape')
  const address = page.url()
  await page.reload()
  expect(await lab.settled(20)).toBe(hash)

  const elsewhere = await browser.newContext({ serviceWorkers: 'block' })
  const other = await elsewhere.newPage()
  await other.goto(address)
  await expect(other.getByTestId('notice')).toContainText('a file of its own')
  await elsewhere.close()
})

test('from where an arm’s scene is seen goes with the link', async ({ lab, page }) => {
  await lab.open(linkTo({ planner: 'rrt-guided', scene: 'arm-cuboid', seed: 1 }, 20))
  await lab.settled(20)
  await lab.stage.focus()
  await page.keyboard.press('2')
  await expect(page).toHaveURL(/&page\.camera=(-?[\d.]+,){4}0,0/)
  await page.keyboard.press('+')
  const camera = /page\.camera=([^&]*)/
  const before = camera.exec(page.url())?.[1]
  await expect.poll(() => camera.exec(page.url())?.[1]).not.toBe(before)
  const url = page.url()
  await page.reload()
  await lab.settled(20)
  await expect.poll(() => page.url()).toBe(url)
})
