import { templates as all } from 'virtual:templates'
import { language } from '../../locales/language.svelte'

export type Level = 'easy' | 'medium' | 'hard'

export interface Template {
  name: string
  title: string
  level: Level
  code: string
}

/** From easy to hard. */
const NAMES: Readonly<Record<Level, readonly string[]>> = {
  easy: ['random-search', 'hill-climber'],
  medium: ['pso', 'ants'],
  hard: ['rrt', 'two-opt'],
}
export const LEVELS = Object.keys(NAMES) as Level[]

/** The templates in the language of the page. */
export const templates = (): Template[] =>
  LEVELS.flatMap((level) =>
    NAMES[level].flatMap((name) => {
      const own = all[name]?.[language.tag] ?? all[name]?.en
      return own ? [{ name, level, ...own }] : []
    }),
  )

/** The name of the template that a code is, in whatever language. */
export const templateOf = (code: string): string | undefined =>
  Object.keys(all).find((name) => Object.values(all[name] ?? {}).some((own) => own.code === code))
