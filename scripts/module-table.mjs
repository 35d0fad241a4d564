// Where the bytes of a module are: code by folders of the library and by crates, from the names of its functions, before wasm-opt.
//   node scripts/module-table.mjs FILE.wasm [DEPTH]   DEPTH: how far into the library's folders, 1 by default
import { readFileSync } from 'node:fs'

const [file, depth = '1'] = process.argv.slice(2)
const bytes = readFileSync(file)
let at = 8

/** An unsigned number in LEB128. */
function number() {
  let [value, shift] = [0, 0]
  for (;;) {
    const byte = bytes[at++]
    value += (byte & 0x7f) * 2 ** shift
    if (byte < 0x80) return value
    shift += 7
  }
}

function text() {
  const length = number()
  at += length
  return bytes.toString('utf8', at - length, at)
}

const sizes = []
const names = new Map()
let [imported, data] = [0, 0]
while (at < bytes.length) {
  const section = bytes[at++]
  const end = number() + at
  if (section === 2) {
    for (let left = number(); left > 0; left--) {
      text()
      text()
      const kind = bytes[at++]
      if (kind === 0) {
        imported += 1
        number()
      } else if (kind === 3) at += 2
      else {
        if (kind === 1) at += 1
        if (number() & 1) number()
        number()
      }
    }
  } else if (section === 10) {
    for (let left = number(); left > 0; left--) {
      const size = number()
      sizes.push(size)
      at += size
    }
  } else if (section === 11) data = end - at
  else if (section === 0 && text() === 'name') {
    while (at < end) {
      const part = bytes[at++]
      const until = number() + at
      if (part === 1) for (let left = number(); left > 0; left--) names.set(number(), text())
      at = until
    }
  }
  at = end
}
if (names.size === 0) throw new Error(`${file} has no names of functions`)

/** A name as the linker has it (`_ZN6forage4math…E`), as a path. */
function readable(name) {
  if (!name.startsWith('_ZN')) return name
  const path = []
  for (let rest = name.slice(3); ; ) {
    const [length] = /^\d+/.exec(rest) ?? []
    if (!length) break
    path.push(rest.slice(length.length, length.length + Number(length)))
    rest = rest.slice(length.length + Number(length))
  }
  return path
    .join('::')
    .replace(/^_(?=\$)/, '')
    .replaceAll('$LT$', '<')
    .replaceAll('$GT$', '>')
    .replaceAll('$u20$', ' ')
    .replaceAll('..', '::')
}

/** The crate of a function, and within the library its folders. */
function place(mangled) {
  const path = readable(mangled)
    .replace(/^_?<+(?:impl )?(?:&mut |&|\[|\*const |\*mut )*/, '')
    .split(/[<>( ]/)[0]
    .replaceAll(/\[[0-9a-f]+\]/g, '')
    .split('::')
  if (path.length === 1) return 'exports and glue'
  return path.slice(0, path[0] === 'forage' ? 1 + Number(depth) : 1).join('::')
}

const totals = new Map()
for (const [i, size] of sizes.entries()) {
  const where = place(names.get(imported + i) ?? '?')
  totals.set(where, (totals.get(where) ?? 0) + size)
}
const all = sizes.reduce((sum, size) => sum + size, 0)
for (const [where, size] of [...totals].sort((a, b) => b[1] - a[1])) {
  if (size < all / 500) break
  console.log(`${where.padEnd(40)} ${String(size).padStart(9)} ${((100 * size) / all).toFixed(1).padStart(6)} %`)
}
console.log(`${'code'.padEnd(40)} ${String(all).padStart(9)}\n${'data'.padEnd(40)} ${String(data).padStart(9)}`)
