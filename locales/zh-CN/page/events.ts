import type * as English from '../../../www/src/locales/en/events'
import type { Translated } from '../../../www/src/locales/texts'

/** Text about what happens in simulated time: loaded with the first run that tells of any. */
export const events: Translated<typeof English.events> = {
  rail: '时间轴上的事件',
  when: (time: string, iteration: string) => `${time} s，第 ${iteration} 次迭代`,
  seconds: (time: string) => `${time} s`,
  obstacle: (n: string) => `障碍物 ${n}`,
  /** Of those that happened nearly at once: how many more there are beside the one that is told. */
  more: (count: string) => `另有 ${count} 个事件`,
  together: (count: string) => `${count} 个事件`,
  later: '尚未发生',
  said: (title: string, time: string, reason: string) => `${time} s：${title}。${reason}`,
  tones: { plain: '提示', warning: '警告', decision: '决策', good: '成功', bad: '严重' },
  log: {
    none: '尚无事件。',
    keys: '焦点在画布或时间轴上时，按 N 跳到下一个事件，按 Shift + N 跳到上一个事件。',
    list: '按时间排列的事件，按 Enter 跳转',
    filter: '筛选事件',
    /** Those that must not happen are always listed. */
    only: (title: string, count: string) => `${title}：${count}`,
    hidden: (count: string) => `${count} 个事件未列出。`,
    all: '全部列出',
    copy: '复制为 CSV',
    copied: '已复制',
    failed: '浏览器不允许复制。',
    csv: '保存为 CSV',
  },
  fate: {
    collisions: (count: string) => `${count} 次碰撞`,
    arrived: '到达目标点，无碰撞',
    arrivedAfter: (time: string) => `${time} s 后到达目标点，无碰撞`,
    arrivedStruck: (count: string) => `到达目标点，但有 ${count}`,
    lost: '未到达目标点',
    touches: '到达目标点，但有碰撞',
    underway: '目前无碰撞',
    struckUnderway: (count: string) => `目前已有 ${count}`,
    figures: '行驶',
  },
}
