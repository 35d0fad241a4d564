import type { Moving, Point, Scene } from 'forage-lab'

/* What every scene's edits need of moving obstacles; what only their own tools need is in aiming.ts. */

const NONE: readonly Moving[] = []

/** A scene's moving obstacles, in its order. */
export const movingOf = (scene: Scene): readonly Moving[] => (scene.kind === 'grid' ? (scene.moving ?? NONE) : NONE)

/** The scene with other moving obstacles; the same if it takes none. A scene without any doesn't mention them. */
export function withMoving<S extends Scene>(scene: S, change: (moving: Moving[]) => Moving[]): S {
  if (scene.kind !== 'grid') return scene
  const { moving: _before, ...rest } = scene
  const moving = change([...movingOf(scene)])
  return (moving.length > 0 ? { ...rest, moving } : rest) as S
}

/** An obstacle's places, its start and its way-points, each put elsewhere. */
export function placed(moving: Moving, to: (at: Point) => Point): Moving {
  const { waypoints } = moving
  return {
    ...moving,
    center: to(moving.center),
    ...(waypoints && { waypoints: waypoints.map(([time, x, y]): [number, number, number] => [time, ...to([x, y])]) }),
  }
}
