import * as Comlink from 'comlink'
import { load, ready } from 'forage-lab'
import type { UncheckedSetup } from 'forage-lab'
import { causeOf, refusalOf } from './refusal'
import type { FieldRequest, Viewport } from '../../render/frame'
import type { Answer } from '../protocol'
import type { Picture, Settled, Start } from '../race.protocol'
import { Racer } from './racer'

let racer: Racer | undefined

async function own(): Promise<Racer> {
  await load()
  racer ??= new Racer()
  return racer
}

/** Pictures travel, they aren't copied. */
const sent = (picture: Picture | null): Picture | null =>
  picture && Comlink.transfer(picture, [picture.buffer, ...picture.fields.map(({ bitmap }) => bitmap)])

/** Has the racer do something. An error has a short message: the lane shows it. */
async function act<T>(action: (found: Racer) => T | Promise<T>): Promise<T> {
  try {
    return await action(await own())
  } catch (error) {
    throw new Error(causeOf(error), { cause: error })
  }
}

const api = {
  start: (setup: UncheckedSetup): Promise<Answer<Start>> =>
    act(async (found): Promise<Answer<Start>> => {
      try {
        return { ok: true, value: await ready(() => found.start(setup)) }
      } catch (error) {
        const refusal = refusalOf(error)
        if (!refusal) throw error
        return { ok: false, refusal }
      }
    }),
  go: (clock: number): Promise<Picture | null> => act(async (found) => sent(await found.go(clock))),
  /** It has received what was sent before. */
  ping: (): void => undefined,
  halt: (): void => racer?.halt(),
  look: (look: Viewport): Promise<Picture | null> => act(async (found) => sent(await found.look(look))),
  settle: (): Promise<Settled | null> => act((found) => ready(() => found.settle())),
  giveBack: (buffer: ArrayBuffer): void => racer?.giveBack(buffer),
  field: ({ min, max, width, height, ramp }: FieldRequest): Promise<ImageBitmap | null> =>
    act((found) => {
      const canvas = new OffscreenCanvas(width, height)
      const context = canvas.getContext('2d')
      if (!context || !found.session?.paintField(context, min, max, ramp)) return null
      const picture = canvas.transferToImageBitmap()
      return Comlink.transfer(picture, [picture])
    }),
}

export type RaceApi = typeof api
Comlink.expose(api)
