import { texts } from '../texts'

/** Functions that the reader writes. */
export const functions = texts('functions', {
  title: 'A function of your own',
  intro: 'Swarms look for the least value of what you write here.',
  example: 'Begin with',
  nothing: 'No example has these words.',
  name: 'Name',
  unnamed: 'A function of my own',
  formula: 'f(x) =',
  formulaHelp: 'x, y and z are the first variables, x[1] to x[n] all of them. sum(…) and prod(…) go over i from 1 to n.',
  reference: 'All that can be used',
  groups: {
    variables: 'Variables',
    numbers: 'Numbers',
    operators: 'Operators',
    sums: 'Sums and products',
    choices: 'Conditions',
    functions: 'Functions',
  },
  others: 'over another name and range:',
  dimension: 'Variables',
  low: 'From',
  high: 'To',
  sidesHelp: 'A number for all variables, or one for each: −5, 0',
  optimum: 'Least value, if known',
  optimumHelp: 'Results are compared with it.',
  noNumbers: (text: string) => (text.trim() === '' ? 'A number is missing.' : `“${text.trim()}” is not a number, or a list of numbers.`),
  noNumber: (text: string) => `“${text.trim()}” is not a number.`,
  preview: (count: number) =>
    count > 2 ? `The first two of ${count} variables. The others are in the middle of the box.` : 'The function over its box',
  heights: (low: string, high: string) => `${low} to ${high}`,
  use: 'Use this function',
  cancel: 'Cancel',
} as const)
