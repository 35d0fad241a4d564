import type * as English from '../../../www/src/locales/en/lesson'
import type { Translated } from '../../../www/src/locales/texts'

/** Text of lessons: what is around their own words. */
export const lesson: Translated<typeof English.lesson> = {
  lessons: '课程',
  lead: '每课约 10 分钟。先作预测，再看程序算出的结果。',
  minutes: (n: number) => `${n} 分钟`,
  steps: (n: number) => `${n} 个步骤`,
  readTo: (step: number, all: number) => `读到步骤 ${step} / ${all}`,
  done: '已读完',
  begin: '开始',
  goOn: '继续',
  forget: '删除学习进度',
  forgotten: '学习进度已删除',
  kept: '学习进度只保存在本浏览器中。',
  close: '全部课程',
  goals: '学完本课程后，能够',
  notes: '教师备注',
  next: '下一步',
  back: '上一步',
  place: (step: number, all: number) => `步骤 ${step} / ${all}`,
  stepsLabel: '课程步骤',
  stage: '该步骤展示的运行',
  away: {
    forked: '运行已修改，与课程中的不同。',
    moved: '已离开该步骤展示的时刻。',
    back: '回到课程',
    lab: '在实验室中打开',
  },
  change: '修改参数',
  articles: '论文解读',
  articlesLead: '正文旁实际运行各篇论文的方法。除原文数据外，所有数值都由运行得出。',
  claims: '论文的论断与运行结果',
  papers: '在“论文”中查看依据',
  figures: {
    moment: '由该次运行算出：点击查看对应时刻',
    seeds: '由多次运行算出',
    setting: '该次运行的参数',
    published: '取自复现数据表',
  },
  experiment: '实验',
  compare: '在“对比”中打开',
  task: '任务',
  tasks: {
    gap: (most: string) => `目标：相对精确最优值的最优性间隙不超过 ${most}`,
    length: (most: string) => `目标：长度不超过 ${most}`,
    cost: (most: string) => `目标：代价不超过 ${most}`,
    budget: (most: string) => `评价预算：不超过 ${most} 次评价`,
    own: '使用自己编写的规划器',
    back: '回到课程',
    begin: '开始任务',
    handIn: '复制用于提交的链接',
    copied: '链接已复制，可以提交',
    other: '当前运行的规划器、场景或参数与任务不符。',
    none: '当前运行尚无可行结果。',
    standing: (value: string, evaluations: string) => `当前运行：${evaluations} 次评价后，结果为 ${value}。`,
    reached: '已达到目标。',
    short: '尚未达到目标。',
    over: '评价次数已超出预算。',
  },
  question: '预测',
  answer: '提交预测',
  retry: '重新预测',
  answered: '已作答。',
  finding: '正在计算答案……',
  failed: (reason: string) => `没有得到答案：${reason}`,
  how: {
    arrow: '拖动箭头末端，或用方向键移动。',
    cell: '点击一个相邻栅格，或用方向键选择。',
    member: '点击一个个体，或用方向键选择。',
    node: '点击树的一个节点，或用方向键选择。',
  },
  layer: {
    arrow: '预测：箭头末端',
    cell: '预测：一个相邻栅格',
    member: '预测：一个个体',
    node: '预测：一个节点',
  },
  tip: (x: string, y: string) => `箭头末端位于 (${x}, ${y})。`,
  chosenMember: (index: number) => `个体 ${index}。`,
  chosenNode: (n: number) => `节点 ${n}。`,
  /** By how near a prediction was. */
  grades: { right: '预测正确', near: '预测接近', off: '与预测不同' },
  feedback: {
    arrow: (off: string, length: string, angle: string) =>
      `预测的箭头末端与实际到达的位置相距 ${off}。实际移动距离为 ${length}；预测的方向偏差 ${angle}°。`,
    cell: (direction: string, chosen: string, best: string, likeliest: string) =>
      direction === best
        ? `选择的是${direction}方向，概率最大：${chosen}。`
        : `选择了${direction}方向：概率 ${chosen}。概率最大的是${best}方向：${likeliest}。`,
    node: (chosen: string, nearest: string) => `所选节点到采样点的距离为 ${chosen}，最近节点的距离为 ${nearest}。`,
    member: (index: number, value: string, rank: number, best: number, smallest: string) =>
      rank === 1
        ? `选择了个体 ${index}：其值为 ${value}，最小。`
        : `选择了个体 ${index}：其值为 ${value}，排第 ${rank} 位。最小的是个体 ${best}：${smallest}。`,
    option: (chosen: string, came: string) => (chosen === came ? `选择了“${came}”。` : `选择了“${chosen}”。实际结果：“${came}”。`),
    value: (of: string, value: string) => `${of}：${value}。`,
    run: (of: string, value: string, iteration: number) => `第 ${iteration} 次迭代的${of}：${value}。`,
    seeds: (of: string, value: string, agree: number, seeds: number) =>
      `${of}，${seeds} 个随机种子的中位数：${value}。${seeds} 次运行中有 ${agree} 次落入该选项。`,
    compared: (of: string, seeds: number) => `${of}，各取 ${seeds} 个随机种子的中位数`,
    wins: (n: number, seeds: number) => `${seeds} 次运行中有 ${n} 次最优`,
  },
  measures: {
    cost: '代价',
    length: '长度',
    gap: '相对精确最优值的最优性间隙',
    evaluations: '评价次数',
    iterations: '迭代次数',
  } as Readonly<Record<string, string>>,
}
