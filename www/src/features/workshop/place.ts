import { ensureSyntaxTree } from '@codemirror/language'
import type { EditorState } from '@codemirror/state'
import type { SyntaxNode } from '@lezer/common'

/** Milliseconds for reading a code that nobody has read yet. */
const PATIENCE = 100

/** Names and numbers of a path: `parameters[0].default`. */
const STEP = /[^.[\]]+/g

/** What is given to `register`. */
function registered(state: EditorState): SyntaxNode | null {
  let found: SyntaxNode | null = null
  ensureSyntaxTree(state, state.doc.length, PATIENCE)?.iterate({
    enter(node) {
      if (node.name !== 'CallExpression' || found) return
      const callee = node.node.firstChild
      if (callee?.name === 'VariableName' && state.sliceDoc(callee.from, callee.to) === 'register')
        found = node.node.getChild('ArgList')?.getChild('ObjectExpression') ?? null
    },
  })
  return found
}

/** The property of an object that has this name, or the item of a list that has this number. */
function partOf(state: EditorState, whole: SyntaxNode | null, step: string): SyntaxNode | null {
  if (whole?.name === 'ArrayExpression') {
    const items = whole.getChildren('Expression')
    return items[Number(step)] ?? null
  }
  if (whole?.name !== 'ObjectExpression') return null
  const named = (property: SyntaxNode): boolean => {
    const name = property.firstChild?.name === 'async' ? property.firstChild.nextSibling : property.firstChild
    return name !== null && state.sliceDoc(name.from, name.to).replace(/^(['"])(.*)\1$/, '$2') === step
  }
  return whole.getChildren('Property').find(named) ?? null
}

/** The line, from 1, at which a part of the described planner is, or what it is missing in; null if no planner is described. */
export function lineOf(state: EditorState, field: string): number | null {
  const whole = registered(state)
  let [at, value] = [whole, whole]
  for (const step of field.match(STEP) ?? []) {
    const part = partOf(state, value, step)
    if (!part) break
    at = part
    value = part.name === 'Property' ? part.lastChild : part
  }
  return at && state.doc.lineAt(at.from).number
}
