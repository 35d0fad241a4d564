import { readFileSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { describe, expect, it } from 'vitest'
import { code } from '../../locales/zh-CN/page/code'
import { describe as described } from '../../crates/isolate/src/js/describe.js'
import { conformBy } from '../../package/testing/suite.js'

const root = fileURLToPath(new URL('../..', import.meta.url))

const SOURCES = [
  'crates/isolate/src/js/describe.js',
  'crates/isolate/src/js/host.js',
  'crates/isolate/src/js/inside.js',
  'crates/isolate/src/js/powers.js',
  'package/interpreter.js',
  'package/own.js',
  'package/own/link.js',
  'package/testing/suite.js',
  'www/src/engine/host/plain.ts',
  'www/src/engine/watchdog.ts',
]

/** Prose that is said elsewhere: in the catalogue, in a report in English, or to nobody. */
const ELSEWHERE = [
  /^(?:After how many iterations it stops|The cost of the best so far|The best so far)\.$|^Best cost$/,
  /^3 keeps to all 3 checks\.$|^3 on 3: not “/,
  /^export const register|^delete globalThis|^indexOf lastIndexOf/,
]

/** What parts of messages are parts of. */
const AROUND: readonly ((part: string) => string)[] = [
  (part) => part,
  (part) => `field: ${part} is not allowed; it must be true or false`,
  (part) => `field: 3 is not allowed; it must be ${part}`,
  (part) => `code: "${part}" is not allowed; it must be a code that is not damaged`,
  (part) => `slice: there is too much to go through; it takes ${part}`,
  (part) => `state.x is a Map: ${part}`,
  (part) => `evaluate takes a list of numbers, not ${part}`,
]

/** A text with values in place of what is computed: constants of the file, or what else may stand there. */
const filled = (text: string, file: string): string =>
  text.replace(/\$\{([^}]*)\}/g, (_, name: string) => {
    const known: Record<string, string> = { where: ' (line 3)', 'nameOf(value)': 'a list', "integer ? 'whole ' : ''": 'whole ' }
    const [, single, template] = new RegExp(`^const ${/\w*/.exec(name)?.[0]} = (?:'(.*)'|\`(.*)\`)$`, 'm').exec(file) ?? []
    return known[name] ?? single ?? (template === undefined ? '3' : filled(template, file))
  })

