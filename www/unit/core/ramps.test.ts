import { describe, expect, it } from 'vitest'
import type { Color } from 'forage-lab'
import { catalogue } from '../../../pkg/node.js'
import palette from '../../../src/describe/palette.json'

type Rgba = [red: number, green: number, blue: number, opacity: number]

const read = (hex: string): Rgba => [1, 3, 5, 7].map((at) => (at < hex.length ? Number.parseInt(hex.slice(at, at + 2), 16) : 255)) as Rgba

const mix = (from: Rgba, to: Rgba, share: number): Rgba => from.map((part, at) => part + share * ((to[at] ?? 0) - part)) as Rgba

/** On the ground of the stage. */
const over = ([red, green, blue, opacity]: Rgba, ground: Rgba): Rgba => mix(ground, [red, green, blue, 255], opacity / 255)

/** The lightness in Oklab: equal distances look equal. */
function lightness(color: Rgba): number {
  const linear = (part: number): number => (part / 255 <= 0.04045 ? part / 255 / 12.92 : ((part / 255 + 0.055) / 1.055) ** 2.4)
  const [r, g, b] = color.slice(0, 3).map(linear) as [number, number, number]
  const l = Math.cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b)
  const m = Math.cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b)
  const s = Math.cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b)
  return 0.2104542553 * l + 0.793617785 * m - 0.0040720468 * s
}

const STEPS = 12

describe.each([
  ['light', 0],
  ['dark', 1],
] as const)('in the %s theme', (theme, at) => {
  const ground = read(palette.stage[at] ?? '')
  const { planners, heights } = catalogue()
  const ramps = new Map<string, readonly Color[]>([['heights', heights]])
  for (const { role, look } of planners.flatMap(({ layers }) => layers)) if (look.ramp) ramps.set(role, look.ramp)

  it.each([...ramps])('equal steps of %s look equal, and all go one way', (_, ramp) => {
    const colors = ramp.map((color) => read(color[theme]))
    const shade = (share: number): number => {
      const along = share * (colors.length - 1)
      const first = Math.min(Math.floor(along), colors.length - 2)
      return lightness(over(mix(colors[first] as Rgba, colors[first + 1] as Rgba, along - first), ground))
    }
    const steps = Array.from({ length: STEPS }, (_, k) => shade((k + 1) / STEPS) - shade(k / STEPS))
    const sizes = steps.map((step) => Math.abs(step))
    expect(new Set(steps.map(Math.sign)).size).toBe(1)
    expect(Math.max(...sizes) / Math.min(...sizes)).toBeLessThan(1.5)
  })
})
