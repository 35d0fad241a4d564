// An order of a module's functions in which similar ones are neighbours: a compressor that looks back 32 kB finds more there.

/** Bytes that are compared at a time. */
const PIECE = 6
/** Pieces are known by a number below this one. */
const KINDS = 1_048_573
/** So many functions, and bytes, are looked back. */
const BACK = { functions: 20, bytes: 31_000 }
/** A function of so many pieces has to have half of them in common to count as much as a long one that has all. */
const SHORT = 30

const IMPORTS = 2
const CODE = 10

/** An unsigned number of the format, and what is behind it. */
function unsigned(bytes, at) {
  let [value, shift, next] = [0, 0, at]
  for (;;) {
    const byte = bytes[next++]
    value |= (byte & 127) << shift
    if (byte < 128) return [value >>> 0, next]
    shift += 7
  }
}

function written(value) {
  const bytes = []
  for (let rest = value; ; rest >>>= 7) {
    if (rest < 128) return [...bytes, rest]
    bytes.push((rest & 127) | 128)
  }
}

/** The sections: their number, where they begin and end, and where their content begins. */
function* sections(bytes) {
  for (let at = 8; at < bytes.length; ) {
    const [size, content] = unsigned(bytes, at + 1)
    yield { id: bytes[at], content, end: content + size }
    at = content + size
  }
}

/** What each function consists of. */
function bodies(bytes) {
  const { content } = [...sections(bytes)].find(({ id }) => id === CODE)
  let [count, at] = unsigned(bytes, content)
  const found = []
  for (; count > 0; count -= 1) {
    const [size, begin] = unsigned(bytes, at)
    at = begin + size
    found.push(bytes.subarray(begin, at))
  }
  return found
}

function pieces(body) {
  const all = new Set()
  for (let at = 0; at + PIECE <= body.length; at += 1) {
    let piece = 0
    for (let k = 0; k < PIECE; k += 1) piece = (piece * 257 + body[at + k]) % KINDS
    all.add(piece)
  }
  return all
}

/** The functions' numbers in their new order: each is the one that has most in common with those before it. */
function neighbours(all) {
  const sets = all.map(pieces)
  const left = new Set(all.keys())
  const order = []
  let next = all.reduce((longest, body, at) => (body.length > all[longest].length ? at : longest), 0)
  while (left.size > 0) {
    left.delete(next)
    order.push(next)
    const before = new Set()
    for (let back = 1, bytes = 0; back <= Math.min(order.length, BACK.functions) && bytes < BACK.bytes; back += 1) {
      const number = order[order.length - back]
      bytes += all[number].length
      for (const piece of sets[number]) before.add(piece)
    }
    let most = -1
    for (const number of left) {
      let common = 0
      for (const piece of sets[number]) if (before.has(piece)) common += 1
      const share = common / (sets[number].size + SHORT)
      if (share > most) [most, next] = [share, number]
    }
  }
  return order
}

/** How many functions come from elsewhere: they are counted first. */
function imported(bytes, module, binaryen) {
  if (![...sections(bytes)].some(({ id }) => id === IMPORTS)) return 0
  let count = 0
  for (let at = 0; at < module.getNumFunctions(); at += 1)
    if (binaryen.getFunctionInfo(module.getFunctionByIndex(at)).module !== '') count += 1
  return count
}

/** The module with names by which its functions can be put into that order. */
export function named(bytes, module, binaryen) {
  const all = bodies(bytes)
  const first = imported(bytes, module, binaryen)
  const ranks = new Map(neighbours(all).map((number, rank) => [number, rank]))
  const text = new TextEncoder()
  const names = all.flatMap((_, number) => {
    const name = text.encode(String(ranks.get(number)).padStart(6, '0'))
    return [...written(first + number), name.length, ...name]
  })
  const map = [...written(all.length), ...names]
  const title = text.encode('name')
  const section = [title.length, ...title, 1, ...written(map.length), ...map]
  return new Uint8Array([...bytes, 0, ...written(section.length), ...section])
}
