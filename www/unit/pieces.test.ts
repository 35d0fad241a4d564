import { expect, test } from 'vitest'
import { tokensOf } from '../src/ui/markdown'
import { type Piece, piecesOf } from '../src/ui/pieces'

const paragraph = (text: string): Piece[] => {
  const [token] = tokensOf(text)
  const tokens = token && 'tokens' in token ? (token.tokens ?? []) : []
  const terms = (words: string) =>
    words.split(/(swarm|粒子)/).map((word) => (/^(?:swarm|粒子)$/.test(word) ? { text: word, term: 'particle' } : { text: word }))
  return piecesOf(tokens, { terms, layer: 'layer:' })
}

/** How pieces follow each other in a line: what is kept together is in brackets. */
const line = (text: string): string => shownAs(paragraph(text))

const shownAs = (pieces: readonly Piece[]): string =>
  pieces
    .map((piece) => {
      if (piece.kind === 'box') {
        const { shown } = piece
        const words = shown.as === 'math' ? shown.tex : shown.as === 'layer' ? shown.role : shown.as === 'figure' ? shown.name : shown.text
        return `[${piece.before}<${words}>${piece.behind}]`
      }
      if ('pieces' in piece) return `*${shownAs(piece.pieces)}*`
      return piece.kind === 'text' ? piece.text : piece.kind
    })
    .join('')

test('marks stay in the line of the box that they follow or precede', () => {
  expect(line('每个粒子。第二（$w$）、{gap-end}，完')).toBe('每个[<粒子>。]第二[（<w>）、][<gap-end>，]完')
  expect(line('A swarm: its ("$c_1$") and [its speed](layer:velocity)…')).toBe('A [<swarm>:] its [("<c_1>")] and [<velocity>…]')
  expect(line('（**粒子**）。 *its $w$*, **bold**.')).toBe('*[（<粒子>）。]* *its [<w>,]* *bold*.')
  expect(line('$w$\\) and swarm\\.')).toBe('[<w>)] and [<swarm>.]')
  expect(line('swarm and $w$ alone')).toBe('[<swarm>] and [<w>] alone')
})

test('a link leads somewhere, or it is its words', () => {
  expect(paragraph('[here](https://example.org/a) and [there](javascript:x) and [below](#view=learn)')).toMatchObject([
    { kind: 'link', href: 'https://example.org/a' },
    { kind: 'text', text: ' and there and ' },
    { kind: 'link', href: '#view=learn' },
  ])
})
