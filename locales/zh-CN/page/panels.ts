import type * as English from '../../../www/src/locales/en/panels'
import type { Translated } from '../../../www/src/locales/texts'

/** Text of the panels that are there at once; that of the others is in closer.ts. What the core says (titles, help, symbols) isn't here: it comes with the catalogue. */
export const panels: Translated<typeof English.panels> = {
  parameters: {
    help: (title: string) => `“${title}”的说明`,
    slider: (title: string) => `${title}，滑块`,
    range: (min: string, max: string) => `允许范围：${min} 至 ${max}。`,
    whole: (min: string, max: string) => `允许范围：${min} 至 ${max} 的整数。`,
    standard: (value: string) => `默认值：${value}。`,
    reset: (title: string, value: string) => `将“${title}”恢复为默认值（${value}）`,
    resetAll: '全部恢复默认值',
    allDefault: '全部为默认值。',
    changed: (count: number) => `已修改 ${count} 个参数`,
    on: '开',
    off: '关',
    suggested: (source: string, population: string, iterations: string) =>
      `建议值（${source.replace(/ (\(\d+\))$/, ' 式 $1')}）：N = ${population}，M = ${iterations}`,
    use: '采用',
    useBoth: '采用建议的种群规模和迭代次数',
    inUse: '已采用',
  },
  readings: {
    groups: { cost: '代价', length: '长度', measure: '指标', schedule: '时变参数', count: '计数' },
    iteration: '迭代',
    label: (group: string, k: string) => `第 ${k} 次迭代的${group}`,
  },
  formulas: {
    paper: '原文公式',
    live: '代入本次迭代的数值',
    item: '代入该对象的数值',
    none: '该规划器未列出公式。',
    steps: '规划器的步骤，附本次迭代的数值',
  },
  chart: {
    label: '收敛曲线：选择一次迭代',
    view: '图表内容',
    costs: '代价',
    lengths: '长度',
    measures: '指标',
    schedules: '时变参数',
    scale: '纵轴刻度',
    linear: '线性',
    log: '对数',
    near: '精确最优值附近',
    logHint: '对数刻度要求数值为正。',
    iteration: '迭代次数',
    exact: '精确最优值',
    smoothed: '结果（平滑后）',
    before: '修改前',
    empty: '完成第一次迭代后显示曲线。',
    nothing: '暂无数据：得到首个结果后开始绘制曲线。',
    table: '曲线数据表',
    caption: (from: string, to: string) => `第 ${from} 至 ${to} 次迭代的数据`,
    at: (k: string, values: string) => `第 ${k} 次迭代：${values}`,
    hint: '点击或按方向键，跳转到某次迭代。',
    summary: (title: string, first: string, last: string, from: string, to: string) =>
      `${title}：第 ${from} 次迭代为 ${first}，第 ${to} 次迭代为 ${last}。`,
  },
}
