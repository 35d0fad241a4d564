import * as v from 'valibot'

/*
 * What a lesson's file holds. `lessons/lesson.schema.json` is made from this, and the reader refuses what does not keep to it. All words
 * are in `texts`, by language and key; the rest of the file has their keys.
 */

const [MOST_STEPS, MOST_OPTIONS, MOST_SEEDS, LONGEST_TEXT] = [60, 8, 200, 8000] as const

const described = <const S extends v.GenericSchema>(schema: S, description: string) => v.pipe(schema, v.description(description))
const optional = <const S extends v.GenericSchema>(schema: S, description: string) => v.optional(described(schema, description))

const name = v.pipe(v.string(), v.regex(/^[a-z0-9][a-z0-9-]{0,63}$/, 'name'))
const key = v.pipe(v.string(), v.regex(/^[a-z0-9][a-z0-9.-]{0,99}$/, 'key'))
const short = v.pipe(v.string(), v.minLength(1), v.maxLength(100))
const whole = (least: number, most: number) => v.pipe(v.number(), v.integer(), v.minValue(least), v.maxValue(most))
const iteration = whole(0, 1_000_000)

const Params = v.record(short, v.union([v.number(), v.string(), v.boolean()]))
const Scene = v.union([short, v.looseObject({ format: v.literal('forage-scene') })])

/** What a run is made of; what is left out is as in the step before. */
const RunPart = v.strictObject({
  planner: optional(short, 'The name of a planner. Another one begins with its standard parameters.'),
  scene: optional(Scene, 'The name of a shipped scene, or a whole scene.'),
  params: optional(Params, 'The parameters that differ from the standard ones: all of them.'),
  seed: optional(whole(0, Number.MAX_SAFE_INTEGER), 'The seed.'),
})

const Item = v.strictObject({
  role: described(short, 'The key of a layer whose pieces can be explained.'),
  index: described(whole(0, 1_000_000_000), 'Which of its pieces, from 0.'),
})

const asked = {
  text: described(key, 'The question.'),
  answer: optional(key, 'What is said when it is answered, beside the numbers.'),
}

const shows = optional(iteration, 'The iteration that is shown once it is answered, where the answer is about several runs.')

const between = {
  from: optional(v.number(), 'It is this option from this value on.'),
  to: optional(v.number(), 'It is this option below this value.'),
}

const optionsOf = <const S extends v.GenericSchema>(option: S) => v.pipe(v.array(option), v.minLength(2), v.maxLength(MOST_OPTIONS))

const Arrow = v.strictObject({
  kind: v.literal('arrow'),
  ...asked,
  item: described(Item, 'The member whose next move is to be drawn.'),
})

const Cell = v.strictObject({
  kind: v.literal('cell'),
  ...asked,
  item: described(Item, 'The cell on which an ant stands: its layer, and its number row by row.'),
})

const Node = v.strictObject({
  kind: v.literal('node'),
  ...asked,
  item: described(Item, 'The node that the next iteration adds: the answer is its parent.'),
})

const Member = v.strictObject({
  kind: v.literal('member'),
  ...asked,
  role: described(short, 'The layer whose pieces are the members, such as `particles`.'),
  of: described(short, 'The name of a number of their explanations: whose is the smallest after the next iteration is the answer.'),
})

const OfItem = v.strictObject({
  kind: v.literal('item'),
  ...asked,
  item: described(Item, 'What the question is about.'),
  at: optional(iteration, 'The iteration that answers it; else the next one.'),
  of: optional(short, 'The name of a number of its explanation; else the options name its events.'),
  options: optionsOf(
    v.strictObject({
      text: key,
      events: optional(v.pipe(v.array(short), v.minLength(1)), 'It is this option after these events.'),
      ...between,
    }),
  ),
})

