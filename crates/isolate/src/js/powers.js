/*
 * `a ** b` as `power$(a, b)`: the last bits of an engine's own power are its own, those of the core's are the same everywhere. Lines
 * stay where they are. What a code means otherwise is the engine's business: what is no JavaScript is left to it.
 */

const SPACE = /(?:\s|\/\/[^\n]*|\/\*[^]*?\*\/)*/y
const WORD = /[A-Za-z$_#\\\u0080-\uffff][\w$\\\u0080-\uffff]*/y
const NUMBER = /0[xXbBoO][\da-fA-F_]+n?|(?:\d[\d_]*\.?[\d_]*|\.\d[\d_]*)(?:[eE][+-]?\d[\d_]*)?n?/y
const STRING = /'(?:[^'\\\n]|\\[^])*'?|"(?:[^"\\\n]|\\[^])*"?/y
const REGEX = /\/(?:[^\\/[\n]|\\.|\[(?:[^\]\\\n]|\\.)*\])+\/[\w$]*/y
/** From a backtick, or the brace after an expression, to the next expression or the end. */
const TEMPLATE = /[`}](?:[^`\\$]|\\[^]|\$(?!\{))*(?:`|\$\{)?/y
const SIGN = /\*\*=?|\.\.\.|\?\.(?!\d)|\+\+|--|=>|[^]/y

/** Words that no operand ends with: after them a slash begins a regular expression. */
const OPERATORS = 'return typeof case in delete void instanceof new do else yield await throw extends'.split(' ')
const CONDITIONS = ['if', 'while', 'for', 'with']
const UNARY = ['!', '~', '+', '-', 'typeof', 'void', 'delete', 'await']
const STEPS = ['++', '--']

/** Texts with their kinds and places; of brackets, the other one. Nothing where a bracket has no other one. */
function tokensOf(code) {
  const tokens = []
  const open = []
  let at = 0
  let isWhole = true
  const read = (pattern) => {
    pattern.lastIndex = at
    return pattern.exec(code)?.[0]
  }
  const push = (kind, text) => {
    const breaks = code.slice(tokens.at(-1)?.to ?? 0, at).includes('\n')
    tokens.push({ kind, text, from: at, to: at + text.length, breaks })
  }
  const pair = (index) => {
    const from = open.pop()
    if (from === undefined) {
      isWhole = false
      return
    }
    tokens[from].end = index
    tokens[index].begin = from
  }
  for (;;) {
    at += read(SPACE)?.length ?? 0
    if (at >= code.length) return isWhole && open.length === 0 ? tokens : undefined
    const last = tokens.at(-1)
    const inTemplate = open.length > 0 && tokens[open.at(-1)].kind === 'template'
    let text
    if (code[at] === '`' || (code[at] === '}' && inTemplate)) {
      text = read(TEMPLATE)
      push('template', text)
      if (text[0] === '}') pair(tokens.length - 1)
      if (text.endsWith('${')) open.push(tokens.length - 1)
    } else if ((text = read(WORD))) push(isOne(last, ['.', '?.']) ? 'member' : 'word', text)
    else if (/[\d.]/.test(code[at]) && (text = read(NUMBER))) push('number', text)
    else if ((text = read(STRING))) push('string', text)
    else if (code[at] === '/' && !(isOperand(last) && last.text !== '}' && !last.condition) && (text = read(REGEX))) push('regex', text)
    else {
      text = read(SIGN)
      push('sign', text)
      if ('([{'.includes(text)) open.push(tokens.length - 1)
      if (')]}'.includes(text)) {
        pair(tokens.length - 1)
        const { begin } = tokens.at(-1)
        tokens.at(-1).condition = text === ')' && isOne(tokens[begin - 1], CONDITIONS)
      }
    }
    at += text.length
  }
}

/** Whether an operand may end here. */
function isOperand(token) {
  if (!token) return false
  if (token.kind === 'sign') return [')', ']', '}', ...STEPS].includes(token.text)
  if (token.kind === 'template') return token.text.endsWith('`')
  return token.kind !== 'word' || !OPERATORS.includes(token.text)
}

const isOne = (token, texts) => token !== undefined && ['sign', 'word'].includes(token.kind) && texts.includes(token.text)

/** The first token of a template that ends at `index`. */
function headOf(tokens, index) {
  while (tokens[index].text[0] === '}') index = tokens[index].begin
  return index
}

