import type { Report } from '../../engine/protocol'
import { RunClient } from '../../engine/run-client'
import type { Display, Renderer } from '../../render/display'
import { Heights } from '../../render/heights'
import { namesOf, rampOf } from '../../render/looks'
import type { Theme } from '../../render/palette'
import { viewportOf } from '../../render/viewport'
import type { Lab } from '../../stores/lab.svelte'
import { renderers } from '../../stores/renderers'
import { canvasesOf } from '../stage/canvases'

/** The run of the stage once more, in a thread and on a canvas of its own: what is seen there stays as it is. */
export class Replay {
  private readonly display: Display
  private readonly names
  private arrived: ((report: Report) => void) | null = null
  private generation = 0
  private closed = false
  /** Fails when nothing more comes: it was closed, refused, or broke down. */
  private readonly over: Promise<never>
  private fail: (message: string) => void = () => undefined

  private readonly client = new RunClient(
    {
      onopen: () => undefined,
      onreport: (report) => this.receive(report),
      onrefused: ({ message }) => this.fail(message),
      onprogress: () => undefined,
      onbroken: (message) => this.fail(message),
      onreplaced: () => undefined,
    },
    { speed: Infinity, summary: false, underway: false },
  )

  private constructor(
    private readonly lab: Lab,
    display: Display,
    theme: Theme,
    readonly renderer: Renderer,
  ) {
    const { present } = lab.run
    // A run that draws nothing of what somebody chose or points at.
    this.display = {
      ...display,
      ...(present && { scene: present.scene }),
      ...{ theme: { ...display.theme, ...theme }, fits: true, faded: false, details: null, followed: false },
      ...{ selection: null, hover: null, blamed: null, cell: null, pointed: null, chosen: null, grip: null, held: false },
    }
    const { catalogue } = lab.setup
    this.names = catalogue ? namesOf(catalogue, lab.run.drawer) : { layers: [], shapes: [] }
    renderer.show(this.display)
    // Nobody may be waiting.
    this.over = new Promise<never>((_, reject) => {
      this.fail = (message) => reject(new Error(message))
    })
    this.over.catch(() => undefined)
  }

  /** Null where there is no picture to do it like. */
  static async open(lab: Lab, theme: Theme): Promise<Replay | null> {
    const { display } = canvasesOf(lab)
    if (!display || !lab.run.present) return null
    const replays: Replay[] = []
    const listeners = {
      onreleased: (buffer: ArrayBuffer) => replays[0]?.client.giveBack(buffer),
      ondrawn: () => undefined,
      onlost: () => replays[0]?.fail('the thread that draws broke down'),
    }
    const renderer = await renderers.open(document.createElement('canvas'), listeners, display.orbit !== undefined)
    const replay = new Replay(lab, display, theme, renderer)
    replays.push(replay)
    return replay
  }

  /** Goes to an iteration; the run may end before. Its picture is the renderer's then. */
  async at(iteration: number): Promise<Report> {
    if (this.closed) throw new Error('closed')
    const arrived = new Promise<Report>((resolve) => {
      this.arrived = resolve
    })
    if (this.generation === 0) this.begin(iteration)
    else this.client.want({ target: { at: iteration, play: false } })
    const report = await Promise.race([arrived, this.over])
    const { frame } = report
    if (this.generation === 0) {
      this.generation = report.generation
      await Promise.race([this.paintHeights(), this.over])
    }
    this.renderer.show({ ...this.display, playing: report.iteration > 0 })
    this.renderer.frame(frame, this.names)
    return report
  }

  private begin(at: number): void {
    const { present } = this.lab.run
    if (!present) return
    const { planner, scene, seed, parameters: params } = present
    const { view, size, theme } = this.display
    const shown = this.lab.layers.list.filter(({ role, on }) => this.lab.layers.shows(role, on))
    const viewport = viewportOf(scene.kind === 'arm' ? [] : shown, view, size, theme.dark)
    this.client.want({ start: { setup: { planner, scene, params, seed }, at, play: false }, viewport })
    void this.client.open()
  }

  /** Those of a function lie beneath all pictures. */
  private paintHeights(): Promise<void> {
    const { scene, view, size, theme } = this.display
    const ramp = rampOf(this.lab.setup.catalogue?.heights ?? [], theme.dark)
    if (scene.kind !== 'function') return Promise.resolve()
    return new Promise((resolve) => {
      const heights = new Heights(
        (request) => this.client.api.field(request),
        (ground) => this.renderer.ground(ground),
        resolve,
      )
      heights.want(scene, view, size, this.generation, ramp)
    })
  }

  private receive(report: Report): void {
    const { arrived } = this
    if (!arrived || !report.arrived || this.client.starting || !this.client.follows(report)) {
      for (const { bitmap } of report.frame.fields) bitmap.close()
      this.client.giveBack(report.frame.buffer)
      return
    }
    this.arrived = null
    arrived(report)
  }

  close(): void {
    if (this.closed) return
    this.closed = true
    this.client.close()
    this.renderer.dispose()
    this.fail('closed')
  }
}
