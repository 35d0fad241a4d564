import type { RunSetup } from '../catalogue/own'
import type { Inspection, Item, Point, TrialRecord } from 'forage-lab'
import { median, optionAt, pointOf } from '../lessons/score'
import type { Question, QuestionOf, RunPart } from '../lessons/format'
import { changed, type WholeRun } from '../lessons/runs'
import { refusals } from '../locales/en/refusals'

/** Whom the core's answers come from. */
export interface Oracle {
  /** A run at an iteration, with the explanation of an item. */
  at(
    setup: RunSetup,
    iteration: number,
    item: Item | null,
  ): Promise<{ inspection: Inspection | null; readings: Readonly<Record<string, number>>; outcome: object | null; evaluations: number }>
  /** The nearest piece in the run that was asked for last. */
  pick(x: number, y: number, reach: number): Promise<Item | null>
  /** Whole runs with the seeds 1, 2, 3, … */
  trials(setup: RunSetup, seeds: number, evaluations: number | null): Promise<TrialRecord[]>
}

/** What came out, as the core has it. */
export type Truth =
  | { kind: 'arrow'; inspection: Inspection; from: Point; to: Point }
  | { kind: 'cell'; inspection: Inspection; centre: Point; probabilities: number[]; directions: string[] }
  | { kind: 'node'; inspection: Inspection; sample: Point; parent: Item; at: Point }
  /** The member whose number is the smallest, all numbers, and where they are while it is asked. */
  | { kind: 'member'; inspection: Inspection; index: number; values: number[]; places: Point[] }
  | { kind: 'item'; inspection: Inspection; option: number; value: number | null }
  /** Of several seeds: how many of them come to the same option. */
  | { kind: 'run'; option: number; value: number; agree: number | null }
  /** The median of each option's runs, and with how many seeds it is alone the best. */
  | { kind: 'compare'; option: number; medians: number[]; wins: number[] }

export type TruthOf<K extends Truth['kind']> = Extract<Truth, { kind: K }>

const text = refusals.truth

/** A question that cannot be answered: its lesson asks for what is not there. */
export class NoTruth extends Error {
  override name = 'NoTruth'
}

/** Finds what the answer to a question is. `at`: the iteration that is shown while it is asked. */
export async function truthOf(question: Question, setup: RunSetup, at: number, oracle: Oracle): Promise<Truth> {
  switch (question.kind) {
    case 'arrow':
      return ofArrow(await explained(question, setup, at + 1, oracle))
    case 'cell':
      return ofCell(await explained(question, setup, at, oracle))
    case 'node':
      return ofNode(await explained(question, setup, at + 1, oracle), oracle)
    case 'member':
      return ofMember(question, setup, at + 1, oracle)
    case 'item':
      return ofItem(question, await explained(question, setup, question.at ?? at + 1, oracle))
    case 'run':
      return ofRun(question, setup, oracle)
    case 'compare':
      return compared(question, setup, oracle)
  }
}

async function explained(
  { item }: { item: { role: string; index: number } },
  setup: RunSetup,
  at: number,
  oracle: Oracle,
): Promise<Inspection> {
  const { inspection } = await oracle.at(setup, at, item as Item)
  if (!inspection) throw new NoTruth(text.item(item.role, item.index, at))
  return inspection
}

function marked(inspection: Inspection, role: string): Point {
  const point = pointOf(inspection, role)
  if (!point) throw new NoTruth(text.mark(inspection.item.role, inspection.item.index, role))
  return point
}

const ofArrow = (inspection: Inspection): Truth => ({
  kind: 'arrow',
  inspection,
  from: marked(inspection, 'before'),
  to: marked(inspection, 'after'),
})

function ofCell(inspection: Inspection): Truth {
  const { columns, labels, rows } = inspection.table
  const column = columns.findIndex(({ name }) => name === 'p')
  if (column < 0) throw new NoTruth(text.probabilities(inspection.item.role, inspection.item.index))
  return {
    kind: 'cell',
    inspection,
    centre: marked(inspection, 'step'),
    probabilities: rows.map((row) => row[column] ?? 0),
    directions: labels.map(String),
  }
}

