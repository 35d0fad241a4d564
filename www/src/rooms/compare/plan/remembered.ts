import type { Catalogue, Scene } from 'forage-lab'
import { sameScene } from '../../../scene/equality'
import { COUNT, MOST_BUDGET, MOST_ENTRANTS, type Plan } from './plan'

/* The plan outlives a reload: it is kept as long as the browser's tab. */

const KEY = 'forage.comparison'

interface Kept extends Omit<Plan, 'scene'> {
  /** The name of a scene that ships, or another in full. */
  scene: string | Scene
}

export function remember(plan: Plan, { scenes }: Catalogue): void {
  const ships = scenes.some((scene) => sameScene(scene, plan.scene))
  const kept: Kept = { ...plan, scene: ships ? plan.scene.name : plan.scene }
  try {
    sessionStorage.setItem(KEY, JSON.stringify(kept))
  } catch {
    // There is no room, or it isn't allowed: nothing is kept that would be of another plan.
    forget()
  }
}

function forget(): void {
  try {
    sessionStorage.removeItem(KEY)
  } catch {
    // Then nothing is there, either.
  }
}

const isWhole = (value: unknown, least: number, most: number): value is number =>
  Number.isSafeInteger(value) && Number(value) >= least && Number(value) <= most

/** What was kept, if this version of the page can still do something with it. */
export function remembered({ planners, scenes, generators }: Catalogue): Plan | null {
  try {
    const { scene: told, maps = null, entrants, from, count, budget } = JSON.parse(sessionStorage.getItem(KEY) ?? '') as Kept
    const scene = typeof told === 'string' ? scenes.find(({ name }) => name === told) : told
    const fits =
      scene &&
      scenes.some(({ kind }) => kind === scene.kind) &&
      (maps === null || (typeof maps.params === 'object' && generators.some(({ name }) => name === maps.generator))) &&
      entrants.length <= MOST_ENTRANTS &&
      entrants.every(
        (entrant) =>
          isWhole(entrant.slot, 0, MOST_ENTRANTS - 1) &&
          typeof entrant.params === 'object' &&
          planners.some(({ name }) => name === entrant.planner),
      ) &&
      isWhole(from, 0, Number.MAX_SAFE_INTEGER - COUNT.most) &&
      isWhole(count, COUNT.least, COUNT.most) &&
      (budget === 'first' || budget === 'own' || isWhole(budget, 1, MOST_BUDGET))
    return fits ? { scene, maps, entrants, from, count, budget } : null
  } catch {
    return null
  }
}
