import type { Catalogue, Layer, Planner, UncheckedSetup } from 'forage-lab'

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

/** What a setup has besides the planner's name. */
export const codeOf = (planner: Planner | null | undefined): Pick<RunSetup, 'code' | 'full'> =>
  isOwn(planner) ? { code: planner.code, full: planner.full } : {}

/** The look of layers that no planner of the catalogue has. */
const OTHERWISE = 'particles'

/** As the catalogue has planners: its layers look as those of the same name do elsewhere. */
export function ownPlanner({ planners }: Catalogue, described: Planner, of: Pick<OwnPlanner, 'code' | 'packed' | 'full'>): OwnPlanner {
  const known = planners.filter((planner) => !isOwn(planner)).flatMap(({ layers }) => layers)
  const lookOf = (role: string): Layer['look'] | undefined => known.find((layer) => layer.role === role)?.look
  const layers = described.layers.flatMap((layer): Layer[] => {
    const look = lookOf(layer.role) ?? lookOf(OTHERWISE)
    return look ? [{ ...layer, look } as Layer] : []
  })
  return { ...described, layers, ...of }
}

/** The catalogue with a planner, in the place of another one of its name. */
export const withPlanner = (catalogue: Catalogue, planner: OwnPlanner): Catalogue => ({
  ...catalogue,
  planners: [...catalogue.planners.filter(({ name }) => name !== planner.name), planner],
})
