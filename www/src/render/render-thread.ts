/* A thread that draws: one for all canvases of a page. */
import { useLetters } from './canvas/letters'
import { CanvasRenderer } from './canvas/renderer'
import type { Display } from './display'
import type { Names } from './looks'
import type { Asked, FromRenderer, ToRenderer } from './protocol'

interface Drawn {
  renderer: CanvasRenderer
  display: Partial<Display>
  names: Names
}

const canvases = new Map<number, Drawn>()
const send = (message: FromRenderer, transfer: Transferable[] = []): void => postMessage(message, { transfer })

/** Some browsers draw space only on a page. */
function probe(canvas: number): void {
  const context = new OffscreenCanvas(1, 1).getContext('webgl2')
  send({ canvas, is: 'probed', able: context !== null })
  context?.getExtension('WEBGL_lose_context')?.loseContext()
}

/** Threads have letters of their own. */
async function letter(canvas: number, address: string): Promise<void> {
  const { fonts } = self as unknown as { fonts?: FontFaceSet }
  try {
    fonts?.add(await new FontFace('Inter', `url("${address}")`, { weight: '100 900' }).load())
    useLetters()
    for (const { renderer } of canvases.values()) renderer.refresh()
  } catch {
    // The system's are there.
  }
  send({ canvas, is: 'lettered' })
}

function open(canvas: number, element: OffscreenCanvas): void {
  const renderer = new CanvasRenderer(element, {
    onreleased: (buffer) => send({ canvas, is: 'released', buffer }, [buffer]),
    ondrawn: () => send({ canvas, is: 'drawn' }),
    onspace: (state) => send({ canvas, is: 'space', state }),
  })
  canvases.set(canvas, { renderer, display: {}, names: { layers: [], shapes: [] } })
}

const found = (renderer: CanvasRenderer, asked: Asked): Promise<unknown> =>
  asked.for === 'nearest'
    ? renderer.nearest(asked.at, asked.reach, asked.layers)
    : (renderer.files[asked.for] as (...given: unknown[]) => Promise<unknown>)(...asked.given)

async function answer(canvas: number, renderer: CanvasRenderer, asked: Asked & { id: number }): Promise<void> {
  const { id } = asked
  try {
    send({ canvas, is: 'answer', id, value: await found(renderer, asked) })
  } catch (error) {
    send({ canvas, is: 'refused', id, message: String(error) })
  }
}

addEventListener('message', ({ data }: MessageEvent<ToRenderer>) => {
  if (data.is === 'open') open(data.canvas, data.element)
  if (data.is === 'probe') probe(data.canvas)
  if (data.is === 'letters') void letter(data.canvas, data.address)
  const drawn = canvases.get(data.canvas)
  if (!drawn) return
  const { renderer } = drawn
  switch (data.is) {
    case 'show':
      // The first change is the whole of it.
      drawn.display = { ...drawn.display, ...data.change }
      renderer.show(drawn.display as Display)
      break
    case 'frame':
      drawn.names = data.names ?? drawn.names
      renderer.frame(data.frame, drawn.names)
      break
    case 'ground':
      renderer.ground(data.ground)
      break
    case 'ask':
      void answer(data.canvas, renderer, data)
      break
    case 'close':
      renderer.dispose()
      canvases.delete(data.canvas)
      send({ canvas: data.canvas, is: 'closed' })
      break
  }
})
