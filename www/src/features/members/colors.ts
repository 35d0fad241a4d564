/** Colours of bars, in the order of the numbers that are drawn as bars. */
const BARS = ['--cognitive', '--attractor', '--ant', '--hen'] as const
/** Colours of words, in their order. */
const WORDS = ['--line-strong', '--chick', '--exact', '--mean', '--selected', '--hen'] as const

export const barColour = (index: number): string => `var(${BARS[index % BARS.length]})`
export const wordColour = (index: number): string => `var(${WORDS[index % WORDS.length]})`
