import { PerspectiveCamera, Vector3 } from 'three'
import type { ArmScene, Point3, Scene } from '../../../pkg/node.js'
import { whole } from '../../src/render/space/kinematics'
import { aim, FIELD_OF_VIEW, fit, type Side, SIDES } from '../../src/render/space/orbit'
import { margins } from '../../src/render/view'
import type { Lab, Picture } from './lab'

/** The scene of an arm. */
export function armOf(scene: Scene): ArmScene {
  if (scene.kind !== 'arm') throw new Error(scene.kind)
  return scene
}

/** Where a point of the scene is on the page, while all is seen from a side. */
export async function seenAt(lab: Lab, scene: ArmScene, point: Point3, side: Side = 'corner'): Promise<{ x: number; y: number }> {
  const box = await lab.stage.boundingBox()
  if (!box) throw new Error('no stage')
  const camera = new PerspectiveCamera(FIELD_OF_VIEW, box.width / box.height)
  aim(camera, fit(whole(scene.workspace, scene.arm), box, margins(box.width, false), SIDES[side]))
  const at = new Vector3(...point).project(camera)
  return { x: box.x + ((at.x + 1) / 2) * box.width, y: box.y + ((1 - at.y) / 2) * box.height }
}

/** The stage as it is on the screen, once it stands still: what is drawn in space can't be read from its canvas. */
export async function shot(lab: Lab): Promise<Picture> {
  await lab.page.mouse.move(0, 0)
  // Buttons that were pressed are painted a shade otherwise. The page's policy lets in no style of a test's own, but such a sheet.
  await lab.page.evaluate(() => {
    const sheet = new CSSStyleSheet()
    sheet.replaceSync('.tools, .views { visibility: hidden }')
    document.adoptedStyleSheets = [sheet]
  })
  let last = ''
  for (;;) {
    const next = (await lab.stage.screenshot()).toString('base64')
    if (next === last) break
    last = next
  }
  await lab.page.evaluate(() => (document.adoptedStyleSheets = []))
  return lab.page.evaluate(async (content) => {
    const bytes = Uint8Array.from(atob(content), (letter) => letter.charCodeAt(0))
    const bitmap = await createImageBitmap(new Blob([bytes], { type: 'image/png' }))
    const { width, height } = bitmap
    const context = new OffscreenCanvas(width, height).getContext('2d')
    if (!context) throw new Error('no canvas')
    context.drawImage(bitmap, 0, 0)
    const seen = new Set<number>()
    let digest = 0x811c9dc5
    for (const pixel of new Uint32Array(context.getImageData(0, 0, width, height).data.buffer)) {
      digest = Math.imul(digest ^ pixel, 0x01000193)
      if (seen.size < 4096) seen.add(pixel)
    }
    return { digest: (digest >>> 0).toString(16), colours: seen.size, width, height }
  }, last)
}
