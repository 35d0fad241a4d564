import { Color } from 'three'
import type { Palette } from '../stage/palette'

/** A token's colour. */
export const colourOf = (palette: Palette, token: string): Color => new Color(palette.get(token))

/** Between two colours, as they are seen. */
export function mixed(from: Color, to: Color, share: number): Color {
  const [a, b] = [from.clone().convertLinearToSRGB(), to.clone().convertLinearToSRGB()]
  return a.lerp(b, share).convertSRGBToLinear()
}
