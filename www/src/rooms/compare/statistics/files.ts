import type { ParameterValue, Scene, TrialRecord } from 'forage-lab'
import { batch as text } from '../../../locales/en/batch'
import { cell } from '../../../text/cells'
import type { Shown } from './shown'

/* The files of `forage experiment`: the same columns but for its digests, the same digits, the same order of rows. */

const LEAD = ['scene', 'planner', 'seed'] as const
const RESULTS = [
  'status',
  'limit',
  'iterations',
  'budget',
  'evaluations',
  'cost',
  'length',
  'value',
  'feasible',
  'clearance',
  'exact',
  'exact_by',
  'gap',
  'within',
  'reached',
  'reached_iteration',
  'settled',
  'turns',
  'deterministic',
  'hash',
] as const

/** What counts as reached in the page: what the core and the shell take, too, unless told otherwise. */
const WITHIN = 0.01

/** Beyond these the shell writes powers of ten. */
const [LEAST_PLAIN, LEAST_LARGE] = [1e-4, 1e16]

/** The shortest digits that give the number again, as the shell writes them. */
export function digits(value: number): string {
  const size = Math.abs(value)
  if (Object.is(value, -0)) return '-0'
  return size === 0 || (size >= LEAST_PLAIN && size < LEAST_LARGE) ? String(value) : value.toExponential().replace('+', '')
}

const plain = (value: ParameterValue | null | undefined): string =>
  value === null || value === undefined ? '' : typeof value === 'number' ? digits(value) : String(value)

const json = (value: ParameterValue | null | undefined): string =>
  value === null || value === undefined ? 'null' : typeof value === 'number' ? digits(value) : JSON.stringify(value)

interface Table {
  columns: string[]
  rows: (ParameterValue | null | undefined)[][]
}

function tableOf(shown: Shown): Table {
  // Those that any entrant sets, in the order in which they are met.
  const names = [...new Set(shown.groups.flatMap(({ params }) => Object.keys(params)))]
  const taken = (name: string): boolean => ([...LEAD, ...RESULTS] as string[]).includes(name)
  const cells = (record: TrialRecord, keys: readonly (keyof TrialRecord | 'within' | 'budget')[]): Table['rows'][number] =>
    keys.map((key) => (key === 'within' ? WITHIN : key === 'budget' ? shown.allowance : (record[key] as ParameterValue | null)))
  return {
    columns: [...LEAD, ...names.map((name) => (taken(name) ? `p.${name}` : name)), ...RESULTS],
    rows: shown.groups.flatMap(({ runs, params }) =>
      runs.map(({ record, row: { original } }) => [
        ...cells(record, LEAD),
        ...names.map((name) => params[name]),
        ...cells({ ...record, ...original }, RESULTS),
      ]),
    ),
  }
}

export function csv(shown: Shown): string {
  const { columns, rows } = tableOf(shown)
  return [columns, ...rows.map((row) => row.map(plain))].map((row) => `${row.map(cell).join(',')}\n`).join('')
}

export function jsonLines(shown: Shown): string {
  const { columns, rows } = tableOf(shown)
  return rows.map((row) => `{${row.map((value, at) => `${JSON.stringify(columns[at])}:${json(value)}`).join(',')}}\n`).join('')
}

/** Bare keys are letters, digits, dashes and underscores. */
const key = (name: string): string => (/^[\w-]+$/.test(name) ? name : JSON.stringify(name))

/** `scene`: a name that ships, or the path of the file that goes with it. */
export function toml({ plan, groups, allowance }: Shown, name: string, scene: string): string {
  const lines = [
    `# ${text.save.tomlHead} ${name}.toml`,
    `scenes = [${JSON.stringify(scene)}]`,
    `seeds = { from = ${plan.from}, count = ${plan.count} }`,
    `budget = ${allowance ?? '"own"'}`,
    ...groups.flatMap(({ planner, params }) => {
      const set = Object.entries(params).map(([of, value]) => `${key(of)} = ${json(value)}`)
      return ['', '[[planner]]', `name = ${JSON.stringify(planner)}`, ...(set.length > 0 ? [`params = { ${set.join(', ')} }`] : [])]
    }),
  ]
  return `${lines.join('\n')}\n`
}

/** A name for files. */
export const nameOf = ({ plan, groups }: Shown): string =>
  ['batch', plan.maps?.generator ?? plan.scene.name, ...new Set(groups.map(({ planner }) => planner))].join('-').replace(/[^\w.-]+/g, '_')

export const sceneFile = (scene: Scene): string => `${JSON.stringify(scene, null, 1)}\n`
