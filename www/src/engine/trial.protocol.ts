/* What crosses between a batch and the threads that carry out its runs. */
import type { RunSetup } from '../catalogue/own'
import type { Bands, Comparison, Friedman, ParameterValue, Reached, Scene, TrialCurve, TrialRecord } from 'forage-lab'
import type { Refusal } from './protocol'

export type Values = Readonly<Record<string, ParameterValue>>

/** Random maps: each seed has the map of its own number. */
export interface Maps {
  /** A generator's name. */
  generator: string
  /** What differs from the generator's defaults. */
  params: Values
}

/** A run that is over. */
export interface Row {
  record: TrialRecord
  /** What files have instead, where runs are compared by how far each is above its own optimum. */
  original: Pick<TrialRecord, 'value' | 'exact'> | null
  curve: Pick<TrialCurve, 'evaluations' | 'values'>
  /** Opens it where it ended. */
  link: string
}

/** A run that is to be carried out. */
export interface Errand {
  /** Which runs it is compared with: see `keyOf`. */
  key: string
  seed: number
  setup: RunSetup
  /** Where the seed's scene comes from, instead of the setup's. */
  maps: Maps | null
  /** It ends with the step that brings it to so many evaluations, if not before. */
  budget: number | null
  /** Where the budget decides how many iterations it has: the most that it may have. */
  most: number | null
}

/** How a run ended: over, refused before it began, broken off, or with the core. */
export type Ending = { is: 'over'; row: Row } | { is: 'refused'; refusal: Refusal } | { is: 'stopped' } | { is: 'broken'; message: string }

export type Curve = Row['curve']

/** Runs that are compared, small values first; in all groups of `common` the same place stands for the same seed. */
export interface Question {
  /** By the gaps to the optimum of each run's own map. */
  relative: boolean
  curves: { key: string; seed: number; curve: Measured }[]
  groups: {
    name: string
    key: string
    deterministic: boolean
    seeds: number[]
    values: (number | null)[]
    reached: (number | null)[]
    spent: number[]
    settled: number[]
    end: number
  }[]
  common: { name: string; deterministic: boolean; values: (number | null)[] }[]
}

/** A curve with the optimum that its run is measured by. */
export interface Measured extends Curve {
  exact: number | null
}

/** A map, or why there is none. */
export interface Made {
  scene?: Scene
  refused?: Refusal
}

/** What the checks of a planner found. */
export interface Conformance {
  checks: string[]
  violations: { check: string; where: string; found: string }[]
}

export interface Answered {
  comparison: Comparison
  /** Mean ranks over the seeds that all groups have run with. */
  friedman: Friedman | null
  /** Since which iteration the runs of each group agreed, those that did: the median. */
  settled: (number | null)[]
  bands: Bands
  reached: Reached[]
}
