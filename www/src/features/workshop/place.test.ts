import { javascript } from '@codemirror/lang-javascript'
import { EditorState } from '@codemirror/state'
import { expect, test } from 'vitest'
import { lineOf } from './place'

const CODE = `import { register } from 'forage-lab'

const NAME = 'x'
register({
  name: NAME,
  'kinds': [
    'function',
    'maze',
  ],
  parameters: [
    { name: 'a',
      default: 5 },
    shared,
    { name: 'c' },
  ],
  async start() {},
  ...more,
  draw: (state, pen) => pen.points('a', state),
})
`

test('parts of a described planner are found at their lines', () => {
  const state = EditorState.create({ doc: CODE, extensions: javascript() })
  const lines = [
    ['name', 5],
    ['kinds', 6],
    ['kinds[1]', 8],
    ['parameters[0].default', 12],
    ['parameters[0].name', 11],
    ['parameters[1].name', 13],
    ['parameters[2].default', 14],
    ['start', 16],
    ['draw', 18],
    // What is missing would be in there.
    ['advance', 4],
    ['readings[0].name', 4],
  ] as const
  expect(lines.map(([field]) => [field, lineOf(state, field)])).toEqual(lines.map((one) => [...one]))
  expect(lineOf(EditorState.create({ doc: '', extensions: javascript() }), 'name')).toBe(null)
})
