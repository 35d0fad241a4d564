import type * as English from '../../../www/src/locales/en/glossary'
import type { Translated } from '../../../www/src/locales/texts'

export const glossary: Translated<typeof English.glossary> = {
  title: '术语表',
  open: '术语表',
  search: '查找术语',
  symbol: '符号',
  meaning: '含义',
  nothing: '没有匹配的术语。',
  term: (name: string) => `${name}：查看释义`,
}
