/* A thread that hosts a run. */
import { begin, ModuleDead } from 'forage-lab/core'
import type { FromHost, Question, ToHost } from '../protocol'
import { type Questions, questionsTo } from './questions'
import { causeOf } from './refusal'
import { from } from './files'
import { rest } from './rest'
import { RunHost } from './run-host'

/** After so many milliseconds a part that could not be loaded is asked for again. */
const RETRY = 5000

const send = (message: FromHost, transfers: Transferable[] = []): void => postMessage(message, { transfer: transfers })
const host = new RunHost(send)
const questions = questionsTo(host)
let opened: Promise<void> | undefined

/** A trap leaves the module's memory in an unknown state: the page says so, and may start another thread. */
function breakDown(error: unknown): void {
  send({ is: 'broken', message: causeOf(error) })
}

host.onbroken = breakDown

async function open({ core, files }: ToHost & { is: 'open' }): Promise<void> {
  if (files) (await rest()).serveBy(from(files))
  await begin(core)
}

async function bringLinks(): Promise<void> {
  try {
    await (await rest()).loadCode('links')
    host.link()
  } catch {
    setTimeout(() => void bringLinks(), RETRY)
  }
}

async function answer(number: number, { name, given }: Question): Promise<void> {
  try {
    const ask = questions[name as keyof Questions] as (...given: unknown[]) => Promise<unknown>
    const value = await ask(...given)
    send({ is: 'answer', number, value }, value instanceof ImageBitmap ? [value] : [])
  } catch (error) {
    if (error instanceof ModuleDead) breakDown(error)
    else send({ is: 'answer', number, error: causeOf(error) })
  }
}

function receive(message: ToHost): void {
  switch (message.is) {
    case 'open':
      opened = open(message).then(() => send({ is: 'open' }), breakDown)
      break
    case 'want':
      host.want(message.version, message.change)
      if (message.change.links) void bringLinks()
      break
    case 'ask':
      void answer(message.number, message.question)
      break
    case 'results':
      host.provide(message.id, message.results)
      break
    case 'buffer':
      host.giveBack(message.buffer)
      break
  }
}

addEventListener('message', async ({ data }: MessageEvent<ToHost>) => {
  if (data.number > 0) send({ is: 'seen', number: data.number })
  // In the order in which they came.
  await opened
  receive(data)
})
