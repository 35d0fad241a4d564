import { MediaQuery } from 'svelte/reactivity'
import { recall, remember } from './storage'

export const CHOICES = ['system', 'light', 'dark'] as const
export type Choice = (typeof CHOICES)[number]

export const isChoice = (value: string | null): value is Choice => CHOICES.some((choice) => choice === value)

const night = new MediaQuery('prefers-color-scheme: dark')

/** Whether it is drawn for day or night. */
export class Theme {
  choice = $state<Choice>('system')
  readonly dark = $derived(this.choice === 'dark' || (this.choice === 'system' && night.current))

  /** The choice of before, where the browser remembers it. */
  recall(): this {
    const stored = recall('theme')
    if (isChoice(stored)) this.choice = stored
    return this
  }

  choose(choice: Choice): void {
    this.choice = choice
    remember('theme', choice)
  }
}

export const stillness = matchMedia('(prefers-reduced-motion: reduce)')
