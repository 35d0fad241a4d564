import type { Catalogue, LinkSetup, ParameterValue, Scene } from 'forage-lab'
import type { Questions } from '../../engine/host/questions'
import { restored } from '../../stores/large-links'
import { sameScene } from '../../scene/equality'

/* Planners with their parameters, and a scene, as keys of an address: `scene=sphere&with=pso,wpso;w_max=0.8`. */

interface Contender {
  planner: string
  params: Readonly<Record<string, ParameterValue>>
  /** Its own scene, as links have it. */
  scene?: string | null | undefined
}

/** Letters that part keys, planners and parameters stay what they are. */
const plain = (text: string): string => encodeURIComponent(text)

/** Of more planners nobody makes an address. */
const MOST = 16

/** No parameter is called so. */
const OWN = '@'

export const contendersText = (contenders: readonly Contender[]): string =>
  contenders
    .map(({ planner, params, scene }) =>
      [
        planner,
        ...(scene ? [`${OWN}=${scene}`] : []),
        ...Object.entries(params).map(([name, value]) => `${plain(name)}=${plain(String(value))}`),
      ].join(';'),
    )
    .join()

/** A scene that ships by its name; null for others: the core packs those. */
export const shippedText = ({ scenes }: Catalogue, scene: Scene): string | null =>
  scenes.some((shipped) => sameScene(shipped, scene)) ? scene.name : null

/** The scene in a link. */
export const sceneIn = (link: string): string | null => /[#&]scene=([^&]*)/.exec(link)?.[1] ?? null

/** Planners with parameters as texts, as an address has them. */
export const contendersOf = (text: string): { planner: string; pairs: [string, string][] }[] =>
  text
    .split(',')
    .filter(Boolean)
    .slice(0, MOST)
    .map((contender) => {
      const [planner = '', ...pairs] = contender.split(';')
      return { planner, pairs: pairs.map((pair) => [pair.split('=')[0] ?? '', pair.slice(pair.indexOf('=') + 1)]) }
    })

/** What an address names: those that the core takes, and what it says of the others. */
export interface Named {
  scene: Scene
  contenders: { planner: string; params: Record<string, ParameterValue>; scene?: Scene }[]
  refused: string[]
}

/** Has the core read what an address names, planner by planner, as it reads links. Without a scene where nothing of it is taken. */
export async function named(api: Pick<Questions, 'parseLink'>, scene: string, contenders: string): Promise<Named | { refused: string[] }> {
  const answers = await Promise.all(
    contendersOf(contenders).map(async ({ planner, pairs }) => {
      const own = pairs.find(([name]) => name === OWN)?.[1]
      const others = pairs.filter(([name]) => name !== OWN)
      const params = others.map(([name, value]) => `&p.${plain(decoded(name))}=${decoded(value)}`).join('')
      const answer = await api.parseLink(await restored(`#v=1&planner=${planner}&scene=${own ?? scene}&seed=1${params}&at=0`))
      return { answer, own: own !== undefined }
    }),
  )
  const taken = answers.flatMap(({ answer, own }): (LinkSetup & { own: boolean })[] => (answer.ok ? [{ ...answer.value, own }] : []))
  const refused = [...new Set(answers.flatMap(({ answer }) => (answer.ok ? [] : [answer.refusal.message])))]
  const first = taken.find(({ own }) => !own) ?? taken[0]
  if (!first) return { refused }
  const list = taken.map(({ planner, params, scene: on, own }) => ({
    planner,
    params,
    ...(own && on !== first.scene && { scene: on }),
  }))
  return { scene: first.scene, contenders: list, refused }
}

/** A value as it is meant; as it is written where that makes no sense. */
export function decoded(text: string): string {
  try {
    return decodeURIComponent(text)
  } catch {
    return text
  }
}

/** A whole number in these bounds; else nothing. */
export function wholeIn(text: string | undefined, least: number, most: number): number | null {
  const number = text !== undefined && /^\d{1,16}$/.test(text) ? Number(text) : Number.NaN
  return Number.isSafeInteger(number) && number >= least && number <= most ? number : null
}
