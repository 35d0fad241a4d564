import type { Token, Tokens } from 'marked'
import { type FigureToken, hrefOf, type MathToken, plain } from './markdown'

/** What a line of text is made of, in the order in which it is read. */
export type Piece =
  | { kind: 'text'; text: string }
  | { kind: 'strong'; pieces: Piece[] }
  | { kind: 'em'; pieces: Piece[] }
  | { kind: 'code'; text: string }
  | { kind: 'br' }
  | { kind: 'link'; href: string; pieces: Piece[] }
  | ({ kind: 'box' } & Box)

/**
 * What is one box in its line: a browser breaks the line before and behind a box, whatever stands there. So marks that must not
 * begin or end a line are part of the piece.
 */
export interface Box {
  shown:
    | { as: 'math'; tex: string }
    | { as: 'figure'; name: string; raw: string }
    | { as: 'layer'; role: string; pieces: Piece[] }
    | { as: 'term'; term: string; text: string }
  /** Opening marks just before it. */
  before: string
  /** Closing marks just behind it. */
  behind: string
}

interface Rules {
  /** The text in pieces, of which some are terms. */
  terms: ((text: string) => readonly { text: string; term?: string }[]) | undefined
  /** Links to these lead to layers of the stage. */
  layer: string | undefined
}

/** With these no line begins. */
const CLOSING = /^[\p{Pe}\p{Pf}.,:;!?%、。，：；！？…—～·"']+/u
/** With these no line ends. */
const OPENING = /[\p{Ps}\p{Pi}"']+$/u

const inner = (token: Token): Token[] => ('tokens' in token && token.tokens) || []

/** A token's words. */
export const wordsOf = (token: Token): string => plain('text' in token ? String(token.text) : token.raw)

const box = (shown: Box['shown']): Piece => ({ kind: 'box', shown, before: '', behind: '' })

function pieceOf(token: Token, rules: Rules): Piece[] {
  switch (token.type) {
    case 'strong':
    case 'em':
      return [{ kind: token.type, pieces: piecesOf(inner(token), rules) }]
    case 'codespan':
      return [{ kind: 'code', text: wordsOf(token) }]
    case 'math':
      return [box({ as: 'math', tex: (token as MathToken).tex })]
    case 'figure':
      return [box({ as: 'figure', name: (token as FigureToken).name, raw: token.raw })]
    case 'br':
      return [{ kind: 'br' }]
    case 'link': {
      const { href } = token as Tokens.Link
      // What leads somewhere as a whole has no terms in it.
      const within = (): Piece[] => piecesOf(inner(token), { ...rules, terms: undefined })
      if (rules.layer !== undefined && href.startsWith(rules.layer)) {
        return [box({ as: 'layer', role: href.slice(rules.layer.length), pieces: within() })]
      }
      const address = hrefOf(href)
      return address === null ? inner(token).flatMap((each) => pieceOf(each, rules)) : [{ kind: 'link', href: address, pieces: within() }]
    }
    default: {
      if (inner(token).length > 0) return inner(token).flatMap((each) => pieceOf(each, rules))
      const text = wordsOf(token)
      const parts = rules.terms?.(text) ?? [{ text }]
      return parts.map(({ text, term }) => (term === undefined ? { kind: 'text', text } : box({ as: 'term', term, text })))
    }
  }
}

/** The box that a piece ends with, or begins with; in bold text, too. */
function boxOf(piece: Piece | undefined, at: 0 | -1): Extract<Piece, { kind: 'box' }> | undefined {
  if (piece?.kind === 'box') return piece
  return piece && 'pieces' in piece ? boxOf(piece.pieces.at(at), at) : undefined
}

/** A line's pieces: marks are part of the box that they follow or precede. */
export function piecesOf(tokens: readonly Token[], rules: Rules): Piece[] {
  const pieces: Piece[] = []
  for (const piece of tokens.flatMap((token) => pieceOf(token, rules))) {
    if (piece.kind === 'text' && piece.text === '') continue
    const last = pieces.at(-1)
    if (piece.kind === 'text' && last?.kind === 'text') last.text += piece.text
    else pieces.push(piece)
  }
  pieces.forEach((piece, at) => {
    const [before, behind] = [pieces[at - 1], pieces[at + 1]]
    const [first, last] = [boxOf(piece, 0), boxOf(piece, -1)]
    if (first && before?.kind === 'text') {
      const marks = OPENING.exec(before.text)?.[0] ?? ''
      first.before = marks + first.before
      before.text = before.text.slice(0, before.text.length - marks.length)
    }
    if (last && behind?.kind === 'text') {
      const marks = CLOSING.exec(behind.text)?.[0] ?? ''
      last.behind += marks
      behind.text = behind.text.slice(marks.length)
    }
  })
  return pieces
}
