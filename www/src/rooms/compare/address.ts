import type { Catalogue, LinkSetup, ParameterValue, Scene } from 'forage-lab'
import type { Questions } from '../../engine/host/questions'
import { restored } from '../../stores/large-links'
import { sameScene } from '../../scene/equality'

/* Planners with their parameters, and a scene, as keys of an address: `scene=sphere&with=pso,wpso;w_max=0.8`. */

interface Contender {
  planner: string
  params: Readonly<Record<string, ParameterValue>>
}

/** Letters that part keys, planners and parameters stay what they are. */
const plain = (text: string): string => encodeURIComponent(text)

/** Of more planners nobody makes an address. */
const MOST = 16

export const contendersText = (contenders: readonly Contender[]): string =>
  contenders
    .map(({ planner, params }) =>
      [planner, ...Object.entries(params).map(([name, value]) => `${plain(name)}=${plain(String(value))}`)].join(';'),
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
  contenders: { planner: string; params: Record<string, ParameterValue> }[]
  refused: string[]
}

/** Has the core read what an address names, planner by planner, as it reads links. Without a scene where nothing of it is taken. */
export async function named(api: Pick<Questions, 'parseLink'>, scene: string, contenders: string): Promise<Named | { refused: string[] }> {
  const answers = await Promise.all(
    contendersOf(contenders).map(async ({ planner, pairs }) => {
      const params = pairs.map(([name, value]) => `&p.${plain(decoded(name))}=${decoded(value)}`).join('')
      return api.parseLink(await restored(`#v=1&planner=${planner}&scene=${scene}&seed=1${params}&at=0`))
    }),
  )
  const taken = answers.flatMap((answer): LinkSetup[] => (answer.ok ? [answer.value] : []))
  const refused = [...new Set(answers.flatMap((answer) => (answer.ok ? [] : [answer.refusal.message])))]
  const [first] = taken
  if (!first) return { refused }
  return { scene: first.scene, contenders: taken.map(({ planner, params }) => ({ planner, params })), refused }
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
