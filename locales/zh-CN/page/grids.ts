import type * as English from '../../../www/src/locales/en/grids'
import type { Translated } from '../../../www/src/locales/texts'

/** Text of the stage’s tools and layers for grids: loaded with the first grid. */
export const grids: Translated<typeof English.grids> = {
  look: '查看：拖动可移动视图，点击可查看解释',
  paint: '绘制障碍栅格',
  clear: '清空：删除所有障碍栅格',
  cells: '用方向键在栅格间移动',
  painting: '在自由栅格上拖动可绘制障碍，在障碍栅格上拖动可擦除。右键或双指拖动可移动视图。',
  cell: (column: number, row: number, blocked: boolean) => `第 ${column} 列，从上往下第 ${row} 行：${blocked ? '障碍栅格' : '自由栅格'}`,
  drive: '让机器人沿路径行驶',
  margin: '膨胀区域',
  marginHelp: '机器人中心不可进入的区域，即与障碍栅格的距离小于机器人半径的区域。',
  moving: '动态障碍物',
  movingHelp: '起始位置，以及 1 s 后的位置。',
}
