import { sceneText } from './scene-text'
import type { Scene } from 'forage-lab'

/** The unit of a scene's lengths, with the space before it; nothing where they have none. */
export function unitOf(scene: Scene | null): string {
  // An arm's scene has angles too.
  if (scene?.kind === 'arm') return ' m'
  return scene?.units && scene.units !== 'unitless' ? ` ${sceneText(scene.units)}` : ''
}
