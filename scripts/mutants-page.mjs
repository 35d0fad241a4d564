// What scripts/mutants --page found: a table by module, and the changes that no test noticed. Fails when fewer than 85 % were, or when
// tests/mutants/page.txt does not name one with a reason.
import { readFileSync } from 'node:fs'

const ENOUGH = 0.85
/** A change that breaks the module at once, or never ends, is noticed, too. */
const NOTICED = ['Killed', 'Timeout', 'RuntimeError']
const MISSED = ['Survived', 'NoCoverage']

const { files } = JSON.parse(readFileSync(process.argv[2], 'utf8'))
const oneLine = (text) => text.replace(/\s+/g, ' ').trim()

/** The text that a change replaces. */
function replaced(source, { start, end }) {
  const lines = source.split('\n').slice(start.line - 1, end.line)
  lines[lines.length - 1] = lines.at(-1).slice(0, end.column - 1)
  lines[0] = lines[0].slice(start.column - 1)
  return oneLine(lines.join('\n'))
}

const table = []
const survivors = []
for (const [name, { source, mutants }] of Object.entries(files)) {
  const noticed = mutants.filter(({ status }) => NOTICED.includes(status)).length
  const missed = mutants.filter(({ status }) => MISSED.includes(status))
  if (noticed + missed.length > 0) table.push([name, noticed + missed.length, missed.length])
  for (const { location, replacement } of missed)
    survivors.push({ line: location.start.line, text: `${name}: ${replaced(source, location)} → ${oneLine(replacement)}` })
}
const sum = (at) => table.reduce((total, row) => total + row[at], 0)
table.push(['all', sum(1), sum(2)])
const share = ([, changes, missed]) => 1 - missed / changes
console.log(`\n${'module'.padEnd(36)} ${'changes'.padStart(8)} ${'survivors'.padStart(10)} ${'noticed'.padStart(8)}`)
for (const row of table) {
  const [name, changes, missed] = row
  const percent = `${(100 * share(row)).toFixed(1)} %`
  console.log(`${name.padEnd(36)} ${String(changes).padStart(8)} ${String(missed).padStart(10)} ${percent.padStart(8)}`)
}

const named = new Set(readFileSync(new URL('../tests/mutants/page.txt', import.meta.url), 'utf8').split('\n'))
const unnamed = survivors.filter(({ text }) => !named.has(text))
if (unnamed.length > 0) console.log('\nNot in tests/mutants/page.txt, with their lines:')
for (const { line, text } of unnamed) console.log(`${line} ${text}`)
process.exitCode = share(table.at(-1)) >= ENOUGH && unnamed.length === 0 ? 0 : 1
