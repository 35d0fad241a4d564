#!/usr/bin/env node
// Fills the generated blocks of README.md and docs/*.md from the catalogue and from the reproduction, writes the TypeScript types
// of the Rust types, and checks all of it.
//
//   node scripts/docs.mjs           writes blocks and types
//   node scripts/docs.mjs --check   exits 1 and names each stale block or type, broken link and command that does not exist
//
// A block stands between `<!-- generated: NAME ARGUMENT -->` and `<!-- /generated -->`; BLOCKS below lists the names.
// The program is $FORAGE, or target/debug/forage.
import { execFileSync } from 'node:child_process'
import { existsSync, readdirSync, readFileSync, writeFileSync } from 'node:fs'
import { basename, dirname, join, relative, resolve } from 'node:path'
import { fileURLToPath } from 'node:url'
import { machine, results } from './results.mjs'

const root = fileURLToPath(new URL('..', import.meta.url))
const program = resolve(root, process.env.FORAGE ?? 'target/debug/forage')
const README_LINES = 120

const read = (path) => readFileSync(join(root, path), 'utf8')
const cache = new Map()
/** What the program prints, asked for once. */
function forage(...args) {
  const key = args.join(' ')
  if (!cache.has(key)) cache.set(key, execFileSync(program, args, { encoding: 'utf8', maxBuffer: 1e8, stdio: ['ignore', 'pipe', 'pipe'] }))
  return cache.get(key)
}
const catalogue = () =>
  cache.has('catalogue') ? cache.get('catalogue') : cache.set('catalogue', JSON.parse(forage('list', '--json'))).get('catalogue')

// ---------------------------------------------------------------- Markdown

const KINDS = { function: 'test function', discs: 'discs', grid: 'grid', tour: 'tour', arm: 'arm' }
const FAMILIES = {
  swarm: ['Particle swarms', 'Particles share what they found: each learns from its personal best and from the global best.'],
  ants: ['Ant colonies', 'Ants walk from cell to cell. Short paths gather pheromone, and pheromone attracts later ants.'],
  search: ['Grid searches', 'They expand cells by increasing cost. `dijkstra` and `a-star` are exact between cells.'],
  tour: ['Tours', 'They order many stops. On a grid another planner first finds the pairwise paths.'],
  tree: ['Random trees', 'A tree grows toward random samples, in the plane, in space or in the joints of an arm.'],
  dynamic: ['Moving obstacles', 'A robot drives in simulated time. It predicts conflicts and takes a detour, replans, waits or evades.'],
  tuning: ['Parameter tuning', 'A planner whose particles are the parameters of another planner.'],
}
const family = (name) => FAMILIES[name] ?? [name, '']
/** For the Chinese README. */
const CHINESE = {
  families: {
    swarm: '群体算法',
    ants: '蚁群',
    search: '图搜索',
    tour: '巡回路线',
    tree: '随机树',
    dynamic: '动态路径规划',
    tuning: '参数优化',
  },
  heads: { families: ['类别', '规划器'], claims: ['论文', '论断数', '成立', '不成立', '未定'] },
  all: '合计',
}

