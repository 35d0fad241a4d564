/* A thread that draws: one for all canvases of a page. */
import { CanvasRenderer } from './canvas/renderer'
import type { Display } from './display'
import type { Names } from './looks'
import type { FromRenderer, ToRenderer, Wanted } from './protocol'

interface Drawn {
  renderer: CanvasRenderer
  display: Partial<Display>
  names: Names
}

const canvases = new Map<number, Drawn>()
const send = (message: FromRenderer, transfer: Transferable[] = []): void => postMessage(message, { transfer })

function open(canvas: number, element: OffscreenCanvas): void {
  const renderer = new CanvasRenderer(element, {
    onreleased: (buffer) => send({ canvas, is: 'released', buffer }, [buffer]),
    ondrawn: () => send({ canvas, is: 'drawn' }),
  })
  canvases.set(canvas, { renderer, display: {}, names: { layers: [], shapes: [] } })
}

async function make(canvas: number, renderer: CanvasRenderer, { id, ...wanted }: Wanted & { id: number }): Promise<void> {
  try {
    const file = await (wanted.as === 'svg' ? renderer.svg(wanted.caption) : renderer.picture(wanted.density))
    send({ canvas, is: 'made', id, file })
  } catch (error) {
    send({ canvas, is: 'failed', id, message: String(error) })
  }
}

addEventListener('message', ({ data }: MessageEvent<ToRenderer>) => {
  if (data.is === 'open') open(data.canvas, data.element)
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
    case 'make':
      void make(data.canvas, renderer, data)
      break
    case 'close':
      renderer.dispose()
      canvases.delete(data.canvas)
      send({ canvas: data.canvas, is: 'closed' })
      break
  }
})
