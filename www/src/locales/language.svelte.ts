import { languages, load, type Words } from 'virtual:languages'
import { translateBy } from './texts'

export { languages }

export type Tag = (typeof languages)[number]['tag']

/** The language of the page: that of its texts, and of what the core says. */
class Language {
  tag = $state<Tag>('en')
  /** Titles of the scenes that ship, and what is made of random ones, by what they are in English. */
  titles = $state.raw<ReadonlyMap<string, string>>(new Map())
  /** Called when it has changed. */
  readonly listeners = new Set<() => void>()
  /** All its words are there. */
  isComplete = true
  /** Of the newest language that was wanted: an older one that comes later is none. */
  private turn = 0
  private texts = $state.raw<Readonly<Record<string, object>>>({})

  constructor() {
    translateBy((module) => this.texts[module] as Readonly<Record<string, unknown>> | undefined)
  }

  /** Speaks another language, as soon as its words are there; `first`: those of the first view, until `complete` is called. */
  async speak(tag: Tag, first = false): Promise<void> {
    this.turn += 1
    const { turn } = this
    const texts = tag === 'en' ? {} : await (first ? wordsOf(tag).first() : wordsOf(tag).texts())
    if (turn !== this.turn) return
    this.texts = texts
    this.tag = tag
    this.isComplete = !first || tag === 'en'
    for (const tell of this.listeners) tell()
  }

  /** Loads the other words. Where they cannot be loaded those views are in English. */
  async complete(): Promise<void> {
    const { tag, turn } = this
    if (this.isComplete) return
    const texts = await wordsOf(tag).texts()
    if (turn !== this.turn) return
    this.texts = texts
    this.isComplete = true
  }
}

const wordsOf = (tag: Tag): Words => {
  const words = load[tag]
  if (!words) throw new RangeError(`there is no language ${tag}`)
  return words
}

export const language = new Language()

/** The language among ours that a tag asks for, such as `zh`, `zh-Hans-SG` or `en-GB`. */
export function closest(wanted: string): Tag | undefined {
  if (wanted === '') return undefined
  const tags = languages.map(({ tag }) => tag)
  const whole = tags.find((tag) => tag.toLowerCase() === wanted.toLowerCase())
  const [base = ''] = wanted.toLowerCase().split('-')
  return whole ?? tags.find((tag) => tag.toLowerCase().split('-')[0] === base)
}

/** The first language of the browser's that is ours. */
export function preferred(): Tag {
  for (const wanted of navigator.languages) {
    const found = closest(wanted)
    if (found) return found
  }
  return 'en'
}

/** Compares names as the language sorts them. */
export const collator = (): Intl.Collator => new Intl.Collator(language.tag, { numeric: true })
