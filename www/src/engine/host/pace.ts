import type { Status } from 'forage-lab'

/** How long the worker computes before it listens again, in milliseconds. */
export const SLICE = 12

const channel = new MessageChannel()
const waiting: (() => void)[] = []
channel.port1.onmessage = () => waiting.shift()?.()

/** Lets commands in; unlike a timer it costs no 4 ms. */
export function breathe(): Promise<void> {
  return new Promise((resolve) => {
    waiting.push(resolve)
    channel.port2.postMessage(0)
  })
}

/** A run or a trial whose long steps are taken in parts. */
interface Stepped {
  advance(): Status | 'partly'
}

/** Takes a step, listening between the parts of a long one; false if it is not `wanted` any more: then it has only begun. */
export async function step(run: Stepped, wanted: () => boolean): Promise<boolean> {
  let until = performance.now() + SLICE
  while (run.advance() === 'partly') {
    if (performance.now() < until) continue
    await breathe()
    if (!wanted()) return false
    until = performance.now() + SLICE
  }
  return true
}

export function wait(milliseconds: number): Promise<void> {
  return new Promise((resolve) => setTimeout(resolve, milliseconds))
}
