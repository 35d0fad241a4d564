import type { Context, Path } from '../canvas/pen'
import { VectorPath } from './path'

type Matrix = readonly [a: number, b: number, c: number, d: number, e: number, f: number]
type Attributes = Record<string, string | number | undefined>

const IDENTITY: Matrix = [1, 0, 0, 1, 0, 0]

const times = ([a, b, c, d, e, f]: Matrix, [g, h, i, j, k, l]: Matrix): Matrix => [
  a * g + c * h,
  b * g + d * h,
  a * i + c * j,
  b * i + d * j,
  a * k + c * l + e,
  b * k + d * l + f,
]

const ENTITIES: Readonly<Record<string, string>> = { '&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;' }
// Control characters that XML has no place for are left out.
const escaped = (text: string): string =>
  text.replace(/[&<>"]/g, (letter) => ENTITIES[letter] ?? '').replace(/[^\t\n\r\u0020-\ud7ff\ue000-\ufffd\u{10000}-\u{10ffff}]/gu, '')

const tag = (name: string, attributes: Attributes, content = ''): string => {
  const written = Object.entries(attributes).map(([key, value]) => (value === undefined ? '' : ` ${key}="${escaped(String(value))}"`))
  return content === '' ? `<${name}${written.join('')}/>` : `<${name}${written.join('')}>${content}</${name}>`
}

/** A hatch, as SVG has it. */
class VectorPattern {
  matrix: Matrix = IDENTITY

  constructor(
    readonly id: string,
    readonly tile: Picture,
  ) {}

  setTransform(matrix?: DOMMatrix2DInit): void {
    const { a = 1, b = 0, c = 0, d = 1, e = 0, f = 0 } = matrix ?? {}
    this.matrix = [a, b, c, d, e, f]
  }
}

/** What was on a canvas when it was drawn. */
interface Picture {
  width: number
  height: number
  address: Promise<string>
}

async function addressOf(canvas: OffscreenCanvas): Promise<string> {
  const bytes = new Uint8Array(await (await canvas.convertToBlob()).arrayBuffer())
  let text = ''
  // All at once would be more arguments than a call may have.
  for (let at = 0; at < bytes.length; at += 8192) text += String.fromCharCode(...bytes.subarray(at, at + 8192))
  return `data:image/png;base64,${btoa(text)}`
}

function copied(source: CanvasImageSource): Picture {
  const { width, height } = source as OffscreenCanvas | ImageBitmap
  const canvas = new OffscreenCanvas(Math.max(1, width), Math.max(1, height))
  canvas.getContext('2d')?.drawImage(source, 0, 0)
  return { width, height, address: addressOf(canvas) }
}

interface State {
  fillStyle: string | CanvasGradient | CanvasPattern
  strokeStyle: string | CanvasGradient | CanvasPattern
  globalAlpha: number
  lineWidth: number
  lineCap: CanvasLineCap
  lineJoin: CanvasLineJoin
  font: string
  textAlign: CanvasTextAlign
  textBaseline: CanvasTextBaseline
  imageSmoothingEnabled: boolean
  dash: readonly number[]
  matrix: Matrix
  clip: string | undefined
}

const FIRST: State = {
  fillStyle: '',
  strokeStyle: '',
  globalAlpha: 1,
  lineWidth: 1,
  lineCap: 'butt',
  lineJoin: 'miter',
  font: '',
  textAlign: 'left',
  textBaseline: 'alphabetic',
  imageSmoothingEnabled: true,
  dash: [],
  matrix: IDENTITY,
  clip: undefined,
}

const ANCHORS: Partial<Record<CanvasTextAlign, string>> = { center: 'middle', right: 'end' }
/** How far beneath its place a text stands, as a share of its size: not all that reads SVG knows other lines than the base line. */
const BELOW: Partial<Record<CanvasTextBaseline, number>> = { middle: 0.32, bottom: -0.24, top: 0.8 }

/** Writes down as SVG what is drawn: what a canvas takes of lines, areas, text and pictures. */
export class VectorContext implements Context {
  fillStyle = FIRST.fillStyle
  strokeStyle = FIRST.strokeStyle
  globalAlpha = FIRST.globalAlpha
  lineWidth = FIRST.lineWidth
  lineCap = FIRST.lineCap
  lineJoin = FIRST.lineJoin
  font = FIRST.font
  textAlign = FIRST.textAlign
  textBaseline = FIRST.textBaseline
  imageSmoothingEnabled = FIRST.imageSmoothingEnabled
  imageSmoothingQuality: ImageSmoothingQuality = 'low'
  private dash = FIRST.dash
  private matrix = FIRST.matrix
  private clipped = FIRST.clip
  private readonly saved: State[] = []
  private current = new VectorPath()
  private readonly body: (string | Promise<string>)[] = []
  private readonly defined: (string | Promise<string>)[] = []
  private ids = 0
  private within = false

  /** `density` pixels of what it is drawn with are one of the picture. */
  constructor(
    private readonly width: number,
    private readonly height: number,
    private readonly density: number,
  ) {}

  /** A path that can be written down. */
  path(d?: string): Path {
    return new VectorPath(d)
  }

  /** What follows is of this layer: together, and by its name, for those who work on with the file. */
  layer(role: string | null): void {
    if (this.within) this.body.push('</g>')
    this.within = role !== null
    if (role !== null) this.body.push(`<g class="${escaped(role)}">`)
  }

  /** What was drawn, to be put into another drawing of the same size: without what it defines. */
  async content(): Promise<string> {
    this.layer(null)
    return (await Promise.all(this.body)).join('\n')
  }

  async svg(caption: string): Promise<string> {
    const [defined, body] = await Promise.all([Promise.all(this.defined), Promise.all(this.body)])
    const size = { width: this.width, height: this.height, viewBox: `0 0 ${this.width} ${this.height}` }
    const content = [tag('title', {}, escaped(caption)), tag('defs', {}, defined.join('\n') || ' '), ...body]
    return `${tag('svg', { xmlns: 'http://www.w3.org/2000/svg', ...size, role: 'img' }, `\n${content.join('\n')}\n`)}\n`
  }

  save(): void {
    const { dash, matrix, clipped: clip } = this
    const { fillStyle, strokeStyle, globalAlpha, lineWidth, lineCap, lineJoin, font, textAlign, textBaseline } = this
    const { imageSmoothingEnabled } = this
    this.saved.push({
      ...{ fillStyle, strokeStyle, globalAlpha, lineWidth, lineCap, lineJoin, font, textAlign, textBaseline },
      ...{ imageSmoothingEnabled, dash, matrix, clip },
    })
  }

  restore(): void {
    const state = this.saved.pop()
    if (!state) return
    const { clip, ...rest } = state
    Object.assign(this, rest)
    this.clipped = clip
  }

  setTransform(a: number, b: number, c: number, d: number, e: number, f: number): void {
    this.matrix = times([1 / this.density, 0, 0, 1 / this.density, 0, 0], [a, b, c, d, e, f])
  }

  translate(x: number, y: number): void {
    this.matrix = times(this.matrix, [1, 0, 0, 1, x, y])
  }

  scale(x: number, y: number): void {
    this.matrix = times(this.matrix, [x, 0, 0, y, 0, 0])
  }

  rotate(angle: number): void {
    const [cos, sin] = [Math.cos(angle), Math.sin(angle)]
    this.matrix = times(this.matrix, [cos, sin, -sin, cos, 0, 0])
  }

  setLineDash(dash: number[]): void {
    this.dash = dash
  }

  beginPath(): void {
    this.current = new VectorPath()
  }

  moveTo(x: number, y: number): void {
    this.current.moveTo(x, y)
  }

  lineTo(x: number, y: number): void {
    this.current.lineTo(x, y)
  }

  closePath(): void {
    this.current.closePath()
  }

  rect(x: number, y: number, width: number, height: number): void {
    this.current.rect(x, y, width, height)
  }

  roundRect(x: number, y: number, width: number, height: number, radius: number): void {
    this.current.roundRect(x, y, width, height, radius)
  }

  arc(x: number, y: number, radius: number, from: number, to: number): void {
    this.current.arc(x, y, radius, from, to)
  }

  stroke(path: Path = this.current): void {
    const { d } = path as VectorPath
    if (d !== '') this.put('path', { d, fill: 'none', ...this.line() })
  }

  fill(path: Path = this.current): void {
    const { d } = path as VectorPath
    if (d !== '') this.put('path', { d, ...this.paint('fill', this.fillStyle) })
  }

  clip(path: Path = this.current): void {
    this.clipped = this.define('clipPath', { ...this.shared(), 'clip-path': this.clipped }, tag('path', { d: (path as VectorPath).d }))
  }

  fillRect(x: number, y: number, width: number, height: number): void {
    this.put('rect', { x, y, width, height, ...this.paint('fill', this.fillStyle) })
  }

  strokeRect(x: number, y: number, width: number, height: number): void {
    this.put('rect', { x, y, width, height, fill: 'none', ...this.line() })
  }

  fillText(text: string, x: number, y: number): void {
    this.put('text', { x, y, ...this.type(), ...this.paint('fill', this.fillStyle) }, escaped(text))
  }

  strokeText(text: string, x: number, y: number): void {
    this.put('text', { x, y, ...this.type(), fill: 'none', ...this.line() }, escaped(text))
  }

  drawImage(source: CanvasImageSource, x: number, y: number, width?: number, height?: number): void {
    const picture = copied(source)
    const attributes = {
      ...{ x, y, width: width ?? picture.width, height: height ?? picture.height, preserveAspectRatio: 'none' },
      'image-rendering': this.imageSmoothingEnabled ? undefined : 'pixelated',
      opacity: this.globalAlpha === 1 ? undefined : this.globalAlpha,
      ...this.shared(),
    }
    this.body.push(picture.address.then((href) => tag('image', { ...attributes, href })))
  }

  createPattern(source: CanvasImageSource): CanvasPattern {
    this.ids += 1
    return new VectorPattern(`p${this.ids}`, copied(source))
  }

  private put(name: string, attributes: Attributes, content?: string): void {
    this.body.push(tag(name, { ...attributes, ...this.shared() }, content))
  }

  private define(name: string, attributes: Attributes, content: string): string {
    this.ids += 1
    const id = `d${this.ids}`
    this.defined.push(tag(name, { id, ...attributes }, content))
    return `url(#${id})`
  }

  private shared(): Attributes {
    const { matrix } = this
    const moved = matrix.some((part, at) => part !== IDENTITY[at])
    return { transform: moved ? `matrix(${matrix.join(' ')})` : undefined, 'clip-path': this.clipped }
  }

  private line(): Attributes {
    return {
      ...this.paint('stroke', this.strokeStyle),
      'stroke-width': this.lineWidth,
      'stroke-linecap': this.lineCap === 'butt' ? undefined : this.lineCap,
      'stroke-linejoin': this.lineJoin === 'miter' ? undefined : this.lineJoin,
      'stroke-dasharray': this.dash.length > 0 ? this.dash.join(' ') : undefined,
    }
  }

  /** Not all that reads SVG knows colours with an opacity: it is written apart. */
  private paint(what: 'fill' | 'stroke', style: State['fillStyle']): Attributes {
    let [color, opacity] = ['none', this.globalAlpha]
    if (typeof style === 'string') {
      color = style.slice(0, 7)
      if (style.length > 7) opacity *= Number.parseInt(style.slice(7), 16) / 255
    } else if (style instanceof VectorPattern) {
      color = this.filling(style)
    }
    return { [what]: color, [`${what}-opacity`]: opacity === 1 ? undefined : opacity }
  }

  private filling({ id, tile: { width, height, address }, matrix }: VectorPattern): string {
    const place = { id, width, height, patternUnits: 'userSpaceOnUse', patternTransform: `matrix(${matrix.join(' ')})` }
    this.defined.push(address.then((href) => tag('pattern', place, tag('image', { width, height, href }))))
    return `url(#${id})`
  }

  private type(): Attributes {
    const [, style, weight, size, family] = /^(?:(italic) )?(?:(\d+) )?([\d.]+)px (.*)$/.exec(this.font) ?? []
    return {
      'font-family': family,
      'font-style': style,
      'font-size': size,
      'font-weight': weight,
      'text-anchor': ANCHORS[this.textAlign],
      dy: Number(size) * (BELOW[this.textBaseline] ?? 0) || undefined,
    }
  }
}
