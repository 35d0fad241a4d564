import { test as base, expect, type Locator, type Page } from '@playwright/test'
import type { Point, Scene } from '../../../pkg/node.js'
import { common as page } from '../../src/locales/en/common'
import { scenes } from '../../src/locales/en/scenes'
import { extent, fit, isDown, margins, toScreen } from '../../src/render/view'
import { SITE } from './site'

/** All of the page's text. */
const en = { ...page, ...scenes }

export const HASH = /^[0-9a-f]{16}$/

/** Where panels are that are not in *Setup*. */
const TABS: Readonly<Record<string, 'explain' | 'chart'>> = {
  inspect: 'explain',
  pseudocode: 'explain',
  'inspect-table': 'explain',
  'inspect-values': 'explain',
  formulas: 'explain',
  members: 'explain',
  joints: 'explain',
  chart: 'chart',
  events: 'chart',
  readings: 'chart',
  result: 'chart',
}

/** Without a graphics card the browser reads back what WebGL draws, and says that this takes its time; the tests keep workers out. */
const DRIVER = /GL Driver Message .*GPU stall due to ReadPixels|Service Worker registration blocked by Playwright/

/** A run in the lab: what a test begins with that says nothing else. */
export const FIRST = '#v=1&planner=wcpso&scene=wcpso-discs&seed=1&at=0'

/** The page as somebody uses it. */
export class Lab {
  readonly root: Locator
  readonly stage: Locator
  readonly timeline: Locator

  constructor(readonly page: Page) {
    this.root = page.getByTestId('app')
    this.stage = page.getByTestId('stage')
    this.timeline = page.getByRole('slider', { name: en.transport.timeline, exact: true })
  }

  /** Opens the page, or a link of it, and waits for the first picture. */
  async open(link = FIRST): Promise<void> {
    await this.page.goto(SITE + link)
    await expect(this.root).toHaveAttribute('data-phase', 'ready')
    await expect(this.root).not.toHaveAttribute('data-limit', '0')
    // With other letters all is a little wider or narrower.
    if (!link.startsWith('?embed')) await expect(this.page.locator('html[data-letters]')).toBeAttached()
  }

  async iteration(): Promise<number> {
    return Number(await this.root.getAttribute('data-iteration'))
  }

  button(name: string): Locator {
    return this.page.getByRole('button', { name, exact: true })
  }

  async press(name: string): Promise<void> {
    await this.button(name).click()
  }

  /** Stands still at `iteration` (or wherever it is): the state's hash. */
  async settled(iteration?: number): Promise<string> {
    if (iteration !== undefined) await expect(this.root).toHaveAttribute('data-iteration', String(iteration))
    await expect(this.root).toHaveAttribute('data-hash', HASH)
    return (await this.root.getAttribute('data-hash')) ?? ''
  }

  /** After something that starts the run anew: its first picture is there. */
  async restarted(): Promise<void> {
    await expect(this.root).toHaveAttribute('data-stale', 'false')
  }

  async seek(iteration: number): Promise<string> {
    await this.restarted()
    await this.timeline.fill(String(iteration))
    return this.settled(iteration)
  }

  /** The address once it tells the state that `hash` is of. */
  async link(hash: string): Promise<string> {
    await expect(this.page).toHaveURL(new RegExp(`hash=${hash}`))
    return new URL(this.page.url()).hash
  }

  /** Where a point of the scene is on the page, while all of the scene is seen. */
  async whereIs(scene: Scene, point: Point, bare = false): Promise<{ x: number; y: number }> {
    const box = await this.stage.boundingBox()
    if (!box) throw new Error('no stage')
    const [x, y] = toScreen(fit(extent(scene), box, margins(box.width, bare), isDown(scene)), box, point)
    return { x: box.x + x, y: box.y + y }
  }

  async dragFrom(from: { x: number; y: number }, dx: number, dy: number): Promise<void> {
    const { mouse } = this.page
    await mouse.move(from.x, from.y)
    await mouse.down()
    await mouse.move(from.x + dx / 2, from.y + dy / 2, { steps: 4 })
    await mouse.move(from.x + dx, from.y + dy, { steps: 4 })
    await mouse.up()
  }

  /** Shows a tab of the column. */
  async tab(name: 'explain' | 'chart' | 'setup'): Promise<void> {
    await this.page.getByTestId(`tab-${name}`).click()
    // The panels are loaded apart.
    await this.page.locator(`#panel-${name}`).waitFor()
  }