/** The prose in the strings of a file. Checks' names are keys. */
function messagesIn(path: string): string[] {
  const file = readFileSync(`${root}/${path}`, 'utf8')
  const lines = file.split('\n').filter((line) => !/^\s*(?:\/[/*]|\*)|= \/|^import |^ {2}'.*\{$/.test(line))
  const literals = lines.flatMap((line) => [...line.matchAll(/(['"`])((?:(?!\1)[^\\]|\\.)*)\1(\.split)?/g)])
  const texts = literals.map(([, , literal = '', splits]) => (splits ? '' : filled(literal.replaceAll('\\`', '`'), file)))
  return texts.filter((text) => /[a-z]+ [a-z]{2,}/.test(text) && !ELSEWHERE.some((pattern) => pattern.test(text)))
}

/** Chinese, and no English but names. */
const isChinese = (text: string): boolean =>
  /\p{Script=Han}/u.test(text) && !/\b(?:is|are|the|an?|of|it|must|not?|that|than|with)\b/.test(text)

/** Alone, as a part of something, or as the name of a check. */
const isSaid = (text: string): boolean =>
  [...AROUND.map((around) => code.said(around(text))), code.check(text)].some((said) => isChinese(said) && !said.includes(text))

describe('what is said of planners in JavaScript, in Chinese', () => {
  it.each(SOURCES)('all of %s', (path) => {
    const messages = messagesIn(path)
    expect(messages).not.toEqual([])
    expect(messages.filter((message) => !isSaid(message))).toEqual([])
  })

  it('the name of each check', async () => {
    const host = { load: async () => undefined, describedBy: () => ({ name: 'mine', kinds: [] }) }
    const { checks } = (await conformBy(host, [], 'mine')) as { checks: string[] }
    expect(checks.length).toBeGreaterThan(10)
    expect(checks.filter((check) => !isChinese(code.check(check)))).toEqual([])
  })

  const parameter = (given: object): object => ({ name: 'mine', kinds: ['function'], ...CODE, parameters: [{ name: 'a', ...given }] })
  const CODE = { start: () => 0, advance: () => 0, best: () => 0 }

  it.each<[unknown, string]>([
    [undefined, '`planner` 未给出；应为含 name 字段的对象'],
    [{ name: 'Mine' }, '`name` 为 "Mine"；应为 1 至 60 个小写字母、数字、- 或 _，以字母开头'],
    [{ name: 'mine', step: 1 }, expect.stringMatching(/^没有字段 `step`；可选：name、title、.*、explain$/)],
    [{ name: 'mine', kinds: [] }, '`kinds` 为 0 项的列表；应为至少含以下一项的列表：function、discs、grid、tour'],
    [parameter({ default: 7, min: 0, max: 5 }), '`parameters[0].default` 为 7；应为 0 至 5 的数值'],
    [parameter({ default: () => 0, min: 0, max: 5, integer: true }), '`parameters[0].default` 为函数；应为 0 至 5 的整数'],
    [parameter({ min: 6, max: 5 }), '`parameters[0].max` 为 5；应为不小于 min（6）的数值'],
  ])('what is wrong in a description', (planner, chinese) => {
    let message = ''
    try {
      described(planner)
    } catch (error) {
      ;({ message } = error as Error)
    }
    expect(code.said(message)).toEqual(chinese)
  })

  it.each([
    ["code: ReferenceError: 'foo' is not defined (line 1)", '代码：ReferenceError: `foo` 未定义（第 1 行）'],
    ["TypeError: cannot read property 'x' of undefined (line 12)", 'TypeError: 无法读取 undefined 的属性 `x`（第 12 行）'],
    ["TypeError: Cannot read properties of null (reading 'x')", 'TypeError: 无法读取 null 的属性 `x`'],
    ['TypeError: not a function', 'TypeError: 调用的不是函数'],
    ['TypeError: f is not a function', 'TypeError: `f` 不是函数'],
    ["TypeError: 'a' is read-only", 'TypeError: `a` 只读，不能修改'],
    ["SyntaxError: expecting ';' (line 3)", 'SyntaxError: 此处应为 `;`（第 3 行）'],
    ["SyntaxError: unexpected token in expression: '=>'", 'SyntaxError: 此处不应有 `=>`'],
    [
      'code: "9000 bytes" is not allowed; it must be a code of at most 8192 bytes, deflated',
      '代码为 9000 字节；应为压缩后不超过 8192 字节的代码',
    ],
    [
      'TypeError: best: path takes a list of points [x, y], not undefined',
      'TypeError: best 的 path：应为点 [x, y] 的列表，实际为 undefined',
    ],
    [
      'the run ends with a fault: 代码抛出异常“TypeError: not a function (line 2)”',
      '运行因出错而结束：代码抛出异常“TypeError: 调用的不是函数（第 2 行）”',
    ],
    ['with c1 = 4 the run ends with a fault: 代码抛出异常“mine”', 'c1 = 4 时运行因出错而结束：代码抛出异常“mine”'],
  ])('%s', (english, chinese) => {
    expect(code.said(english)).toBe(chinese)
  })

  it.each(['', 'The step is too long', 'RangeError: c1 is mine', '`population` 为 0；应为 1 至 100 的整数', 'mine “not a function”'])(
    'not what an author or the core says: %s',
    (text) => {
      expect(code.said(text)).toBe(text)
      expect(code.check(text)).toBe(text)
    },
  )
})
