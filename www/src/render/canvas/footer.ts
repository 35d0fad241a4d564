import type { Look } from 'forage-lab'
import { number } from '../../text/number'
import type { Footer } from '../display'
import { fontOf, small } from './letters'
import { applyStyle, type Pen } from './pen'

/** All in pixels of the page. */
const [MARGIN, LINE, GAP, SAMPLE] = [12, 16, 14, 22]
/** Others may see it in wider letters. */
const SPARE = 0.88

interface Row {
  font: string
  pieces: { x: number; text: string; look?: Look; line?: boolean }[]
}

export interface Sheet {
  rows: Row[]
  height: number
}

/** Where everything stands below a picture of this width. */
export function laidOut({ caption, legend, link }: Footer, width: number): Sheet {
  const scratch = new OffscreenCanvas(1, 1).getContext('2d')
  const wide = (text: string, font: string): number => {
    if (!scratch) return 6 * text.length
    scratch.font = font
    return scratch.measureText(text).width
  }
  const room = SPARE * (width - 2 * MARGIN)
  const rows: Row[] = []
  caption.forEach((text, at) => {
    const font = at === 0 ? fontOf('700 11px') : small()
    for (const line of wrapped(text.split(' '), ' ', (part) => wide(part, font) <= room))
      rows.push({ font, pieces: [{ x: MARGIN, text: line }] })
  })
  let row: Row | undefined
  let x = MARGIN
  for (const { title: name, look, line, values = [] } of legend) {
    const title = values.length > 0 ? `${name} (${values.map((value) => number(value, 3)).join(' · ')})` : name
    const end = x + SAMPLE + 6 + wide(title, small())
    if (!row || end > MARGIN + room) {
      row = { font: small(), pieces: [] }
      rows.push(row)
      x = MARGIN
    }
    row.pieces.push({ x, text: title, look, line })
    x += SAMPLE + 6 + wide(title, small()) + GAP
  }
  for (const line of wrapped([...link], '', (part) => wide(part, small()) <= room))
    rows.push({ font: small(), pieces: [{ x: MARGIN, text: line }] })
  return { rows, height: 2 * MARGIN + LINE * rows.length }
}

/** Parts in lines that fit. */
function wrapped(parts: readonly string[], between: string, fits: (line: string) => boolean): string[] {
  const lines: string[] = []
  let line = ''
  for (const part of parts) {
    const next = line === '' ? part : `${line}${between}${part}`
    if (line !== '' && !fits(next)) {
      lines.push(line)
      line = part
    } else line = next
  }
  return line === '' ? lines : [...lines, line]
}

/** Draws it below what has this height. */
export function drawFooter(pen: Pen, { rows, height }: Sheet, top: number): void {
  const { context, palette, size } = pen
  context.globalAlpha = 1
  context.setLineDash([])
  context.fillStyle = palette.get('--stage')
  context.fillRect(0, top, size.width, height)
  context.textAlign = 'left'
  context.textBaseline = 'middle'
  rows.forEach(({ font, pieces }, at) => {
    const y = top + MARGIN + LINE * (at + 0.5)
    for (const { x, text, look, line } of pieces) {
      if (look) sample(pen, look, line ?? true, x, y)
      context.font = font
      context.fillStyle = palette.get('--ink')
      context.fillText(text, look ? x + SAMPLE + 6 : x, y)
    }
  })
}

/** A layer's look: a stretch of a line, a point, or the colours of a field. */
function sample(pen: Pen, look: Look, line: boolean, x: number, y: number): void {
  const { context, palette } = pen
  if (look.ramp) {
    const side = SAMPLE / look.ramp.length
    look.ramp.forEach((colour, at) => {
      context.fillStyle = palette.get(colour)
      context.fillRect(x + at * side, y - 4, side + 0.5, 8)
    })
    return
  }
  applyStyle(pen, { ...look, width: Math.max(1.5, look.width) })
  context.beginPath()
  if (line) {
    context.moveTo(x, y)
    context.lineTo(x + SAMPLE, y)
    context.stroke()
  } else {
    context.arc(x + SAMPLE / 2, y, 3, 0, 2 * Math.PI)
    context.fill()
  }
  context.setLineDash([])
}
