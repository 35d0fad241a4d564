import { choices } from '../figure/choices.svelte'
import { addressOf, titleOf } from '../figure/caption'
import { figures as text } from '../../locales/en/figures'
import type { Footer } from '../../render/display'
import type { Lab } from '../../stores/lab.svelte'
import { canvasesOf } from '../stage/canvases'
import { iterationsOf, type Take } from './range'
import { Replay } from './replay'

/** The last picture is seen so long, in seconds, before it begins again. */
const REST = 1.5

/** Records a take: picture after picture of a replay; `onpicture` after each. Aborted, it fails. */
export async function record(lab: Lab, take: Take, onpicture: (done: number) => void, signal: AbortSignal): Promise<Blob> {
  const replay = await Replay.open(lab, choices.theme(lab.theme.dark))
  if (!replay) throw new Error('nothing is shown')
  const stop = (): void => replay.close()
  signal.addEventListener('abort', stop)
  try {
    signal.throwIfAborted()
    // Values of one iteration say nothing of the others.
    const legend = canvasesOf(lab).legend.map((sample) => (sample.fixed ? sample : { ...sample, values: [] }))
    const link = choices.captioned ? await addressOf(lab) : ''
    const footer = (at: number): Footer | undefined =>
      choices.captioned ? { caption: [titleOf(lab, at), `${text.seed} ${lab.run.present?.seed ?? ''}`], legend, link } : undefined
    let done = 0
    for (const wanted of iterationsOf(take)) {
      const { iteration } = await replay.at(wanted)
      // The run may be over before.
      if (iteration < wanted && done > 0) break
      if (done === 0) {
        await replay.renderer.files.film({
          format: take.format,
          density: Number(choices.density),
          rate: take.rate,
          footer: footer(take.to),
        })
      }
      await replay.renderer.files.shoot(footer(iteration))
      done += 1
      onpicture(done)
      signal.throwIfAborted()
    }
    for (let rest = 0; rest < REST * take.rate; rest += 1) await replay.renderer.files.shoot()
    return await replay.renderer.files.cut()
  } finally {
    signal.removeEventListener('abort', stop)
    replay.close()
  }
}
