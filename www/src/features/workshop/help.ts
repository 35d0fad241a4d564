import type { Completion, CompletionContext, CompletionResult } from '@codemirror/autocomplete'
import { syntaxTree } from '@codemirror/language'
import type { EditorState } from '@codemirror/state'
import type { SyntaxNode } from '@lezer/common'
import { contract, type Member } from 'virtual:contract'

/* What can be written where, and what it is: by the contract that the package is typed with. */

const PLANNER = 'PlannerInJavaScript'
/** Lists of a planner, and what is in them. */
const LISTS: Readonly<Record<string, string>> = {
  parameters: 'ParameterInJavaScript',
  readings: 'ReadingInJavaScript',
  layers: 'LayerInJavaScript',
}
/** What is given to a planner's functions by name. */
const GIVEN: Readonly<Record<string, string>> = { math: 'Mathematics', pen: 'Pen', box: 'Box', tools: 'Tools' }

/** Of members whose type is written out, theirs. */
const WRITTEN: Readonly<Record<string, readonly Member[]>> = {
  Mathematics: [
    ...'sin cos tan exp log log10 acos asin sqrt abs floor ceil round trunc sign'.split(' ').map((name) => member(name, `${name}(x)`)),
    member('pow', 'pow(x, y)'),
    member('atan2', 'atan2(y, x)'),
    member('hypot', 'hypot(x, y)'),
    member('min', 'min(...values)'),
    member('max', 'max(...values)'),
    member('PI', 'PI: number', false),
    member('E', 'E: number', false),
  ],
  Box: [member('low', 'low: readonly number[]', false), member('high', 'high: readonly number[]', false)],
}

function member(name: string, type: string, call = true): Member {
  return { name, type: call ? `${type}: number` : type, help: '', call, optional: false }
}

const membersOf = (name: string): readonly Member[] => WRITTEN[name] ?? contract[name] ?? []

const textOf = (state: EditorState, node: SyntaxNode | null | undefined): string => (node ? state.sliceDoc(node.from, node.to) : '')

/** The name of the property whose value this is. */
function propertyOf(state: EditorState, node: SyntaxNode): string {
  const { parent } = node
  return parent?.name === 'Property' ? textOf(state, parent.getChild('PropertyDefinition')) : ''
}

/** Which interface an object has that is written out. */
function interfaceOf(state: EditorState, object: SyntaxNode): string | null {
  const { parent } = object
  if (parent?.name === 'ArgList') return textOf(state, parent.parent?.firstChild) === 'register' ? PLANNER : null
  if (parent?.name !== 'ArrayExpression') return null
  const holder = parent.parent?.parent
  return holder?.name === 'ObjectExpression' && interfaceOf(state, holder) === PLANNER ? (LISTS[propertyOf(state, parent)] ?? null) : null
}

/** Whether a pattern takes apart the last thing that a function of a planner is given. */
function takesTools(pattern: SyntaxNode): boolean {
  return pattern.parent?.name === 'ParamList'
}

/** The interface whose members can be written at a place. */
function placeOf(state: EditorState, at: SyntaxNode): { name: string; as: 'property' | 'pattern' | 'member' } | null {
  for (let node: SyntaxNode | null = at; node; node = node.parent) {
    if (node.name === 'MemberExpression' && at.from > (node.firstChild?.to ?? at.from) - 1) {
      const name = GIVEN[textOf(state, node.firstChild)]
      return name ? { name, as: 'member' } : null
    }
    if (node.name === 'ObjectPattern') return takesTools(node) ? { name: 'Tools', as: 'pattern' } : null
    if (node.name === 'ObjectExpression') {
      const name = interfaceOf(state, node)
      return name ? { name, as: 'property' } : null
    }
    if (/Block|ParamList|ArrowFunction|FunctionExpression/.test(node.name)) return null
  }
  return null
}

const BODIES: Readonly<Record<string, string>> = {
  start: 'start({ box, evaluate, random }) {\n    \n  },',
  advance: 'advance(state, { box, evaluate, random }) {\n    \n  },',
  best: 'best: ({ cost, position }) => ({ cost, position }),',
  draw: 'draw(state, pen) {\n    \n  },',
  explain: "explain: (state, item) => ({ summary: '', values: {} }),",
  value: 'value: (state) => state.',
}

function completionOf(one: Member, as: 'property' | 'pattern' | 'member' | 'word'): Completion {
  const { name, type, help, call } = one
  const apply = as === 'property' ? (BODIES[name] ?? `${name}: `) : as === 'pattern' || !call ? name : `${name}(`
  return {
    label: name,
    apply,
    detail: type.slice(name.length).replace(/^: /, ''),
    info: help,
    type: call ? 'method' : 'property',
    boost: 2,
  }
}

/** Words that a member's type allows, of which a text at a place is one. */
function wordsAt(state: EditorState, at: SyntaxNode): readonly string[] {
  const list = at.parent?.name === 'ArrayExpression' ? at.parent : at
  const holder = list.parent?.parent
  const known = holder?.name === 'ObjectExpression' ? interfaceOf(state, holder) : null
  const type = membersOf(known ?? '').find(({ name }) => name === propertyOf(state, list))?.type ?? ''
  return [...type.matchAll(/'([^']+)'/g)].map(([, word = '']) => word)
}

/** What can be written at the cursor. */
export function completions(context: CompletionContext): CompletionResult | null {
  const { state, pos } = context
  const word = context.matchBefore(/[\w$]*/)
  const dot = context.matchBefore(/[\w$]+\.[\w$]*/)
  if (dot) {
    const [object = ''] = dot.text.split('.')
    const name = GIVEN[object]
    if (!name) return null
    return { from: dot.from + object.length + 1, options: membersOf(name).map((one) => completionOf(one, 'member')), validFor: /^[\w$]*$/ }
  }
  if (!word || (word.from === word.to && !context.explicit)) return null
  const at = syntaxTree(state).resolveInner(pos, -1)
  if (at.name === 'String')
    return { from: word.from, options: wordsAt(state, at).map((label) => ({ label, type: 'constant' })), validFor: /^[\w$-]*$/ }
  const place = placeOf(state, at)
  if (place) {
    const options = membersOf(place.name).map((one) => completionOf(one, place.as))
    return { from: word.from, options, validFor: /^[\w$]*$/ }
  }
  return { from: word.from, options: membersOf('Tools').map((one) => completionOf(one, 'word')), validFor: /^[\w$]*$/ }
}

/** What the name at a place is, by the contract. */
export function explained(state: EditorState, at: number): { from: number; to: number; type: string; help: string } | null {
  const node = syntaxTree(state).resolveInner(at, 1)
  if (!/PropertyDefinition|PropertyName|VariableName|VariableDefinition|PropertyNameDefinition/.test(node.name)) return null
  const name = textOf(state, node)
  const inObject = node.parent?.name === 'Property' && node.parent.parent?.name === 'ObjectExpression'
  const ofObject = inObject && node.parent?.parent ? interfaceOf(state, node.parent.parent) : null
  const ofMember =
    node.parent?.name === 'MemberExpression' && node.name === 'PropertyName' ? GIVEN[textOf(state, node.parent.firstChild)] : null
  const known = ofObject ?? ofMember ?? (node.name === 'PropertyName' || inObject ? null : 'Tools')
  const found = known && membersOf(known).find((one) => one.name === name)
  return found ? { from: node.from, to: node.to, type: found.type, help: found.help } : null
}
