import type { ArmScene, Point3, Scene } from '../../../pkg/node.js'
import { whole } from '../../src/render/space/kinematics'
import { Camera } from '../../src/render/space/camera'
import { fit, type Side, SIDES } from '../../src/render/space/orbit'
import { margins } from '../../src/render/view'
import { expect, type Lab, type Picture } from './lab'

/** Pictures that follow each other and are the same: after them nothing more comes. */
const STILL = 3

/** The scene of an arm. */
export function armOf(scene: Scene): ArmScene {
  if (scene.kind !== 'arm') throw new Error(scene.kind)
  return scene
}

/** Where a point of the scene is on the page, while all is seen from a side. */
export async function seenAt(lab: Lab, scene: ArmScene, point: Point3, side: Side = 'corner'): Promise<{ x: number; y: number }> {
  const box = await lab.stage.boundingBox()
  if (!box) throw new Error('no stage')
  const camera = new Camera(fit(whole(scene.workspace, scene.arm), box, margins(box.width, false), SIDES[side]), box)
  const at = camera.project(point)
  if (!at) throw new Error('behind the eye')
  return { x: box.x + at.x, y: box.y + at.y }
}

/** The stage as it is on the screen, once it stands still. */
export async function shot(lab: Lab): Promise<Picture> {
  await lab.page.mouse.move(0, 0)
  // Buttons that were pressed are painted a shade otherwise, and so is a rim of words over the stage once they were hidden. The page's policy lets in no style of a test's own, but such a sheet.
  await lab.page.evaluate(() => {
    const sheet = new CSSStyleSheet()
    sheet.replaceSync('.tools, .views, .verified { visibility: hidden }')
    document.adoptedStyleSheets = [sheet]
  })
  await expect(lab.stage).toHaveAttribute('data-drawn')
  // It is drawn by another thread: what has changed is seen a moment later.
  let [last, still] = ['', 0]
  while (still < STILL) {
    const next = (await lab.stage.screenshot()).toString('base64')
    still = next === last ? still + 1 : 0
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
