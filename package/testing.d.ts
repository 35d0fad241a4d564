import type { PlannerInJavaScript } from './planner.js'

/** Something that a planner does not keep to. */
export interface Violation {
  /** The check's name, which is what should hold. */
  check: string
  /** With which scene, seed and parameters. */
  where: string
  /** What was found, in words. */
  found: string
}

/** What the suite found. */
export interface Report {
  planner: string
  /** The names of all checks that were made. */
  checks: string[]
  violations: Violation[]
  /** All of it as text: a line for each violation, or that there is none. */
  toString(): string
}

/**
 * Runs a planner on the shipped scenes of its kinds and says what it does not keep to: the same run for the same seed, the way back,
 * hashes and links, costs that are true and never rise, what draws and explains and changes nothing. It is registered for that, or named
 * if it was registered before.
 * `steps`: how many iterations each run takes; 40 if it is left out. `scenes`: the names of others, where those that the suite takes would
 * take too long.
 */
export function conform<State extends object>(
  planner: PlannerInJavaScript<State> | string,
  options?: { steps?: number; scenes?: readonly string[] },
): Promise<Report>
