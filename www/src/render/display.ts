/* What a renderer is given: what is to be seen, as one state, and the frames of a run. */
import type { ArmSolutions, EventKind, Inspection, Item, Look, Point, Point3, Reachability, Scene } from 'forage-lab'
import type { Cell } from '../scene/cells'
import type { Handle, Selection } from '../scene/edits'
import type { FilmFormat } from './film/film'
import type { Frame } from './frame'
import type { Names } from './looks'
import type { Theme } from './palette'
import type { Grip } from './space/handles'
import type { Orbit } from './space/orbit'
import type { Angles } from './space/projection'
import type { Box, Flat, Size, View } from './view'

/** A line over the layers of the frame. */
export interface Overlay {
  points: readonly Flat[]
  look: Look
}

/** What an inspection draws, and how it is to look there. */
export interface Detail extends Pick<Inspection['layers'][number], 'role' | 'shape' | 'vertices'> {
  look: Look
}

/** What is seen in space, and from where. */
export interface InSpace {
  orbit: Orbit
  /** The arm's joints, in degrees; null: at home. */
  posture: readonly number[] | null
  /** The arm touches something. */
  touching: boolean
  /** The radius that its links have at least, in metres. */
  thickness: number
  /** Postures beside its own, and which of them is meant. */
  ghosts: ArmSolutions | null
  ghost: number | null
  /** Where the tip can come. */
  reach: Reachability | null
  /** Points with a ring: one that is pointed at, and one that is chosen. */
  pointed: Item | null
  chosen: Item | null
  /** What is under the pointer, and whether it is held. */
  grip: Grip | null
  held: boolean
}

/** A picture of all that is seen but the frame's layers; with an orbit, in space. */
export interface Display extends Partial<InSpace> {
  scene: Scene
  view: View
  size: Size
  /** Pixels of the screen a pixel of the page. */
  density: number
  theme: Theme
  /** The frame is one of this scene, or of one of its kind. */
  fits: boolean
  /** The picture is not yet that of the scene. */
  faded: boolean
  /** The keys of the layers that are not drawn. */
  hidden: readonly string[]
  overlays: readonly Overlay[]
  /** The keys of the layers that stand out: all else is faint. */
  highlighted: readonly string[] | null
  /** What is looked at closer: all else is faint. */
  details: readonly Detail[] | null
  /** The result is followed in a layer above this one. */
  followed: boolean
  /** What is looked for is a tour: start and goal mean nothing. */
  touring: boolean
  /** The run plays: moving obstacles are on their way. */
  playing: boolean
  /** What calls for attention, by event; null: events are not shown. */
  tones: readonly EventKind['tone'][] | null
  selection: Selection | null
  hover: Handle | null
  /** The object that the scene is refused for. */
  blamed: Selection | null
  /** The cell that is pointed at. */
  cell: Cell | null
  /** Labels. */
  words: { start: string; goal: string }
  /** An arm's scene is seen from this side, with the arm at home. */
  space: { angles: Angles; skeleton: readonly Point3[] } | null
}

/** The heat map of a function. */
export interface Ground {
  bitmap: ImageBitmap
  box: Box
}

/** An entry of a legend. */
export interface Sample {
  title: string
  look: Look
  /** A stretch of a line stands for it, else a point. */
  line: boolean
  /** The values of its colours, from the first to the last. */
  values?: readonly number[]
  /** They hold at every iteration. */
  fixed?: boolean
}

/** What stands below a picture in a file. */
export interface Footer {
  /** What it shows, line by line; the first one is the title. */
  caption: readonly string[]
  legend: readonly Sample[]
  /** The address of the run. */
  link: string
}

/** How a picture in a file differs from what is seen. */
export interface Looks {
  footer?: Footer | undefined
  /** Its colours; absent: those that are seen. */
  theme?: Theme | undefined
}

/** A recording that is to be made. */
export interface Filming {
  format: FilmFormat
  /** Pixels a pixel of the page. */
  density: number
  /** Pictures a second. */
  rate: number
  /** As tall as the first picture's, there is room for each one's own. */
  footer?: Footer | undefined
}

/** What is seen, as files. */
export interface CanvasFiles {
  /** What is seen, as SVG with this title. */
  svg(caption: string, looks?: Looks): Promise<string>
  /** What is seen, as PNG with so many pixels a pixel of the page. */
  picture(density: number, looks?: Looks): Promise<Blob>
  /** Begins a recording. */
  film(filming: Filming): Promise<void>
  /** What is seen, as its next picture. */
  shoot(footer?: Footer): Promise<void>
  /** Ends it. */
  cut(): Promise<Blob>
}

/** Draws one canvas. What was given last counts. */
export interface Renderer {
  show(display: Display): void
  /** It is the renderer's from now on. */
  frame(frame: Frame, names: Names): void
  ground(ground: Ground | null): void
  readonly files: CanvasFiles
  /** The nearest of these layers' points that are shown in space and seen within this reach, in pixels; its index is that in the frame. */
  nearest(at: Point, reach: number, layers: readonly string[]): Promise<Item | null>
  dispose(): void
}

export type SpaceState = 'none' | 'lost' | 'there'

export interface RendererListeners {
  /** A frame was drawn for the last time. */
  onreleased(buffer: ArrayBuffer): void
  /** The first frame was drawn. */
  ondrawn(): void
  /** Whether pictures of space can be made: not at all, not at the moment, or again. */
  onspace?(state: SpaceState): void
}
