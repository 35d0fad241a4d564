import type * as English from '../../../www/src/locales/en/compare'
import type { Translated } from '../../../www/src/locales/texts'

/** Text of what is compared: planners, scene, seeds and budget. */
export const compare: Translated<typeof English.compare> = {
  lead: '所有规划器使用同一场景和相同的评价次数：可并排观看一次运行，也可用多个随机种子进行统计。',
  as: { label: '查看方式', titles: { watch: '观看', statistics: '统计' } },
  address: (why: string) => `链接的部分内容无法打开。${why}`,
  broken: (message: string) => `一个工作线程出错（${message}）。可重试。`,
  joined: (scene: string) => `所选规划器都不适用于“${scene}”；已添加适用的规划器。`,
  /** Which optimum a planner is measured by. */
  references: {
    'any-angle': '任意角度路径的精确最优值',
    cells: '栅格路径的精确最优值',
    matrix: '巡回路线的精确最优值',
    stored: '场景文件所给最优值',
  },
  plan: {
    title: '对比设置',
    scene: '场景',
    here: (title: string) => `${title}（已修改）`,
    maps: '每个随机种子一个随机场景',
    mapsHelp: '随机种子 7 使用生成器的场景 7。各次运行按相对所在场景精确最优值的最优性间隙比较。',
    mapSettings: '场景参数',
    mapsOf: (title: string) => `${title}：每个随机种子一个`,
    ownScenes: '自建场景',
    fromStage: (title: string) => `${title}（来自实验室）`,
    task: '任务',
    tasks: { path: '路径', tour: '巡回路线', tuning: '参数优化' },
    seed: '随机种子',
    from: '起始随机种子',
    count: '随机种子数',
    budget: '评价预算',
    equal: '评价次数相等',
    own: '各自的迭代次数',
    evaluations: '评价次数',
    firstHelp: '评价预算等于第一个规划器完成自身迭代次数所用的评价次数。已开始的迭代会执行完。',
    equalHelp: '各规划器达到该评价次数即停止。已开始的迭代会执行完。',
    evaluation: (what: string) => `一次评价对应${what}。`,
    evaluationDiffers: (things: readonly [what: string, planners: readonly string[]][]) =>
      `各规划器的一次评价含义不同：${things.map(([what, planners]) => `${what}（${planners.join('、')}）`).join('；')}。`,
    watchHelp: '每个节拍对应一个评价次数，各规划器显示首次达到该评价次数的那次迭代。',
    ownHelp: '各规划器按自身设置的迭代次数运行，评价次数不同。',
  },
  fields: {
    whole: (name: string, typed: string, least: string, most: string) => `${name}为“${typed}”；应为 ${least} 至 ${most} 的整数。`,
    wholeOrNothing: (name: string, typed: string, least: string, most: string) =>
      `${name}为“${typed}”；应为 ${least} 至 ${most} 的整数，或留空。`,
  },
  entrants: {
    title: '规划器',
    before: '修改前',
    add: '添加规划器',
    choose: '要添加的规划器',
    full: '最多 8 个规划器。',
    none: '添加规划器以进行对比。',
    parameters: '参数',
    parametersOf: (name: string) => `“${name}”的参数`,
    copy: '复制规划器',
    copyOf: (name: string) => `复制“${name}”，以便设置不同的参数`,
    remove: (name: string) => `移除“${name}”`,
    restore: (name: string) => `恢复“${name}”`,
    unsuited: (scene: string) => `不适用于“${scene}”，不参与对比。`,
    otherTask: '任务不同，不参与对比。',
    double: '与前面的某个规划器完全相同，不参与对比；修改参数后可参与。',
    done: '完成',
  },
  presets: {
    title: '预设对比',
    all: {
      swarms: {
        title: '圆形障碍物中的 4 种粒子群算法',
        help: '在 WCPSO 论文的场景中，对比 WCPSO（对停滞粒子施加扰动）与另外 3 种粒子群算法。',
      },
      inertia: {
        title: '3 种惯性权重',
        help: '同一规划器求解 Rastrigin 函数，w = 0.4、0.6 和 0.8：取值小时易陷入局部最优。',
      },
      bbob: {
        title: 'bbob 测试集中的函数',
        help: '10 维 Rastrigin 函数，经平移、旋转和非线性变换：15 个实例，每维 1000 次评价。',
      },
      shifted: {
        title: '中心偏置',
        help: '10 维 Rastrigin 函数，最小值点位于搜索区域的任意位置：偏向中心搜索的规划器会损失多少？',
      },
      quantum: { title: '量子行为粒子群', help: 'LTQPSO 能否优于基本 QPSO？' },
      ants: { title: '4 种蚁群算法', help: '哪种规则能找到最短路径？多快能找到？' },
      maps: {
        title: '100 张随机地图上的蚁群算法',
        help: '每个随机种子一张房间地图：哪种蚁群算法在每张地图上都能找到路径？最优性间隙有多大？',
      },
      exact: { title: '精确搜索', help: '精确最优值相同，各自扩展多少个栅格？' },
      tours: {
        title: '52 个访问点的巡回路线',
        help: '蝙蝠算法、遗传算法、粒子群算法和模拟退火算法，评价次数相等。',
      },
      trees: { title: '圆形障碍物中的随机树', help: '一棵树、两棵树，以及能重布线的树。' },
      arm: { title: '机械臂的随机树', help: '6 个关节绕过一个长方体：目标导向能减少多少计算量？' },
      drives: { title: '在动态障碍物中行驶', help: '3 种重规划方法在动态障碍物中的表现。' },
    },
  },
}
