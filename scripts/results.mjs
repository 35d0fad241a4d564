// What docs/benchmarks.md says of measured results: tables and paragraphs of docs/benchmarks.json, which scripts/benchmarks.py writes.

/** Rows as objects by column. */
const rowsOf = ({ columns, rows }) => rows.map((row) => Object.fromEntries(columns.map((name, k) => [name, row[k]])))

const number = (text, digits = 3) => {
  if (text === undefined) throw new Error('docs/benchmarks.json lacks what scripts/results.mjs says of it: measure again')
  const value = Number(text)
  if (text === '' || !Number.isFinite(value)) return text
  if (Number.isInteger(value)) return String(value)
  const size = Math.abs(value)
  return size >= 1000 ? value.toFixed(0) : size >= 100 ? value.toFixed(1) : String(Number(value.toPrecision(digits)))
}
const percent = (share) => `${(100 * Number(share)).toFixed(0)} %`
const code = (name) => `\`${name}\``
const list = (names) =>
  names.length === 0 ? 'none' : names.length === 1 ? names[0] : `${names.slice(0, -1).join(', ')} and ${names.at(-1)}`
const best = (rows, column, sign = 1) => [...rows].sort((a, b) => sign * (Number(b[column]) - Number(a[column])))
const isPeer = ({ planner }) => planner === 'random-search' || planner.startsWith('OMPL') || planner.startsWith('DWA')

function bbob({ peers, ...own }) {
  const rows = rowsOf(own)
  const [cma] = rowsOf({ columns: own.columns, rows: peers })
  const ours = best(
    rows.filter((row) => !isPeer(row)),
    'all',
  )
  const random = rows.find(isPeer)
  const above = ours.filter((row) => Number(row.all) > Number(cma.all))
  const below = ours.filter((row) => Number(row.all) <= Number(random.all))
  const first = ours[0]
  return [
    `Of Forage’s planners ${code(first.planner)} reaches most targets, ${percent(first.all)}; random search reaches ${percent(random.all)}, and CMA-ES ${percent(cma.all)} (package cma, which restarts it with a doubled population; Forage’s planners are not restarted).`,
    above.length
      ? `More than CMA-ES: ${list(above.map((row) => code(row.planner)))}.`
      : 'None of them reaches as many as CMA-ES, which is the better choice to minimise a function.',
    below.length ? `Not above random search: ${list(below.map((row) => code(row.planner)))}.` : 'All of them are above random search.',
  ].join(' ')
}

function centreBias(own) {
  const rows = rowsOf(own)
  const random = rows.find(isPeer)
  const ours = rows.filter((row) => !isPeer(row))
  const drawn = ours.filter((row) => Number(row['shifted from']) > Number(random['shifted to']))
  const turned = ours.filter((row) => Number(row['rotated from']) > 1)
  const ratio = (row) => `${code(row.planner)} (${number(row['shifted : centred'])})`
  return [
    `Random search has ${number(random['shifted : centred'])} (${number(random['shifted from'])} to ${number(random['shifted to'])}), since a minimum near a border is farther from most positions.`,
    `Significantly above that (95 % intervals do not overlap): ${list(drawn.map(ratio))}.`,
    `Significantly worse on rotated functions (95 % interval above 1): ${list(turned.map((row) => `${code(row.planner)} (${number(row['rotated : centred'])})`))}.`,
  ].join(' ')
}

function movingai({ all, ...own }) {
  const rows = rowsOf(own)
  const [planner, problems, , optimal] = own.columns
  const exact = rows.filter((row) => Number(row[optimal]) === Number(row[problems]))
  const others = rows.filter((row) => Number(row[optimal]) !== Number(row[problems]))
  const gap = own.columns.find((name) => name.includes('gap'))
  return [
    `${list(exact.map((row) => code(row[planner])))} have the file’s optimum in all ${number(exact[0]?.[problems] ?? '0')} problems, as graph searches must.`,
    ...others.map(
      (row) =>
        `${code(row[planner])} is not bound to grid paths, or is not exact: its mean gap to the shortest grid path is ${number(row[gap])} %.`,
    ),
  ].join(' ')
}

function tsplib({ same, all, ...own }) {
  const spent = (planner) => rowsOf(own).find((row) => row.planner === planner)?.['mean evaluations per stop']
  const ours = Object.entries(same.gaps).sort((a, b) => a[1] - b[1])
  const better = ours.filter(([, gap]) => gap < same['OR-Tools'])
  return [
    `On the ${same.instances} instances with rounded straight distances OR-Tools’ local search has a mean gap of ${number(same['OR-Tools'])} %, Forage’s planners have: ${list(ours.map(([name, gap]) => `${code(name)} ${number(gap)} %`))}.`,
    better.length
      ? `Below OR-Tools: ${list(better.map(([name]) => `${code(name)} with ${number(spent(name))} evaluations per stop`))}; the budget is ${number(same.budget)}, which first tours may exceed.`
      : 'None of them is below it.',
    'OR-Tools stops at a local optimum, Forage at its budget of evaluations: the times are not compared.',
  ].join(' ')
}

