// Random runs on several hosts: the same bits everywhere, or the same refusal. A table says how each host did; its last column is a hash
// of all hashes, which is the same wherever nothing differs.
//   node tests/hosts.mjs [--runs 10000] [--seed N] [--hosts debug,release,node,chromium,firefox,webkit] [--out ROWS.csv]
// `debug` and `release` are those of cargo's target folder, `node` and the browsers run the package in pkg/.
import { spawn } from 'node:child_process'
import { createHash } from 'node:crypto'
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs'
import { availableParallelism, tmpdir } from 'node:os'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { parseArgs } from 'node:util'
import { setupOf, stream } from './fuzz.mjs'

const root = fileURLToPath(new URL('..', import.meta.url))

/** So many random setups, as a command line can say them. */
export function drawn(seed, runs) {
  const random = stream(seed)
  return Array.from({ length: runs }, () => {
    const { planner, scene, params, seed: number } = setupOf(random, true)
    const plain = Object.entries(params).filter(([, value]) => ['number', 'string', 'boolean'].includes(typeof value))
    // Fuzzing takes few iterations, for many runs in a second.
    const longer = plain.map(([name, value]) => [name, name === 'iterations' && value > 0 && value <= 12 ? 8 * value : value])
    return { planner, scene, params: Object.fromEntries(longer), seed: number }
  })
}

export const commandOf = ({ planner, scene, params, seed }) => [
  ...['run', planner, '--scene', scene, '--seed', `${seed}`, '--json'],
  ...Object.entries(params).flatMap(([name, value]) => ['--set', `${name}=${value}`]),
]

/** What a run came to: its hash, or what is refused of it, or what should not happen. */
const hashed = (hash) => ({ hash })
const refusedFor = (error) => ({ refused: error })
const broken = (why) => ({ broken: why })

/** Calls `make` for each of a list, so many at a time; the results in order. */
async function each(list, most, make) {
  const results = new Array(list.length)
  let next = 0
  const lane = async () => {
    while (next < list.length) {
      const k = next++
      results[k] = await make(list[k])
    }
  }
  await Promise.all(Array.from({ length: most }, lane))
  return results
}

/** A program's runs. It says in words what it refuses; exit code 1 is a result that is not feasible. */
export function program(path) {
  const one = (setup) =>
    new Promise((resolve, reject) => {
      const child = spawn(path, commandOf(setup), { stdio: ['ignore', 'pipe', 'pipe'] })
      const texts = { stdout: '', stderr: '' }
      for (const name of ['stdout', 'stderr']) child[name].setEncoding('utf8').on('data', (text) => (texts[name] += text))
      child.once('error', reject)
      child.once('close', (status) => {
        const hash = /^ {2}"hash": "([0-9a-f]+)"/m.exec(texts.stdout)?.[1]
        if (status === 2) resolve(refusedFor({ text: texts.stderr }))
        else if (hash !== undefined && status <= 1) resolve(hashed(hash))
        else resolve(broken(`exit code ${status}: ${texts.stderr.slice(-500)}`))
      })
    })
  return { run: (setups) => each(setups, availableParallelism(), one), close: () => undefined }
}

/** What a host with the package does; it is sent to browsers as text. */
async function ofPackage({ Session, ready }, setups) {
  const results = []
  for (const setup of setups) {
    try {
      const session = await ready(() => new Session(setup))
      // In parts, where a program's run is taken in whole steps.
      while (['running', 'partly'].includes(await ready(() => session.advance(1000))));
      results.push({ hash: session.hash() })
      session.free()
    } catch (error) {
      const { code, field, value, allowed, message } = error
      results.push(
        code && code !== 'dead' ? { refused: { code, field, value, allowed, message } } : { broken: String(error.stack ?? error) },
      )
    }
  }
  return results
}

async function node() {
  const { Session } = await import('../pkg/node.js')
  return { run: (setups) => ofPackage({ Session, ready: (make) => make() }, setups), close: () => undefined }
}

/** A browser that is given the package by a host of files. */
async function inBrowser(start) {
  const { staticHost } = await import('../www/tests/support/static.mjs')
  const blank = mkdtempSync(join(tmpdir(), 'forage-hosts-'))
  writeFileSync(join(blank, 'index.html'), '<!doctype html><title>Forage</title>')
  const server = staticHost(`${root}pkg`, '/', { '/blank/': blank })
  await new Promise((listening) => server.listen(0, '127.0.0.1', listening))
  const browser = await start()
  await browser.open(`http://127.0.0.1:${server.address().port}/blank/`)
  const script = `async (setups) => {
    const { default: init, Session, ready } = await import('/forage.js')
    await init()
    return JSON.stringify(await (${ofPackage})({ Session, ready }, setups))
  }`
  return {
    async run(setups) {
      const results = []
      // So few at a time that no driver loses patience.
      for (let k = 0; k < setups.length; k += 25) results.push(...JSON.parse(await browser.run(script, setups.slice(k, k + 25))))
      return results
    },
    async close() {
      await browser.close()
      server.close()
      rmSync(blank, { recursive: true })
    },
  }
}

