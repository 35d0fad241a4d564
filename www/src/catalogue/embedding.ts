/** What there is to press in an embedded run: nothing; what plays the run; that, the tools of the stage and the result. */
export const CONTROLS = ['none', 'play', 'full'] as const
export type Controls = (typeof CONTROLS)[number]
