import type { Catalogue, Planner, UncheckedSetup } from 'forage-lab'

/** A setup with the code of its planner, if somebody wrote that. */
export type RunSetup = UncheckedSetup & {
  code?: string | undefined
  /** The code runs without an interpreter around it: the user wrote it, and wants that. */
  full?: boolean | undefined
}

/** A planner that somebody wrote. */
export interface OwnPlanner extends Planner {
  code: string
  /** As links have it, with its key; null where it is too long for one. */
  packed: string | null
  full: boolean
}

export const isOwn = (planner: Planner | null | undefined): planner is OwnPlanner => planner != null && 'code' in planner

/** Whether a run ends when its code does not: at full speed nothing ends a step. */
export const isWatched = ({ code, full }: RunSetup): boolean => code !== undefined && full !== true

/** What a setup has besides the planner's name. */
export const codeOf = (planner: Planner | null | undefined): Pick<RunSetup, 'code' | 'full'> =>
  isOwn(planner) ? { code: planner.code, full: planner.full } : {}

/** The catalogue with a planner, in the place of another one of its name. */
export const withPlanner = (catalogue: Catalogue, planner: OwnPlanner): Catalogue => ({
  ...catalogue,
  planners: [...catalogue.planners.filter(({ name }) => name !== planner.name), planner],
})
