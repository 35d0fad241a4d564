import { texts } from '../texts'

/** Text of the glossary; its terms are in docs/glossary.md. */
export const glossary = texts('glossary', {
  title: 'Glossary',
  open: 'Glossary',
  search: 'Find a term',
  symbol: 'Symbol',
  meaning: 'Meaning',
  nothing: 'No term has these letters.',
  term: (name: string) => `${name}: what it means`,
} as const)
