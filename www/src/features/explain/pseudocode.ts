/** A piece of a line: words, a formula, or the name of a number. */
export type Piece = { is: 'words' | 'tex' | 'value'; text: string }

export interface Line {
  level: number
  pieces: Piece[]
}

/** A line of pseudocode: `$…$` is TeX, `@name@` a number, two spaces are a level. */
export function lineOf(line: string): Line {
  const text = line.trimStart()
  const pieces = text.split(/(\$[^$]*\$|@[\w.-]+@)/).filter((piece) => piece !== '')
  return {
    level: (line.length - text.length) / 2,
    pieces: pieces.map((piece) => {
      const inside = piece.slice(1, -1)
      if (piece.startsWith('$')) return { is: 'tex', text: inside }
      return piece.startsWith('@') ? { is: 'value', text: inside } : { is: 'words', text: piece }
    }),
  }
}