  /** Of what is in a menu on small screens. */
  async choose(action: 'export' | 'embed' | 'keys' | 'theme' | 'present'): Promise<void> {
    const more = this.page.getByTestId('more')
    if (await more.isVisible()) await more.click()
    await this.page.getByTestId(action).click()
  }

  /** On a small screen: gives the stage all the room that there is. */
  async peek(): Promise<void> {
    const smaller = this.page.getByTestId('sheet-smaller')
    while (await smaller.isEnabled()) await smaller.click()
  }

  /** Opens one of the panels, if it is closed, on the tab that has it. */
  async section(id: string): Promise<Locator> {
    const section = this.page.getByTestId(`section-${id}`)
    await this.tab(TABS[id] ?? 'setup')
    if (id === 'inspect') return section
    // A section may open by itself while the page is still being set up: then a click would close it.
    await expect(async () => {
      if (!(await section.evaluate((node: HTMLDetailsElement) => node.open))) await section.locator('> summary').click()
      await expect(section).toHaveAttribute('open', '', { timeout: 500 })
    }).toPass()
    return section
  }

  async layer(role: string, on: boolean): Promise<void> {
    const fold = this.page.getByTestId('fold-legend')
    if ((await fold.isVisible()) && (await fold.getAttribute('aria-expanded')) === 'false') await fold.click()
    await this.page.getByTestId(`layer-${role}`).setChecked(on)
  }

  /**
   * The picture of the whole scene, drawn anew: browsers draw the first picture on a new canvas with other
   * intermediate shades than the following ones.
   */
  async wholePicture(): Promise<Picture> {
    await this.press(en.stage.fit)
    await this.page.mouse.move(0, 0)
    return this.picture()
  }

  /** The stage's pixels once nothing has been drawn for a few frames: for a run that stands still. */
  async picture(): Promise<Picture> {
    await expect(this.stage).toHaveAttribute('data-drawn', 'true')
    return this.stage.evaluate(async (stage: HTMLCanvasElement) => {
      // A copy is read: reading the page's own canvas would change how the browser keeps it.
      const copy = new OffscreenCanvas(1, 1).getContext('2d', { willReadFrequently: true })
      if (!copy) throw new Error('no canvas')
      const look = (): Picture => {
        const { width, height } = stage
        Object.assign(copy.canvas, { width, height })
        copy.drawImage(stage, 0, 0)
        const seen = new Set<number>()
        let digest = 0x811c9dc5
        for (const pixel of new Uint32Array(copy.getImageData(0, 0, width, height).data.buffer)) {
          digest = Math.imul(digest ^ pixel, 0x01000193)
          if (seen.size < 4096) seen.add(pixel)
        }
        return { digest: (digest >>> 0).toString(16), colours: seen.size, width, height }
      }
      let [last, same] = [look(), 0]
      while (same < 3) {
        await new Promise(requestAnimationFrame)
        const next = look()
        same = next.digest === last.digest ? same + 1 : 0
        last = next
      }
      return last
    })
  }
}

export interface Picture {
  digest: string
  /** How many different colours, up to 4096. */
  colours: number
  width: number
  height: number
}

/** Chooses from one of the lists that can be searched. */
export async function pick(page: Page, id: string, value: string): Promise<void> {
  await page.getByTestId(id).click()
  await page.locator(`.picker-list [data-option="${value}"]`).click()
}

/** Every test also watches for errors and for requests to anywhere else. */
export const test = base.extend<{ lab: Lab; watched: undefined }>({
  watched: [
    async ({ page }, use) => {
      const wrongs: string[] = []
      page.on('pageerror', (error) => wrongs.push(`error: ${error.message}`))
      page.on('console', (message) => {
        if ((message.type() === 'error' || message.type() === 'warning') && !DRIVER.test(message.text()))
          wrongs.push(`console: ${message.text()}`)
      })
      page.on('request', (request) => {
        const url = new URL(request.url())
        if (!request.url().startsWith(SITE) && url.protocol !== 'blob:' && url.protocol !== 'data:')
          wrongs.push(`request: ${request.url()}`)
      })
      page.on('response', (response) => {
        if (response.status() >= 400) wrongs.push(`${response.status()}: ${response.url()}`)
      })
      await use(undefined)
      expect(wrongs).toEqual([])
    },
    { auto: true },
  ],
  lab: async ({ page }, use) => {
    await use(new Lab(page))
  },
})

export { en, expect }
