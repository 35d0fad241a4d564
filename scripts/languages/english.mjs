// The English that there is to translate, from where it is written.
import { execFileSync } from 'node:child_process'
import { readdirSync, readFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import { fileURLToPath } from 'node:url'
import { pattern } from '../../package/fluent.mjs'
import { described, numbered } from '../../package/texts.js'
import { glossaryOf, glossaryTexts } from './glossary.mjs'
import { textsIn } from './page.mjs'
import { templatesIn, wordsOf } from './templates.mjs'

const { parse } = createRequire(new URL('../../www/package.json', import.meta.url))('csv-parse/sync')
const root = fileURLToPath(new URL('../..', import.meta.url))
const json = (path) => JSON.parse(readFileSync(`${root}/${path}`, 'utf8'))

/** Texts that say something in English: neither units nor symbols, numbers and formulas. */
const isText = (text) => /[a-z]{2}|§/i.test(text.replace(/\$[^$]*\$|@\w+@/g, ''))

/** Names of planners, scenes and functions: commands have them. */
function namesOf({ planners, scenes, generators }) {
  const choices = generators.flatMap(({ parameters }) => parameters.flatMap(({ options }) => options ?? []))
  return new Set([...planners, ...scenes].map(({ name }) => name).concat(choices.map(({ value }) => value)))
}

/** The texts of the catalogue by the files that they are in: planners by their families. */
function catalogued(catalogue) {
  const families = Object.fromEntries(catalogue.planners.map(({ name, family }) => [name, family]))
  const files = {}
  for (const [key, text] of Object.entries(described(catalogue))) {
    const [list, name] = key.split('.')
    const file = `catalogue-${list === 'planners' ? families[name] : list}`
    files[file] ??= []
    files[file].push(text)
  }
  return files
}

/** The fields of a paper and its claims that are texts of ours. */
const CLAIMED = [
  'says',
  'reading',
  'because',
  'question',
  'shows',
  'remark',
  'place',
  'on',
  'test',
  'numbers',
  'effect',
  'name',
  'journal',
  'reference',
]

function claimed(value, found = []) {
  for (const [field, inner] of Object.entries(value)) {
    if (typeof inner === 'string') {
      if (CLAIMED.includes(field)) found.push(inner)
    } else if (field === 'tables') found.push(...inner)
    else if (inner !== null && typeof inner === 'object') claimed(inner, found)
  }
  return found
}

/** Words of the table of figures: of every column but names, numbers and commands. */
function figures(csv) {
  const own = ['table', 'row', 'measure', 'value_because', 'ranking_because', 'basis_because', 'source_because']
  return parse(csv, { columns: true }).flatMap((row) => own.map((column) => row[column]))
}

/** What a reproduction prints in a terminal besides its tables' words: notes, and what is in cells. */
function reported(markdown) {
  // What a document has of its own: how figures are marked, questions of claims, and lists under a line that introduces them.
  const [, ...papers] = markdown.split(/^## (?=\[)/m)
  const parts = papers.flatMap((paper) => paper.split(/^(?=#|\*\*)/m)).filter((part) => !part.startsWith('**Questions of '))
  return parts.flatMap((part) => {
    const lines = part.split('\n')
    const introduced = new Set()
    for (const [k, line] of lines.entries())
      if (line.startsWith('- ') && (introduced.has(k - 1) || /:$/.test(lines[k - 1] || lines[k - 2] || ''))) introduced.add(k)
    return lines.flatMap((line, k) => {
      if (line.startsWith('- ')) return introduced.has(k) ? [] : [line.slice(2)]
      if (!line.startsWith('| ')) return []
      const cells = line.split(/(?<!\\)\|/).map((cell) => cell.trim().replaceAll('\\|', '|'))
      return cells.filter((cell) => !/^(?:[\w-]+|`.*)$/.test(cell))
    })
  })
}

/**
 * All English by kinds: messages by key, texts by file, lessons by name and key, and the page's texts by key.
 * @param shell the command line of this version
 */
export function english(shell) {
  const run = (...words) => JSON.parse(execFileSync(shell, words, { encoding: 'utf8', maxBuffer: 1 << 28 }))
  const lessons = readdirSync(`${root}/lessons`)
    .filter((file) => file.endsWith('.json') && !file.endsWith('.schema.json') && file !== 'order.json')
    .map((file) => json(`lessons/${file}`))
  const catalogue = run('list', '--json')
  const templates = templatesIn(`${root}/templates`)
  const names = namesOf(catalogue)
  const published = [...claimed(json('REPRODUCTION.claims.json')), ...figures(readFileSync(`${root}/REPRODUCTION.csv`, 'utf8'))]
  // A text is in the first file that has it: the page has that of the papers alone.
  const texts = {
    papers: published.filter((text) => !names.has(text)).map((text) => numbered(text).text),
    ...catalogued(catalogue),
    shell: run('list', '--texts'),
    reproduction: reported(readFileSync(`${root}/REPRODUCTION.md`, 'utf8')).map((text) => numbered(text).text),
    templates: templates.flatMap(({ code }) => wordsOf(code)),
  }
  const known = new Set()
  for (const [file, list] of Object.entries(texts)) {
    texts[file] = [...new Set(list)].filter((text) => isText(text) && !known.has(text))
    for (const text of texts[file]) known.add(text)
  }
  return {
    messages: Object.fromEntries(run('list', '--messages').map((message) => [message.key, pattern(message)])),
    texts,
    paths: [...Object.keys(described(catalogue)), ...templates.map(({ name }) => `templates.${name}`)],
    lessons: Object.fromEntries(lessons.map(({ name, language, texts }) => [name, texts[language]])),
    glossary: glossaryTexts(glossaryOf(`${root}/docs/glossary.md`)),
    page: textsIn(`${root}/www/src/locales/en`),
  }
}
