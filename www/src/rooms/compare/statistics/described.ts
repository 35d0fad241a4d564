import { sceneText } from '../../../text/scene-text'
import { punctuation } from '../../../locales/en/punctuation'
import { figures as text } from '../../../locales/en/figures'
import { exactly, number } from '../../../text/number'
import type { Described } from '../../../features/figure/described'
import { nameOf } from './files'
import type { Shown } from './shown'

/** What goes with a figure of these results. */
export function describedOf(shown: Shown, chart: string, caption: string): Described {
  const { plan, groups, allowance } = shown
  const of = punctuation.list(groups.map(({ label }) => label))
  const budget = allowance === null ? [] : [text.budget(number(allowance))]
  return {
    name: `${nameOf(shown)}-${chart}`,
    caption: [
      text.compared(of, plan.maps ? plan.maps.generator : sceneText(plan.scene.title)),
      [caption, text.seeds(exactly(plan.from), exactly(plan.from + plan.count - 1)), ...budget].join(' '),
    ],
    link: location.href,
  }
}
