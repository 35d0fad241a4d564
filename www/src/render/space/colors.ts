import { Color } from 'three'
import type { Color as Named } from 'forage-lab'
import type { Palette } from '../palette'

/** The colour of a token, or of a look. */
export const colourOf = (palette: Palette, which: string | Named): Color => new Color(palette.get(which))

/** Between two colours, as they are seen. */
export function mixed(from: Color, to: Color, share: number): Color {
  const [a, b] = [from.clone().convertLinearToSRGB(), to.clone().convertLinearToSRGB()]
  return a.lerp(b, share).convertSRGBToLinear()
}
