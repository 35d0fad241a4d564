import { texts } from '../texts'

/** Punctuation between texts, and with numbers. */
export const punctuation = texts('punctuation', {
  percent: (value: string) => `${value} %`,
  /** Names one after the other. */
  list: (names: readonly string[]) => names.join(', '),
  /** Groups of names. */
  groups: (lists: readonly string[]) => lists.join('; '),
  /** Parts of a sentence; empty ones are left out. */
  clauses: (parts: readonly string[]) => parts.filter(Boolean).join(', '),
  /** Sentences, whether their full stops are there or not; empty ones are left out. */
  sentences: (parts: readonly string[]) =>
    parts
      .filter(Boolean)
      .map((part, at) => (at < parts.length - 1 && !/[.!?…]$/.test(part) ? `${part}.` : part))
      .join(' '),
  /** With a full stop, if it has none. */
  sentence: (text: string) => (/[.!?…]$/.test(text) ? text : `${text}.`),
  /** A number after its name. */
  beside: (label: string, value: string) => `${label} ${value}`,
  colon: ': ',
  pair: (label: string, value: string) => `${label}: ${value}`,
  aside: (what: string) => ` (${what})`,
} as const)
