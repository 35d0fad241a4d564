/** What is shown where nothing else is asked for. */
export const STANDARD = { planner: 'wcpso', scene: 'wcpso-discs', seed: 1 }
