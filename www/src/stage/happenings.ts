import type { EventKind, Point } from 'forage'
import type { Pen } from './pen'
import { toScreen } from './view'

type Tone = EventKind['tone']

/** How a mark's inside and its rim are coloured, and its form: each tone has one of its own. */
const MARKS: Readonly<Record<Tone, { ground: string; rim: string; form(path: Path2D): void; sign?(path: Path2D): void }>> = {
  plain: { ground: '--stage', rim: '--ink', form: (path) => path.arc(0, 0, 3.5, 0, 2 * Math.PI) },
  warning: { ground: '--event', rim: '--ink', form: (path) => polygon(path, [[0, -6.5], [6.5, 5], [-6.5, 5]]) },
  decision: { ground: '--robot-soft', rim: '--robot', form: (path) => path.roundRect(-5, -5, 10, 10, 2), sign: (path) => line(path, [[-2, -2.5], [1.5, 0], [-2, 2.5]]) },
  good: { ground: '--accent-soft', rim: '--accent', form: (path) => path.arc(0, 0, 6, 0, 2 * Math.PI), sign: (path) => line(path, [[-2.75, 0], [-0.75, 2.25], [2.75, -2.25]]) },
  bad: { ground: '--danger-soft', rim: '--danger', form: (path) => path.arc(0, 0, 7.5, 0, 2 * Math.PI), sign: cross },
}

function line(path: Path2D, [first, ...rest]: readonly Point[]): void {
  if (first) path.moveTo(...first)
  for (const point of rest) path.lineTo(...point)
}

function polygon(path: Path2D, points: readonly Point[]): void {
  line(path, points)
  path.closePath()
}

function cross(path: Path2D): void {
  line(path, [[-3, -3], [3, 3]])
  line(path, [[-3, 3], [3, -3]])
}

/** Where something happened or was decided: what calls for attention lies on top, and what is not known yet is plain. */
export function drawHappenings(pen: Pen, places: readonly Point[], toneOf: (index: number) => Tone | undefined): void {
  const { context, view, size, palette } = pen
  const rank = Object.keys(MARKS)
  const marks = places.map((place, index) => ({ place, tone: toneOf(index) ?? ('plain' as const) }))
  context.setLineDash([])
  context.lineJoin = context.lineCap = 'round'
  for (const { place, tone } of marks.sort((a, b) => rank.indexOf(a.tone) - rank.indexOf(b.tone))) {
    const { ground, rim, form, sign } = MARKS[tone]
    const [body, drawn] = [new Path2D(), new Path2D()]
    form(body)
    sign?.(drawn)
    const [x, y] = toScreen(view, size, place)
    context.save()
    context.translate(x, y)
    context.lineWidth = 4.5
    context.strokeStyle = palette.get('--stage')
    context.stroke(body)
    context.fillStyle = palette.get(ground)
    context.fill(body)
    context.lineWidth = 1.75
    context.strokeStyle = palette.get(rim)
    context.stroke(body)
    context.stroke(drawn)
    context.restore()
  }
}
