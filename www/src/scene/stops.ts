import type { Planner, Point, Scene, TourScene } from 'forage-lab'

/** Without a place of their own they lie on a circle, as the core draws them. */
const circles = new Map<number, Point[]>()

function circle(count: number): Point[] {
  const turn = (2 * Math.PI) / count
  const known = circles.get(count) ?? Array.from({ length: count }, (_, at): Point => [Math.sin(at * turn), Math.cos(at * turn)])
  circles.set(count, known)
  return known
}

/** Where a scene's stops are, in its order. */
export function stopsOf(scene: Scene): readonly Point[] {
  if (scene.kind === 'grid') return scene.stops ?? []
  if (scene.kind !== 'tour') return []
  return scene.points?.length ? scene.points : circle(scene.matrix?.length ?? 0)
}

/** Stops can be moved, added and removed, unless their distances are given. */
export const takesStops = (scene: Scene): boolean => scene.kind === 'grid' || (scene.kind === 'tour' && !scene.matrix)

/** The scene with other stops; the same if it doesn't take them. */
export function withStops<S extends Scene>(scene: S, change: (stops: Point[]) => Point[]): S {
  if (!takesStops(scene)) return scene
  const before = stopsOf(scene)
  const after = change([...before])
  if (scene.kind === 'grid') return { ...scene, stops: after }
  return { ...scene, points: after, ...(scene.kind === 'tour' && fixedIn(scene, before, after)) }
}

/** The fixed edges whose stops are still there, by their new numbers. */
function fixedIn({ fixed }: TourScene, before: readonly Point[], after: readonly Point[]): Pick<TourScene, 'fixed'> {
  if (!fixed) return {}
  const place = (stop: number): number => {
    const found = before[stop]
    return after.length >= before.length || !found ? stop : after.indexOf(found)
  }
  return { fixed: fixed.map(([a, b]): [number, number] => [place(a), place(b)]).filter((pair) => !pair.includes(-1)) }
}

/** Whether a planner runs on a scene: some call at stops, the others go from start to goal. */
export function suits({ kinds, stops }: Planner, scene: Scene): boolean {
  if (!kinds.includes(scene.kind)) return false
  if (scene.kind !== 'grid') return true
  return stops ? stopsOf(scene).length > 1 : Boolean(scene.start && scene.goal)
}
