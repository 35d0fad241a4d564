/** Rows beside those that are seen, so that a quick scroll finds something. */
const SPARE = 4

/** Which of many rows of the same height are seen, the last one excluded. */
export function seenRows(top: number, height: number, row: number, count: number): [number, number] {
  const from = Math.floor(top / row) - SPARE
  return [Math.min(Math.max(0, from), count), Math.min(count, Math.ceil((top + height) / row) + SPARE)]
}

/** Members in the order of one of their numbers; what is no number comes last. Equal ones keep their order. */
export function sorted(count: number, value: (member: number) => number, descending: boolean): number[] {
  const sign = descending ? -1 : 1
  const key = (member: number): number => {
    const number = value(member)
    return Number.isNaN(number) ? Infinity : sign * number
  }
  return Array.from({ length: count }, (_, member) => member).sort((a, b) => (key(a) === key(b) ? a - b : key(a) < key(b) ? -1 : 1))
}

/** A span's mean where there are more numbers than places for them. */
export function condensed(values: ArrayLike<number>, places: number): number[] {
  const count = Math.max(1, Math.min(values.length, Math.floor(places)))
  return Array.from({ length: count }, (_, place) => {
    const [from, to] = [Math.floor((place * values.length) / count), Math.floor(((place + 1) * values.length) / count)]
    let sum = 0
    for (let at = from; at < to; at += 1) sum += values[at] ?? 0
    return sum / Math.max(1, to - from)
  })
}
