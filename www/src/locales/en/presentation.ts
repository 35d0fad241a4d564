import { texts } from '../texts'

/** Text of the presentation mode. */
export const presentation = texts('presentation', {
  code: 'Show the link as a QR code (Q)',
  codeOf: (iteration: string) => `QR code of the link to iteration ${iteration}`,
  tooLong: 'With this scene the link is too long for a QR code.',
  end: 'Leave the presentation (Escape)',
  unblank: 'Show the stage again (B)',
} as const)
