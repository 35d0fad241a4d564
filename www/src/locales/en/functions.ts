/** Functions that the reader writes. */
export const functions = {
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
} as const

/** What a formula may be made of, as it is listed. The names of functions come from the core's own list in a test. */
export const REFERENCE = {
  variables: ['x', 'y', 'z', 'x[1]', 'x[i]', 'x[n]'],
  numbers: ['n', 'pi', 'tau', 'e', '1.5e-3'],
  operators: ['+', '-', '*', '/', '%', '^'],
  sums: ['sum(x[i]^2)', 'prod(cos(x[i]))', 'sum(x[k+1] - x[k], k, 1, n - 1)'],
  choices: ['<', '<=', '==', '!=', '&&', '||', '!', 'x > 0 ? x : -x', 'if(x > 0, x, -x)'],
  functions:
    'abs sqrt cbrt exp ln log log2 log10 sin cos tan asin acos atan sinh cosh tanh floor ceil round sign min max atan2 hypot pow mod'.split(
      ' ',
    ),
} as const
