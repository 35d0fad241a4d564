import { autocompletion, closeBrackets, closeBracketsKeymap, completionKeymap } from '@codemirror/autocomplete'
import { defaultKeymap, history, historyKeymap, indentWithTab, temporarilySetTabFocusMode } from '@codemirror/commands'
import { javascript, javascriptLanguage, localCompletionSource } from '@codemirror/lang-javascript'
import {
  bracketMatching,
  foldGutter,
  foldKeymap,
  HighlightStyle,
  indentOnInput,
  indentUnit,
  syntaxHighlighting,
} from '@codemirror/language'
import { type Diagnostic, lintGutter, setDiagnostics } from '@codemirror/lint'
import { highlightSelectionMatches, search, searchKeymap } from '@codemirror/search'
import { Compartment, EditorState, type Extension, type Transaction } from '@codemirror/state'
import {
  drawSelection,
  EditorView,
  highlightActiveLine,
  highlightActiveLineGutter,
  hoverTooltip,
  keymap,
  lineNumbers,
} from '@codemirror/view'
import { tags } from '@lezer/highlight'
import { completions, explained } from './help'
import { lineOf } from './place'

/** What is wrong, and where: a line from 1. */
export interface Wrong {
  message: string
  line: number
  column: number | null
  meaning: string
}

/** An editor as it was left. */
export type Kept = EditorState

interface Options {
  text: string
  /** As it was left, if that has the same text. */
  kept?: Kept | undefined
  label: string
  dark: boolean
  /** `brought`: what was pasted or dropped. */
  onchange(text: string, brought: string): void
  onrun(): void
}

const COLOURS = HighlightStyle.define([
  { tag: [tags.keyword, tags.controlKeyword, tags.definitionKeyword, tags.moduleKeyword, tags.operatorKeyword], color: 'var(--series-2)' },
  { tag: [tags.string, tags.special(tags.string), tags.regexp], color: 'var(--series-8)' },
  { tag: [tags.number, tags.bool, tags.null], color: 'var(--series-3)' },
  { tag: tags.comment, color: 'var(--ink-2)', fontStyle: 'var(--slant)' },
  { tag: [tags.function(tags.variableName), tags.function(tags.propertyName)], color: 'var(--series-7)' },
])

/** Editors that are made again have the state of the one before. */
const THEME = new Compartment()

const looks = (dark: boolean): Extension =>
  EditorView.theme(
    {
      '&': { height: '100%', color: 'var(--ink)', backgroundColor: 'var(--surface)', fontSize: '0.875rem' },
      '&.cm-focused': { outline: '2px solid var(--focus)', outlineOffset: '-2px' },
      '.cm-scroller': { fontFamily: 'var(--font-code)', lineHeight: '1.5', scrollbarWidth: 'thin' },
      '.cm-content': { caretColor: 'var(--ink)', paddingBlock: '0.5rem' },
      '.cm-cursor': { borderLeftColor: 'var(--ink)' },
      '.cm-gutters': { color: 'var(--ink-2)', backgroundColor: 'var(--surface-2)', borderRight: '1px solid var(--line)' },
      '.cm-activeLine': { backgroundColor: 'color-mix(in oklab, var(--accent-soft) 45%, transparent)' },
      '.cm-activeLineGutter': { color: 'var(--ink)', backgroundColor: 'var(--accent-soft)' },
      '&.cm-focused > .cm-scroller > .cm-selectionLayer .cm-selectionBackground, .cm-selectionBackground': {
        backgroundColor: 'color-mix(in oklab, var(--focus) 28%, transparent)',
      },
      '.cm-selectionMatch': { backgroundColor: 'var(--accent-soft)' },
      '&.cm-focused .cm-matchingBracket': { backgroundColor: 'var(--accent-soft)', outline: '1px solid var(--accent)' },
      '.cm-panels, .cm-tooltip': { color: 'var(--ink)', backgroundColor: 'var(--surface)', borderColor: 'var(--line-strong)' },
      '.cm-tooltip': { borderRadius: 'var(--radius)', fontSize: '0.8125rem' },
      '.cm-tooltip-autocomplete > ul > li[aria-selected]': { color: 'var(--accent-ink)', backgroundColor: 'var(--accent)' },
      '.cm-completionIcon': { display: 'none' },
      '.cm-help': { maxWidth: '26rem', padding: '0.4rem 0.6rem' },
      '.cm-help code': { display: 'block', fontFamily: 'inherit', fontWeight: '600' },
      '.cm-help p': { margin: '0.25rem 0 0' },
      '.cm-completionInfo': { maxWidth: '22rem' },
      '.cm-diagnostic-error': { borderLeftColor: 'var(--danger)' },
      '.cm-lintRange-error': { backgroundImage: 'none', textDecoration: 'underline wavy var(--danger)', textUnderlineOffset: '3px' },
      '.cm-lint-marker-error': {
        content: 'none',
        width: '0.6rem',
        height: '0.6rem',
        borderRadius: '50%',
        backgroundColor: 'var(--danger)',
      },
      '.cm-foldGutter': { width: '1rem' },
      '.cm-button': { backgroundImage: 'none', backgroundColor: 'var(--surface-2)', borderColor: 'var(--line-strong)' },
      '.cm-textfield': { backgroundColor: 'var(--surface)', borderColor: 'var(--line-strong)' },
    },
    { dark },
  )

