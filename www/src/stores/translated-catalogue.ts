import type { Catalogue } from 'forage-lab'
import { translated } from 'forage-lab/texts'
import type { Tag } from '../locales/language.svelte'
import { load } from 'virtual:languages'

/** A catalogue, and what its scenes say of themselves in its language. */
export interface Catalogued {
  catalogue: Catalogue
  titles: ReadonlyMap<string, string>
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

/** A catalogue in another language. */
export async function catalogueFrom(before: Catalogue, tag: Tag): Promise<Catalogued> {
  const after = translated(before, (await load[tag]?.catalogue()) ?? [])
  return { catalogue: { ...after, scenes: before.scenes }, titles: titlesOf(before, after) }
}
