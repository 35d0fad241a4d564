import type * as English from '../../../www/src/locales/en/forks'
import type { Translated } from '../../../www/src/locales/texts'

/** Text about the run before a change. */
export const forks: Translated<typeof English.forks> = {
  label: '修改前的运行',
  before: (value: string, iteration: string) => `修改前：${value}，第 ${iteration} 次迭代`,
  undo: '撤销',
  compare: '在“对比”中打开两者',
  /** The title of the planner with the code of before. */
  earlier: (planner: string) => `${planner}（修改前）`,
  noEarlier: '无法为修改前的代码另取名称：名称紧接在 register({ 之后，才能对比两者。',
  otherScene: '两者的场景类型不同。',
  dismiss: '隐藏修改前的运行',
}
