import { isShortened, LARGEST } from '../../stores/large-links'
import type { Lab } from '../../stores/lab.svelte'
import { route } from '../../stores/route.svelte'

async function linkOfRun(lab: Lab): Promise<string> {
  const answer = await lab.api.link()
  if (!answer.ok || !answer.value) throw new Error(answer.ok ? '' : answer.refusal.message)
  return new URL(answer.value + route.added, location.href).href
}

async function linkOfLesson(lab: Lab): Promise<string | null> {
  if (!route.keysOf('learn').startsWith('&lesson=') || route.view !== 'learn') return null
  const found = await (await import('../../stores/lesson-link')).lessonLink(lab)
  return found && new URL(found.address, location.href).href
}

/** Copies the link of what is shown; false where it is too large to be one. */
export async function copyLink(lab: Lab): Promise<boolean> {
  const link = route.view === 'lab' || route.view === 'workshop' ? await linkOfRun(lab) : ((await linkOfLesson(lab)) ?? route.href)
  if (link.length > LARGEST || isShortened(link)) return false
  await navigator.clipboard.writeText(link)
  return true
}
