import type { FilmFormat } from '../../render/film/film'

/** A range of iterations that is recorded. */
export interface Take {
  from: number
  to: number
  /** A picture for every so many iterations. */
  every: number
  format: FilmFormat
  /** Pictures a second. */
  rate: number
}

/** Pictures a recording has at most. */
export const MOST_PICTURES = 2000
/** The iterations of a take's pictures: the last one is among them. */
export function iterationsOf({ from, to, every }: Pick<Take, 'from' | 'to' | 'every'>): number[] {
  const all: number[] = []
  for (let at = from; at < to; at += every) all.push(at)
  return [...all, to]
}
