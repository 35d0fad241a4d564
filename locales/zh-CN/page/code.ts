import type * as English from '../../../www/src/locales/en/code'
import type { Translated } from '../../../www/src/locales/texts'

export const code: Translated<typeof English.code> = {
  said: (message) => message,
  starts: /^planner .*应为可启动的规划器（代码出错：(.+)）$/s,
  check: (name) => name,
}
