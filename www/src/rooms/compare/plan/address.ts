import type { Catalogue, ParameterValue, Scene } from 'forage-lab'
import type { Questions } from '../../../engine/host/questions'
import { packedOf } from '../../../stores/own-code'
import type { Made, Maps } from '../../../engine/trial.protocol'
import { contendersOf, contendersText, decoded, named, shippedText, wholeIn } from '../address'
import { type Budget, COUNT, MOST_BUDGET, MOST_ENTRANTS, type Plan } from './plan'

/** The key for codes of planners that somebody wrote. */
export const CODES = 'codes'

const MOST_LIMIT = 1_000_000

/** A plan as keys of an address; null where one of its scenes neither ships nor was packed by the core. */
export function planKeys(
  { scene, maps, entrants, from, count, budget }: Plan,
  catalogue: Catalogue,
  packed: (scene: Scene) => string | null,
): string | null {
  const textOf = (one: Scene): string | null => shippedText(catalogue, one) ?? packed(one)
  const text = maps ? contendersText([{ planner: maps.generator, params: maps.params }]) : textOf(scene)
  if (text === null) return null
  const contenders = entrants.map(({ planner, params, scene: own }) => ({ planner, params, scene: own && textOf(own) }))
  if (contenders.some(({ scene: own }) => own === null)) return null
  const evaluations = budget === 'first' ? '' : `&budget=${budget}`
  const codes = packedOf(catalogue.planners.filter(({ name }) => entrants.some(({ planner }) => planner === name)))
  const own = codes.length > 0 ? `&${CODES}=${codes.join()}` : ''
  return `&${maps ? 'maps' : 'scene'}=${text}&seeds=${from}-${from + count - 1}${evaluations}&with=${contendersText(contenders)}${own}`
}

/** A generator's parameters are numbers, switches and choices. */
function parsed(text: string): ParameterValue {
  if (text === 'true' || text === 'false') return text === 'true'
  return text !== '' && Number.isFinite(Number(text)) ? Number(text) : text
}

/** Who reads for an address: the core takes planners as in links, a generator makes the first map. */
interface Readers {
  catalogue: Catalogue
  api: Pick<Questions, 'parseLink'>
  map(maps: Maps, seed: number): Promise<Made>
}

/** The plan that an address names, and what is wrong with the rest. */
export async function planOf(
  keys: ReadonlyMap<string, string>,
  { catalogue, api, map }: Readers,
): Promise<{ plan: Plan | null; wrong: string[] }> {
  // Addresses of races had one seed, those of batches a limit of iterations: neither had a budget.
  const [first, last] = (keys.get('seeds') ?? keys.get('seed') ?? '').split('-')
  const limit = wholeIn(keys.get('limit'), 1, MOST_LIMIT)
  const from = wholeIn(first, 0, Number.MAX_SAFE_INTEGER - COUNT.most) ?? 1
  const to = wholeIn(last, from + COUNT.least - 1, from + COUNT.most - 1)
  const made = await mapsOf(keys.get('maps') ?? '', from, map)
  if (made?.wrong) return { plan: null, wrong: [made.wrong] }
  // What planners take hangs on the kind of scene: on one that ships they are asked for.
  const kind = made?.scene?.kind
  const scene = kind ? (catalogue.scenes.find((shipped) => shipped.kind === kind)?.name ?? '') : (keys.get('scene') ?? '')
  const found = await named(api, scene, keys.get('with') ?? '')
  const wrong = found.refused
  if (!('contenders' in found)) return { plan: null, wrong }
  const plan: Plan = {
    scene: made?.scene ?? found.scene,
    maps: made?.scene ? made.maps : null,
    entrants: found.contenders.slice(0, MOST_ENTRANTS).map(({ planner, params, scene: own }, slot) => ({
      planner,
      params: { ...(limit !== null && { iterations: limit }), ...params },
      slot,
      ...(own && { scene: own }),
    })),
    from,
    count: to === null ? COUNT.standard : to - from + 1,
    budget: budgetOf(keys.get('budget')),
  }
  return { plan, wrong }
}

const budgetOf = (text: string | undefined): Budget => (text === 'own' ? text : (wholeIn(text, 1, MOST_BUDGET) ?? 'first'))

async function mapsOf(text: string, seed: number, map: Readers['map']): Promise<{ maps: Maps; scene?: Scene; wrong?: string } | null> {
  const [spread] = contendersOf(text)
  if (!spread) return null
  const params = Object.fromEntries(spread.pairs.map(([name, value]) => [decoded(name), parsed(decoded(value))]))
  const maps: Maps = { generator: spread.planner, params }
  const { scene, refused } = await map(maps, seed)
  return { maps, ...(scene && { scene }), ...(refused && { wrong: refused.message }) }
}
