import { expect, type Locator, type Page } from '@playwright/test'
import type { UncheckedSetup, Status } from '../../../pkg/node.js'
import { sessionAt } from './core'
import { HASH, type Lab, pick } from './lab'

/** A racer as it stands. */
export interface Standing {
  planner: string
  iteration: number
  evaluations: number
  status: string
  hash: string
}

/** The race as somebody watches it. */
export class Race {
  readonly root: Locator
  readonly lanes: Locator
  readonly timeline: Locator

  constructor(readonly page: Page) {
    this.root = page.getByTestId('race')
    this.lanes = page.getByTestId('lane')
    this.timeline = page.getByTestId('race-timeline')
  }

  async open(lab: Lab, ready?: string): Promise<void> {
    await lab.open('#view=compare&as=watch')
    await expect(this.root).toHaveAttribute('data-still', 'true')
    if (ready !== undefined) await this.choose(ready)
  }

  async choose(ready: string): Promise<void> {
    // What was here before stands still, too.
    const before = await this.root.getAttribute('data-started')
    const fold = this.page.getByTestId('fold-presets')
    if ((await fold.isVisible()) && (await fold.getAttribute('aria-expanded')) === 'false') await fold.click()
    await this.page.getByTestId(`ready-${ready}`).click()
    await expect(this.root).not.toHaveAttribute('data-started', before ?? '')
    await this.still()
  }

  async add(planner: string): Promise<void> {
    await pick(this.page, 'compare-adds', planner)
    await expect(this.page.locator(`[data-testid=lane][data-planner=${planner}]`)).toHaveCount(1)
    await this.still()
  }

  async remove(planner: string): Promise<void> {
    await this.page.locator(`[data-testid=entrant][data-planner=${planner}]`).getByTestId('entrant-remove').click()
    await expect(this.page.locator(`[data-testid=lane][data-planner=${planner}]`)).toHaveCount(0)
    await this.still()
  }

  async still(): Promise<void> {
    await expect(this.root).toHaveAttribute('data-still', 'true')
  }

  async clock(): Promise<number> {
    return Number(await this.root.getAttribute('data-clock'))
  }

  /** Stands still at a time of the clock: all racers. */
  async at(clock: number): Promise<Standing[]> {
    await expect(this.root).toHaveAttribute('data-clock', String(clock))
    return this.standings()
  }

  async standings(): Promise<Standing[]> {
    await this.still()
    let standings: Standing[] = []
    // All at one moment: a lane that comes back sets the others going between two looks.
    await expect
      .poll(async () => {
        standings = await this.lanes.evaluateAll((lanes) =>
          lanes.map(({ dataset: { planner = '', iteration, evaluations, status = '', hash = '' } }) => ({
            planner,
            iteration: Number(iteration),
            evaluations: Number(evaluations),
            status,
            hash,
          })),
        )
        return standings.length > 0 && standings.every(({ hash }) => HASH.test(hash))
      })
      .toBe(true)
    return standings
  }

  async seek(clock: number): Promise<Standing[]> {
    await this.timeline.fill(String(clock))
    return this.at(clock)
  }

  async step(by: 'race-forward' | 'race-back', times = 1): Promise<void> {
    for (let click = 0; click < times; click += 1) await this.page.getByTestId(by).click()
    await this.still()
  }
}

/** The first iteration at or beyond so many evaluations, or the end, as the core comes to it. */
export const coreAt = (setup: Partial<UncheckedSetup>, clock: number): Standing =>
  sessionAt(setup, 0, (session) => {
    let status: Status = session.status
    while (status === 'running' && session.evaluations < clock) status = session.stepTo(clock, 1)
    return { planner: session.planner, iteration: session.iteration, evaluations: session.evaluations, status, hash: session.hash() }
  })
