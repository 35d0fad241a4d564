/* Runs that spend the same evaluations, whatever their planners take for an iteration; as `run::Spending` and the shell's sweeps do it. */

/** What a run spends, as its first step shows. */
export interface Spending {
  /** Evaluations before that. */
  start: number
  /** Steps that evaluate nothing, before the first that does. */
  idle: number
  /** Evaluations of that one; 0: no step has any. */
  step: number
  /** The most steps that it takes. */
  limit: number
}

/** What a run of this spending evaluates at most, by its own iterations. */
export const allOf = ({ start, idle, step, limit }: Spending): number => start + step * (limit - idle)

/** So many iterations, at most `most`, spend these evaluations: one begun is finished. */
export const iterationsFor = ({ start, idle, step }: Spending, evaluations: number, most: number): number =>
  Math.min(most, Math.max(1, idle + Math.ceil(Math.max(0, evaluations - start) / Math.max(step, 1))))

/** So often a run begins again with more iterations. */
export const AGAIN = 4

interface Over {
  evaluations: number
  iteration: number
  /** The most steps that it takes: more than its parameter `iterations`, where something is prepared before. */
  limit: number
}

/** How many iterations a run is to have whose limit came before its budget was spent with so many; null where that is not so. */
export function moreIterations({ evaluations, iteration, limit }: Over, iterations: number, budget: number, most: number): number | null {
  if (evaluations >= budget || iteration < limit || iterations >= most) return null
  const more = Math.floor(iterations * Math.min(budget / Math.max(evaluations, 1), 100) * 1.1)
  return Math.min(most, Math.max(iterations + 1, more))
}
