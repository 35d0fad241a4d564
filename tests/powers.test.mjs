// biome-ignore-all lint/suspicious/noTemplateCurlyInString: codes are written as texts here
// `a ** b` as a call of the core's power: what a code means stays the same.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { withPowers } from '../crates/isolate/src/js/powers.js'

const scope = {
  a: 3,
  b: 2,
  c: 2,
  o: { x: { y: [4, 5] }, f: (x) => x + 1, g: () => ({ h: 3 }), of: 7 },
  t: (texts, ...values) => texts.length + values.length,
  N: class {
    constructor(value = 2) {
      this.value = value
    }
    valueOf() {
      return this.value
    }
  },
}

const resultOf = (code) => {
  const power = (x, y) => x ** y
  return String(new Function('power$', ...Object.keys(scope), `return (${code})`)(power, ...Object.values(scope)))
}

const CODES = [
  ...['a ** b', 'a ** b ** c', 'a ** (b ** c) ** 1', '(a + b) ** 2', '(1, a) ** 2', '-(a ** b)', '1 - a ** 2', 'a / b ** 2 / c', 'a\n** b'],
  ...['o.x.y[1] ** 2', 'o.f(3) ** o.f(1)', 'o.g().h ** 2', 'o?.x?.y?.[0] ** 2', 'o?.f?.(2) ** 2', 'o.of ** 2', 'a ** o.x.y[0] / 2'],
  ...[
    '2 ** -1',
    '2 ** +a',
    '2 ** typeof b.length',
    'typeof (a ** b)',
    '!(a ** 2)',
    'a ** `${b}`',
    't`q${1}` ** 2',
    '"5" ** 2',
    '[2] ** 2',
    '({}) ** 2',
  ],
  ...[
    'a++ ** 2 + a',
    '++a ** 2',
    'a-- ** 2 + a',
    'b ** a++ + a',
    'new N(3) ** 2',
    'new N ** 3',
    '2n ** 3n + ""',
    '.5 ** 2',
    '1e3 ** 2',
    '0x10 ** 2',
  ],
  ...[
    '`x${a ** 2}y${`${b ** 3}`}`',
    '[1, 2].map((x) => x ** 2).join()',
    '[...[a ** 2]][0]',
    'Math.max(...[a ** 2, b ** 3])',
    '({ q: a ** 2 }).q',
  ],
  ...['a > b ** 2 ? a ** 2 : b ** 2', '(() => { if (a) /[/*]*`/.test(""); return a ** 2 })()', '(function () { return a ** 2 })()'],
  // What is no sign stays as it is.
  ...['\'**\' + a ** b + "**"', 'a/* ** */ ** /* x */ b // **\n', '/a*\\/*/.source.length ** 2', '`**${a}`'],
]

test('powers are called, and nothing else is another', () => {
  for (const code of CODES) {
    const written = withPowers(code)
    assert.ok(written.includes('power$(') || code === '`**${a}`', code)
    assert.equal(resultOf(written), resultOf(code), `${code} as ${written}`)
    assert.equal(written.split('\n').length, code.split('\n').length, code)
  }
})

test('lines, conditions and members are what they are', () => {
  for (const [code, written] of [
    ['i++\nb ** 2', 'i++\npower$(b , 2)'],
    ['a\n++b ** 2', 'a\npower$(++b , 2)'],
    ['if (a) (x) ** 2 > 1', 'if (a) power$((x) , 2) > 1'],
    ['q.if(4) / 2 / g ** 2', 'q.if(4) / 2 / power$(g , 2)'],
    ['a.with(1) / 2 ** b / c', 'a.with(1) / power$(2 , b) / c'],
    ['of / 2 / g ** 2', 'of / 2 / power$(g , 2)'],
    // Unfinished.
    ['const y = 2 ** (3', 'const y = 2 ** (3'],
  ])
    assert.equal(withPowers(code), written)
  const many = `${'2**'.repeat(2000)}1`
  assert.equal(withPowers(many).match(/power\$/g).length, 2000)
})

test('what is no JavaScript is left to the engine, and what is too much said at its place', () => {
  for (const code of ['-a ** b', 'typeof a ** 2', '!a ** 2', '2 ** -a ** 2'])
    assert.throws(() => new Function(withPowers(code)), SyntaxError)
  for (const [code, place] of [
    ['a **= 2', '1:3'],
    ['\n  a ** function () {}', '2:5'],
    ['a ** {}', '1:3'],
    ['** b', '1:1'],
  ])
    assert.throws(() => withPowers(code), { name: 'SyntaxError', stack: `planner.js:${place}` })
})
