import type { Catalogue } from 'forage-lab'
import { translated } from 'forage-lab/texts'
import { isOwn, withPlanner } from '../catalogue/own'
import { host } from '../engine/host'
import type { Tag } from '../locales/language.svelte'
import { load } from 'virtual:languages'

let english: Promise<Catalogue> | undefined

/** As it ships; one that could not be read is asked for again. */
function shipped(): Promise<Catalogue> {
  english ??= host().catalogue()
  english.catch(() => (english = undefined))
  return english
}

/** What scenes say of themselves, as it is said in another language. */
function titlesOf(before: Catalogue, after: Catalogue): Map<string, string> {
  const pairs = [...before.scenes.keys()].flatMap((k) => {
    const [from, to] = [before.scenes[k], after.scenes[k]]
    return [
      [from?.title, to?.title],
      [from?.note, to?.note],
      [from?.units, to?.units],
    ]
  })
  const generators = before.generators.map(({ title }, k) => [title, after.generators[k]?.title])
  return new Map([...pairs, ...generators].flatMap(([from, to]) => (from && to ? [[from, to] as const] : [])))
}

/** A catalogue, and what its scenes say of themselves in its language. */
export interface Catalogued {
  catalogue: Catalogue
  titles: ReadonlyMap<string, string>
}

/** The catalogue in a language. Scenes are data, whatever the language: `sceneText` says how they are called. */
export async function catalogueIn(tag: Tag): Promise<Catalogued> {
  const before = await shipped()
  if (tag === 'en') return { catalogue: before, titles: new Map() }
  const after = translated(before, (await load[tag]?.catalogue()) ?? [])
  return { catalogue: { ...after, scenes: before.scenes }, titles: titlesOf(before, after) }
}

/** A catalogue with the planners that somebody wrote for another one. */
export const withOwn = (catalogue: Catalogue, before: Catalogue | null): Catalogue =>
  (before?.planners ?? []).filter(isOwn).reduce(withPlanner, catalogue)
