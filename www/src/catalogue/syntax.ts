/** What a formula may be made of, as it is listed. The names of functions come from the core's own list in a test. */
export const SYNTAX = {
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
