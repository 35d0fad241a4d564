import { expect, test } from 'vitest'
import { lineOf } from './pseudocode'

test('a line has a level, and words, formulas and numbers in their order', () => {
  expect(lineOf('    with $c_1$ = @c1@: go')).toEqual({
    level: 2,
    pieces: [
      { is: 'words', text: 'with ' },
      { is: 'tex', text: 'c_1' },
      { is: 'words', text: ' = ' },
      { is: 'value', text: 'c1' },
      { is: 'words', text: ': go' },
    ],
  })
  expect(lineOf('for each')).toEqual({ level: 0, pieces: [{ is: 'words', text: 'for each' }] })
})
