import type * as English from '../../../www/src/locales/en/embed'
import type { Translated } from '../../../www/src/locales/texts'

/** Text of the dialog that gives what shows a run on another page. */
export const embed: Translated<typeof English.embed> = {
  title: '嵌入本次运行',
  intro: '将代码复制到网页中，即可显示当前状态的运行；读者可前后单步查看。',
  as: '嵌入方式',
  kinds: { iframe: 'iframe', element: '自定义元素' },
  iframeHelp: 'iframe 只需这段代码，内容从本站加载。',
  elementHelp: '自定义元素只需一个脚本，可复制到自己的网站。同一网页中的多次运行共用该脚本。',
  controls: '控件',
  controlNames: { none: '无', play: '播放', full: '全部' },
  theme: '颜色',
  themes: { system: '跟随读者', light: '浅色', dark: '深色' },
  language: '语言',
  autoplay: '进入可视区域时自动播放',
  width: '宽度',
  height: '高度',
  size: (least: number, most: number) => `像素，${least} 至 ${most}。`,
  code: '待复制的代码',
  copy: '复制',
  copied: '已复制',
  copyFailed: '浏览器不允许复制；代码已选中。',
  preview: '预览',
  lessonTooLarge: '课程过长，链接容纳不下。可保存为文件后分享。',
  failed: (message: string) => `无法生成本次运行的链接：${message}`,
}
