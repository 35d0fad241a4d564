import { readdirSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import { expect, test } from 'vitest'
import { catalogue, type Planner, Session, type Setup } from '../../../pkg/node.js'
import { offered } from '../../src/catalogue/cases'
import { closer } from '../../src/locales/en/closer'

const { events: words, roles } = closer.inspect

/** Whether the page has a word, or the planner a title, for what happened to an item. */
const isNamed = (planner: Planner, event: string): boolean => event in words || planner.events.some(({ name }) => name === event)

test('each event of an inspected item and each of its marks has a word in the page, for every planner', () => {
  const known = catalogue()
  const unnamed = new Set<string>()
  let inspected = 0
  const cases = new Map(offered(known).map((offer) => [offer.planner, offer]))
  for (const { planner: name, scene, params, seed } of cases.values()) {
    const planner = known.planners.find((candidate) => candidate.name === name) as Planner
    const session = new Session({ planner: name, scene, params, seed } as Setup)
    for (let i = 0; i < 8; i++) {
      for (const layer of planner.layers.filter(({ pickable }) => pickable)) {
        for (let index = 0; index < 3; index++) {
          const inspection = session.inspect({ role: layer.role, index })
          if (!inspection) continue
          inspected++
          if (!isNamed(planner, inspection.event)) unnamed.add(`${name}: ${inspection.event}`)
          for (const { role } of inspection.layers) {
            if (!(role in roles || `${layer.role} ${role}` in roles)) unnamed.add(`${name}: ${layer.role} ${role}`)
          }
        }
      }
      session.step(1)
    }
    session.free()
  }
  expect([...unnamed]).toEqual([])
  expect(inspected).toBeGreaterThan(500)
})

/** How the core’s explanations write what happened: in front of a sentence, in a call, one of two, of a list or of a match. */
const WRITTEN = [
  /\(\s*"([^"]+)",\s*(?:message!|summary\b|random_start\b)/g,
  /\b(?:sheet|Inspection::new)\((?:[^"]|message!\([^)]*\))*?,\s*"([^"]+)",/g,
  /(?:title, |item, |event = |\()if [\w.]+ \{ "([^"]+)" \} else \{ "([^"]+)" \}/g,
  /event = "([^"]+)"/g,
  /=> "([^"]+)",/g,
]

test('each word for what happens is one of the core’s, and each of these has a word', () => {
  const root = new URL('../../../src', import.meta.url).pathname
  const sources = readdirSync(root, { recursive: true, encoding: 'utf8' })
    .filter((file) => file.endsWith('.rs') && !file.includes('tests'))
    .map((file) => readFileSync(join(root, file), 'utf8').replace(/#\[cfg\(test\)\]\s+mod \w+ \{.*/s, ''))
    .filter((source) => source.includes('Inspection'))
  const listed = sources.flatMap((source) => [...source.matchAll(/const WORDS[^=]*= &\[(.*?)\]/gs)].map(([, list = '']) => list))
  const found = new Set([
    ...sources.flatMap((source) => WRITTEN.flatMap((pattern) => [...source.matchAll(pattern)].flatMap(([, ...names]) => names))),
    ...listed.flatMap((list) => [...list.matchAll(/"([^"]+)"/g)].map(([, name = '']) => name)),
  ])
  expect([...found].filter((name) => !(name in words))).toEqual([])
  expect(Object.keys(words).filter((name) => !found.has(name))).toEqual([])
})
