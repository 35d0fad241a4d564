import type * as English from '../../../www/src/locales/en/tours'
import type { Translated } from '../../../www/src/locales/texts'

/** Text about tours and those that search side by side: loaded when there are any. */
export const tours: Translated<typeof English.tours> = {
  step: (title: string, k: string, of: string, runs: string) => `${title} ${k} / ${of}：${runs}`,
  order: {
    title: (stops: string) => `${stops} 个访问点的访问顺序`,
    numbers: '此处为访问点在场景中的编号；画布中的编号沿巡回路线递增。',
    copy: '复制访问顺序',
    copied: '已复制',
    failed: '浏览器不允许复制。',
  },
  members: {
    waiting: '访问点间路径全部求出后开始搜索。',
    none: '第一次迭代之前没有数据。',
    number: '编号',
    sort: (title: string) => `${title}（点击排序）`,
    range: (least: string, mean: string, most: string) => `${least} 至 ${most}，均值 ${mean}`,
    row: (name: string, numbers: string) => `${name}：${numbers}`,
    layer: (title: string) => `在画布中显示：${title}`,
    pick: '点击条形查看解释',
    hint: '点击某一行，或在该行按 Enter，可查看解释。',
  },
}
