import { readFileSync } from 'node:fs'
import { Session } from 'node:inspector'
import type { Profiler } from 'node:inspector'
import { fileURLToPath } from 'node:url'
import { expect, test } from 'vitest'
import { lessonsIn } from '../plugins/lessons'
import { draftOf, lessonOfDraft } from '../src/lessons/draft'
import { LessonError, readLesson } from '../src/lessons/read'
import { piecesOf } from '../src/ui/pieces'
import { tokensOf } from '../src/ui/markdown'

/*
 * The reader of lessons under changed lessons, of which those are kept that reach what no other reached. It takes `FORAGE_FUZZ_MINUTES`,
 * or a few seconds: npx vitest run unit/lessons-fuzz.test.ts
 */

const MINUTES = Number(process.env.FORAGE_FUZZ_MINUTES ?? 0)
const RUNS = 2000
/** The longest text that others are made from: what is copied into itself doubles each time. */
const LONGEST = 100_000

type Json = null | boolean | number | string | Json[] | { [key: string]: Json }

/** What else may stand somewhere. */
const NONSENSE: readonly Json[] = [
  ...[
    null,
    true,
    '',
    'x',
    'constructor',
    '__proto__',
    'toString',
    '{constructor}',
    '{gap}',
    '$x$',
    '**a**',
    '[b](layer:c)',
    'javascript:x',
  ],
  ...[
    0,
    -1,
    0.5,
    1e9,
    Number.POSITIVE_INFINITY,
    2 ** 53,
    'en',
    'zh-CN',
    'run',
    'item',
    'arrow',
    'cell',
    'node',
    'reading',
    'step-1',
    'é\ud800',
    'y'.repeat(5000),
  ],
  ...[[], {}, [[]], { kind: 'run' }, { from: 1, to: 0 }],
]

/** A stream of random numbers below 1 (mulberry32). */
function stream(seed: number): () => number {
  let state = seed
  return () => {
    state = (state + 0x6d2b79f5) | 0
    let mixed = Math.imul(state ^ (state >>> 15), state | 1)
    mixed ^= mixed + Math.imul(mixed ^ (mixed >>> 7), mixed | 61)
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 2 ** 32
  }
}

const unit = stream(27)
const below = (n: number): number => Math.floor(unit() * n)
const one = <T>(list: readonly T[]): T => list[below(list.length)] as T
/** A copy: put into two places of a lesson, one and the same object could come to hold itself. */
const nonsense = (): Json => structuredClone(one(NONSENSE))

/** All places in a value, as what holds them and under which key. */
function* places(value: Json): Generator<[holder: Record<string, Json>, key: string]> {
  if (value === null || typeof value !== 'object') return
  for (const key of Object.keys(value)) {
    yield [value as Record<string, Json>, key]
    yield* places((value as Record<string, Json>)[key] as Json)
  }
}

/** What a text is as JSON, if it is. */
function parsed(text: string): Json {
  try {
    return JSON.parse(text)
  } catch {
    return null
  }
}

/** Changes something in a text: a value in it, or its letters. */
function changed(text: string, other: string): string {
  if (unit() < 0.1) {
    const at = below(text.length)
    return one([text.slice(0, at), text.slice(0, at) + one(['"', '}', ',', '\\', '\u0000', '9']) + text.slice(at + below(3))])
  }
  const [json, elsewhere] = [parsed(text), parsed(other)]
  for (let count = 1 + below(3); count > 0; count--) {
    const all = [...places(json)]
    if (all.length === 0) return other
    const [holder, key] = one(all)
    const others = [...places(elsewhere)]
    const [within, inner] = one(all)
    const [from, name] = others.length > 0 ? one(others) : [holder, key]
    one([
      () => delete holder[key],
      () => (holder[key] = nonsense()),
      () => (holder[key] = structuredClone(from[name] as Json)),
      () => Object.assign(holder, { [one([name, 'constructor', 'extra'])]: one([structuredClone(from[name] ?? null), nonsense()]) }),
      () => Object.assign(holder, { [key]: structuredClone(within[inner] ?? null) }),
    ])()
  }
  return JSON.stringify(json)
}

/** What of some modules was reached since the last question: ranges of their code, and about how often. */
function reached(session: Session): Promise<string[]> {
  return new Promise((resolve, reject) => {
    session.post('Profiler.takePreciseCoverage', (error, taken: Profiler.TakePreciseCoverageReturnType) => {
      if (error) return reject(error)
      const ours = taken.result.filter(({ url }) => /\/src\/(?:lessons|ui)\//.test(url))
      resolve(
        ours.flatMap(({ scriptId, functions }) =>
          functions.flatMap(({ ranges }) =>
            ranges
              .filter(({ count }) => count > 0)
              .map((range) => `${scriptId} ${range.startOffset} ${range.endOffset} ${Math.min(31 - Math.clz32(range.count), 4)}`),
          ),
        ),
      )
    })
  })
}

/** A lesson that is read can be edited, and is shown; one that is not says where it is wrong. */
function tryOut(text: string): boolean {
  try {
    const lesson = readLesson(text)
    for (const known of Object.values(lesson.texts))
      for (const words of Object.values(known)) {
        expect(typeof words).toBe('string')
        for (const token of tokensOf(words)) piecesOf([token], { terms: undefined, layer: 'layer:' })
      }
    const own = lesson.texts[lesson.language] as Record<string, string>
    for (const key of [lesson.title, lesson.summary, ...lesson.steps.map((step) => step.text)])
      expect(Object.hasOwn(own, key), key).toBe(true)
    const edited = readLesson(JSON.stringify(lessonOfDraft(draftOf(lesson))))
    expect(edited.steps.length).toBe(lesson.steps.length)
    return true
  } catch (error) {
    if (!(error instanceof LessonError)) throw error
    expect(error.message.length, error.message).toBeLessThan(1000)
    return false
  }
}

test('changed lessons are read, or refused with what is wrong', { timeout: 60_000 + MINUTES * 60_000 }, async () => {
  const folder = fileURLToPath(new URL('../../lessons', import.meta.url))
  const kept = lessonsIn(folder).map(({ name }) => readFileSync(`${folder}/${name}.json`, 'utf8'))
  const own = kept.length
  const session = new Session()
  session.connect()
  session.post('Profiler.enable')
  session.post('Profiler.startPreciseCoverage', { callCount: true, detailed: true })
  const known = new Set<string>()
  let unchanged = 0
  const until = Date.now() + MINUTES * 60_000
  let [runs, read] = [0, 0]
  for (; runs < RUNS || Date.now() < until; runs++) {
    const text = runs < own ? (kept[runs] as string) : changed(one(kept), one(kept))
    try {
      read += Number(tryOut(text))
    } catch (error) {
      throw new Error(`${error instanceof Error ? error.message : error}: ${text}`)
    }
    const found = await reached(session)
    if (runs >= own && text.length < LONGEST && found.some((place) => !known.has(place))) kept.push(text)
    for (const place of found) known.add(place)
    if (runs === own - 1) unchanged = known.size
  }
  session.disconnect()
  console.info(`${runs} lessons, ${read} of them read; ${kept.length} kept, ${known.size} places reached`)
  // The changed ones reach what the lessons that ship do not, or nothing guides.
  expect(kept.length).toBeGreaterThan(own)
  expect(known.size).toBeGreaterThan(unchanged)
  expect(read).toBeGreaterThan(runs / 100)
  expect(runs - read).toBeGreaterThan(runs / 10)
})
