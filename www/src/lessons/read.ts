import * as v from 'valibot'
import { Lesson, type Step } from './format.ts'

/** A lesson's file that cannot be read: where, what is there, and what is allowed. */
export class LessonError extends Error {
  override name = 'LessonError'

  constructor(
    readonly field: string,
    message: string,
  ) {
    super(message)
  }
}

const refuse = (field: string, problem: string): LessonError => new LessonError(field, field === '' ? problem : `\`${field}\` ${problem}`)

/** Reads a lesson's file. Throws {@link LessonError} at the first thing that is wrong. */
export function readLesson(text: string): Lesson {
  let json: unknown
  try {
    json = JSON.parse(text)
  } catch (error) {
    throw refuse('', `The lesson is not JSON: ${error instanceof Error ? error.message : String(error)}`)
  }
  return checkLesson(json)
}

/** The same of a file that is parsed already. */
export function checkLesson(json: unknown): Lesson {
  const read = v.safeParse(Lesson, json)
  if (!read.success) throw refused(read.issues[0])
  const lesson = read.output
  checkTexts(lesson)
  checkSteps(lesson.steps)
  checkNumbers(lesson)
  if (lesson.task?.own && lesson.task.planner !== undefined)
    throw refuse('task.planner', 'is given, although `task.own` asks for one that is written for it')
  return lesson
}

const place = (path: readonly { key: unknown }[] = []): string =>
  path.map(({ key }, at) => (typeof key === 'number' ? `[${key}]` : `${at > 0 ? '.' : ''}${String(key)}`)).join('')

/** What a schema says of a value, as what it is and what is allowed. */
function refused(issue: v.BaseIssue<unknown>): LessonError {
  const field = place(issue.path as { key: unknown }[] | undefined)
  if (issue.received === 'undefined') return refuse(field, 'is missing')
  if (issue.type === 'strict_object') return refuse(field, 'is no field of this format')
  // Where a pattern says it in words, those are its message.
  const allowed = issue.kind === 'validation' && issue.type === 'regex' ? issue.message : wordsOf(issue)
  return refuse(field, `is ${shown(issue.input)}; it must be ${allowed}`)
}

function wordsOf({ type, expected, ...issue }: v.BaseIssue<unknown>): string {
  const requirement = 'requirement' in issue ? String(issue.requirement) : ''
  const words: Readonly<Record<string, string>> = {
    integer: 'a whole number',
    min_value: `at least ${requirement}`,
    max_value: `at most ${requirement}`,
    min_length: `at least ${requirement} long`,
    max_length: `at most ${requirement} long`,
    starts_with: `an address that begins with ${requirement}`,
  }
  return words[type] ?? String(expected ?? 'something else').replaceAll(' | ', ' or ')
}

function shown(value: unknown): string {
  const text = JSON.stringify(value) ?? String(value)
  return text.length > 60 ? `${text.slice(0, 60)}…` : text
}

/** All keys that the file's other parts have, with where. */
function* keysOf(lesson: Lesson): Generator<[field: string, key: string]> {
  yield ['title', lesson.title]
  yield ['summary', lesson.summary]
  for (const [at, key] of (lesson.goals ?? []).entries()) yield [`goals[${at}]`, key]
  for (const field of ['misconception', 'notes'] as const) if (lesson[field] !== undefined) yield [field, lesson[field]]
  if (lesson.experiment) yield ['experiment.text', lesson.experiment.text]
  if (lesson.task) yield ['task.text', lesson.task.text]
  for (const [at, { title, text, question }] of lesson.steps.entries()) {
    if (title !== undefined) yield [`steps[${at}].title`, title]
    yield [`steps[${at}].text`, text]
    if (!question) continue
    yield [`steps[${at}].question.text`, question.text]
    if (question.answer !== undefined) yield [`steps[${at}].question.answer`, question.answer]
    const options = 'options' in question ? question.options : []
    for (const [number, { text: key }] of options.entries()) yield [`steps[${at}].question.options[${number}].text`, key]
  }
}

/** Each key has its text in the lesson's own language, and no text is there for nothing. */
function checkTexts(lesson: Lesson): void {
  const { language, texts } = lesson
  const own = texts[language]
  if (!own) throw refuse('language', `is ${shown(language)}; \`texts\` has ${Object.keys(texts).join(', ') || 'no language'}`)
  const used = new Set<string>()
  for (const [field, key] of keysOf(lesson)) {
    if (own[key] === undefined) throw refuse(field, `is ${shown(key)}; \`texts.${language}\` has no text with this key`)
    used.add(key)
  }
  for (const [tag, known] of Object.entries(texts)) {
    const idle = Object.keys(known).find((key) => !used.has(key))
    if (idle !== undefined) throw refuse(`texts.${tag}.${idle}`, 'is not used by the lesson')
  }
}

function checkSteps(steps: readonly Step[]): void {
  const names = new Set<string>()
  for (const [at, step] of steps.entries()) {
    const field = `steps[${at}]`
    if (names.has(step.name)) throw refuse(`${field}.name`, `is ${shown(step.name)}; another step has this name`)
    names.add(step.name)
    if (step.from !== undefined && step.from > step.at) throw refuse(`${field}.from`, `is ${step.from}; it must be at most ${step.at}`)
    if (at === 0)
      for (const part of ['planner', 'scene'] as const) if (!step.run?.[part]) throw refuse(`${field}.run.${part}`, 'is missing')
    checkQuestion(step, `${field}.question`)
  }
}

/** As texts have a number: `{gap-end}`. */
export const FIGURE = /\{([a-z0-9][a-z0-9-]*)\}/g

/** Each number in a text is there, and is of a step; none is there for nothing. */
function checkNumbers({ numbers = {}, steps, texts }: Lesson): void {
  const used = new Set<string>()
  for (const [tag, known] of Object.entries(texts))
    for (const [key, words] of Object.entries(known))
      for (const [, name = ''] of words.replace(/\$[^$]*\$/g, '').matchAll(FIGURE)) {
        if (!(name in numbers)) throw refuse(`texts.${tag}.${key}`, `has {${name}}; \`numbers\` has no such number`)
        used.add(name)
      }
  for (const [name, number] of Object.entries(numbers)) {
    if (!used.has(name)) throw refuse(`numbers.${name}`, 'is in no text')
    if ('step' in number && !steps.some((step) => step.name === number.step))
      throw refuse(`numbers.${name}.step`, `is ${shown(number.step)}; it must be one of ${steps.map((step) => step.name).join(', ')}`)
  }
}

function checkQuestion({ at, question }: Step, field: string): void {
  if (question?.kind === 'run' && (question.at === undefined) === (question.seeds === undefined))
    throw refuse(`${field}.at`, 'or `seeds` is needed, and not both')
  if ((question?.kind === 'run' || question?.kind === 'item') && question.at !== undefined && question.at <= at)
    throw refuse(`${field}.at`, `is ${question.at}; it must be more than ${at}, the iteration that is shown`)
  if (question?.kind !== 'run' && question?.kind !== 'item') return
  const named = question.kind === 'item' && question.of === undefined
  for (const [number, option] of question.options.entries()) {
    const events = 'events' in option && option.events !== undefined
    const range = option.from !== undefined || option.to !== undefined
    const what = named ? 'events' : '`from` or `to`'
    if (named ? !events || range : events || !range)
      throw refuse(`${field}.options[${number}]`, `must have ${what.replace('events', '`events`')}`)
  }
}
