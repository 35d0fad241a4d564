import type * as English from '../../../www/src/locales/en/setup'
import type { Translated } from '../../../www/src/locales/texts'

/** Text of what is run: case, planner, scene and seed. */
export const setup: Translated<typeof English.setup> = {
  case: '示例',
  planner: '规划器',
  scene: '场景',
  edited: (title: string) => `${title}（已修改）`,
  kinds: { tour: '巡回路线', grid: '栅格地图', discs: '圆形障碍物', function: '测试函数', arm: '机械臂' },
  see: '观察要点：',
  chooseCase: '选择示例并运行',
  own: { title: '自定义', function: '自定义函数……', random: '随机场景……' },
  nothingFound: '没有匹配项。可减少关键词。',
  families: {
    swarm: '群体算法',
    ants: '蚁群',
    search: '图搜索',
    tour: '巡回路线',
    tree: '随机树',
    dynamic: '动态路径规划',
    tuning: '参数优化',
    own: '自定义',
  } as Readonly<Record<string, string>>,
  seed: '随机种子',
  source: '来源',
  seedHint: '应为 0 至 9 007 199 254 740 991 的整数。',
}
