import type { Lesson, Question, RunPart, Step } from './format'
import { changed, NO_RUN, type WholeRun } from './runs'

/*
 * A lesson while it is written: its words are where they are used, and each step has the whole of its run, so that steps can change
 * places.
 */

type Worded<Q> = Q extends { options: (infer O)[] } ? Omit<Q, 'options'> & { options: O[] } : Q
/** A question with its words in place of their keys. */
export type DraftQuestion = Worded<Question>

export interface DraftStep extends Omit<Step, 'title' | 'text' | 'run' | 'question'> {
  title: string
  text: string
  run: WholeRun
  question?: DraftQuestion | undefined
}

export interface Draft extends Pick<Lesson, 'kind' | 'name' | 'language' | 'minutes' | 'paper' | 'task' | 'experiment'> {
  title: string
  summary: string
  goals: string[]
  misconception: string
  notes: string
  steps: DraftStep[]
  /** Words in other languages, by the keys that the file has. */
  others: Lesson['texts']
}

export const emptyDraft = (): Draft => ({
  name: 'my-lesson',
  language: 'en',
  title: '',
  summary: '',
  goals: [],
  misconception: '',
  notes: '',
  steps: [],
  others: {},
})

/** A name for addresses from a title: `A swarm` is `a-swarm`. */
export function nameFor(title: string, taken: readonly string[] = []): string {
  const plain = title
    .toLowerCase()
    .normalize('NFD')
    .replace(/[^a-z0-9]+/g, '-')
    .replace(/^-+|-+$/g, '')
    .slice(0, 40)
  const name = plain || 'step'
  let number = 2
  let found = name
  while (taken.includes(found)) found = `${name}-${number++}`
  return found
}

const same = (a: unknown, b: unknown): boolean => JSON.stringify(a) === JSON.stringify(b)

/** What differs from the run of before, as a file has it. */
function partOf(run: WholeRun, before: WholeRun | undefined): RunPart | undefined {
  if (!before) return run
  const other = run.planner !== before.planner
  const part: RunPart = {
    ...(other && { planner: run.planner }),
    ...(!same(run.scene, before.scene) && { scene: run.scene }),
    // Another planner begins with its standard parameters.
    ...(!same(run.params, other ? {} : before.params) && { params: run.params }),
    ...(run.seed !== before.seed && { seed: run.seed }),
  }
  return Object.keys(part).length > 0 ? part : undefined
}

/** The file of a draft. It is to be read before it is used: what is missing is said there. */
export function lessonOfDraft(draft: Draft): Lesson {
  const { language, others, steps, title, summary, goals, misconception, notes, task, experiment, ...rest } = draft
  const texts: Record<string, string> = {}
  const word = (key: string, words: string): string => {
    texts[key] = words
    return key
  }
  const optional = (key: string, words: string): string | undefined => (words.trim() === '' ? undefined : word(key, words))
  const named = goals.filter((goal) => goal.trim() !== '')
  const lesson = {
    format: 'forage-lesson',
    version: 1,
    ...rest,
    language,
    title: word('title', title),
    summary: word('summary', summary),
    goals: named.length > 0 ? named.map((goal, at) => word(`goals.${at + 1}`, goal)) : undefined,
    misconception: optional('misconception', misconception),
    steps: steps.map(({ title: heading, text, run, question, ...step }, at) => ({
      ...step,
      title: optional(`${step.name}.title`, heading),
      text: word(step.name, text),
      run: partOf(run, steps[at - 1]?.run),
      question: question && keyed(question, step.name, word, optional),
    })),
    experiment: experiment && { ...experiment, text: word('experiment', experiment.text) },
    task: task && { ...task, text: word('task', task.text) },
    notes: optional('notes', notes),
    texts: { ...withKeys(others, texts), [language]: texts },
  }
  // What is undefined is not in a file.
  return JSON.parse(JSON.stringify(lesson)) as Lesson
}

/** Words in other languages that are still used. */
const withKeys = (others: Lesson['texts'], texts: Readonly<Record<string, string>>): Lesson['texts'] =>
  Object.fromEntries(
    Object.entries(others).map(([tag, words]) => [
      tag,
      Object.fromEntries(Object.entries(words).filter(([key]) => Object.hasOwn(texts, key))),
    ]),
  )

function keyed(
  question: DraftQuestion,
  step: string,
  word: (key: string, words: string) => string,
  optional: (key: string, words: string) => string | undefined,
): unknown {
  const options =
    'options' in question
      ? question.options.map((option, at) => ({ ...option, text: word(`${step}.option.${at + 1}`, option.text) }))
      : undefined
  return {
    ...question,
    text: word(`${step}.question`, question.text),
    answer: optional(`${step}.answer`, question.answer ?? ''),
    options,
  }
}

/** A lesson as it is written on. */
export function draftOf(lesson: Lesson): Draft {
  const {
    $schema: _schema,
    format: _format,
    version: _version,
    texts,
    steps,
    title,
    summary,
    goals,
    misconception,
    notes,
    ...rest
  } = lesson
  const { [lesson.language]: own = {}, ...others } = texts
  const word = (key: string | undefined): string => (key === undefined ? '' : (own[key] ?? ''))
  let run = NO_RUN
  return {
    ...rest,
    title: word(title),
    summary: word(summary),
    goals: (goals ?? []).map(word),
    misconception: word(misconception),
    notes: word(notes),
    ...(rest.task && { task: { ...rest.task, text: word(rest.task.text) } }),
    ...(rest.experiment && { experiment: { ...rest.experiment, text: word(rest.experiment.text) } }),
    steps: steps.map(({ title: heading, text, run: part, question, ...step }) => {
      run = changed(run, part)
      return { ...step, title: word(heading), text: word(text), run, ...(question && { question: worded(question, word) }) }
    }),
    others,
  }
}

const worded = (question: Question, word: (key: string | undefined) => string): DraftQuestion =>
  ({
    ...question,
    text: word(question.text),
    ...(question.answer !== undefined && { answer: word(question.answer) }),
    ...('options' in question && { options: question.options.map((option) => ({ ...option, text: word(option.text) })) }),
  }) as DraftQuestion
