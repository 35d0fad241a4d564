import { sceneText } from '../../text/scene-text'
import { canvasesOf } from '../stage/canvases'
import { figures as text } from '../../locales/en/figures'
import { common } from '../../locales/en/common'
import type { Footer } from '../../render/display'
import type { Lab } from '../../stores/lab.svelte'
import { compared } from '../../text/gap'
import { number } from '../../text/number'
import type { Described } from './described'

/** What a figure of the run shows, in a line. */
export const titleOf = (lab: Lab, iteration = lab.playback.iteration): string =>
  text.of(lab.setup.planner?.title ?? '', sceneText(lab.run.present?.scene.title ?? ''), iteration)

/** What the files of the run are called. */
export const nameOf = (lab: Lab): string =>
  `forage-${lab.run.present?.planner ?? ''}-${lab.run.present?.scene.name ?? ''}-${lab.run.present?.seed ?? ''}-${lab.playback.iteration}`

/** The address of the run as it is now; empty where it has none. */
export async function addressOf(lab: Lab): Promise<string> {
  const answer = await lab.api.link()
  const [page = ''] = location.href.split('#')
  return answer.ok && answer.value ? page + answer.value : ''
}

/** What was found, and how good it is. */
function found(lab: Lab): string[] {
  const { outcome } = lab.run
  const value = outcome ? (outcome.length ?? outcome.cost) : null
  if (!outcome || value === null) return []
  const isPath = outcome.length !== null
  return [
    `${isPath ? common.result.length : common.result.cost} ${number(value, 6)}`,
    ...(outcome.gap === null ? [] : [compared(outcome.gap, lab.run.optimum)]),
    ...(isPath ? [outcome.feasible ? common.result.free : common.result.cuts] : []),
  ]
}

/** What stands below a figure of the run. */
export async function footerOf(lab: Lab): Promise<Footer> {
  return {
    caption: [titleOf(lab), [...found(lab), `${text.seed} ${lab.run.present?.seed ?? ''}`].join(' · ')],
    legend: canvasesOf(lab).legend,
    link: await addressOf(lab),
  }
}

/** What goes with a figure of this chart of the run. */
export async function describedOf(lab: Lab, chart: string): Promise<Described> {
  const { caption, link } = await footerOf(lab)
  return { name: `${nameOf(lab)}-${chart}`, caption: [...caption], link }
}