/** A step of what comes after it, not of what is before. */
const isStepBefore = (tokens, index) => isOne(tokens[index], STEPS) && (!isOperand(tokens[index - 1]) || tokens[index].breaks)

/** Where the operand begins that ends at `index`; nothing where that is no simple one. */
function beginOf(tokens, index) {
  let at = index
  while (isOne(tokens[at], STEPS)) at -= 1
  for (;;) {
    const token = tokens[at]
    if (!isOperand(token) || token.text === '}') return undefined
    const isBracket = token.kind === 'sign'
    const first = isBracket ? token.begin : token.kind === 'template' ? headOf(tokens, at) : at
    if (first === undefined) return undefined
    const before = tokens[first - 1]
    if (isOne(before, ['.', '?.'])) at = first - 2
    // A call, a member, or a template with a tag.
    else if ((isBracket || token.kind === 'template') && isOperand(before) && !before.condition && !isOne(before, STEPS)) at = first - 1
    else {
      let begin = first
      while (isOne(tokens[begin - 1], ['new']) || isStepBefore(tokens, begin - 1)) begin -= 1
      return begin
    }
  }
}

/** Where the operand ends that begins at `index`, with the power after it, whose end is in `ends`; nothing where that is no simple one. */
function endOf(tokens, index, ends) {
  let at = index
  while (isOne(tokens[at], [...UNARY, ...STEPS, 'new'])) at += 1
  let isFirst = true
  for (;;) {
    const token = tokens[at]
    if (!token || isOne(token, ['function', 'class', 'async', '{'])) return undefined
    if (token.kind === 'template' && token.text[0] === '`') while (tokens[at].text.endsWith('${')) at = tokens[at].end ?? tokens.length
    else if (isOne(token, ['(', '['])) at = token.end
    else if (!isFirst && token.kind !== 'member') return undefined
    if (tokens[at] === undefined) return undefined
    isFirst = false
    const next = tokens[at + 1]
    if (isOne(next, ['.', '?.'])) at += 2
    else if (isOne(next, ['(', '[']) || (next?.kind === 'template' && next.text[0] === '`')) at += 1
    else break
  }
  const next = tokens[at + 1]
  if (isOne(next, STEPS) && !next.breaks) at += 1
  return isOne(tokens[at + 1], ['**']) ? ends.get(at + 1) : at
}

/** A sign, and not one between two operands. */
const isPrefix = (tokens, index) => isOne(tokens[index], UNARY) && !(['+', '-'].includes(tokens[index].text) && isOperand(tokens[index - 1]))

function refusal(code, place, message) {
  const lines = code.slice(0, place).split('\n')
  return Object.assign(new SyntaxError(message), { stack: `planner.js:${lines.length}:${lines.at(-1).length + 1}` })
}

/** The code with powers of the core. Throws a `SyntaxError` with its place for `**=`, and around what is no simple operand. */
export function withPowers(code) {
  if (!code.includes('**')) return code
  const tokens = tokensOf(code)
  if (!tokens) return code
  const edits = []
  const ends = new Map()
  for (let index = tokens.length - 1; index >= 0; index -= 1) {
    const { kind, text, from, to } = tokens[index]
    if (kind !== 'sign' || !text.startsWith('**')) continue
    if (text === '**=') throw refusal(code, from, '`**=` is not there: write `x = x ** y`')
    const begin = beginOf(tokens, index - 1)
    const end = endOf(tokens, index + 1, ends)
    ends.set(index, end)
    // The engine refuses that.
    if (begin !== undefined && isPrefix(tokens, begin - 1)) continue
    if (begin === undefined || end === undefined) throw refusal(code, from, 'put what is before or after `**` in parentheses')
    edits.push([tokens[begin].from, 0, 'power$('], [from, to - from, ','], [tokens[end].to, 0, ')'])
  }
  let done = 0
  let out = ''
  for (const [place, length, text] of edits.sort((a, b) => a[0] - b[0])) {
    out += code.slice(done, place) + text
    done = place + length
  }
  return out + code.slice(done)
}

/** Of two numbers the core's power; large integers are exact in every engine. */
export const powerBy = (pow) => (x, y) => (typeof x === 'bigint' || typeof y === 'bigint' ? x ** y : pow(+x, +y))
