import type * as English from '../../../www/src/locales/en/learn'
import type { Translated } from '../../../www/src/locales/texts'

/** Text of the room where a newcomer begins. */
export const learn: Translated<typeof English.learn> = {
  title: '粒子群搜索最短路径',
  lead: '每条线是一个粒子：它记住个体最优，也获知群体最优。',
  prompt: '拖动圆形障碍物',
  dragged: '粒子群重新开始搜索',
  why: '为什么？到实验室查看数值',
  open: '在实验室中打开',
  families: {
    title: '路径规划的 6 种方法',
    open: (title: string) => `${title}：在实验室中运行`,
    all: {
      swarm: { title: '粒子群', text: '粒子移向个体最优和群体最优。' },
      ants: { title: '蚁群', text: '蚂蚁边走边留下信息素，走得最多的路径信息素浓度最高。' },
      bats: { title: '蝙蝠', text: '闭合巡回路线含 52 个访问点，蝙蝠按回声定位原理调整顺序。' },
      tree: { title: '随机树', text: '树向自由空间扩展，并不断重布线。' },
      moving: { title: '动态障碍物', text: '障碍物横穿路径时，机器人随即重规划。' },
      arm: { title: '机械臂', text: '6 个关节协同运动，绕过长方体。' },
    },
  },
  papers: {
    title: '所依据的 5 篇论文',
    text: '论文的论断，以及重新运行的结果。',
    open: '查看论文',
  },
  unknown: (name: string) => `没有课程“${name}”。`,
  loading: '课程加载中……',
}
