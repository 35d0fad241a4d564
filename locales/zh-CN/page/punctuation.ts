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
      .map((part, at) => (at < parts.length - 1 && !/[。！？….]$/.test(part) ? `${part}。` : part))
      .join(''),
  sentence: (text) => (/[。！？….]$/.test(text) ? text : `${text}。`),
  // Between Han there is no space.
  beside: (label, value) => `${label}${/[\u3400-\u9fff]$/.test(label) && /^[\u3400-\u9fff]/.test(value) ? '' : ' '}${value}`,
  colon: '：',
  pair: (label, value) => `${label}：${value}`,
  aside: (what) => `（${what}）`,
}