const help = hoverTooltip((view, at) => {
  const found = explained(view.state, at)
  return (
    found && {
      pos: found.from,
      end: found.to,
      above: true,
      create: () => {
        const dom = document.createElement('div')
        dom.className = 'cm-help'
        const type = dom.appendChild(document.createElement('code'))
        type.textContent = found.type
        if (found.help) dom.appendChild(document.createElement('p')).textContent = found.help
        return { dom }
      },
    }
  )
})

/** What a change brought from elsewhere. */
function broughtBy(transaction: Transaction): string {
  if (!(transaction.isUserEvent('input.paste') || transaction.isUserEvent('input.drop'))) return ''
  const inserted: string[] = []
  transaction.changes.iterChanges((_fromBefore, _toBefore, _from, _to, text) => inserted.push(text.toString()))
  return inserted.join('\n')
}

function diagnosticOf({ doc }: EditorState, { message, line, column, meaning }: Wrong): Diagnostic {
  const { from, to, text } = doc.line(Math.min(Math.max(line, 1), doc.lines))
  const indent = text.length - text.trimStart().length
  const at = column ? Math.min(from + column - 1, to) : from + indent
  const all = at >= to ? from + indent : at
  return { from: all, to, severity: 'error', message: meaning ? `${message}\n${meaning}` : message }
}

/** An editor for a planner's code. It lives in a shadow root: there its styles need no permission. */
export class Editor {
  private readonly view: EditorView
  private readonly extensions: (dark: boolean) => Extension[]
  private dark: boolean

  constructor(parent: HTMLElement, { text, kept, label, dark, onchange, onrun }: Options) {
    const root = parent.shadowRoot ?? parent.attachShadow({ mode: 'open' })
    this.extensions = (now) => [
      lineNumbers(),
      foldGutter(),
      lintGutter(),
      history(),
      drawSelection(),
      indentUnit.of('  '),
      indentOnInput(),
      bracketMatching(),
      closeBrackets(),
      highlightActiveLine(),
      highlightActiveLineGutter(),
      highlightSelectionMatches(),
      EditorView.lineWrapping,
      search({ top: true }),
      javascript(),
      javascriptLanguage.data.of({ autocomplete: completions }),
      javascriptLanguage.data.of({ autocomplete: localCompletionSource }),
      autocompletion({ icons: false }),
      syntaxHighlighting(COLOURS),
      help,
      EditorView.contentAttributes.of({ 'aria-label': label, 'data-testid': 'editor', tabindex: '0' }),
      keymap.of([
        {
          key: 'Mod-Enter',
          run: () => {
            onrun()
            return true
          },
        },
        // Then Tab leaves the editor.
        { key: 'Escape', run: temporarilySetTabFocusMode },
        ...closeBracketsKeymap,
        ...completionKeymap,
        ...searchKeymap,
        ...historyKeymap,
        ...foldKeymap,
        ...defaultKeymap,
        indentWithTab,
      ]),
      EditorView.updateListener.of(({ docChanged, state, transactions }) => {
        if (docChanged) onchange(state.doc.toString(), transactions.map(broughtBy).join('\n'))
      }),
      THEME.of(looks(now)),
    ]
    this.dark = dark
    const state = kept?.doc.toString() === text ? kept : this.stateOf(text)
    this.view = new EditorView({
      state,
      parent: root,
      root,
      scrollTo: EditorView.scrollIntoView(state.selection.main.head, { y: 'center' }),
    })
  }

  private stateOf(doc: string): EditorState {
    return EditorState.create({ doc, extensions: this.extensions(this.dark) })
  }

  /** Another text. Undoing does not lead back: what was there may be somebody else's. */
  put(text: string): void {
    if (this.view.state.doc.toString() === text) return
    this.view.setState(this.stateOf(text))
    this.view.dispatch({ effects: EditorView.scrollIntoView(0, { y: 'start' }) })
  }

  setDark(dark: boolean): void {
    this.dark = dark
    this.view.dispatch({ effects: THEME.reconfigure(looks(dark)) })
  }

  mark(wrong: Wrong | null): void {
    const { state } = this.view
    this.view.dispatch(setDiagnostics(state, wrong ? [diagnosticOf(state, wrong)] : []))
  }

  /** The line at which a part of the described planner is. */
  lineOf = (field: string): number | null => lineOf(this.view.state, field)

  goTo(line: number): void {
    const { doc } = this.view.state
    const { from } = doc.line(Math.min(Math.max(line, 1), doc.lines))
    this.view.dispatch({ selection: { anchor: from }, effects: EditorView.scrollIntoView(from, { y: 'center' }) })
    this.view.focus()
  }

  destroy(): Kept {
    const { state } = this.view
    this.view.destroy()
    return state
  }
}
