import { isOwn } from '../../catalogue/own'
import { workshop } from '../../locales/en/workshop'
import { isShortened, LARGEST } from '../../stores/large-links'
import type { Lab } from '../../stores/lab.svelte'
import { route } from '../../stores/route.svelte'
import { languageKey } from '../../stores/language'

async function linkOfRun(lab: Lab): Promise<string> {
  const answer = await lab.api.link()
  if (!answer.ok || !answer.value) throw new Error(answer.ok ? '' : answer.refusal.message)
  return new URL(answer.value + route.added + languageKey(), location.href).href
}

async function linkOfLesson(lab: Lab): Promise<string | null> {
  if (!route.keysOf('learn').startsWith('&lesson=') || route.view !== 'learn') return null
  const found = await (await import('../../stores/lesson-link')).lessonLink(lab)
  return found && new URL(found.address + languageKey(), location.href).href
}

/** A planner that somebody wrote, of which the code is too long for a link. */
const isLong = (lab: Lab, name: string): boolean =>
  lab.setup.catalogue?.planners.some((planner) => planner.name === name && isOwn(planner) && planner.packed === null) ?? false

export type Copied = 'copied' | 'large-scene' | 'large-code'

/** Copies the link of what is shown, unless it is too large to be one. */
export async function copyLink(lab: Lab): Promise<Copied> {
  const runs = route.view === 'lab' || route.view === 'workshop'
  const named = runs ? [lab.setup.plannerName] : [...route.keysOf(route.view).matchAll(/[a-z][\w-]*/g)].map(([name]) => name)
  if (named.some((name) => isLong(lab, name))) {
    lab.notices.text = workshop.large
    return 'large-code'
  }
  const link = runs ? await linkOfRun(lab) : ((await linkOfLesson(lab)) ?? route.href)
  if (link.length > LARGEST || isShortened(link)) return 'large-scene'
  await navigator.clipboard.writeText(link)
  return 'copied'
}
