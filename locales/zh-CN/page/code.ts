import type * as English from '../../../www/src/locales/en/code'
import type { Translated } from '../../../www/src/locales/texts'

/** The first pattern that fits a whole text says it. */
type Table = readonly (readonly [RegExp, (...found: string[]) => string])[]

const HAN = /\p{Script=Han}/u
const WIDE = /[\s\u2018-\u201d\u2026\u3000-\u303f\uff00-\uffef]/

/** Between Han and what is not there is a space, unless a wide mark stands there. */
function joined(before: string, after: string): string {
  const [last, first] = [before.slice(-1), after.slice(0, 1)]
  const apart = HAN.test(last) !== HAN.test(first) && last !== '' && first !== '' && !WIDE.test(last + first)
  return before + (apart ? ' ' : '') + after
}

/** A text with values in it, spaced. */
const zh = (parts: TemplateStringsArray, ...values: string[]): string =>
  parts.reduce((said, part, at) => joined(joined(said, values[at - 1] ?? ''), part), '')

function found(table: Table, text: string): string | undefined {
  for (const [pattern, says] of table) {
    const groups = pattern.exec(text)
    if (groups) return says(...groups.slice(1))
  }
  return undefined
}

const list = (names: string): string => names.replaceAll(', ', '、')

/** What a value is. */
const VALUES: Table = [
  [/^a list$/, () => '列表'],
  [/^a list of (\d+)$/, (count) => `${count} 项的列表`],
  [/^an object$/, () => '对象'],
  [/^a function$/, () => '函数'],
  [/^a number$/, () => '数值'],
  [/^a string$/, () => '字符串'],
  [/^a boolean$/, () => '布尔值'],
  [/^a strange object$/, () => '特殊对象'],
  [/^an? (\w+)$/, (type) => `${type} 类型的值`],
]
const value = (text: string): string => found(VALUES, text) ?? text

/** What was called, and a part of it. */
const call = (text: string): string => text.replace(/^(\w+): /, '$1 的 ')

/** What a field must be. */
const ALLOWED: Table = [
  [/^an object with a name$/, () => '含 name 字段的对象'],
  [/^an object$/, () => '对象'],
  [/^a function$/, () => '函数'],
  [/^true or false$/, () => 'true 或 false'],
  [/^a finite number$/, () => '有限数值'],
  [/^a number from (.+) to (.+)$/, (min, max) => zh`${min} 至 ${max} 的数值`],
  [/^a whole number from (.+) to (.+)$/, (min, max) => zh`${min} 至 ${max} 的整数`],
  [/^a whole number from 0, where integer is true$/, () => '非负整数（integer 为 true）'],
  [/^at least min = (.+)$/, (min) => zh`不小于 min（${min}）的数值`],
  [/^one of (.+)$/s, (names) => zh`以下之一：${list(names)}`],
  [/^a text of at most (\d+) characters$/, (most) => zh`不超过 ${most} 个字符的字符串`],
  [/^a text of (\d+) to (\d+) characters$/, (least, most) => zh`${least} 至 ${most} 个字符的字符串`],
  [/^(\d+) to (\d+) small letters, digits, - and _, a letter first$/, (a, b) => zh`${a} 至 ${b} 个小写字母、数字、- 或 _，以字母开头`],
  [/^a list of at most (\d+)$/, (most) => zh`不超过 ${most} 项的列表`],
  [/^a list of texts, each of them once$/, () => '不含重复项的字符串列表'],
  [/^a list of (.+): one of them at least$/, (names) => zh`至少含以下一项的列表：${list(names)}`],
  [/^tour alone, or without it: /, () => '只含 tour 或不含 tour 的列表：巡回路线与路径不能并存'],
  [/^a name that no other one has$/, () => '不与其他项重复的名称'],
  [/^a name that no planner of the package has$/, () => '内置规划器未使用的名称'],
  [/^the name of a planner that was registered$/, () => '已注册的规划器名称'],
  [/^a code of at most (\d+) bytes$/, (most) => zh`不超过 ${most} 字节的代码`],
  [/^a code of at most (\d+) bytes, deflated$/, (most) => zh`压缩后不超过 ${most} 字节的代码`],
  [/^a code that is not damaged$/, () => '完好的代码'],
  [/^at most 10 million items$/, () => '至多 1000 万项'],
  [/^texts whose lengths multiply to at most 10⁹$/, () => '长度之积不超过 10⁹ 的字符串'],
]
const allowed = (text: string): string => found(ALLOWED, text) ?? text