const OfRun = v.strictObject({
  kind: v.literal('run'),
  ...asked,
  of: described(
    short,
    'A reading of the planner, or `cost`, `length`, `gap`, `evaluations`; of several seeds one of these, `settled` or `reached`.',
  ),
  at: optional(iteration, 'The iteration that answers it.'),
  seeds: optional(whole(2, MOST_SEEDS), 'Instead of that: the median at the end of so many runs, with the seeds 1, 2, 3, …'),
  shows,
  options: optionsOf(v.strictObject({ text: key, ...between })),
})

const Compare = v.strictObject({
  kind: v.literal('compare'),
  ...asked,
  of: described(
    v.picklist(['cost', 'length', 'gap', 'evaluations', 'iterations']),
    'What the runs are compared by: the smallest median is the answer.',
  ),
  evaluations: optional(whole(1, 1_000_000), 'With so many evaluations each; else to their ends.'),
  seeds: described(whole(2, MOST_SEEDS), 'Of so many runs each, with the seeds 1, 2, 3, …'),
  shows,
  options: optionsOf(v.strictObject({ text: key, run: described(RunPart, 'What differs from the run of the step.') })),
})

const Question = v.variant('kind', [Arrow, Cell, Node, Member, OfItem, OfRun, Compare])

const Step = v.strictObject({
  name: described(name, 'Its name in addresses; no two steps of a lesson share one.'),
  title: optional(key, 'A heading.'),
  text: described(key, 'Two or three sentences, in Markdown.'),
  run: optional(RunPart, 'What runs; the first step names planner and scene.'),
  at: described(iteration, 'The iteration that is shown.'),
  from: optional(iteration, 'It plays from there.'),
  item: optional(Item, 'What is explained on the stage.'),
  layers: optional(v.record(short, v.boolean()), 'Layers that are shown or hidden, by their keys.'),
  highlight: optional(v.pipe(v.array(short), v.minLength(1)), 'Layers that stand out: all others are faint.'),
  camera: optional(
    v.strictObject({
      center: described(v.tuple([v.number(), v.number()]), 'The middle of what is seen, in the scene’s unit.'),
      zoom: described(
        v.pipe(v.number(), v.minValue(0.2), v.maxValue(400)),
        'How many times larger it is than with the whole scene in view.',
      ),
    }),
    'What the stage shows of a scene in the plane; else all of it.',
  ),
  panels: optional(v.array(v.picklist(['chart', 'result', 'parameters'])), 'What is shown below the stage.'),
  question: optional(Question, 'What is asked before it is shown.'),
})

/** What is to be reached, as `forage grade` reads it. */
export const Task = v.strictObject({
  goal: described(
    v.union([
      v.strictObject({ gap: v.pipe(v.number(), v.minValue(0)) }),
      v.strictObject({ length: v.pipe(v.number(), v.minValue(0)) }),
      v.strictObject({ cost: v.number() }),
    ]),
    'At most this gap to the exact optimum (0.01 is 1 %), this length or this cost.',
  ),
  budget: optional(
    v.strictObject({ evaluations: whole(1, Number.MAX_SAFE_INTEGER) }),
    'With at most so many evaluations; else with as many as the run takes.',
  ),
  planner: optional(short, 'The planner that is to be used.'),
  own: optional(v.boolean(), 'The planner is to be one that is written for it; `planner` is not given then.'),
  scene: optional(Scene, 'The scene that it is to be reached on.'),
  params: optional(Params, 'Parameters that are given.'),
})

const written = {
  value: described(v.number(), 'The number: a test computes it again.'),
  as: optional(v.picklist(['percent']), 'Written as a percentage; else as it is.'),
}

