import { existsSync, readdirSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import type { Plugin } from 'vite'
import type { Lesson } from '../src/lessons/format.ts'
import { readLesson } from '../src/lessons/read.ts'

const ID = 'virtual:lessons'
const RESOLVED = `\0${ID}`
/** The order in which they are offered; others follow by name. */
const FIRST = 'order.json'

/** The words of a lesson in other languages: those have a folder each. */
function translated(name: string, locales: string): Lesson['texts'] {
  const tags = readdirSync(locales).filter((tag) => existsSync(join(locales, tag, 'lessons', `${name}.json`)))
  return Object.fromEntries(
    tags.map((tag) => {
      const entries = JSON.parse(readFileSync(join(locales, tag, 'lessons', `${name}.json`), 'utf8')) as Record<string, { says: string }>
      const said = Object.entries(entries).flatMap(([key, { says }]) => (says ? [[key, says] as const] : []))
      return [tag, Object.fromEntries(said)]
    }),
  )
}

/** The lessons of a folder, in their order, in all languages. */
export function lessonsIn(folder: string, locales = join(folder, '../locales')): Lesson[] {
  const order = JSON.parse(readFileSync(join(folder, FIRST), 'utf8')) as string[]
  const files = readdirSync(folder).filter((file) => file.endsWith('.json') && !file.endsWith('.schema.json') && file !== FIRST)
  const lessons = files.map((file) => {
    try {
      const lesson = readLesson(readFileSync(join(folder, file), 'utf8'))
      if (`${lesson.name}.json` !== file) throw new Error(`its name is ${lesson.name}`)
      return { ...lesson, texts: { ...lesson.texts, ...translated(lesson.name, locales) } }
    } catch (error) {
      throw new Error(`${join(folder, file)}: ${error instanceof Error ? error.message : String(error)}`)
    }
  })
  const place = ({ name }: Lesson): number => (order.includes(name) ? order.indexOf(name) : order.length)
  return lessons.sort((a, b) => place(a) - place(b) || a.name.localeCompare(b.name))
}

interface Judged {
  id: string
  paper: string
  says: string
  mark: string
}

/** Without its scripts: a list needs no more of a lesson. */
const entryOf = ({ name, kind, minutes, paper, language, title, summary, steps, texts }: Lesson) => ({
  name,
  kind: kind ?? 'lesson',
  minutes,
  paper,
  steps: steps.length,
  texts: Object.fromEntries(Object.entries(texts).map(([tag, known]) => [tag, { title: known[title], summary: known[summary] }])),
  language,
})

/**
 * Provides `virtual:lessons`: what lessons there are, and each of them when it is asked for.
 * @param folder where their files are
 * @param locales where other languages have their words
 * @param claims the file with the judged claims of the papers
 */
export function lessons(folder: string, locales: string, claims: string): Plugin {
  return {
    name: 'forage-lessons',
    resolveId: (id) => (id === ID || id.startsWith(`${ID}/`) ? `\0${id}` : undefined),
    load(id) {
      if (!id.startsWith(RESOLVED)) return undefined
      const all = lessonsIn(folder, locales)
      for (const file of readdirSync(folder)) this.addWatchFile(join(folder, file))
      if (id !== RESOLVED) {
        const lesson = all.find(({ name }) => id === `${RESOLVED}/${name}`)
        return `export default JSON.parse(${JSON.stringify(JSON.stringify(lesson))})`
      }
      const loaders = all.map(({ name }) => `${JSON.stringify(name)}: () => import(${JSON.stringify(`${ID}/${name}`)})`)
      const named = new Set(all.flatMap(({ claims = [] }) => claims))
      const judged = (JSON.parse(readFileSync(claims, 'utf8')) as { claims: Judged[] }).claims
      const told = judged.filter(({ id }) => named.has(id)).map(({ id, paper, says, mark }) => [id, { paper, says, mark }] as const)
      return [
        `export const claims = ${JSON.stringify(Object.fromEntries(told))}`,
        `export const entries = ${JSON.stringify(all.map(entryOf))}`,
        `export const load = { ${loaders.join(', ')} }`,
      ].join('\n')
    },
  }
}
