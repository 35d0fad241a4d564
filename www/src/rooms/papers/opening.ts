import { tick } from 'svelte'
import type { Lab } from '../../stores/lab.svelte'
import { proposed } from '../../stores/proposed.svelte'
import { route, type View } from '../../stores/route.svelte'
import type { Case, Run } from './cases'

const RACERS = { least: 2, most: 4 } as const

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
  void show('stage')
}

export function openBatch({ scene, runs }: Case, [first, last]: readonly [number, number]): void {
  const seeds = { from: first, count: last - first + 1 }
  proposed.batch = { scene, planners: runs.map(({ planner, params }) => ({ planner, params: { ...params } })), seeds }
  void show('batch')
}

export const races = ({ runs }: Case): boolean => runs.length >= RACERS.least && runs.length <= RACERS.most

export function openRace({ scene, runs }: Case): void {
  const [first] = runs
  proposed.race = { scene, planners: runs.map(({ planner, params }) => ({ planner, params: { ...params } })), seed: first?.seed ?? 1 }
  void show('race')
}
