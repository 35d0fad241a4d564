import type { ArmSolutions, Motion, Reachability } from 'forage-lab'
import type { Clock } from '../state/clock.svelte'

/**
 * What the stage in space shows beside the run, and who else shows it: `state/arm.svelte.ts` exports `arm`, an object like this.
 * What it needs of the run itself is in `lab`: `arm` (the scene), `frame`, `selection`, `inspection`, `outcome`, `run.exact.tip_path`.
 *
 * - Which node is looked at closer is `lab.inspection?.item` (`{ role: 'nodes', index }`); to choose one: `lab.inspect(item)`.
 * - What of the scene is selected is `lab.selection`: `start`, `goal`, `base` or `{ kind: 'cuboid', index }`; to choose: `lab.select`.
 * - The scene is changed by the functions of `state/arms.ts`, and put with `lab.edit`, `lab.drag` and `lab.settle`, `lab.press`.
 */
export interface ArmView {
  /** The arm following the result; null: it doesn't, and stands in its home posture. */
  readonly motion: Motion | null
  /** Seconds since it set off. */
  readonly clock: Clock
  /** Its joints in degrees at that time; null without a motion. */
  postureAt(time: number): readonly number[] | null
  /** The postures that bring the tip to a point, shown as ghosts; null: not asked for. */
  readonly ghosts: ArmSolutions | null
  /** The one of them that is pointed at: its number in `ghosts.solutions`. */
  ghost: number | null
  /** Where the tip can come; null: not asked for. */
  readonly reach: Reachability | null
  /** The node that the pointer is over, here or in another view of the same tree. */
  node: number | null
}