/** A number in a text, `{name}`, and where it comes from. */
const Figure = v.variant('kind', [
  v.strictObject({
    kind: v.literal('moment'),
    step: described(name, 'The step whose run it is of.'),
    at: optional(iteration, 'The iteration; else the one that the step shows.'),
    item: optional(Item, 'It is a number of this item’s explanation.'),
    of: described(short, 'A reading, or a field of the result such as `cost`, `length`, `gap`, `exact`, `evaluations`.'),
    ...written,
  }),
  v.strictObject({
    kind: v.literal('seeds'),
    step: described(name, 'The step whose run is repeated.'),
    run: optional(RunPart, 'What differs from it.'),
    seeds: described(whole(2, MOST_SEEDS), 'With the seeds 1, 2, 3, …'),
    evaluations: optional(whole(1, 1_000_000), 'With so many evaluations each; else to the end.'),
    of: described(
      short,
      'The median of `cost`, `length`, `gap`, `evaluations`, `iterations`, `settled`, `reached`, `reached_iteration` or `turns`; `feasible`: the share of runs with a valid result.',
    ),
    ...written,
  }),
  v.strictObject({
    kind: v.literal('setting'),
    step: described(name, 'The step whose run it is of.'),
    of: described(short, 'A parameter.'),
    ...written,
  }),
  v.strictObject({
    kind: v.literal('published'),
    reproduction: described(short, 'As in REPRODUCTION.csv.'),
    table: described(short, 'As in REPRODUCTION.csv.'),
    row: described(short, 'As in REPRODUCTION.csv.'),
    measure: described(short, 'As in REPRODUCTION.csv.'),
    of: described(
      v.picklist(['published_best', 'published_mean', 'published_std', 'published_runs', 'best', 'mean', 'std', 'median', 'runs']),
      'The column.',
    ),
    ...written,
  }),
])

export const Lesson = v.strictObject({
  $schema: optional(v.string(), 'Where this schema is, for editors.'),
  format: described(v.literal('forage-lesson'), 'Always `forage-lesson`.'),
  version: described(v.literal(1), 'The version of this format: 1.'),
  kind: optional(v.picklist(['lesson', 'article']), 'An article has no predictions; else it is a lesson.'),
  name: described(name, 'Its name in addresses.'),
  language: described(v.string(), 'The language of `texts` that has all keys.'),
  title: described(key, 'Its title.'),
  summary: described(key, 'What it is about, in a sentence.'),
  minutes: optional(whole(1, 240), 'How long it takes.'),
  paper: optional(short, 'The tag of the paper that it is about.'),
  goals: optional(v.array(key), 'What one can do after it.'),
  misconception: optional(key, 'The misconception that it removes.'),
  steps: v.pipe(v.array(Step), v.minLength(1), v.maxLength(MOST_STEPS)),
  experiment: optional(
    v.strictObject({
      text: described(key, 'What to compare, and what to look for.'),
      compare: described(v.pipe(v.string(), v.startsWith('#view=compare&')), 'The address in Compare.'),
    }),
    'An experiment to go on with.',
  ),
  task: optional(v.strictObject({ text: key, ...Task.entries }), 'A task whose run is handed in as a link.'),
  numbers: optional(v.record(name, Figure), 'Numbers that texts have as `{name}`.'),
  claims: optional(v.array(short), 'Claims of the paper that are judged at the end, by their names in REPRODUCTION.'),
  notes: optional(key, 'Notes for the lecturer.'),
  texts: described(
    v.record(
      v.pipe(v.string(), v.regex(/^[a-z]{2,3}(-[A-Za-z0-9]{2,8})*$/, 'tag')),
      v.record(key, v.pipe(v.string(), v.minLength(1), v.maxLength(LONGEST_TEXT))),
    ),
    'All words, by language and key; Markdown.',
  ),
})

export type Lesson = v.InferOutput<typeof Lesson>
export type Step = v.InferOutput<typeof Step>
export type Question = v.InferOutput<typeof Question>
export type QuestionOf<K extends Question['kind']> = Extract<Question, { kind: K }>
export type RunPart = v.InferOutput<typeof RunPart>
export type Figure = v.InferOutput<typeof Figure>
export type Task = v.InferOutput<typeof Task>
