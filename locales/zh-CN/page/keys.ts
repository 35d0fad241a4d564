import type * as English from '../../../www/src/locales/en/keys'
import type { KeyRow, KeyGroup } from '../../../www/src/locales/en/keys'
import type { Translated } from '../../../www/src/locales/texts'

const everywhere: KeyGroup = {
  title: '通用',
  rows: [
    [['?'], '显示快捷键'],
    [['P'], '演示：画布占满屏幕'],
    [['M'], '添加或删除本次迭代的书签'],
    [['Ctrl', 'Z'], '撤销修改'],
    [['Ctrl', 'Shift', 'Z'], '重做修改'],
  ],
}

const time: readonly KeyRow[] = [
  [['空格'], '播放或暂停'],
  [['Home'], '跳到开头'],
  [['End'], '跳到结尾'],
]

const run: KeyGroup = {
  title: '运行',
  rows: [
    ...time,
    [['左', '右'], '后退或前进一次迭代；按住 Shift 为 10 次'],
    [['Page Up', 'Page Down'], '跳到上一阶段或下一阶段'],
    [['N', 'Shift + N'], '跳到下一个或上一个事件'],
  ],
}

const stage: KeyGroup = {
  title: '画布',
  rows: [
    [['+', '−'], '缩放'],
    [['0'], '显示全部'],
    [['上', '下'], '平移视图'],
    [['方向键'], '移动所选对象；按住 Shift 移动更远'],
    [['Delete'], '删除所选圆形障碍物或访问点'],
    [['Esc'], '取消选择或返回'],
    [['方向键', '空格'], '选择栅格，再用当前工具绘制或查看解释'],
  ],
}

const space: KeyGroup = {
  title: '机械臂画布',
  rows: [
    ...time,
    [['逗号', '句号'], '后退或前进一次迭代；按住 Shift 为 10 次'],
    [['方向键'], '旋转视图'],
    [['+', '−'], '缩放'],
    [['0'], '显示全部'],
    [['1', '2', '3', '4'], '正视、侧视、俯视和轴测视角'],
    [['N', 'Shift + N'], '选择下一个或上一个对象'],
    [['方向键'], '在水平面内移动所选对象'],
    [['Page Up', 'Page Down'], '升高或降低所选对象'],
    [['Shift', '方向键'], '改变所选长方体的尺寸（远侧面移动）；转动所选基座'],
    [['A'], '添加长方体'],
    [['Delete'], '删除所选长方体'],
    [['J', 'K'], '查看上一个或下一个节点的解释'],
    [['Esc'], '取消选择'],
  ],
}

const presenting: KeyGroup = {
  title: '演示时',
  rows: [
    [['Page Down', 'Page Up'], '前进或后退一次迭代，与翻页笔一致'],
    [['1', '9'], '1 至 9 依次跳到各书签；没有书签时跳到运行的 10% 至 90% 处'],
    [['B'], '黑屏'],
    [['Q'], '将链接显示为二维码'],
    [['Esc'], '退出'],
  ],
}

const race: KeyGroup = {
  title: '观看对比',
  rows: [
    ...time,
    [['左', '右'], '后退或前进一个节拍；按住 Shift 为 10 个'],
    [['+', '−'], '焦点在画面上时，缩放全部画面'],
    [['0'], '焦点在画面上时，显示全部'],
  ],
}

/** As a sentence for those who hear it. */
const spoken = ({ rows }: KeyGroup): string => rows.map(([keys, what]) => `${keys.join('、')}：${what}。`).join('')

export const keys: Translated<typeof English.keys> = {
  title: '快捷键',
  groups: [everywhere, run, stage, space, presenting, race],
  stageHelp: `${spoken(run)}${spoken(stage)}`,
  spaceHelp: spoken(space),
}
