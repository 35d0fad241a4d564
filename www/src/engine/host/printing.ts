/** What a planner prints belongs to an iteration: known without what runs such planners. */
export const printing = {
  /** The iteration that is computed. */
  iteration: 0,
  /** A step is taken that was taken before. */
  muted: false,
  /** A step begins. */
  onstep: (_iteration: number): void => undefined,
}

export function stepping(iteration: number): void {
  printing.iteration = iteration
  printing.onstep(iteration)
}
