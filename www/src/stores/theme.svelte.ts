import { recall, remember } from './storage'

export const CHOICES = ['system', 'light', 'dark'] as const
export type Choice = (typeof CHOICES)[number]

const isChoice = (value: string | null): value is Choice => CHOICES.some((choice) => choice === value)

class Theme {
  choice = $state<Choice>('system')
  private system = $state(false)
  readonly dark = $derived(this.choice === 'dark' || (this.choice === 'system' && this.system))

  constructor() {
    const stored = recall('theme')
    if (isChoice(stored)) this.choice = stored
    const query = matchMedia('(prefers-color-scheme: dark)')
    this.system = query.matches
    query.addEventListener('change', ({ matches }) => (this.system = matches))
  }

  choose(choice: Choice): void {
    this.choice = choice
    remember('theme', choice)
  }
}

export const theme = new Theme()
export const stillness = matchMedia('(prefers-reduced-motion: reduce)')
