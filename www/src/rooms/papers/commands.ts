import type { ParameterValue } from 'forage-lab'
import type { Case, Run } from './cases'

const RUN = /^forage run (\S+) --scene (\S+) --seed (\d+)((?: --set \w+=\S+)*)$/

/** The run that a command line repeats; none where it repeats more than one. */
export function runOf(command: string): { run: Run; on: Case } | null {
  const [, planner, scene, seed, sets = ''] = RUN.exec(command) ?? []
  if (planner === undefined || scene === undefined) return null
  const params = Object.fromEntries([...sets.matchAll(/--set (\w+)=(\S+)/g)].map(([, name = '', value = '']) => [name, read(value)]))
  const run = { planner, params, seed: Number(seed) }
  return { run, on: { scene, runs: [run] } }
}

function read(value: string): ParameterValue {
  if (value === 'true' || value === 'false') return value === 'true'
  return Number.isNaN(Number(value)) ? value : Number(value)
}
