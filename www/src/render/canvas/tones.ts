import type { EventKind } from 'forage-lab'

export type Tone = EventKind['tone']

/** Each tone has a shape of its own, and most a sign in it, on a square of 16: nobody has to tell colours apart. What calls for
 * attention comes later. */
export const TONES: Readonly<Record<Tone, { colour: string; outline: string; sign: string }>> = {
  plain: { colour: '--ink-2', outline: 'M8 4.5a3.5 3.5 0 1 1 0 7a3.5 3.5 0 1 1 0-7Z', sign: '' },
  good: { colour: '--accent', outline: 'M8 1.5a6.5 6.5 0 1 1 0 13a6.5 6.5 0 1 1 0-13Z', sign: 'm5 8.3 2.1 2.1L11 6.2' },
  warning: { colour: '--best', outline: 'M8 1.8 14.8 14H1.2Z', sign: 'M8 6.2v3.6M8 11.8v.2' },
  decision: { colour: '--robot', outline: 'M8 1.2 14.8 8 8 14.8 1.2 8Z', sign: 'M5.8 8h4.4M8.4 6.1 10.3 8 8.4 9.9' },
  bad: { colour: '--danger', outline: 'M5.2 1.2h5.6l4 4v5.6l-4 4H5.2l-4-4V5.2Z', sign: 'm5.4 5.4 5.2 5.2M10.6 5.4l-5.2 5.2' },
}
