import * as v from 'valibot'
import { refusals as text } from '../locales/en/refusals.ts'
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

const refuse = (field: string, problem: string): LessonError => new LessonError(field, field === '' ? problem : text.at(field, problem))

/** Reads a lesson's file. Throws {@link LessonError} at the first thing that is wrong. */
export function readLesson(file: string): Lesson {
  let json: unknown
  try {
    json = JSON.parse(file)
  } catch (error) {
    throw refuse('', text.json(error instanceof Error ? error.message : String(error)))
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
  if (lesson.task?.own && lesson.task.planner !== undefined) throw refuse('task.planner', text.ownTask)
  return lesson
}

const place = (path: readonly { key: unknown }[] = []): string =>
  path.map(({ key }, at) => (typeof key === 'number' ? `[${key}]` : `${at > 0 ? '.' : ''}${String(key)}`)).join('')

/** What a schema says of a value, as what it is and what is allowed. */
function refused(issue: v.BaseIssue<unknown>): LessonError {
  const field = place(issue.path as { key: unknown }[] | undefined)
  if (issue.received === 'undefined') return refuse(field, text.missing)
  if (issue.type === 'strict_object') return refuse(field, text.noField)
  // Where a pattern says it in words, those are its message.
  const allowed = issue.kind === 'validation' && issue.type === 'regex' ? patternOf(issue.message) : wordsOf(issue)
  return refuse(field, text.is(shown(issue.input), allowed))
}

/** What a pattern of the format asks for. */
const patternOf = (name: string): string => (name === 'name' || name === 'key' || name === 'tag' ? text[name] : name)

function wordsOf({ type, expected, ...issue }: v.BaseIssue<unknown>): string {
  const requirement = 'requirement' in issue ? String(issue.requirement) : ''
  const words: Readonly<Record<string, string>> = {
    integer: text.integer,
    min_value: text.atLeast(requirement),
    max_value: text.atMost(requirement),
    min_length: text.longAtLeast(requirement),
    max_length: text.longAtMost(requirement),
    starts_with: text.begins(requirement),
  }
  return words[type] ?? (typeof expected === 'string' ? text.either(expected.split(' | ')) : text.somethingElse)
}

function shown(value: unknown): string {
  const json = JSON.stringify(value) ?? String(value)
  return json.length > 60 ? `${json.slice(0, 60)}…` : json
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
  const own = Object.hasOwn(texts, language) ? texts[language] : undefined
  if (!own) throw refuse('language', text.language(shown(language), Object.keys(texts)))
  const used = new Set<string>()
  for (const [field, key] of keysOf(lesson)) {
    if (!Object.hasOwn(own, key)) throw refuse(field, text.noText(shown(key), language))
    used.add(key)
  }
  for (const [tag, known] of Object.entries(texts)) {
    const idle = Object.keys(known).find((key) => !used.has(key))
    if (idle !== undefined) throw refuse(`texts.${tag}.${idle}`, text.unused)
  }
}

function checkSteps(steps: readonly Step[]): void {
  const names = new Set<string>()
  for (const [at, step] of steps.entries()) {
    const field = `steps[${at}]`
    if (names.has(step.name)) throw refuse(`${field}.name`, text.twice(shown(step.name)))
    names.add(step.name)
    if (step.from !== undefined && step.from > step.at)
      throw refuse(`${field}.from`, text.is(String(step.from), text.atMost(String(step.at))))
    if (at === 0)
      for (const part of ['planner', 'scene'] as const) if (!step.run?.[part]) throw refuse(`${field}.run.${part}`, text.missing)
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
        if (!Object.hasOwn(numbers, name)) throw refuse(`texts.${tag}.${key}`, text.noNumber(name))
        used.add(name)
      }
  for (const [name, number] of Object.entries(numbers)) {
    if (!used.has(name)) throw refuse(`numbers.${name}`, text.inNoText)
    if ('step' in number && !steps.some((step) => step.name === number.step))
      throw refuse(`numbers.${name}.step`, text.is(shown(number.step), text.oneOf(steps.map((step) => step.name))))
  }
}

function checkQuestion({ at, question }: Step, field: string): void {
  if (question?.kind === 'run' && (question.at === undefined) === (question.seeds === undefined))
    throw refuse(`${field}.at`, text.atOrSeeds)
  if ((question?.kind === 'run' || question?.kind === 'item') && question.at !== undefined && question.at <= at)
    throw refuse(`${field}.at`, text.is(String(question.at), text.moreThan(at)))
  if (question?.kind !== 'run' && question?.kind !== 'item') return
  const named = question.kind === 'item' && question.of === undefined
  for (const [number, option] of question.options.entries()) {
    const events = 'events' in option && option.events !== undefined
    const range = option.from !== undefined || option.to !== undefined
    if (named ? !events || range : events || !range) throw refuse(`${field}.options[${number}]`, named ? text.needsEvents : text.needsRange)
  }
}
