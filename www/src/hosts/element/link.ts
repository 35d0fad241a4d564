import type { Catalogue } from 'forage-lab'
import { STANDARD } from '../../catalogue/standard'
import { suits } from '../../scene/stops'

/** What says which run is shown: `src` alone, or the others. */
export const SETUP = ['src', 'planner', 'scene', 'seed', 'params', 'at', 'layers'] as const

type Read = (name: (typeof SETUP)[number]) => string | null

/** `w=0.7; c1=2` as keys of a link. */
const paramsOf = (text: string): string[] =>
  text
    .split(/[;\s]+/)
    .filter(Boolean)
    .map((pair) => `p.${pair}`)

/**
 * The link of the run that an element's attributes ask for. Without a scene it is the first that the planner runs on. What is wrong
 * with it is known when it is opened.
 */
export function linkOf(read: Read, { planners, scenes }: Catalogue): string {
  const layers = read('layers')?.trim()
  const shown = layers ? [`page.layers=${layers.split(/[,\s]+/).join()}`] : []
  const src = read('src')?.trim()
  if (src) return [src, ...shown].join('&')
  const name = read('planner')?.trim() || STANDARD.planner
  const own = read('planner')?.trim()
    ? ''
    : Object.entries(STANDARD.params)
        .map((pair) => pair.join('='))
        .join()
  const planner = planners.find((candidate) => candidate.name === name)
  const fits = (scene: (typeof scenes)[number]): boolean => planner !== undefined && suits(planner, scene)
  const standard = scenes.find((scene) => scene.name === STANDARD.scene)
  const scene = read('scene')?.trim() || (standard && fits(standard) ? standard : scenes.find(fits))?.name || STANDARD.scene
  const seed = read('seed')?.trim() || String(STANDARD.seed)
  const at = read('at')?.trim() || '0'
  const keys = [`planner=${name}`, `scene=${scene}`, `seed=${seed}`, ...paramsOf(read('params') ?? own), `at=${at}`]
  return ['#v=1', ...keys, ...shown].join('&')
}
