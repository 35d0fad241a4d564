import type { Point } from 'forage-lab'
import { expect, test } from 'vitest'
import { fit as fitted, pan, tick, toScene, toScreen, type View, zoom } from './view'

const SIZE = { width: 800, height: 600 }
const BOX = { min: [-10, 0] as Point, max: [30, 20] as Point }

for (const down of [false, true]) {
  const y = down ? 'down' : 'up'
  const whole = fitted(BOX, SIZE, [64, 38], down)

  test(`screen and scene map to each other, y ${y}`, () => {
    for (const at of [
      [0, 0],
      [123, 456],
      [800, 600],
    ] as Point[]) {
      const [x, y2] = toScreen(whole, SIZE, toScene(whole, SIZE, at))
      expect(x).toBeCloseTo(at[0], 9)
      expect(y2).toBeCloseTo(at[1], 9)
    }
    const above = toScreen(whole, SIZE, [0, 20])[1] < toScreen(whole, SIZE, [0, 0])[1]
    expect(above).toBe(!down)
  })

  test(`the whole box is seen with its margins, y ${y}`, () => {
    for (const corner of [BOX.min, BOX.max]) {
      const [x, y2] = toScreen(whole, SIZE, corner)
      expect(x).toBeGreaterThanOrEqual(64 - 1e-9)
      expect(x).toBeLessThanOrEqual(SIZE.width - 64 + 1e-9)
      expect(y2).toBeGreaterThanOrEqual(38 - 1e-9)
      expect(y2).toBeLessThanOrEqual(SIZE.height - 38 + 1e-9)
    }
  })

  test(`room is left below for tools, y ${y}`, () => {
    const lifted = fitted(BOX, { width: 390, height: 390 }, [38, 38, 140], down)
    const edges = [BOX.min, BOX.max].map((corner) => toScreen(lifted, { width: 390, height: 390 }, corner)[1])
    expect((edges[0] ?? 0) + (edges[1] ?? 0)).toBeCloseTo(38 + (390 - 140), 9)
    expect(Math.max(...edges)).toBeLessThanOrEqual(390 - 140 + 1e-9)
  })

  test(`zooming keeps what is under the pointer, panning moves it, y ${y}`, () => {
    const at: Point = [200, 450]
    const place = toScene(whole, SIZE, at)
    const closer = zoom(whole, SIZE, 3, at, whole.scale)
    expect(closer.scale).toBeCloseTo(3 * whole.scale, 9)
    const moved: View = pan(closer, 25, -40)
    for (const [view, [dx, dy]] of [
      [closer, [0, 0]],
      [moved, [25, -40]],
    ] as [View, Point][]) {
      const [x, y2] = toScreen(view, SIZE, place)
      expect(x).toBeCloseTo(at[0] + dx, 9)
      expect(y2).toBeCloseTo(at[1] + dy, 9)
    }
  })
}

test('zooming ends at both limits', () => {
  const whole = fitted(BOX, SIZE, [0, 0])
  expect(zoom(whole, SIZE, 1e9, [0, 0], whole.scale).scale).toBe(400 * whole.scale)
  expect(zoom(whole, SIZE, 1e-9, [0, 0], whole.scale).scale).toBe(0.2 * whole.scale)
})

test.each([
  [1, 80, 100],
  [100, 80, 1],
  [50, 80, 2],
  [0.001, 150, 200_000],
])('at %d pixels a unit, ticks %d pixels apart are %d units', (scale, pixels, step) => {
  expect(tick(scale, pixels)).toBeCloseTo(step, 9)
})
