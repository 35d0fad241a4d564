import type * as English from '../../../www/src/locales/en/papers'
import type { Translated } from '../../../www/src/locales/texts'

/** The names of marks, by kind. */
const names = {
  value: {
    'same digits': '数字相同',
    'no significant difference': '无显著差异',
    'same power of ten': '同一数量级',
    differs: '不符',
  },
  ranking: { same: '排序相同', partly: '排序部分相同', reversed: '排序相反', undecided: '排序未定' },
  basis: {
    printed: '原文给出全部条件',
    'our reconstruction': '本软件的重建',
    fitted: '按此表拟合',
    'machine-dependent': '与计算机有关',
  },
  source: { consistent: '自洽', doubtful: '数据存疑', 'impossible as printed': '不可能出现' },
  claim: { upheld: '成立', refuted: '不成立', undecided: '未定' },
  answer: { 'as-claimed': '符合论断', contrary: '与论断相反', trivial: '差异可忽略', undecided: '未定' },
}

/** Text of the papers' cards: loaded with them. Claims come from REPRODUCTION.claims.json, figures from REPRODUCTION.csv. */
export const papers: Translated<typeof English.papers> = {
  title: '论文',
  intro:
    '本页列出 5 篇论文的论断，说明各论断在本软件中是否成立，并将原文数据与计算结果并列。全部结果由本页面所用的规划器算出。展开一条论断，可查看其标记所依据的检验，并观看相应的运行。',
  headline: (claims: string, figures: string) => `${claims} 条论断，${figures} 项原文数据`,
  overview: '论文总览',
  paper: '论文',
  subject: '主题',
  goto: (tag: string) => `转到 ${tag} 的卡片`,
  total: '5 篇合计',
  rule: {
    title: '论断和数据如何标记',
    claims: '论断',
    figures: '数据',
    asked:
      '每条论断化为一个或几个检验问题，每个问题用指定的统计检验回答。检验使用随机种子 51 至 100，选择参数时未用过这些随机种子。跨地图的问题对每种生成器取 6 张地图，每张地图 5 个随机种子。采用双侧检验，p 值用 Holm 法按同一论断的全部问题校正。A 为优势概率，即在所有成对的运行中，第一个规划器更优的比例；结果相同时计一半。原文未给出的障碍物布局由本软件重建。',
    answers: {
      'as-claimed': 'p < 0.05，方向与论断一致，且 A 不小于 0.60。',
      contrary: 'p < 0.05，方向与论断相反。',
      trivial: '长度或代价的均值相差不到 0.5%（置信度 95%）。',
      undecided: '其余情况，例如两个规划器都总能找到精确最优值。',
    },
    claimed: {
      upheld: '所有回答都符合论断。',
      refuted: '所有回答都与论断相反或差异可忽略；若论断含“全部”“最优”“从不”一类说法，一个相反的回答就足以判为不成立。',
      undecided: '其余情况。',
    },
    intro: '所有数据都由 forage reproduce 命令按同一规则标记，没有人工标记。标记所依据的数值见各行的“理由与命令”。',
    marks: {
      value: {
        'same digits': '计算均值按原文位数舍入后，与原文数据相同。',
        'no significant difference':
          '5% 水平的检验未发现显著差异。原文给出标准差和运行次数，且各次计算结果之间相差不到 10 倍时，用 Welch t 检验；否则从计算结果中重复抽样 2000 次，每次抽取的个数等于原文的运行次数；原文数据应落在各次均值的中间 95% 内。拟合的数值则应落在计算结果的 95% 区间内。',
        'same power of ten': '两者相差不到 10 倍。',
        differs: '两者相差 10 倍或更多，或符号不同。',
      },
      ranking: {
        same: '各行两两之间差异显著，顺序与原文相同。',
        partly: '部分行之间差异显著且顺序与原文相同，但不是全部。',
        reversed: '部分行之间差异显著，且顺序全部与原文相反。',
        undecided: '各行两两之间均无显著差异。',
      },
      basis: {
        printed: '原文给出了得出该数据的全部条件。',
        'our reconstruction': '原文有未交代之处，由本软件选定；理由中说明选了什么。',
        fitted: '为得到此表而选定了参数值；理由中说明用几个值拟合几项数据。',
        'machine-dependent': '该数据为运行时间，因计算机而异。',
      },
      source: {
        consistent: '该数据有可能是原文所说的量。',
        doubtful: '该数据只可能是另一个量。',
        'impossible as printed': '任何运行或路径都得不到该数据。',
      },
    },
  },
  kinds: {
    value: { title: '数值', about: '计算值与原文数据的接近程度。' },
    ranking: {
      title: '排序',
      about: '表中各行的优劣顺序是否与原文相同。各行两两检验：Wilcoxon 秩和检验，Holm 校正，5% 水平。',
    },
    basis: { title: '依据', about: '计算值以什么为依据。' },
    source: { title: '原文核对', about: '从算术上判断原文数据是否可能正确。无标记：没有可核对的内容。' },
  },
  names,
  count: (n: string, mark: string) => `${mark} ${n}`,
  rows: (n: number) => `${n} 行`,
  claims: '论断',
  place: (place: string) => `出处：${place}`,
  elsewhere: (claim: string) => `相关数据列于论断 ${claim}。`,
  questions: {
    of: (claim: string) => `论断 ${claim} 的检验问题`,
    columns: ['检验问题', '场景', '规划器', '数值', '检验', 'p', '效应量', '回答'],
    open: '对比',
    runs: (n: string) => `n = ${n}`,
    common: (parameters: string) => `共同参数：${parameters}`,
  },
  translated: '本软件译',
  pictures: '未给出数据的图',
  pictureClaims: (claims: string) => `论断：${claims}。`,
  open: (planner: string, scene: string) => `${planner}：在实验室的场景“${scene}”中打开`,
  statistics: '统计',
  statisticsHelp: (scene: string, seeds: string) => `统计：在“${scene}”中用 ${seeds} 个随机种子运行这些规划器`,
  watch: '观看',
  watchHelp: (scene: string) => `观看：这些规划器在“${scene}”中并排运行`,
  figuresShort: '数据',
  otherFigures: '其他数据',
  group: (table: string, reproduction: string) => `${table}（${reproduction}）`,
  whole: '复现整张表：',
  columns: {
    row: '行',
    published: '原文',
    ours: '本软件',
    best: '最优',
    mean: '均值',
    std: '标准差',
    median: '中位数',
    runs: '运行次数',
    marks: '标记',
    repeat: '理由与命令',
  },
  unprinted: '原文未给出',
  command: '复现命令：',
  repeat: '在实验室中打开',
  repeatHelp: (command: string) => `在实验室中打开：${command}`,
  why: (row: string) => `理由与命令：${row}`,
  all: '显示全部理由与命令',
  copy: '复制',
  copyHelp: (command: string) => `复制命令：${command}`,
  copied: '已复制',
  copyFailed: '浏览器不允许复制；可选中文字手动复制。',
  subjects: {
    WCPSO: '参数按三角函数变化、采用母鸡和小鸡更新方程的粒子群',
    LTQPSO: '引入进化速度、群体离散度和自然选择的量子行为粒子群',
    ANTBAT: '方向启发蚁群求路径，蝙蝠算法求访问顺序',
    'ARM-RRT': '六自由度机械臂的目标导向快速扩展随机树',
    'WOLF-ANT': '由粒子群优化参数的狼群分配蚁群，面向动态障碍物',
  },
}
