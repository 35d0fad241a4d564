/** The racers' colours, in their order: far from each other and from the optimum's green, by day and by night. */
const COLOURS = ['--best', '--kept', '--hen', '--inertia']

export const colourOf = (at: number): string => COLOURS[at % COLOURS.length] ?? '--best'
