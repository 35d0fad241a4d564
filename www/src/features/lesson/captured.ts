import { authoring as text } from '../../locales/en/authoring'
import { draft } from '../../stores/draft.svelte'
import type { Lab } from '../../stores/lab.svelte'

/** Captures the run as it is shown; what came of it in words. */
export function captured(lab: Lab): string {
  const step = draft.capture(lab)
  return step === null ? text.uncaptured : text.captured(step)
}
