// Languages other than English: whether they have all there is to say, and what finds what they lack.
import assert from 'node:assert/strict'
import { execFileSync } from 'node:child_process'
import { mkdtempSync, readdirSync, readFileSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { test } from 'node:test'
import { fileURLToPath } from 'node:url'
import { english } from '../scripts/languages/english.mjs'
import { compare, languageOf, saidAt, tagsOf } from '../scripts/languages/folder.mjs'
import { numbered } from '../package/texts.js'
import { skeletonOf, textsOf } from '../scripts/languages/page.mjs'

const root = fileURLToPath(new URL('..', import.meta.url))
const locales = join(root, 'locales')
const source = english(process.env.FORAGE)
const tags = tagsOf(locales)

test('every language has every text, translated from the English of today', () => {
  assert.ok(tags.includes('zh-CN'))
  for (const tag of tags) assert.deepEqual(compare(source, languageOf(join(locales, tag))), { missing: [], stale: [], unused: [] }, tag)
})

test('titles and columns of what is reproduced are among the words to translate', () => {
  const lines = readFileSync(join(root, 'REPRODUCTION.md'), 'utf8').split('\n')
  const printed = lines.flatMap((line, k) => {
    // What a document writes over the questions of a claim is in no table of a terminal.
    const title = /^\*\*(?!Questions of )(.*)\*\*$/.exec(line)?.[1]
    const columns = /^\|[ :-]+-[-| :]*$/.test(line) ? lines[k - 1].split('|').map((cell) => cell.trim()) : []
    return [title, ...columns].filter((text) => /[A-Za-z]{2}/.test(text ?? ''))
  })
  assert.ok(printed.length > 300)
  const words = new Set(Object.values(source.texts).flat())
  assert.deepEqual(
    [...new Set(printed)].filter((text) => !words.has(numbered(text).text)),
    [],
  )
})

test('numbers are told from texts, as the shell does', () => {
  for (const [text, pattern, numbers] of JSON.parse(readFileSync(join(root, 'tests/numbered.json'), 'utf8')))
    assert.deepEqual(numbered(text), { text: pattern, numbers })
})

const placeholders = (text) => [...new Set(text.match(/\{ ?(?:NUMBER\()?\$?[\w-]+(?:, digits: \d+\))?/g) ?? [])].sort()

test('translations put the same things in', () => {
  for (const tag of tags) {
    const { messages, texts, lessons } = languageOf(join(locales, tag))
    const variables = (text) => new Set([...text.matchAll(/\$([a-z_][a-z0-9_]*)/g)].map(([, name]) => name))
    for (const [key, { english: before, says }] of Object.entries(messages)) {
      for (const name of variables(says)) assert.ok(variables(before).has(name), `${tag}, ${key}: $${name} is not in "${before}"`)
      // A number that only chooses between words may have nothing to choose.
      const chosen = new Set([...before.matchAll(/\$([a-z_][a-z0-9_]*) ->/g)].map(([, name]) => name))
      for (const name of variables(before)) assert.ok(chosen.has(name) || variables(says).has(name), `${tag}, ${key}: $${name} is lost`)
    }
    for (const [before, entry] of Object.entries(texts))
      for (const says of typeof entry === 'string' ? [entry] : Object.values(entry))
        assert.deepEqual(placeholders(says), placeholders(before), `${tag}: ${before}`)
    for (const [name, entries] of Object.entries(lessons))
      for (const [key, { english: before, says }] of Object.entries(entries)) {
        const numbers = (text) => [...new Set(text.match(/(?<![\\\w}])\{[a-z0-9-]+\}/g) ?? [])].sort()
        assert.deepEqual(numbers(says), numbers(before), `${tag}, ${name}: ${key}`)
      }
  }
})

test('the package speaks it, and English where it has no words', () => {
  const script = `
    import { Session, speakIn } from './pkg/node.js'
    const said = () => { try { new Session({ planner: 'pso', scene: 'sphere', params: { population: 0 } }) } catch ({ message }) { return message } }
    const all = [said()]
    for (const tag of ['zh-CN', 'en']) { await speakIn(tag); all.push(said()) }
    all.push(await speakIn('xx').catch(({ message }) => message), said())
    console.log(JSON.stringify(all))`
  const [english, chinese, again, refused, after] = JSON.parse(
    execFileSync('node', ['--input-type=module', '--eval', script], { cwd: root, encoding: 'utf8' }),
  )
  assert.match(english, /^population: 0 is not allowed/)
  assert.match(chinese, /^population 为 0；应为 1 至 100000 的整数$/)
  assert.deepEqual([again, after], [english, english])
  assert.match(refused, /there is no `xx`; known: en, zh-CN/)
})

test('what a language lacks is listed', () => {
  const before = {
    messages: { a: 'One', b: 'Two', d: 'Five' },
    texts: { things: ['Ant', 'Bat'] },
    paths: ['zoo.ant.title'],
    lessons: { first: { title: 'First', text: 'Text' } },
    glossary: { Swarms: '', bat: 'One bat.', ant: 'One ant.' },
    page: { exported: { 'p.x': "'X'", 'p.y': "'Y'" }, helpers: { 'p.list': '() => 1', 'p.other': '2' } },
  }
  const language = {
    messages: {
      a: { english: 'One', says: 'Eins' },
      b: { english: 'Two', says: '' },
      d: { english: 'Four', says: 'Vier' },
      gone: { says: 'Weg' },
    },
    texts: { Ant: { '': 'Ameise', 'zoo.ant': 'Emse', 'zoo.bat': 'x' }, Cat: 'Katze' },
    lessons: { first: { title: { english: 'First', says: 'Erste' } } },
    glossary: {
      Swarms: { english: '', term: 'Schwärme' },
      bat: { english: 'A bat.', term: 'Fledermaus', says: 'Eine.' },
      ant: { english: 'One ant.', term: 'Ameise', says: '' },
    },
    page: { exported: { 'p.x': "'IX'", 'p.z': "'Z'" }, helpers: { 'p.list': '() => 2' } },
    pageEnglish: { 'p.x': "'X!'", 'p.list': '() => 1' },
  }
  assert.deepEqual(compare(before, language), {
    missing: ['messages: b', 'texts: Bat', 'lessons/first: text', 'glossary: ant', 'page: p.y'],
    stale: ['messages: d', 'glossary: bat', 'page: p.x'],
    unused: ['messages: gone', 'texts: Ant at zoo.bat', 'texts: Cat', 'page: p.z'],
  })
})

test('a text may be said otherwise at a place', () => {
  const entry = { '': 'keep', 'planners.rrt.marks.kept': 'kept', 'planners.rrt': 'stays' }
  assert.equal(saidAt(entry, 'planners.rrt.marks.kept.title'), 'kept')
  assert.equal(saidAt(entry, 'planners.rrt.layers.tree.title'), 'stays')
  assert.equal(saidAt(entry, 'planners.rrt-star.layers.tree.title'), 'keep')
  assert.equal(saidAt('one', 'planners.rrt'), 'one')
})

test('the texts of a module are found as they are written', () => {
  const module = `import { texts } from '../texts'
const list = (names: string[]): string => names.join(', ')
export interface Words {
  a: string
}

/** Texts. */
export const arm = texts('arm', {
  title: 'An arm',
  of: {
    two: (n: number) => ['a', n].join(
      ' and '),
  } as const,
} as const)
`
  const found = textsOf('arm', module)
  assert.deepEqual(found.helpers, { 'arm.list': "(names: string[]): string => names.join(', ')" })
  assert.deepEqual(found.exported, { 'arm.title': "'An arm'", 'arm.of.two': "(n: number) => ['a', n].join( ' and ')" })
  const skeleton = skeletonOf(module, '../en/arm')
  assert.match(skeleton, /^import type \* as English from '..\/en\/arm'\nimport type \{ Translated \} from '..\/texts'\n/)
  assert.match(skeleton, /export const arm: Translated<typeof English.arm> = \{\n {2}title: 'An arm',/)
  assert.deepEqual(textsOf('arm', skeleton), found)
})

test('a skeleton has all there is to translate', { timeout: 120_000 }, () => {
  const LOCALES = mkdtempSync(join(tmpdir(), 'locales-'))
  const language = (...words) => {
    try {
      return execFileSync('node', [join(root, 'scripts/languages/main.mjs'), ...words], {
        encoding: 'utf8',
        env: { ...process.env, LOCALES },
      })
    } catch ({ stdout, stderr }) {
      return stdout + stderr
    }
  }
  assert.equal(language('new', 'xx'), '')
  assert.match(language('new', 'xx'), /is there already/)
  const lines = language('check').trim().split('\n')
  const counts = Object.values(source.texts).flat().length + Object.keys(source.messages).length
  assert.ok(lines.length > counts && lines.every((line) => /^xx: (missing|stale): /.test(line)), lines[0])
  // All is said in English.
  const fill = (path, entries) => writeFileSync(path, JSON.stringify(Object.fromEntries(entries)))
  for (const part of ['messages', 'lessons', 'texts'])
    for (const file of readdirSync(join(LOCALES, 'xx', part))) {
      const path = join(LOCALES, 'xx', part, file)
      const entries = Object.entries(JSON.parse(readFileSync(path, 'utf8')))
      fill(
        path,
        entries.map(([key, entry]) => [key, part === 'texts' ? key : { ...entry, says: entry.english }]),
      )
    }
  const glossary = join(LOCALES, 'xx/glossary.json')
  fill(
    glossary,
    Object.entries(JSON.parse(readFileSync(glossary, 'utf8'))).map(([term, { english }]) => [term, { english, term, says: english }]),
  )
  assert.equal(language('accept', 'xx'), '')
  assert.equal(language('check'), '')
})
