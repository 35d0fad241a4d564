import * as Comlink from 'comlink'
import { load, ModuleDead, ready } from 'forage-lab'
import type { UncheckedSetup } from 'forage-lab'
import { causeOf } from './broken'
import type { Answer, FieldRequest, Look } from './protocol'
import type { Picture, Settled, Start } from './race.protocol'
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

const api = {
  async start(setup: UncheckedSetup): Promise<Answer<Start>> {
    const found = await own()
    try {
      return { ok: true, value: await ready(() => found.start(setup)) }
    } catch (error) {
      // The engine itself broke down: its memory is in an unknown state.
      if (error instanceof ModuleDead || !(error instanceof Error)) throw new Error(causeOf(error), { cause: error })
      return { ok: false, refusal: { message: error.message, field: 'field' in error ? String(error.field) : '' } }
    }
  },
  go: async (clock: number): Promise<Picture | null> => sent(await (await own()).go(clock)),
  /** It has seen what it was told before. */
  hear: (): void => undefined,
  halt: (): void => racer?.halt(),
  look: async (look: Look): Promise<Picture | null> => sent((await own()).look(look)),
  async settle(): Promise<Settled | null> {
    const found = await own()
    return ready(() => found.settle())
  },
  giveBack: (buffer: ArrayBuffer): void => racer?.giveBack(buffer),
  async field({ min, max, width, height, ramp }: FieldRequest): Promise<ImageBitmap | null> {
    const canvas = new OffscreenCanvas(width, height)
    const context = canvas.getContext('2d')
    if (!context || !(await own()).session?.paintField(context, min, max, ramp)) return null
    const picture = canvas.transferToImageBitmap()
    return Comlink.transfer(picture, [picture])
  },
}

export type RaceApi = typeof api
Comlink.expose(api)
