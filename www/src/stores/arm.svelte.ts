import type { ArmScene, ArmSolutions, Motion, Point, Point3, Reachability } from 'forage-lab'
import type { Answer } from '../engine/protocol'
import { pool } from '../engine/pool'
import type { Clock } from './clock.svelte'
import { perLab } from './context.svelte'
import { Following } from './following.svelte'
import type { Lab } from './lab.svelte'
import { nodeOf } from './nodes'
import { Swing } from '../scene/trajectory'

/** The arm is shown as fast as it is. */
const PACE = 1
const DEGREE = Math.PI / 180

/** A point whose postures can be asked for. */
export type Aim = 'start' | 'goal' | 'node' | 'tip'

/** Where the tool points, in degrees: about the vertical, from x towards y, and up from the horizontal. */
export interface Direction {
  azimuth: number
  elevation: number
}

/** Two joints, the angles between which they turn, and a posture that the others keep; all in degrees. */
export interface Slice {
  scene: ArmScene
  posture: number[]
  pair: Point
  min: Point
  max: Point
  /** Of the links, in metres. */
  radius: number
}

/** A survey, and the scene that it is of. */
interface Survey {
  scene: ArmScene
  reach: Reachability
}

/** What there is to know about the arm beside the run: how it follows the result, its postures at a point, where its tip can come. */
export class ArmStore {
  readonly following: Following<Motion, Swing>
  node = $state<number | null>(null)
  /** The posture of the node that is pointed at, in degrees, where nodes are postures. */
  pointed = $state.raw<readonly number[] | null>(null)

  aim = $state<Aim>('goal')
  /** Null: whatever is nearest to the arm's posture. */
  direction = $state.raw<Direction | null>(null)
  ghosts = $state.raw<ArmSolutions | null>(null)
  ghost = $state<number | null>(null)
  /** Why nothing can be said of the point's postures. */
  problem = $state('')
  private turn = 0

  private survey = $state.raw<Survey | null>(null)
  surveying = $state(false)
  private exploring: AbortController | undefined
  /** Why there is no survey. */
  unsurveyed = $state('')
  /** What arm stands where among what: another one is to be surveyed anew. */
  readonly reach = $derived.by(() => {
    const [of, now] = [this.survey?.scene, this.lab.scene.arm]
    const holds = of && now && of.arm === now.arm && of.cuboids === now.cuboids && of.workspace === now.workspace
    return holds ? (this.survey?.reach ?? null) : null
  })

  constructor(private readonly lab: Lab) {
    this.following = new Following<Motion, Swing>(
      PACE,
      (params) => lab.api.motion(params),
      (motion) => new Swing(motion),
    )
    lab.followers.motion = this.following
  }

  get clock(): Clock {
    return this.following.clock
  }

  get motion(): Motion | null {
    return this.following.track?.motion ?? null
  }

  postureAt(time: number): readonly number[] | null {
    return this.following.track?.postureAt(time) ?? null
  }

  /** Where a point is, if there is one now. */
  place(aim: Aim): Point3 | null {
    if (aim === 'node') return this.lab.selection.inspection && nodeOf(this.lab.selection.inspection)
    if (aim === 'tip') return this.following.track?.tipAt(this.clock.time) ?? null
    return this.lab.scene.arm?.[aim] ?? null
  }

  /** Asks for a point's postures; null takes them away. */
  async ask(scene: ArmScene, point: Point3 | null, direction: Direction | null): Promise<void> {
    this.turn += 1
    const turn = this.turn
    const near = this.postureAt(this.clock.time)
    const answer = point && (await this.lab.api.armSolutions(scene, point, direction && vector(direction), near ? [...near] : undefined))
    if (turn !== this.turn) return
    this.problem = answer && !answer.ok ? answer.refusal.message : ''
    this.ghosts = answer?.ok ? answer.value : null
    if ((this.ghost ?? 0) >= (this.ghosts?.solutions.length ?? 0)) this.ghost = null
  }

  forget(): void {
    this.turn += 1
    this.ghosts = null
    this.ghost = null
    this.problem = ''
  }

  /** Finds out where the tip can come, on a lattice of this step. */
  explore = async (step: number): Promise<void> => {
    const scene = this.lab.scene.arm
    if (!scene) return
    this.surveying = true
    this.unsurveyed = ''
    this.exploring?.abort()
    const exploring = new AbortController()
    this.exploring = exploring
    const answer = await pool()
      .run<Answer<Reachability>>((api) => api.reach(scene, step), { signal: exploring.signal })
      .catch((error: Error) => error)
    // Called off, or asked again.
    if (exploring.signal.aborted) return
    this.surveying = false
    if (answer instanceof Error) this.unsurveyed = answer.message
    else if (answer.ok) this.survey = { scene, reach: answer.value }
    else this.unsurveyed = answer.refusal.message
  }

  /** Finds out where the arm touches something; null where that was called off, or can't be known. */
  cut = async ({ scene, posture, pair, min, max, radius }: Slice, signal: AbortSignal): Promise<Uint8Array | null> => {
    const answer = await pool()
      .run<Answer<Uint8Array>>((api) => api.slice(scene, posture, pair, min, max, radius), { signal })
      .catch(() => null)
    return !signal.aborted && answer?.ok ? answer.value : null
  }

  /** Takes the cloud away, or calls off what is on its way. */
  clear = (): void => {
    this.exploring?.abort()
    this.surveying = false
    this.survey = null
    this.unsurveyed = ''
  }
}

function vector({ azimuth, elevation }: Direction): Point3 {
  const [turn, rise] = [azimuth * DEGREE, elevation * DEGREE]
  return [Math.cos(rise) * Math.cos(turn), Math.cos(rise) * Math.sin(turn), Math.sin(rise)]
}

/** The direction that a vector has. */
export const directionOf = ([x, y, z]: Point3): Direction => ({
  azimuth: Math.atan2(y, x) / DEGREE,
  elevation: Math.atan2(z, Math.hypot(x, y)) / DEGREE,
})

export const armOf = perLab((lab) => new ArmStore(lab))