async function ofNode(inspection: Inspection, oracle: Oracle): Promise<Truth> {
  const at = marked(inspection, 'before')
  const parent = await oracle.pick(...at, 1e-6)
  if (!parent) throw new NoTruth(text.node(at.join(', ')))
  return { kind: 'node', inspection, sample: marked(inspection, 'samples'), parent, at }
}

/** Of more nobody is asked to choose one. */
const MOST_MEMBERS = 100

async function ofMember({ role, of }: QuestionOf<'member'>, setup: RunSetup, at: number, oracle: Oracle): Promise<Truth> {
  const all: Inspection[] = []
  for (let index = 0; index < MOST_MEMBERS; index += 1) {
    const { inspection } = await oracle.at(setup, at, { role, index } as Item)
    if (!inspection) break
    all.push(inspection)
  }
  const values = all.map((inspection) => inspection.values.find(({ name }) => name === of)?.value ?? Number.NaN)
  const index = values.indexOf(Math.min(...values))
  const inspection = all[index]
  if (!inspection) throw new NoTruth(text.reading(role, of, at))
  return { kind: 'member', inspection, index, values, places: all.map((each) => marked(each, 'before')) }
}

function ofItem({ of, options }: QuestionOf<'item'>, inspection: Inspection): Truth {
  const { event, values } = inspection
  const value = of === undefined ? null : (values.find(({ name }) => name === of)?.value ?? Number.NaN)
  const option = value === null ? options.findIndex(({ events }) => events?.includes(event)) : optionAt(options, value)
  if (option < 0) throw new NoTruth(text.option(String(value ?? event)))
  return { kind: 'item', inspection, option, value }
}

async function ofRun({ of, at, seeds, options }: QuestionOf<'run'>, setup: RunSetup, oracle: Oracle): Promise<Truth> {
  const values: number[] = []
  if (seeds !== undefined) {
    for (const record of await oracle.trials(setup, seeds, null)) values.push(numberOf(record, of))
  } else if (at !== undefined) {
    const { readings, outcome, evaluations } = await oracle.at(setup, at, null)
    values.push(numberOf({ ...outcome, readings, evaluations }, of))
  }
  const value = median(values)
  const option = optionAt(options, value)
  if (option < 0) throw new NoTruth(text.option(String(value)))
  return {
    kind: 'run',
    option,
    value,
    agree: seeds === undefined ? null : values.filter((each) => optionAt(options, each) === option).length,
  }
}

async function compared({ of, options, seeds, evaluations }: QuestionOf<'compare'>, setup: RunSetup, oracle: Oracle): Promise<Truth> {
  const all = await Promise.all(
    options.map(async ({ run }) =>
      (await oracle.trials(setupWith(setup, run), seeds, evaluations ?? null)).map((record) => numberOf(record, of)),
    ),
  )
  const medians = all.map((values) => median(values))
  const option = medians.indexOf(Math.min(...medians))
  const wins = all.map(
    (values, own) => values.filter((value, seed) => all.every((others, at) => at === own || value < (others[seed] ?? Number.NaN))).length,
  )
  return { kind: 'compare', option, medians, wins }
}

/** A result's number: what is not there, or is of a path that collides, counts as worse than all. */
export function numberOf(result: object, of: string): number {
  const { readings } = result as { readings?: Readonly<Record<string, number>> }
  const own = (result as Readonly<Record<string, unknown>>)[of]
  const invalid = (of === 'length' || of === 'gap') && (result as { feasible?: boolean }).feasible === false
  if (own === null || invalid) return Number.POSITIVE_INFINITY
  const value = typeof own === 'number' ? own : readings?.[of]
  if (value === undefined) throw new NoTruth(text.nothing(of))
  return value
}

/** A setup with what a part says otherwise. */
export const setupWith = ({ params = {}, seed = 0, ...setup }: RunSetup, part: RunPart): RunSetup =>
  changed({ ...setup, params, seed } as WholeRun, part) as RunSetup