function trees({ peers }) {
  const rows = rowsOf(peers)
  const totals = new Map()
  for (const { planner, solved, evaluations } of rows) {
    const [count, all] = solved.split(' of ').map(Number)
    const total = totals.get(planner) ?? { planner, count: 0, all: 0, evaluations: [] }
    totals.set(planner, {
      ...total,
      count: total.count + count,
      all: total.all + all,
      evaluations: [...total.evaluations, Number(evaluations)],
    })
  }
  const median = (numbers) => {
    const sorted = [...numbers].sort((a, b) => a - b)
    const at = (sorted.length - 1) / 2
    return (sorted[Math.floor(at)] + sorted[Math.ceil(at)]) / 2
  }
  const parts = [...totals.values()].map(
    ({ planner, count, all, evaluations }) =>
      `${planner.startsWith('OMPL') ? planner : code(planner)} ${count} of ${all} (${number(median(evaluations))})`,
  )
  const scenes = new Set(rows.map(({ scene }) => scene)).size
  return `On the ${scenes} scenes with discs and grids, runs solved and, in parentheses, the median over scenes of the median evaluations of a whole run: ${list(parts)}. RRT\\* and ${code('rrt-star')} go on until the budget is spent, the others stop at their first path.`
}

function barn(own) {
  const rows = rowsOf(own)
  const sets = [...new Set(rows.map(({ set }) => set))]
  const parts = sets.map((set) => {
    const of = best(
      rows.filter((row) => row.set === set && !isPeer(row)),
      'success %',
    )
    return `${set}: ${list(of.map((row) => `${code(row.planner)} ${number(row['success %'])} % with a score of ${number(row.score)}`))}`
  })
  const dwa = rows.find(isPeer)
  const published = dwa
    ? ` The repository’s DWA has ${number(dwa['success %'])} % and ${number(dwa.score)} in Gazebo, where a robot slides, bumps and sees with a laser: that a disc does better here says nothing about a Jackal.`
    : ''
  return `${parts.join('; ')}. A score of 0.5 is the most that the rule gives.${published}`
}

const SAYS = { bbob, 'centre-bias': centreBias, movingai, tsplib, trees, barn }

/** The machine on which all was measured. */
export function machine({ machine: { cpu, cores, memory_gib, system, forage, python, libraries } }) {
  const named = Object.entries(libraries).map(([name, version]) => `${name} ${version}`)
  return `The results below were measured on ${cpu}, ${cores} cores, ${memory_gib} GiB, ${system}, with Forage ${forage}; peers with Python ${python}, ${list(named)}. \`scripts/benchmarks.py\` measures them; no number is typed by hand. Evaluations, lengths, gaps and scores are the same on every machine; times are not.`
}

/** What a second table shows: all planners of a suite, or all of its problems. */
const ALL = {
  movingai(own) {
    const rows = rowsOf(own)
    const optimal = rows.filter((row) => row.optimal === row.problems).map((row) => code(row.planner))
    const free = rows.filter((row) => Number(row['mean gap, %']) < 0).map((row) => code(row.planner))
    return [
      'All planners on the smallest of these maps, one problem of each bucket.',
      `The optimum in all problems: ${list(optimal)}.`,
      `Not bound to grid paths, and shorter on average: ${list(free)}.`,
    ].join(' ')
  },
  tsplib(own) {
    const [row] = rowsOf(own)
    return `All ${row.instances} instances: ${code(row.planner)} stops at a local optimum, with a median gap of ${number(row['median gap, %'])} %.`
  },
}

/** A suite’s results: its command, its table, and what that shows. */
export function results(all, suite, table) {
  const own = all[suite]
  if (!own || !SAYS[suite]) throw new Error(`docs/benchmarks.json has no results of ${suite}`)
  const rows = [...own.rows, ...(Array.isArray(own.peers) ? own.peers : [])].map((row) =>
    row.map((cell, k) => (k === 0 ? cell : number(cell))),
  )
  const shown = `    ${own.command}\n\n${table(own.columns, rows)}\n\n${SAYS[suite](own)}`
  if (!own.all) return shown
  const more = own.all.rows.map((row) => row.map((cell, k) => (k === 0 ? cell : number(cell))))
  return `${shown}\n\n    ${own.all.command}\n\n${table(own.all.columns, more)}\n\n${ALL[suite](own.all)}`
}
