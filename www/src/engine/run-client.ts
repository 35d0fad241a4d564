import * as Comlink from 'comlink'
import type { Catalogue } from 'forage-lab'
import address from 'forage-lab/catalogue.json?url'
import core from 'forage-lab/forage_bg.wasm?url'
import type { Api } from './host/run.worker'
import { Watchdog } from './watchdog'
import type { FrameMessage, FromWorker, ProgressMessage, ReturnedBuffer } from './protocol'

interface Listeners {
  onframe(frame: FrameMessage): void
  onprogress(progress: ProgressMessage): void
  oncrash(message: string): void
  /** It has not received for three seconds what it was sent. */
  onunresponsive(): void
}

/** More threads than these cost more memory than they save time. */
const MOST_HANDS = 8

/** What there is to choose from: known before any of the core is loaded. */
async function readCatalogue(): Promise<Catalogue> {
  const found = await fetch(address)
  if (!found.ok) throw new Error(`${found.status} ${found.statusText}: ${address}`)
  return found.json()
}

let compiled: Promise<WebAssembly.Module | undefined> | undefined

/** The core's first part, compiled while the worker starts. The worker loads it by itself where that fails: it says what is wrong. */
const compile = (): typeof compiled => (compiled ??= WebAssembly.compileStreaming(fetch(core)).catch(() => (compiled = undefined)))

/** One thread is left for what is seen. */
const hands = (): number => Math.min(Math.max((navigator.hardwareConcurrency || 2) - 1, 1), MOST_HANDS)

/** The thread that computes. After a crash it is thrown away and a new one started. */
export class Client {
  private worker: Worker | undefined
  private frames: MessagePort | undefined
  private remote: Comlink.Remote<Api> | undefined

  private readonly watchdog = new Watchdog(
    async () => this.remote?.ping(),
    () => this.listeners.onunresponsive(),
  )

  constructor(private readonly listeners: Listeners) {}

  get api(): Comlink.Remote<Api> {
    if (!this.remote) throw new Error('the worker is not started')
    this.expect()
    return this.remote
  }

  /** Something waits for the worker: it is looked whether it answers. */
  expect(): void {
    this.watchdog.expect()
  }

  async open(): Promise<Catalogue> {
    this.close()
    const worker = new Worker(new URL('./host/run.worker.ts', import.meta.url), { type: 'module' })
    const { port1, port2 } = new MessageChannel()
    this.worker = worker
    this.frames = port1
    this.remote = Comlink.wrap<Api>(worker)
    port1.onmessage = ({ data }: MessageEvent<FromWorker>) => {
      if (worker !== this.worker) return
      if (data.type === 'frame') this.listeners.onframe(data)
      else if (data.type === 'progress') this.listeners.onprogress(data)
      else this.listeners.oncrash(data.message)
    }
    const failed = new Promise<never>((_, reject) => {
      worker.onerror = (event) => {
        event.preventDefault()
        const message = event.message || 'worker'
        this.listeners.oncrash(message)
        reject(new Error(message))
      }
    })
    const { remote } = this
    const open = async (): Promise<void> => remote.open(Comlink.transfer(port2, [port2]), hands(), await compile())
    const [catalogue] = await Promise.all([readCatalogue(), Promise.race([open(), failed])])
    return catalogue
  }

  giveBack(buffer: ArrayBuffer): void {
    const message: ReturnedBuffer = { buffer }
    this.frames?.postMessage(message, [buffer])
  }

  close(): void {
    this.watchdog.stop()
    this.worker?.terminate()
    this.frames?.close()
    this.worker = undefined
  }
}
