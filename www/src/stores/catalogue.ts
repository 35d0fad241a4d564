import type { Catalogue } from 'forage-lab'
import { isOwn, withPlanner } from '../catalogue/own'
import { host } from '../engine/host'
import type { Tag } from '../locales/language.svelte'
import type { Catalogued } from './translated-catalogue'

let english: Promise<Catalogue> | undefined

/** As it ships; one that could not be read is asked for again. */
function shipped(): Promise<Catalogue> {
  english ??= host().catalogue()
  english.catch(() => (english = undefined))
  return english
}

/** The catalogue in a language. Scenes are data, whatever the language: `sceneText` says how they are called. */
export async function catalogueIn(tag: Tag): Promise<Catalogued> {
  const before = await shipped()
  if (tag === 'en') return { catalogue: before, titles: new Map() }
  // English needs no translator.
  const { catalogueFrom } = await import('./translated-catalogue')
  return catalogueFrom(before, tag)
}

/** A catalogue with the planners that somebody wrote for another one. */
export const withOwn = (catalogue: Catalogue, before: Catalogue | null): Catalogue =>
  (before?.planners ?? []).filter(isOwn).reduce(withPlanner, catalogue)
