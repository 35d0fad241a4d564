import type * as English from '../../../www/src/locales/en/punctuation'
import type { Translated } from '../../../www/src/locales/texts'

export const punctuation: Translated<typeof English.punctuation> = {
  percent: (value) => `${value}%`,
  list: (names) => names.join('、'),
  groups: (lists) => lists.join('；'),
  clauses: (parts) => parts.filter(Boolean).join('，'),
  sentences: (parts) =>
    parts
      .filter(Boolean)
      .map((part, at) => (at < parts.length - 1 && !/[。！？…]$/.test(part) ? `${part}。` : part))
      .join(''),
  pair: (label, value) => `${label}：${value}`,
  aside: (what) => `（${what}）`,
}