/** What planners must be, and what is refused while they run. */
const RULES: Table = [
  [/^(.+?): .+ is not allowed; it must be left out; known here: (.+)$/s, (field, known) => zh`没有字段 \`${field}\`；可选：${list(known)}`],
  [/^(.+?): nothing is not allowed; it must be (.+)$/s, (field, must) => zh`\`${field}\` 未给出；应为${allowed(must)}`],
  [/^code: "more than (\d+) bytes" is not allowed; it must be (.+)$/, (size, must) => zh`代码超过 ${size} 字节；应为${allowed(must)}`],
  [/^code: "(\d+) bytes" is not allowed; it must be (.+)$/, (size, must) => zh`代码为 ${size} 字节；应为${allowed(must)}`],
  [/^code: "(\d+) characters" is not allowed; it must be (.+)$/, (size, must) => zh`代码为 ${size} 个字符；应为${allowed(must)}`],
  [/^(.+?): (.+) is not allowed; it must be (.+)$/s, (field, is, must) => zh`\`${field}\` 为${value(is)}；应为${allowed(must)}`],
  [/^code: it must be (.+)$/, (must) => zh`代码应为${allowed(must)}`],
  [/^the code must call (`.+`) once; it does so (\d+) times$/, (call, count) => zh`代码应调用一次 ${call}，实际调用 ${count} 次`],
  [/^it registers no planner$/, () => '代码没有注册规划器'],
  [/^the code is refused$/, () => '代码不符合要求'],
  [/^(`.+`) can't be imported: only forage-lab is here$/, (name) => zh`无法导入 ${name}：只能导入 forage-lab`],
  [/^`\*\*=` is not there: write (`.+`)$/, (instead) => zh`不支持 \`**=\`：应写成 ${instead}`],
  [/^put what is before or after `\*\*` in parentheses$/, () => '`**` 前后的表达式应加括号'],
  [/^Math\.random is another one each time: /, () => 'Math.random 每次结果不同：应使用传入 `start` 和 `advance` 的 `random`'],
  [/^(.+): there is too much to go through; it takes (.+)$/, (name, most) => zh`${name}：处理的数据过多；应为${allowed(most)}`],
  [/^(?:it|its code) took longer than (\d+) ms and was stopped$/, (limit) => zh`运行超过 ${limit} ms，已中止`],
  [/^(?:it|its code) took longer than (\d+) ms and could not be stopped$/, (limit) => zh`运行超过 ${limit} ms，且无法中止`],
  [/^it needs more than (\d+) MB$/, (most) => zh`所需内存超过 ${most} MB`],
  [/^it awaits what never comes, or it needs more than (\d+) MB$/, (most) => zh`await 始终未得到结果，或所需内存超过 ${most} MB`],
  [/^its states could not be kept: together they need more than (\d+) MB$/, (most) => zh`状态无法保存：所需内存共超过 ${most} MB`],
  [/^its calls are nested too deeply$/, () => '调用嵌套过深'],
  [/^the interpreter broke down: (.+)$/s, (why) => zh`解释器出错：${said(why)}`],
  [/^(.+) takes a list of numbers, not (.+)$/, (what, is) => zh`${call(what)}：应为数值列表，实际为${value(is)}`],
  [/^(.+) takes a list of points(?: \[x, y\])?, not (.+)$/, (what, is) => zh`${call(what)}：应为点 [x, y] 的列表，实际为${value(is)}`],
  [
    /^(.+): number (\d+) is not a number \(NaN\): /,
    (what, at) => zh`${call(what)}：第 ${at} 项（从 0 起）是 NaN：某个参与计算的量可能没有值`,
  ],
  [/^(.+): point (\d+) is no \[x, y\]$/, (what, at) => zh`${call(what)}：第 ${at} 项（从 0 起）不是点 [x, y]`],
  [/^(.+): point (\d+) is not a number \(NaN\)$/, (what, at) => zh`${call(what)}：第 ${at} 个点（从 0 起）含 NaN`],
  [/^(.+): there is no layer "(.*)"; known: (.*)$/, (what, name, known) => zh`${call(what)}：没有图层“${name}”；可选：${list(known)}`],
  [/^the state is (.+): it must be an object$/, (is) => zh`状态为${value(is)}；应为对象`],
  [
    /^(.+) is nested deeper than (\d+) levels, or holds itself: (.+)$/,
    (at, most, rule) => zh`${at} 的嵌套超过 ${most} 层或包含自身：${said(rule)}`,
  ],
  [/^(.+) is (a .+): (a state is made of .+)$/, (at, is, rule) => zh`${at} 为${value(is)}：${said(rule)}`],
  [/^a state is made of /, () => '状态只能由数值、字符串、true、false、null、列表、类型化数组和普通对象组成'],
]

/** What checks find. */
const FINDINGS: Table = [
  [/^two starts with one seed have different states: /, () => '随机种子相同，初始状态却不同：使用了 `random` 以外的随机来源'],
  [/^after (\d+) iterations two runs with one seed differ$/, (n) => zh`随机种子相同的两次运行在 ${n} 次迭代后不同`],
  [/^(\d+) steps at once lead elsewhere than \d+ single ones$/, (n) => zh`连续执行 ${n} 次迭代与逐次执行所得状态不同`],
  [/^back at iteration (\d+) the state is another one: /, (k) => zh`后退到第 ${k} 次迭代时状态不同：有数据保存在状态之外`],
  [/^with a second run under way a run goes another way: /, () => '同时进行另一次运行时，结果发生变化：两次运行共用了数据'],
  [/^a link of the run leads to another state$/, () => '打开运行的链接所得状态不同'],
  [/^in iteration (\d+) the best cost rises from (.+) to (.+)$/, (k, a, b) => zh`第 ${k} 次迭代的迄今最优代价从 ${a} 升高到 ${b}`],
  [/^the run ends with a fault: (.+)$/s, (why) => zh`运行因出错而结束：${said(why)}`],
  [/^after (\d+) iterations there is no best solution$/, (n) => zh`${n} 次迭代后仍没有最优解`],
  [/^the cost is said to be (.+); it is (.+)$/, (given, real) => zh`代码给出的代价为 ${given}，实际为 ${real}`],
  [/^`draw`, `best`, `explain` or a reading changes the state$/, () => '`draw`、`best`、`explain` 或某个指标改变了状态'],
  [/^the reading (`.+`) is no number$/, (name) => zh`指标 ${name} 不是数值`],
  [/^with (\S+) = (.+?) the run ends with a fault: (.+)$/s, (name, end, why) => zh`${name} = ${end} 时运行因出错而结束：${said(why)}`],
  [/^with iterations = (\d+) it takes (\d+)$/, (given, taken) => zh`iterations = ${given} 时执行了 ${taken} 次迭代`],
]

/** What the interpreter says of a code, and browsers where it runs at full speed. */
const ENGINE: Table = [
  [/^'?([\w$]+)'? is not defined$/, (name) => zh`\`${name}\` 未定义`],
  [/^Can't find variable: (.+)$/, (name) => zh`\`${name}\` 未定义`],
  [/^(?:lexical variable is not initialized|Cannot access uninitialized variable\.)$/, () => '变量在声明之前使用'],
  [/^([\w$]+) is not initialized$/, (name) => zh`变量 \`${name}\` 在声明之前使用`],
  [/^(?:Cannot access|can't access lexical declaration) '(.+)' before initialization/, (name) => zh`变量 \`${name}\` 在声明之前使用`],
  [/^cannot (?:read|set) property of (undefined|null)$/, (of) => zh`${of} 没有属性`],
  [/^cannot read property 'Symbol.iterator' of (undefined|null)$/, (of) => zh`${of} 不可迭代，应为列表等`],
  [/^cannot read property '(.+)' of (undefined|null)$/, (name, of) => zh`无法读取 ${of} 的属性 \`${name}\``],
  [/^cannot set property '(.+)' of (undefined|null)$/, (name, of) => zh`无法设置 ${of} 的属性 \`${name}\``],
  [/^Cannot read properties of (undefined|null) \(reading '(.+)'\)$/, (of, name) => zh`无法读取 ${of} 的属性 \`${name}\``],
  [/^Cannot set properties of (undefined|null) \(setting '(.+)'\)$/, (of, name) => zh`无法设置 ${of} 的属性 \`${name}\``],
  [/^can't access property "(.+)", (.+) is (undefined|null)$/, (name, of, is) => zh`\`${of}\` 为 ${is}，无法访问属性 \`${name}\``],
  [/^(undefined|null) is not an object \(evaluating '(.+)'\)$/, (is, where) => zh`\`${where}\` 访问了 ${is} 的属性`],
  [/^not a function$/, () => '调用的不是函数'],
  [/^(\S+) is not a function(?:\. \(.+)?$/, (name) => zh`\`${name}\` 不是函数`],
  [/^not a constructor$/, () => 'new 后面不是构造函数'],
  [/^(\S+) is not a constructor$/, (name) => zh`\`${name}\` 不是构造函数`],
  [/^(?:value|(?:object )?(?:undefined|null)) is not iterable/, () => '该值不可迭代，应为列表等'],
  [/^(\S+) is not iterable$/, (name) => zh`\`${name}\` 不可迭代，应为列表等`],
  [/^'(.+)' is read-only$/, (name) => zh`\`${name}\` 只读，不能修改`],
  [/^Cannot assign to read only property '(.+)' of /, (name) => zh`属性 \`${name}\` 只读，不能修改`],
  [/^(?:Assignment to constant variable|Attempted to assign to readonly property)\.$/, () => '常量或只读属性不能修改'],
  [/^invalid assignment to const '(.+)'$/, (name) => zh`常量 \`${name}\` 不能修改`],
  [/^object is not extensible$|^Cannot add property .+, object is not extensible$/, () => '该对象不能增加属性'],
  [/^(?:Maximum call stack size exceeded\.?|stack overflow|too much recursion)$/, () => '调用嵌套过深'],
  [
    /^(?:cannot convert to object|Cannot convert undefined or null to object|null or undefined are forbidden)$/,
    () => '需要对象，实际没有值',
  ],
  [/^cannot convert (\w+) to (\w+)$/, (from, to) => zh`${from} 不能转换为 ${to}`],
  [/^cannot convert to BigInt: not an integer$/, () => '只有整数能转换为 BigInt'],
  [/^not an object$/, () => '该值不是对象'],
  [/^not an? (number|string|boolean|symbol)$/, (type) => zh`该值不是 ${type} 类型`],
  [/^(?:must be called with new|(?:class )?constructors? (?:requires|must be invoked with) 'new')$/i, () => '构造函数应使用 new 调用'],
  [/^(?:empty array|Reduce of empty array with no initial value)$/, () => '空数组没有初值，不能归约'],
  [/^out of memory/, () => '内存不足'],
  [/^circular reference$/, () => '对象循环引用自身'],
  [/^invalid '(in|instanceof)' (?:right )?operand$/, (name) => zh`${name} 的右侧操作数无效`],
  [/^invalid (?:typed )?array (?:buffer )?length$/i, () => '数组长度无效'],
  [/^invalid array index$/, () => '数组下标无效'],
  [/^invalid string length$|^string too long$/i, () => '字符串过长'],
  [/^invalid repeat count$/, () => '重复次数无效'],
  [/^invalid number of digits$/, () => '位数无效'],
  [/^unexpected token in expression: ''$|^Unexpected end of (?:JSON )?input$|^unexpected end$/, () => '代码或字符串在此意外结束'],
  [/^unexpected token(?: in expression)?:? '(.+)'$/i, (token) => zh`此处不应有 \`${token}\``],
  [/^unexpected '(await|yield)' keyword$/, (word) => zh`此处不应有 \`${word}\``],
  [/^unexpected character$|^invalid first character of private name$/, () => '此处有无效字符'],
  [/^unexpected end of (string|comment|regexp)$/, (what) => `${{ string: '字符串', comment: '注释' }[what] ?? '正则表达式'}没有结束`],
  [/^expecting '([!-~])'$/, (sign) => zh`此处应为 \`${sign}\``],
  [/^expecting catch or finally$/, () => 'try 之后应有 catch 或 finally'],
  [/^expecting (?:field|property) name$|^invalid (?:property|field|method) name$/, () => '此处应为属性名'],
  [/^expecting '/, () => '此处缺少关键字或符号'],
  [/^(?:identifier|variable name) expected$/, () => '此处应为变量名'],
  [/^function name expected$/, () => '此处应为函数名'],
  [/^class statement requires a name$/, () => '此处应为类名'],
  [/^(?:string|from clause) expected$|^invalid (?:import binding|export syntax)$/, () => 'import 或 export 的写法无效'],
  [/^redeclaration of '(.+)'$/, (name) => zh`变量 \`${name}\` 重复声明`],
  [/^invalid redefinition of .+$/, () => '名称重复声明'],
  [/^missing initializer for (?:const )?variable$/, () => 'const 声明缺少初值'],
  [/^invalid assignment (?:left-hand side|syntax)$|^invalid lvalue in strict mode$/, () => '等号左侧不能赋值'],
  [/^invalid increment\/decrement operand$/, () => '`++` 和 `--` 只能用于变量'],
  [/^invalid destructuring target$/, () => '解构的目标无效'],
  [/^rest element must be the last one$|^assignment rest property must be last$/, () => '`...` 应是最后一项'],
  [/^return not in a function$/, () => 'return 不在函数中'],
  [/^break must be inside loop or switch$/, () => 'break 不在循环或 switch 中'],
  [/^continue must be inside loop$/, () => 'continue 不在循环中'],
  [/^invalid switch statement$/, () => 'switch 中应为 case 或 default'],
  [/^expected 'of' or 'in' in for control expression$/, () => 'for 的括号内缺少 of、in 或分号'],
  [/^'(.+)' is a reserved identifier$/, (word) => zh`\`${word}\` 是保留字`],
  [/^(?:unsupported|invalid) keyword: (.+)$/, (word) => zh`不支持 \`${word}\``],
  [/^invalid (?:variable|argument|function) name in strict (?:mode|code)$/, () => '该名称不能使用'],
  [/^invalid number literal$/, () => '数值的写法无效'],
  [/^octal literals are deprecated in strict mode$/, () => '整数不能以 0 开头'],
  [/^missing formal parameter$/, () => '缺少形式参数'],
  [/^duplicate (?:argument|parameter) names not allowed in this context$/, () => '形式参数重名'],
  [/^cannot delete a direct reference in strict mode$/, () => 'delete 不能用于变量'],
  [/^cannot mix \?\? with && or \|\|$/, () => '`??` 与 `&&` 或 `||` 混用时应加括号'],
  [/^unparenthesized unary expression can't appear on the left-hand side of '\*\*'$/, () => '`**` 左侧带正负号的表达式应加括号'],
  [/^(\w+) declarations can't appear in single-statement context$/, () => '声明应写在花括号内'],
  [/^Could not find export '(.+)' in module '(.+)'$/, (name, from) => zh`${from} 没有导出 \`${name}\``],
  [/^exported variable '(.+)' does not exist$/, (name) => zh`导出的变量 \`${name}\` 不存在`],
  [/^could not load module '(.+)'$/, (name) => zh`无法导入 \`${name}\``],
  [/^invalid regular expression flags$/, () => '正则表达式的标志无效'],
  [/^nothing to repeat$/, () => '正则表达式的量词前没有内容'],
]

/** Where it is, and what kind of error. */
const AROUND: Table = [
  [/^(.+) \(line (\d+)\)$/s, (what, line) => `${said(what)}（第 ${line} 行）`],
  [/^(\w*Error): (.+)$/s, (name, what) => `${name}: ${said(what)}`],
]

/** What is said in front of such a text, or quotes it. */
const QUOTES: Table = [
  [/^code: (.+)$/s, (what) => `代码：${said(what)}`],
  [/^([^“]*\p{Script=Han}[^“]*“)(.+)(”.*)$/su, (before, what, after) => `${before}${said(what)}${after}`],
]

const TABLES = [AROUND, RULES, FINDINGS, ENGINE, QUOTES]

function said(message: string): string {
  for (const table of TABLES) {
    const told = found(table, message)
    if (told !== undefined) return told
  }
  return message
}

const CHECKS: Readonly<Record<string, string>> = {
  'it starts': '能够启动',
  'the same seed is the same run': '随机种子相同，运行也相同',
  'many steps at once are single steps': '连续执行与逐次执行结果相同',
  'the way back leads to the same states': '后退时回到相同的状态',
  'another run at the same time changes nothing': '同时进行的另一次运行不影响结果',
  'a link opens the same state': '打开链接得到相同的状态',
  'the best cost never rises': '迄今最优代价从不升高',
  'a run has a result, and no fault': '运行有结果且不出错',
  'the cost is that of the solution': '代价与解相符',
  'looking changes nothing': '查看不改变状态',
  'readings are numbers': '指标均为数值',
  'parameters run at both ends': '参数取范围两端的值时均能运行',
  'it stops when it should': '达到迭代次数时停止',
}

export const code: Translated<typeof English.code> = {
  said,
  starts: /^planner .*应为可启动的规划器（代码出错：(.+)）$/s,
  check: (name) => CHECKS[name] ?? name,
}
