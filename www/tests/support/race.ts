import { expect, type Locator, type Page } from '@playwright/test'
import type { Setup, Status } from '../../../pkg/node.js'
import { sessionAt } from './core'
import { HASH, type Lab } from './lab'

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
    await lab.open('#view=race')
    await expect(this.root).toHaveAttribute('data-still', 'true')
    if (ready !== undefined) await this.choose(ready)
  }

  async choose(ready: string): Promise<void> {
    await this.page.getByTestId(`ready-${ready}`).click()
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
    const lanes = await this.lanes.all()
    return Promise.all(
      lanes.map(async (lane) => {
        const told = async (name: string): Promise<string> => (await lane.getAttribute(`data-${name}`)) ?? ''
        await expect(lane).toHaveAttribute('data-hash', HASH)
        return {
          planner: await told('planner'),
          iteration: Number(await told('iteration')),
          evaluations: Number(await told('evaluations')),
          status: await told('status'),
          hash: await told('hash'),
        }
      }),
    )
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
export const coreAt = (setup: Partial<Setup>, clock: number): Standing =>
  sessionAt(setup, 0, (session) => {
    let status: Status = session.status
    while (status === 'running' && session.evaluations < clock) status = session.stepTo(clock, 1)
    return { planner: session.planner, iteration: session.iteration, evaluations: session.evaluations, status, hash: session.hash() }
  })
