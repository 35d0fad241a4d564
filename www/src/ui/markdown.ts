import { Marked, type Token, type Tokens, type TokensList } from 'marked'

/** A symbol or formula in TeX: `$\omega$`. */
export interface MathToken extends Tokens.Generic {
  type: 'math'
  tex: string
}

/** A number whose value stands elsewhere: `{gap-end}`. */
export interface FigureToken extends Tokens.Generic {
  type: 'figure'
  name: string
}

const marked = new Marked({
  gfm: true,
  extensions: [
    {
      name: 'math',
      level: 'inline',
      start: (text) => text.indexOf('$'),
      tokenizer(text): MathToken | undefined {
        const [raw, tex] = /^\$([^\s$](?:[^$\n]*[^\s$])?)\$(?!\d)/.exec(text) ?? []
        return raw === undefined || tex === undefined ? undefined : { type: 'math', raw, tex }
      },
    },
    {
      name: 'figure',
      level: 'inline',
      start: (text) => text.indexOf('{'),
      tokenizer(text): FigureToken | undefined {
        const [raw, name] = /^\{([a-z0-9][a-z0-9-]*)\}/.exec(text) ?? []
        return raw === undefined || name === undefined ? undefined : { type: 'figure', raw, name }
      },
    },
  ],
})

/**
 * What a text in Markdown is made of. It is put into the page element by element, never as HTML: tags in it are text, and `hrefOf`
 * decides which links there are.
 */
export const tokensOf = (text: string): TokensList | Token[] => marked.lexer(text)

/** Where a link may lead: elsewhere on the web, or to an address of the page. Others are text. */
export function hrefOf(href: string): string | null {
  if (href.startsWith('#')) return href
  try {
    const { protocol } = new URL(href)
    return protocol === 'https:' || protocol === 'http:' ? href : null
  } catch {
    return null
  }
}

const ENTITIES: Readonly<Record<string, string>> = { '&amp;': '&', '&lt;': '<', '&gt;': '>', '&quot;': '"', '&#39;': "'" }

/** A token's text: the reader of Markdown escapes some of it for HTML. */
export const plain = (text: string): string => text.replace(/&(?:amp|lt|gt|quot|#39);/g, (entity) => ENTITIES[entity] ?? entity)
