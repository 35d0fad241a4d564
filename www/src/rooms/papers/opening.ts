import { tick } from 'svelte'
import type { Lab } from '../../stores/lab.svelte'
import { proposed, type Sight } from '../../stores/proposed.svelte'
import { route, type View } from '../../stores/route.svelte'
import type { Case, Run } from './cases'

/** Beyond so many, lanes say less than statistics. */
const MOST_WATCHED = 8
/** With which its statistics begin. */
const SEEDS = 50

/** What was pressed is gone with its view: whoever uses the keyboard goes on from the name of the new one. */
async function show(view: View): Promise<void> {
  route.go(view)
  await tick()
  document.querySelector<HTMLElement>('nav [aria-current="page"]')?.focus()
}

export function openRun(lab: Lab, { scene: name }: Case, { planner, params, seed }: Run): void {
  const scene = lab.setup.catalogue?.scenes.find((candidate) => candidate.name === name)
  if (!scene) return
  lab.setup.openCase(planner, scene, { ...params }, seed)
  void show('lab')
}

function propose(as: Sight, { scene, runs }: Case, seeds: { from: number; count: number }): void {
  proposed.comparison = { as, scene, planners: runs.map(({ planner, params }) => ({ planner, params: { ...params } })), seeds }
  void show('compare')
}

export const openStatistics = (one: Case, [first, last]: readonly [number, number]): void =>
  propose('statistics', one, { from: first, count: last - first + 1 })

export const watchable = ({ runs }: Case): boolean => runs.length >= 2 && runs.length <= MOST_WATCHED

export const openWatch = (one: Case): void => propose('watch', one, { from: one.runs[0]?.seed ?? 1, count: SEEDS })
