import type * as English from '../../../www/src/locales/en/presentation'
import type { Translated } from '../../../www/src/locales/texts'

/** Text of the presentation mode. */
export const presentation: Translated<typeof English.presentation> = {
  code: '将链接显示为二维码（Q）',
  codeOf: (iteration: string) => `第 ${iteration} 次迭代的链接二维码`,
  tooLong: '含该场景的链接过长，无法生成二维码。',
  end: '退出演示（Esc）',
  unblank: '恢复显示画布（B）',
}
