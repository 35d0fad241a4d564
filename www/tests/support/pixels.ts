import sharp from 'sharp'

/** The share of pixels in which two pictures of one size differ by more than this in a channel. */
export async function difference(one: Buffer, other: Buffer, noticed: number): Promise<number> {
  const read = async (image: Buffer) => sharp(image).removeAlpha().raw().toBuffer({ resolveWithObject: true })
  const [a, b] = await Promise.all([read(one), read(other)])
  const { width, height } = a.info
  if (b.info.width !== width || b.info.height !== height) throw new Error(`${width} × ${height} and ${b.info.width} × ${b.info.height}`)
  let different = 0
  for (let at = 0; at < a.data.length; at += 3) {
    if ([0, 1, 2].some((channel) => Math.abs((a.data[at + channel] ?? 0) - (b.data[at + channel] ?? 0)) > noticed)) different += 1
  }
  return different / (width * height)
}

/** A picture that a canvas or a page gave as an address. */
export const decoded = (address: string): Buffer => Buffer.from(address.slice(address.indexOf(',') + 1), 'base64')