const engines = () => import('../www/tests/support/engines.mjs')
const target = process.env.CARGO_TARGET_DIR ?? `${root}target`
/** All hosts by their names. */
export const HOSTS = {
  debug: () => program(process.env.FORAGE ?? `${target}/debug/forage`),
  release: () => program(`${target}/release/forage`),
  node,
  chromium: async () => inBrowser((await engines()).chromium),
  firefox: async () => inBrowser((await engines()).ENGINES.firefox),
  webkit: async () => inBrowser((await engines()).ENGINES.webkit),
}

/**
 * Whether two hosts came to the same. The shell says in its own words what it refuses: names that it did not find with the nearest one,
 * values with what is allowed, and not all of a long text.
 */
function agree(one, other) {
  if (one.broken || other.broken) return false
  if (!one.refused || !other.refused) return !one.refused && !other.refused && one.hash === other.hash
  if (one.refused.text !== undefined && other.refused.text !== undefined) return one.refused.text === other.refused.text
  if (one.refused.text === undefined && other.refused.text === undefined) return one.refused.message === other.refused.message
  const [{ text }, { code, field, value, allowed }] =
    one.refused.text === undefined ? [other.refused, one.refused] : [one.refused, other.refused]
  const missing = value === 'nothing' ? 'missing' : value
  return (code === 'refused' ? [field, missing, allowed] : [value]).every((part) => text.includes(part.slice(0, 60)))
}

/**
 * So many random runs on each host. Each is compared with the first: `{ rows, differing }`, a row for each host, and what differs, as
 * texts with the command that repeats it.
 */
export async function compareHosts({ seed, runs, hosts, out }) {
  const setups = drawn(seed, runs)
  const [rows, differing, results] = [[], [], []]
  for (const name of hosts) {
    const began = performance.now()
    const host = await HOSTS[name]()
    const found = await Promise.resolve(host.run(setups)).finally(() => host.close())
    const first = results[0] ?? found
    const apart = setups.map((_, k) => k).filter((k) => !agree(first[k], found[k]) || found[k].broken)
    for (const k of apart) differing.push(`${name}: forage ${commandOf(setups[k]).join(' ')}\n${JSON.stringify([first[k], found[k]])}`)
    const all = createHash('sha256')
    for (const { hash } of found) all.update(`${hash ?? 'refused'}\n`)
    rows.push({
      host: name,
      runs: found.length,
      refused: found.filter(({ refused }) => refused).length,
      differing: apart.length,
      seconds: Math.round((performance.now() - began) / 1000),
      'all hashes': all.digest('hex').slice(0, 16),
    })
    results.push(found)
  }
  if (out) {
    const cell = (text) => `"${String(text).replaceAll('"', '""')}"`
    const lines = setups.map((setup, k) => [
      ...[setup.planner, setup.scene, setup.seed],
      cell(JSON.stringify(setup.params)),
      ...results.map((found) => found[k].hash ?? (found[k].refused ? 'refused' : 'broken')),
    ])
    writeFileSync(out, [['planner', 'scene', 'seed', 'params', ...hosts], ...lines].map((line) => `${line.join(',')}\n`).join(''))
  }
  return { rows, differing }
}

if (import.meta.filename === process.argv[1]) {
  const text = { type: 'string' }
  const { values } = parseArgs({ options: { runs: text, seed: text, hosts: text, out: text } })
  const hosts = values.hosts?.split(',') ?? Object.keys(HOSTS)
  const unknown = hosts.find((name) => !(name in HOSTS))
  if (unknown !== undefined) {
    console.error(`There is no host '${unknown}'; there are: ${Object.keys(HOSTS).join(', ')}`)
    process.exit(2)
  }
  const { rows, differing } = await compareHosts({
    seed: Number(values.seed ?? 1),
    runs: Number(values.runs ?? 10_000),
    hosts,
    out: values.out,
  })
  console.table(rows)
  for (const one of differing.slice(0, 20)) console.log(one)
  process.exitCode = differing.length > 0 ? 1 : 0
}
