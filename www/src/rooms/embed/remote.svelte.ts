import type { RunCommand, RunEvent, RunState } from 'forage-lab/embed'
import type { Lab } from '../../stores/lab.svelte'

export const stateOf = ({ playback, run, scene, setup }: Lab): RunState => ({
  planner: setup.plannerName,
  scene: scene.present?.name ?? '',
  seed: setup.seed,
  iteration: playback.iteration,
  limit: run.limit,
  status: run.status,
  playing: playback.playing,
  hash: playback.hash,
})

/** Does what is asked for; what makes no sense is refused in words. */
export function obey(lab: Lab, command: RunCommand): void {
  const { playback } = lab
  switch (command.is) {
    case 'play':
      playback.play()
      break
    case 'pause':
      playback.pause()
      break
    case 'step':
      playback.stepBy(wholeNumber('by', command.by ?? 1))
      break
    case 'seek':
      playback.seek(command.to === Infinity ? Infinity : wholeNumber('to', command.to))
      break
    case 'open':
      if (typeof command.link !== 'string') throw new TypeError(`link: ${String(command.link)} is not a text.`)
      void lab.openLink(command.link)
      break
    default:
      throw new TypeError(`is: ${JSON.stringify((command as { is: unknown }).is)} is none of 'play', 'pause', 'step', 'seek', 'open'.`)
  }
}

function wholeNumber(field: string, value: unknown): number {
  if (!Number.isSafeInteger(value)) throw new TypeError(`${field}: ${JSON.stringify(value)} is not a whole number.`)
  return value as number
}

/** Tells what happens until the returned function is called. */
export function tell(lab: Lab, listener: (event: RunEvent) => void): () => void {
  let told = { generation: -1, iteration: -1, hash: '', ended: false }
  let wrong = ''
  return $effect.root(() => {
    $effect(() => {
      const { iteration, hash, stale } = lab.playback
      const { present, finished } = lab.run
      if (!present || stale) return
      const { generation } = present
      const fresh = generation !== told.generation
      if (!fresh && iteration === told.iteration && hash === told.hash) return
      const ended = finished && hash !== ''
      const before = told
      told = { generation, iteration, hash, ended }
      const state = stateOf(lab)
      if (fresh) listener({ is: 'ready', state })
      if (fresh || iteration !== before.iteration || hash !== '') listener({ is: 'step', state })
      if (ended && (fresh || !before.ended)) listener({ is: 'end', state })
    })
    $effect(() => {
      const { crash, notices, run } = lab
      const message = crash || (run.refusal?.message ?? notices.unloaded?.message ?? notices.text)
      if (message !== '' && message !== wrong) listener({ is: 'error', message })
      wrong = message
    })
  })
}
