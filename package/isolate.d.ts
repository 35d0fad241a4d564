import type { Session } from './forage.js'
import type { Described, Tools } from './planner.js'

/**
 * Adds a planner by its code: a script that calls `register({ … })` once, which is there, or imports it from `forage-lab`. The code runs
 * in an interpreter of its own, which is loaded when it is needed (231 kB): without network, clock, document and storage, 900 ms for
 * each step, 300 ms for what shows it, and 64 MB at most. `Math` has the bits of the core there. For code that comes from somebody else.
 *
 * Where a step takes longer the run ends as `failed`, and says so. What the code prints by `console.log` goes to `onprint`, and
 * what is wrong with its `draw` and `explain`, which end no run. Steps that are computed once more, for the way back or a curve, print
 * once more.
 *
 * Throws an `Error` with the `line` and `column` where the code is wrong, or the `field` of what it says of itself, and `stopped`, which
 * is `time` or `memory`, where it was stopped.
 */
export function registerCode(code: string, options?: { onprint?: (line: string) => void }): Promise<Described>

/** The link of a run with the code of its planner, 8192 bytes of it at most, deflated. */
export function withCode(link: string, code: string): Promise<string>

/** The code that a link carries; undefined where it has none. */
export function codeIn(link: string): Promise<string | undefined>

/** The state of the planner of a session, as plain data; undefined where it is a planner of the package. */
export function stateOf(session: Session): unknown

/** The mathematics that planners are given, once the part of the core is loaded that runs planners from code. */
export const mathematics: Tools['math']

/**
 * A code with each `a ** b` written as `power$(a, b)`: the last bits of `**` are the engine's own. `registerCode` does so, with the
 * core's power. Throws a `SyntaxError` for `**=`, and where what is on a side of `**` has to be in parentheses.
 */
export function withPowers(code: string): string

/** What `power$` is, by a power of two numbers: that of large integers is exact in every engine. */
export function powerBy(pow: (x: number, y: number) => number): (x: unknown, y: unknown) => unknown

/** A value as `console.log` of a planner shows it: NaN and infinities are written as they are, unlike in JSON. */
export function shown(value: unknown): string
