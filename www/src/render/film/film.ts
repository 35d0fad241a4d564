/* Recordings: picture after picture of one size, as one file. */
import type { Encoder, FilmContext } from './encoder'

/** What recordings are saved as. */
export type FilmFormat = 'webm' | 'mp4' | 'gif'

/** The sides of a picture are even: videos have no others. */
export const even = (side: number): number => Math.max(2, 2 * Math.ceil(side / 2))

/** Begins a file with so many pictures a second. */
export async function encoderOf(format: FilmFormat, context: FilmContext, rate: number): Promise<Encoder> {
  if (format === 'gif') {
    const { Gif } = await import('./gif')
    return new Gif(context, rate)
  }
  const { Video } = await import('./video')
  return Video.begin(format, context, rate)
}
