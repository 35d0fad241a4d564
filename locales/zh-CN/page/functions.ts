import type * as English from '../../../www/src/locales/en/functions'
import type { Translated } from '../../../www/src/locales/texts'

/** Functions that the reader writes. */
export const functions: Translated<typeof English.functions> = {
  title: '自定义函数',
  intro: '群体算法求此处所写函数的最小值。',
  example: '示例',
  nothing: '没有匹配的示例。',
  name: '名称',
  unnamed: '自定义函数',
  formula: 'f(x) =',
  formulaHelp: 'x、y、z 是前 3 个变量，x[1] 至 x[n] 是全部变量。sum(…) 和 prod(…) 中的 i 从 1 取到 n。',
  reference: '可用的全部符号',
  groups: {
    variables: '变量',
    numbers: '常数',
    operators: '运算符',
    sums: '求和与连乘',
    choices: '条件',
    functions: '函数',
  },
  others: '改用其他下标和范围：',
  dimension: '维数',
  low: '下界',
  high: '上界',
  sidesHelp: '所有变量共用一个数值，或每个变量一个：−5, 0',
  optimum: '最小值（若已知）',
  optimumHelp: '结果将与它比较。',
  noNumbers: (text: string) => (text.trim() === '' ? '缺少数值。' : `“${text.trim()}”既不是数值，也不是数值列表。`),
  noNumber: (text: string) => `“${text.trim()}”不是数值。`,
  preview: (count: number) => (count > 2 ? `共 ${count} 维，图中为前 2 维，其余各维取搜索区域的中点。` : '函数在搜索区域上的图像'),
  heights: (low: string, high: string) => `${low} 至 ${high}`,
  use: '使用该函数',
  cancel: '取消',
}
