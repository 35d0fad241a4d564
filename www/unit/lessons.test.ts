import { readFileSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { toJsonSchema } from '@valibot/to-json-schema'
import Ajv2020 from 'ajv/dist/2020.js'
import { describe, expect, it } from 'vitest'
import type { Outcome, Scene } from 'forage-lab'
import { lessonsIn } from '../plugins/lessons'
import { Lesson, Task } from '../src/lessons/format'
import { draftOf, lessonOfDraft, nameFor } from '../src/lessons/draft'
import { packed, unpacked } from '../src/lessons/link'
import { checkLesson, LessonError, readLesson } from '../src/lessons/read'
import { isMet, standingOf } from '../src/lessons/task'
import { median, optionAt, scoreArrow, scoreCell, scoreMember, scoreNode } from '../src/lessons/score'
import { hrefOf, tokensOf } from '../src/ui/markdown'

const folder = fileURLToPath(new URL('../../lessons', import.meta.url))
const SCHEMAS = {
  lesson: [Lesson, 'Forage lesson, version 1'],
  task: [Task, 'Forage task'],
} as const

/** As it lies beside the lessons. `npx vitest run -u` writes it. */
function schemaOf(name: keyof typeof SCHEMAS): string {
  const [schema, title] = SCHEMAS[name]
  const { $schema: _, ...rules } = toJsonSchema(schema, { target: 'draft-2020-12', errorMode: 'ignore' })
  return `${JSON.stringify({ $schema: 'https://json-schema.org/draft/2020-12/schema', title, ...rules }, null, 2)}\n`
}

describe('the schemas', () => {
  it.each(['lesson', 'task'] as const)('%s.schema.json is what the reader keeps to', async (name) => {
    await expect(schemaOf(name)).toMatchFileSnapshot(`${folder}/${name}.schema.json`)
  })

  it('accept the lessons and tasks that ship', () => {
    const ajv = new Ajv2020({ strict: false })
    const [lesson, task] = [ajv.compile(JSON.parse(schemaOf('lesson'))), ajv.compile(JSON.parse(schemaOf('task')))]
    for (const { name, task: own, ...others } of lessonsIn(folder)) {
      expect(lesson({ name, ...others, ...(own && { task: own }) }), name).toBe(true)
      if (!own) continue
      const { text: _, ...rules } = own
      expect(task(rules), name).toBe(true)
    }
  })
})

it('the lesson in the documentation can be read', () => {
  const text = readFileSync(`${folder}/../docs/lessons.md`, 'utf8')
  const [, json = ''] = /```json\n([\s\S]*?)```/.exec(text) ?? []
  expect(readLesson(json).name).toBe('one-move')
})

describe('a lesson that is wrong', () => {
  const whole = (): Record<string, unknown> & { steps: Record<number, Record<string, unknown>>; texts: { en: Record<string, string> } } =>
    JSON.parse(readFileSync(`${folder}/pso.json`, 'utf8'))

  const step = ({ steps }: ReturnType<typeof whole>, at: number): Record<string, unknown> => steps[at] ?? {}

  it.each<[string, (lesson: ReturnType<typeof whole>) => unknown, string, string]>([
    ['has another format', (l) => (l.format = 'x'), 'format', '`format` is "x"; it must be "forage-lesson"'],
    ['has no title', (l) => delete l.title, 'title', '`title` is missing'],
    ['has a field too many', (l) => (l.author = 'x'), 'author', '`author` is no field of this format'],
    ['has no steps', (l) => Object.assign(l, { steps: [] }), 'steps', '`steps` is []; it must be at least 1 long'],
    ['names a text that there is not', (l) => (l.title = 'x'), 'title', '`title` is "x"; `texts.en` has no text with this key'],
    [
      'names what every object has',
      (l) => (l.notes = 'constructor'),
      'notes',
      '`notes` is "constructor"; `texts.en` has no text with this key',
    ],
    ['is in the language of every object', (l) => (l.language = 'constructor'), 'language', '`language` is "constructor"; `texts` has en'],
    ['has a text for nothing', (l) => (l.texts.en.idle = 'x'), 'texts.en.idle', '`texts.en.idle` is not used by the lesson'],
    ['has no texts in its language', (l) => (l.language = 'fr'), 'language', '`language` is "fr"; `texts` has en'],
    ['has an iteration below 0', (l) => (step(l, 1).at = -1), 'steps[1].at', '`steps[1].at` is -1; it must be at least 0'],
    ['has half an iteration', (l) => (step(l, 1).at = 1.5), 'steps[1].at', '`steps[1].at` is 1.5; it must be a whole number'],
    [
      'has two steps of one name',
      (l) => (step(l, 1).name = 'bowl'),
      'steps[1].name',
      '`steps[1].name` is "bowl"; another step has this name',
    ],
    [
      'begins without a planner',
      (l) => (step(l, 0).run = { scene: 'sphere' }),
      'steps[0].run.planner',
      '`steps[0].run.planner` is missing',
    ],
    ['plays backwards', (l) => (step(l, 1).from = 9), 'steps[1].from', '`steps[1].from` is 9; it must be at most 2'],
    [
      'asks an unknown question',
      (l) => (step(l, 3).question = { kind: 'guess' }),
      'steps[3].question.kind',
      '`steps[3].question.kind` is "guess"; it must be ("arrow" or "cell" or "node" or "member" or "item" or "run" or "compare")',
    ],
    [
      'asks for the past',
      (l) => Object.assign(step(l, 5).question as object, { at: 5 }),
      'steps[5].question.at',
      '`steps[5].question.at` is 5; it must be more than 9, the iteration that is shown',
    ],
    [
      'has an option without a range',
      (l) => delete (step(l, 5).question as { options: { to?: number }[] }).options[2]?.to,
      'steps[5].question.options[2]',
      '`steps[5].question.options[2]` must have `from` or `to`',
    ],
    [
      'leads elsewhere than to Compare',
      (l) => (l.experiment = { text: 'experiment', compare: 'https://example.org' }),
      'experiment.compare',
      '`experiment.compare` is "https://example.org"; it must be an address that begins with #view=compare&',
    ],
  ])('%s', (_, change, field, message) => {
    const lesson = whole()
    change(lesson)
    let error: unknown
    try {
      checkLesson(lesson)
    } catch (caught) {
      error = caught
    }
    expect(error).toBeInstanceOf(LessonError)
    expect(error).toMatchObject({ field, message })
  })

  it('is no JSON', () => {
    expect(() => readLesson('{')).toThrow(LessonError)
  })
})

describe('a prediction', () => {
  it('of a move is scored by how far the tip is off, of the length of the move', () => {
    expect(scoreArrow([0, 0], [3, 4], [3, 4])).toEqual({ grade: 'right', off: 0, length: 5, angle: 0 })
    // A right angle: 5 √2 off.
    const turned = scoreArrow([0, 0], [-4, 3], [3, 4])
    expect([turned.grade, turned.off, turned.angle]).toEqual(['off', expect.closeTo(5 * Math.SQRT2), expect.closeTo(90)])
    expect(scoreArrow([1, 1], [4, 5], [3, 4]).grade).toBe('near')
    expect(scoreArrow([0, 0], [-1, 0.1], [-1, -0.1]).angle).toBeCloseTo((2 * Math.atan(0.1) * 180) / Math.PI)
    expect([scoreArrow([0, 0], [0, 0], [0, 0]).grade, scoreArrow([0, 0], [1, 0], [0, 0]).grade]).toEqual(['right', 'off'])
  })

  it('of a step is scored by its probability, of the likeliest one’s', () => {
    const p = [0.5, 0.41, 0.2, 0.09, 0, 0, 0, 0]
    expect([0, 1, 2, 3, 4].map((d) => scoreCell(p, d).grade)).toEqual(['right', 'right', 'near', 'off', 'off'])
  })

  it('of a node is scored by how near it is to the sample', () => {
    const grades = [3, 3.7, 4].map((x) => scoreNode([0, 0], [x, 0], [0, 3], false).grade)
    expect([...grades, scoreNode([0, 0], [0, 3], [0, 3], true).grade]).toEqual(['near', 'near', 'off', 'right'])
  })

  it('of the best member is scored by its place', () => {
    expect([0, 1, 2, 3].map((index) => scoreMember([4, 1, 3, 2], index).grade)).toEqual(['off', 'right', 'near', 'near'])
  })

  it('of a range is the first that has the value', () => {
    const options = [{ from: 2 }, { from: 1, to: 2 }, { to: 1 }]
    expect([3, 2, 1, 0].map((value) => optionAt(options, value))).toEqual([0, 0, 1, 2])
    expect(optionAt([{ to: 1 }], 2)).toBe(-1)
  })

  it('over seeds is about the median; runs without a result are worse than all', () => {
    expect([median([3, 1, 2]), median([1, 2, 3, 4]), median([1, null, null]), median([])]).toEqual([
      2,
      2.5,
      Number.POSITIVE_INFINITY,
      Number.NaN,
    ])
  })
})

describe('a task', () => {
  const shown = {
    planner: 'pso',
    own: false,
    scene: { name: 'sphere-2' } as Scene,
    outcome: { gap: null, length: null, cost: 0.5, feasible: true, evaluations: 900, parameters: { w: 0.7 } } as unknown as Outcome,
  }

  it('is met by a feasible result within the budget, of what is given', () => {
    const met = (task: Task, other: object = {}): boolean => isMet(standingOf(task, { ...shown, ...other }))
    const goal = { cost: 0.5 }
    expect(met({ goal, budget: { evaluations: 900 }, planner: 'pso', scene: 'sphere-2', params: { w: 0.7 } })).toBe(true)
    expect(met({ goal: { cost: 0.4 } })).toBe(false)
    expect(met({ goal, budget: { evaluations: 899 } })).toBe(false)
    expect([met({ goal, planner: 'wpso' }), met({ goal, scene: 'sphere' }), met({ goal, params: { w: 0.8 } })]).toEqual([
      false,
      false,
      false,
    ])
    expect([met({ goal, own: true }), met({ goal, own: true }, { own: true, planner: 'mine' })]).toEqual([false, true])
    expect(met({ goal: { gap: 1 } })).toBe(false)
    expect(met({ goal }, { outcome: { ...shown.outcome, feasible: false } })).toBe(false)
    expect(met({ goal }, { outcome: null })).toBe(false)
  })
})

describe('a draft', () => {
  it.each(lessonsIn(folder).map((lesson) => [lesson.name, lesson] as const))('of %s makes the same lesson again', (_, lesson) => {
    const written = draftOf(lesson)
    const again = lessonOfDraft(written)
    expect(draftOf(again)).toEqual(written)
    expect(checkLesson(again)).toEqual(again)
  })

  it('keeps each step’s run where steps change places', () => {
    const draft = draftOf(readLesson(readFileSync(`${folder}/pso.json`, 'utf8')))
    const [first, second, ...others] = draft.steps
    if (!first || !second) throw new Error('too few steps')
    const turned = checkLesson(lessonOfDraft({ ...draft, steps: [second, { ...first, run: { ...first.run, seed: 9 } }, ...others] }))
    expect(turned.steps.slice(0, 3).map(({ run }) => run)).toEqual([second.run, { seed: 9 }, { seed: second.run.seed }])
  })

  it('names its steps by what they are called, each once', () => {
    expect([nameFor('A swarm!'), nameFor('Ω', []), nameFor('A swarm', ['a-swarm', 'a-swarm-2'])]).toEqual(['a-swarm', 'step', 'a-swarm-3'])
  })

  it('fits in a link and comes out of it', async () => {
    const text = readFileSync(`${folder}/pso.json`, 'utf8')
    const name = await packed(text)
    expect(name).toMatch(/^~[\w-]+$/)
    expect(name.length).toBeLessThan(8000)
    expect(await unpacked(name)).toBe(text)
    await expect(unpacked(name.slice(0, 100))).rejects.toThrow()
  })
})

describe('Markdown', () => {
  it('leads to the web and to addresses of the page only', () => {
    expect(['https://x.org/', 'http://x.org/', '#lesson=pso'].map(hrefOf)).toEqual(['https://x.org/', 'http://x.org/', '#lesson=pso'])
    expect(['javascript:alert(1)', 'data:text/html,x', 'file:///x', '//x', 'x'].map(hrefOf)).toEqual([null, null, null, null, null])
  })

  it('has symbols between dollars, and prices', () => {
    const kinds = (text: string): string[] =>
      tokensOf(text).flatMap((token) => ('tokens' in token ? (token.tokens ?? []) : []).map(({ type }) => type))
    expect(kinds('a $\\omega$ b')).toEqual(['text', 'math', 'text'])
    expect(kinds('for $5 or $6')).toEqual(['text'])
  })
})