const escaped = (text) =>
  String(text)
    .replace(/([\\*_|`])/g, '\\$1')
    .replaceAll('<', '&lt;')
    .replaceAll('\n', ' ')
const code = (text) => `\`${text}\``

function table(heading, rows) {
  const line = (cells) => `| ${cells.map((cell) => (cell === '' ? ' ' : cell)).join(' | ')} |`
  return [line(heading), line(heading.map(() => '---')), ...rows.map(line)].join('\n')
}

const byFamily = (planners) =>
  Map.groupBy
    ? [...Map.groupBy(planners, (p) => p.family)]
    : [...planners.reduce((m, p) => m.set(p.family, [...(m.get(p.family) ?? []), p]), new Map())]

// ---------------------------------------------------------------- Parameters

function allowed({ type, min, max, options }) {
  const number = (x) => (x !== 0 && Math.abs(x) < 1e-12 ? String(x) : x.toLocaleString('en-US', { maximumFractionDigits: 12 }))
  switch (type) {
    case 'integer':
      return `integer, ${number(min)} to ${number(max)}`
    case 'number':
      return `${number(min)} to ${number(max)}`
    case 'flag':
      return 'true, false'
    case 'choice':
      return options.map(({ value }) => code(value)).join(', ')
    case 'subset':
      return `any of ${options.map(({ value }) => code(value)).join(', ')}`
    default:
      throw new Error(`unknown type of parameter: ${type}`)
  }
}

function defaults({ default: value, defaults: others = {}, kinds = [] }) {
  const groups = new Map()
  for (const kind of kinds.length ? kinds : Object.keys(KINDS)) {
    const own = String(others[kind] ?? value)
    groups.set(own, [...(groups.get(own) ?? []), KINDS[kind] ?? kind])
  }
  if (groups.size <= 1) return code([...groups.keys()][0] ?? value)
  return [...groups].map(([own, on]) => `${code(own)} (${on.join(', ')})`).join(', ')
}

function parameters(list, planner) {
  const rows = list.map((parameter) => {
    const { name, help, when, kinds = [], options = [] } = parameter
    const only = []
    if (planner && kinds.length && kinds.length < planner.kinds.length)
      only.push(`on ${kinds.map((kind) => KINDS[kind] ?? kind).join(', ')}`)
    if (when) only.push(`with ${code(`${when.parameter}=${when.value}`)}`)
    const choices = options
      .filter(({ help }) => help)
      .map(({ value, help }) => ` ${code(value)}: ${escaped(help)}`)
      .join('')
    return [
      code(name),
      defaults(parameter),
      allowed(parameter),
      `${escaped(help)}${choices}${only.length ? ` Only ${only.join(' and ')}.` : ''}`,
    ]
  })
  return table(['parameter', 'default', 'allowed', 'meaning'], rows)
}

/** The centre bias of a planner; nothing for planners that were not measured. */
function centreBias({ centre_bias: bias }) {
  if (!bias) return ''
  const shown = ({ value, from, to }) => `${value.toFixed(2)} (${from.toFixed(2)} to ${to.toFixed(2)})`
  const shifted = `shifting the minimum away from the centre of the search box multiplies the gap by ${shown(bias.shifted)}`
  const random = bias.random_search.value.toFixed(2)
  return `[Centre bias](benchmarks.md#centre-bias): ${shifted} (random search: ${random}), rotating the axes by ${shown(bias.rotated)}.\n\n`
}

function reference() {
  const { planners, drive, motion } = catalogue()
  const parts = byFamily(planners).map(([name, group]) => {
    const sections = group.map(
      (p) =>
        `### ${p.name}\n\n${escaped(p.title)}. ${escaped(p.summary)} Source: ${escaped(p.source)}.${p.evaluation ? ` An evaluation is ${p.evaluation}.` : ''}\n\n${centreBias(p)}${parameters(p.parameters, p)}`,
    )
    return `## ${family(name)[0]}\n\n${sections.join('\n\n')}`
  })
  parts.push(
    `## Driving simulation\n\n${escaped(drive.summary)} Set with \`--drive-set\`. Source: ${escaped(drive.source)}.\n\n${parameters(drive.parameters)}`,
  )
  parts.push(
    `## Arm motion\n\n${escaped(motion.summary)} Set with \`--motion-set\`. Source: ${escaped(motion.source)}.\n\n${parameters(motion.parameters)}`,
  )
  return parts.join('\n\n')
}

// ---------------------------------------------------------------- Reproduction

/** Rows of a CSV file as objects. */
function csv(text) {
  const rows = [[]]
  let cell = ''
  let quoted = false
  for (let i = 0; i < text.length; i++) {
    const c = text[i]
    if (quoted) {
      if (c === '"' && text[i + 1] === '"') cell += text[++i]
      else if (c === '"') quoted = false
      else cell += c
    } else if (c === '"') quoted = true
    else if (c === ',' || c === '\n') {
      rows.at(-1).push(cell)
      cell = ''
      if (c === '\n') rows.push([])
    } else if (c !== '\r') cell += c
  }
  const [names, ...records] = rows.filter((row) => row.length > 1)
  return records.map((record) => Object.fromEntries(names.map((name, k) => [name, record[k] ?? ''])))
}

const figures = () => csv(read('REPRODUCTION.csv'))
const VALUES = ['same digits', 'no significant difference', 'same power of ten', 'differs']
const IMPOSSIBLE = 'impossible as printed'

/** How many figures of each paper have which mark. */
function marks() {
  const rows = figures()
  const unknown = rows.find(({ value }) => value !== '' && !VALUES.includes(value))
  if (unknown) throw new Error(`REPRODUCTION.csv: unknown mark ${unknown.value}`)
  const count = (of) => [
    ...VALUES.map((mark) => String(of.filter(({ value }) => value === mark).length)),
    String(of.filter(({ source }) => source === IMPOSSIBLE).length),
  ]
  const papers = [...new Set(rows.map(({ paper }) => paper))]
  return table(
    ['paper', 'figures', ...VALUES, IMPOSSIBLE],
    [
      ...papers.map((paper) => {
        const of = rows.filter((row) => row.paper === paper)
        return [`[${paper}]`, String(of.length), ...count(of)]
      }),
      ['all', String(rows.length), ...count(rows)],
    ],
  )
}

const significant = (text) =>
  text
    .replace(/e.*$/i, '')
    .replace(/[^0-9.]/g, '')
    .replace('.', '')
    .replace(/^0+/, '').length
/** A computed number with as many digits as the published one, four at least, seven at most. */
function digits(text, published) {
  if (text === '') return ''
  const x = Number(text)
  if (!Number.isFinite(x)) return text
  if (Number.isInteger(x) && Math.abs(x) < 1e6) return String(x)
  const n = Math.min(7, Math.max(4, significant(published)))
  const shown = x.toPrecision(n)
  if (Math.abs(x) < 1e-4 || Math.abs(x) >= 1e7) return x.toExponential(n - 1)
  return shown.includes('e') ? String(Number(shown)) : shown
}

function reproduction(name) {
  const rows = figures().filter((row) => row.reproduction === name)
  if (!rows.length) throw new Error(`REPRODUCTION.csv has no rows of ${name}`)
  const tables = [...new Set(rows.map((row) => row.table))].map((title) => {
    const of = rows.filter((row) => row.table === title)
    const columns = [
      ['row', (r) => escaped(r.row)],
      ['measure', (r) => escaped(r.measure)],
      ['published best', (r) => r.published_best],
      ['published mean', (r) => r.published_mean],
      ['published std', (r) => digits(r.published_std, '')],
      ['best', (r) => digits(r.best, r.published_best)],
      ['mean', (r) => digits(r.mean, r.published_mean)],
      ['std', (r) => digits(r.std, '')],
      ['runs', (r) => r.runs],
      ['value', (r) => r.value],
      ['ranking', (r) => r.ranking],
      ['basis', (r) => r.basis],
      ['source', (r) => r.source],
    ].filter(([, cell]) => of.some((row) => cell(row) !== ''))
    return `**${escaped(title)}**\n\n${table(
      columns.map(([heading]) => heading),
      of.map((row) => columns.map(([, cell]) => cell(row))),
    )}`
  })
  return tables.join('\n\n')
}

const CLAIM_MARKS = ['upheld', 'refuted', 'undecided']

/** A paper's claims with their marks; without a paper, how many of each have which mark, in Chinese for `zh`. */
function claims(paper) {
  const { papers, claims: all } = JSON.parse(read('REPRODUCTION.claims.json'))
  const count = (of) => [of.length, ...CLAIM_MARKS.map((mark) => of.filter((claim) => claim.mark === mark).length)].map(String)
  if (paper === undefined || paper === 'zh') {
    const [head, whole] = paper === 'zh' ? [CHINESE.heads.claims, CHINESE.all] : [['paper', 'claims', ...CLAIM_MARKS], 'all']
    return table(head, [
      ...papers.map(({ tag }) => [`[${tag}]`, ...count(all.filter((claim) => claim.paper === tag))]),
      [whole, ...count(all)],
    ])
  }
  const mine = all.filter((claim) => claim.paper.toLowerCase() === paper)
  if (!mine.length) throw new Error(`REPRODUCTION.claims.json has no claims of ${paper}`)
  return table(
    ['claim', 'mark', 'why'],
    mine.map(({ id, says, mark, because }) => [`${id}: ${escaped(says)}`, mark, escaped(because)]),
  )
}

/** The names that `forage reproduce` knows, from its help. */
function reproductions() {
  const [, names] = forage('reproduce', '--help').split(/^Names:\n/m)
  if (!names) throw new Error('forage reproduce --help lists no names')
  const rows = []
  for (const line of names.split('\n')) {
    const item = line.match(/^ {2}([a-z][a-z0-9-]*) {2,}(.*)$/)
    if (item) rows.push([item[1], item[2].trim()])
    else if (line.trim() && rows.length && line.startsWith('  ')) rows.at(-1)[1] += ` ${line.trim()}`
    else if (line.trim()) break
  }
  return table(
    ['name', 'what it repeats'],
    rows.map(([name, what]) => [code(name), escaped(what)]),
  )
}

// ---------------------------------------------------------------- Blocks

const measured = () => JSON.parse(read('docs/benchmarks.json'))

const BLOCKS = {
  /** Planners by family, one line a family; in Chinese for `zh`. */
  families(language) {
    const named = (name) => (language === 'zh' ? (CHINESE.families[name] ?? name) : family(name)[0])
    return table(
      language === 'zh' ? CHINESE.heads.families : ['family', 'planners'],
      byFamily(catalogue().planners).map(([name, group]) => [
        named(name),
        group.map((p) => `[${code(p.name)}](docs/reference.md#${p.name})`).join(' '),
      ]),
    )
  },
  /** Planners by family with title, summary and source. */
  planners() {
    const kinds = (p) => p.kinds.map((kind) => KINDS[kind] ?? kind).join(', ')
    const rows = (group) =>
      group.map((p) => [
        `[${code(p.name)}](reference.md#${p.name})`,
        `**${escaped(p.title)}.** ${escaped(p.summary)}`,
        kinds(p),
        escaped(p.source),
      ])
    return byFamily(catalogue().planners)
      .map(
        ([name, group]) =>
          `## ${family(name)[0]}\n\n${family(name)[1]}\n\n${table(['planner', 'what it does', 'scenes', 'source'], rows(group))}`,
      )
      .join('\n\n')
  },
  reference,
  /** Shipped scenes by kind. */
  scenes() {
    return table(
      ['scene', 'kind', 'title', 'source'],
      catalogue().scenes.map((s) => [code(s.name), s.kind, escaped(s.title), escaped(s.source ?? '')]),
    )
  },
  /** Generators with their parameters. */
  generators() {
    return catalogue()
      .generators.map((g) => `### ${g.name}\n\n${escaped(g.title)}. ${escaped(g.help)}\n\n${parameters(g.parameters)}`)
      .join('\n\n')
  },
  /** Subcommands with their help in a line. */
  commands() {
    return table(
      ['command', 'what it does'],
      subcommands()
        .filter(([name]) => name !== 'help')
        .map(([name, help]) => [code(`forage ${name}`), escaped(help)]),
    )
  },
  /** What a command prints, without the elapsed time. */
  output(...args) {
    const printed = forage(...args)
      .trimEnd()
      .replace(/, [\d.,]+ ?(?:ms|s)$/m, '')
    return `\`\`\`text\n${printed}\n\`\`\``
  },
  marks,
  reproduction,
  claims,
  reproductions,
  /** What a suite of benchmarks came to. */
  results: (suite) =>
    results(measured(), suite, (columns, rows) =>
      table(
        columns.map(escaped),
        rows.map((row) => row.map(escaped)),
      ),
    ),
  machine: () => machine(measured()),
}

const BLOCK = /^(<!-- generated: ([a-z-]+)((?: [a-z0-9-]+)*) -->\n)([\s\S]*?)^(<!-- \/generated -->)$/gm

/** A page's text with its blocks filled, and the names of those that changed. */
function filled(path, text) {
  const stale = []
  const out = text.replace(BLOCK, (_, open, name, rest, old, close) => {
    const make = BLOCKS[name]
    if (!make) throw new Error(`${path}: no block is called ${name}`)
    const now = `${make(...rest.trim().split(' ').filter(Boolean))}\n`
    if (now !== old) stale.push(`${name}${rest}`)
    return open + now + close
  })
  const opened = text.match(/^<!-- generated: /gm)?.length ?? 0
  if (opened !== (text.match(BLOCK)?.length ?? 0)) throw new Error(`${path}: a generated block is not closed`)
  return { out, stale }
}

// ---------------------------------------------------------------- Checks: links

const withoutCode = (text) => text.replace(/^(```|~~~)[\s\S]*?^\1/gm, '').replace(/`[^`\n]*`/g, '')

function anchors(text) {
  const seen = new Map()
  const headings = text.replace(/^(```|~~~)[\s\S]*?^\1/gm, '').matchAll(/^#{1,6} +(.+?)(?: +#+)?$/gm)
  return new Set(
    [...headings].map(([, heading]) => {
      const plain = heading
        .replace(/\[([^\]]*)\]\([^)]*\)/g, '$1')
        .replace(/[`*\\]/g, '')
        .trim()
      const slug = plain
        .toLowerCase()
        .replace(/[^\p{L}\p{N}\s_-]/gu, '')
        .replace(/\s/g, '-')
      const n = seen.get(slug) ?? 0
      seen.set(slug, n + 1)
      return n ? `${slug}-${n}` : slug
    }),
  )
}

function* brokenLinks(path, text, chapters) {
  const plain = withoutCode(text)
  const targets = [
    ...plain.matchAll(/\]\(<?([^)\s>]+)>?(?: "[^"]*")?\)/g),
    ...plain.matchAll(/^\[[^\]]+\]: +(\S+)(?: +["(].*)?$/gm),
    ...plain.matchAll(/<(?:img|source)[^>]*?(?:src|srcset)="([^"]+)"/g),
  ]
  for (const [, target] of targets) {
    if (/^[a-z][a-z0-9+.-]*:/i.test(target)) continue
    const [file, anchor] = target.split('#')
    const found = file === '' ? path : relative(root, resolve(root, dirname(path), decodeURI(file)))
    if (!existsSync(join(root, found))) yield `${path}: ${target} does not exist`
    else if (path.startsWith('docs/') && !found.startsWith('docs/'))
      yield `${path}: ${target} leaves the book; name the file in code style instead`
    else if (path.startsWith('docs/') && found.endsWith('.md') && !chapters.has(found) && found !== path)
      yield `${path}: ${target} is not in docs/SUMMARY.md`
    else if (anchor && found.endsWith('.md') && !anchors(read(found)).has(anchor)) yield `${path}: ${target}: there is no such heading`
  }
}

/** Paths of the repository that a page names and that do not exist. Built files, and a user's `mine`, need not. */
function* missingFiles(path, text) {
  const named = [...text.matchAll(/(?<![\w./-])(?:src|crates|scripts|tests|docs|scenes|benches|examples|package|www)\/[\w./*-]*/g)]
  for (const file of new Set(named.map(([file]) => file.replace(/[.,]$/, '')))) {
    if (!/[*A-Z]{2,}|\*|\bmine\b/.test(file) && !existsSync(join(root, file))) yield `${path}: ${file} does not exist`
  }
}

// ---------------------------------------------------------------- Checks: commands

/** Name and help of each subcommand. */
function subcommands(...of) {
  const [, list = ''] = forage(...of, '--help').split(/^(?:Commands|Suites):\n/m)
  const rows = []
  for (const line of list.split('\n')) {
    const item = line.match(/^ {2}([a-z][a-z-]*) {2,}(.*)$/)
    if (item) rows.push([item[1], item[2].trim()])
    else if (line.startsWith('    ') && rows.length) rows.at(-1)[1] += ` ${line.trim()}`
    else break
  }
  return rows
}

/** The options of a subcommand, and whether each takes a value. */
function options(...names) {
  const known = new Map()
  for (const [, option, value] of forage(...names, '--help').matchAll(/^ {2,}(?:-\w, )?(--[a-z][a-z-]*)( [<[])?/gm))
    known.set(option, Boolean(value))
  return known
}

/** The words of a command up to a comment, a pipe or a redirection. */
function words(line) {
  const out = []
  for (const [, double, single, bare] of line.matchAll(/"((?:[^"\\]|\\.)*)"|'([^']*)'|([^\s"']+)/g)) {
    if (bare !== undefined && (bare.startsWith('#') || /^(\||>>?|<|&&|;|2>)/.test(bare))) break
    out.push(double ?? single ?? bare)
  }
  return out
}

/** The command lines of a page: those of its blocks, and those in code style in its text. */
function* commands(text) {
  for (const [, language, body] of text.matchAll(/^```([a-z]*)\n([\s\S]*?)^```/gm)) {
    if (!['', 'sh', 'bash', 'shell', 'console', 'text'].includes(language)) continue
    for (const line of body.replace(/\\\n\s*/g, ' ').split('\n')) {
      const command = line.match(/^\s*(?:\$ )?(?:[A-Z_]+=\S+ )*(?:\S*\/)?(forage(?: .*)?)$/)
      if (command) yield command[1]
    }
  }
  const prose = text.replace(/^```[\s\S]*?^```/gm, '')
  for (const [, command, indented] of prose.matchAll(/`(forage [^`]+)`|^ {4}(forage .*)$/gm)) yield command ?? indented
}

const isPlaceholder = (word) => /^[A-Z][A-Z0-9_.-]*(\.[a-z]+)?$/.test(basename(word)) || /[…*$<{]/.test(word)
const looksLikeFile = (word) => /\.(json|map|scen|yaml|yml|pgm|tsp|tour|csv|toml)$/.test(word)

/** A file that `forage convert` or `--out` writes, and those that come with it. */
function companions(file) {
  const stem = file.replace(/\.[a-z]+$/, '')
  return [file, ...(file.endsWith('.tsp') ? [`${stem}.tour`, `${stem}.opt.tour`] : []), ...(file.endsWith('.map') ? [`${stem}.scen`] : [])]
}

function* wrongCommands(path, text) {
  const known = new Map(subcommands())
  const { planners, scenes, generators } = catalogue()
  const written = new Set()
  for (const [, from, to] of text.matchAll(/^cp (\S+) (\S+)$/gm)) {
    if (existsSync(join(root, from))) written.add(to === '.' ? basename(from) : to)
    else yield `${path}: cp ${from} ${to}: ${from} is not in the repository`
  }
  const missing = (file) => looksLikeFile(file) && !isPlaceholder(file) && !written.has(file) && !existsSync(join(root, file))
  for (const command of commands(text)) {
    const [, name, ...rest] = words(command)
    const wrong = (what) => `${path}: ${command}: ${what}`
    if (name === undefined || isPlaceholder(name)) continue
    if (name.startsWith('-')) {
      if (!forage('--help').includes(name)) yield wrong(`there is no option ${name}`)
      continue
    }
    if (!known.has(name)) {
      yield wrong(`there is no subcommand ${name}`)
      continue
    }
    const under = subcommands(name).map(([one]) => one)
    if (under.length && rest.length && !rest[0].startsWith('-') && !isPlaceholder(rest[0]) && !under.includes(rest[0])) {
      yield wrong(`${name} has no subcommand ${rest[0]}`)
      continue
    }
    const takes = options(name, ...(under.includes(rest[0]) ? [rest.shift()] : []))
    const positional = []
    const set = []
    const inputs = []
    for (let i = 0; i < rest.length; i++) {
      const [option, inline] = rest[i].split(/=(.*)/s)
      if (!option.startsWith('--') || option === '--') {
        positional.push(rest[i])
        continue
      }
      if (!takes.has(option)) yield wrong(`there is no option ${option}`)
      const value = inline ?? (takes.get(option) ? rest[++i] : undefined)
      if (option === '--set' && value) set.push(value.split('=')[0])
      if (option === '--scene' && value) inputs.push(value)
      if (option === '--out' && value) for (const file of companions(value)) written.add(file)
    }
    const isLink = (word) => word.includes('#v=')
    const [first] = positional
    if (name === 'run' || name === 'suggest') {
      const planner = planners.find((p) => p.name === first)
      if (first && !planner && !isPlaceholder(first) && !isLink(first)) yield wrong(`there is no planner ${first}`)
      const strange = planner && set.find((parameter) => !isPlaceholder(parameter) && !planner.parameters.some((p) => p.name === parameter))
      if (strange) yield wrong(`${first} has no parameter ${strange}`)
    }
    if (name === 'generate' && first && !isPlaceholder(first)) {
      const generator = generators.find((g) => g.name === first)
      if (!generator) yield wrong(`there is no generator ${first}`)
      const strange = generator && set.find((parameter) => !generator.parameters.some((p) => p.name === parameter))
      if (strange) yield wrong(`${first} has no parameter ${strange}`)
    }
    if (name === 'reproduce' && first && !isPlaceholder(first) && !forage('reproduce', '--help').includes(`  ${first} `))
      yield wrong(`there is no reproduction ${first}`)
    if (name === 'experiment' && first) inputs.push(first)
    if (name === 'convert') {
      inputs.push(...positional.slice(0, -1))
      if (positional.length > 1) for (const file of companions(positional.at(-1))) written.add(file)
    }
    for (const input of inputs) {
      if (missing(input)) yield wrong(`${input} is not in the repository, and no command above writes it`)
      else if (!looksLikeFile(input) && !isPlaceholder(input) && !isLink(input) && !scenes.some((s) => s.name === input))
        yield wrong(`there is no scene ${input}`)
    }
  }
}

// ---------------------------------------------------------------- Types

const TYPES = 'crates/face/src/types.d.ts'

/** The declarations of the Rust types, laid out; what their documentation says in Rust's words is said in TypeScript's. */
function types() {
  const declarations = forage('list', '--types')
    .replace(/^( *\*)\n *\* ```[\s\S]*?^ *\* ```\n/gm, '')
    .replace(/, see \[`[^`]+`\]| \(\[`[A-Za-z:]*[A-Z_]+`\]\)/g, '')
    .replace(/\[`(?:Self::)?([^`\]]+)`\](?:\([^)]*\))?/g, '`$1`')
    .replace(/\[([A-Z-]+)\]\(crate#papers\)/g, '[$1]')
    .replaceAll('`None`', '`null`')
    .replace(/\/\*\*\n \* ([^\n]*)\n \*\//g, '/** $1 */')
  const biome = join(root, 'www/node_modules/.bin/biome')
  if (!existsSync(biome)) throw new Error('www/node_modules is missing: run scripts/setup')
  const input = `// Written by scripts/docs.mjs from the Rust types.\n\n${declarations}`
  return execFileSync(biome, ['format', `--stdin-file-path=${TYPES}`], { cwd: root, input, encoding: 'utf8' })
}

// ---------------------------------------------------------------- Main

const GLOSSARY = 'docs/glossary.md'

/** The glossary with what each term is called in Chinese. */
function withChinese(text) {
  const terms = JSON.parse(read('locales/zh-CN/glossary.json'))
  const out = text.replace(/^\| (.+?) \| (.*?) \|( .*? \| .+? \|)$/gm, (row, term, _, rest) =>
    terms[term] ? `| ${term} | ${terms[term].term} |${rest}` : row,
  )
  return { out, stale: out === text ? [] : ['Chinese terms'] }
}

function main() {
  const [option, ...more] = process.argv.slice(2)
  if (more.length || (option !== undefined && option !== '--check')) {
    console.error('usage: node scripts/docs.mjs [--check]')
    return 2
  }
  if (!existsSync(program)) {
    console.error(`${program} is missing: run cargo build, or set FORAGE`)
    return 2
  }
  const check = option === '--check'
  const chapterFiles = readdirSync(join(root, 'docs'))
    .filter((name) => name.endsWith('.md'))
    .map((name) => `docs/${name}`)
    .sort()
  const chapters = new Set([...read('docs/SUMMARY.md').matchAll(/\]\(([^)#]+\.md)\)/g)].map(([, file]) => join('docs', file)))
  const problems = []
  for (const file of chapterFiles) {
    if (file !== 'docs/SUMMARY.md' && !chapters.has(file)) problems.push(`docs/SUMMARY.md: ${file} is missing`)
  }
  const others = ['CONTRIBUTING.md', 'SECURITY.md', 'CHANGELOG.md', 'package/README.md'].filter((path) => existsSync(join(root, path)))
  for (const path of ['README.md', 'README.zh-CN.md', ...others, ...chapterFiles]) {
    const text = read(path)
    const { out, stale } = path === GLOSSARY ? withChinese(text) : filled(path, text)
    if (check) problems.push(...stale.map((name) => `${path}: the block "${name}" is stale; run node scripts/docs.mjs`))
    else if (stale.length) {
      writeFileSync(join(root, path), out)
      console.log(`${path}: ${stale.join(', ')}`)
    }
    if (!check) continue
    problems.push(...brokenLinks(path, text, chapters), ...missingFiles(path, text), ...new Set(wrongCommands(path, text)))
    const lines = text.split('\n').length - 1
    if (path.startsWith('README.') && lines > README_LINES) problems.push(`${path} has ${lines} lines; at most ${README_LINES} are allowed`)
  }
  const declared = types()
  if (!existsSync(join(root, TYPES)) || read(TYPES) !== declared) {
    if (check) problems.push(`${TYPES} is stale; run node scripts/docs.mjs`)
    else {
      writeFileSync(join(root, TYPES), declared)
      console.log(TYPES)
    }
  }
  for (const problem of problems) console.error(problem)
  return problems.length ? 1 : 0
}

try {
  process.exitCode = main()
} catch (error) {
  console.error(`docs: ${error.message}`)
  process.exitCode = 1
}
