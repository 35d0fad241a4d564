import type * as English from '../../../www/src/locales/en/space'
import type { Translated } from '../../../www/src/locales/texts'

const metres = (value: number): string => `${Number(value.toFixed(3))}`.replace('-', '−')

export const space: Translated<typeof English.space> = {
  label: '三维画布：机械臂、工作空间和规划结果',
  words: ({ size, cuboids, nodes, length, from, to }: Words): string =>
    [
      `工作空间 ${size.map(metres).join(' × ')} m，${cuboids} 个长方体。`,
      `起点 ${point(from)}，目标点 ${point(to)}。`,
      nodes === null ? '' : `树有 ${nodes} 个节点。`,
      length === null ? '尚无路径。' : `已找到长 ${metres(length)} m 的路径。`,
    ].join(''),
  selected: (name: string, at: readonly number[]): string => `${name}，位于 ${point(at)}`,
  cuboid: (index: number): string => `长方体 ${index + 1}`,
  start: '起点',
  goal: '目标点',
  base: '基座',
  axes: ['x', 'y', 'z'] as const,
  unit: 'm',
  tools: '画布工具',
  add: '添加长方体',
  remove: '删除所选长方体',
  zoomIn: '放大',
  zoomOut: '缩小',
  fit: '显示全部',
  views: '视角',
  sides: { corner: '轴测', front: '正视', side: '侧视', top: '俯视' },
  hint: '拖动可在水平面内移动；拖动箭头或按住 Shift 可升降；拖动圆点可移动相应的面。',
  lift: '拖动可在水平面内移动；拖动箭头或按住 Shift 可升降。',
  thinned: (n: number) => `每 ${n} 个绘制 1 个`,
  failed: '本浏览器无法绘制三维图形',
  why: '三维画布需要 WebGL 2，而浏览器未提供：可能在设置中关闭了硬件加速。其余功能均可使用：运行、数值、场景表格和导出。',
  lost: '显卡中断了绘制；显卡空闲后画面自动恢复。',
}

interface Words {
  size: readonly number[]
  cuboids: number
  nodes: number | null
  length: number | null
  from: readonly number[]
  to: readonly number[]
}

const point = (at: readonly number[]): string => `(${at.map(metres).join(', ')})`
