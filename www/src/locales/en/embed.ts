import { texts } from '../texts'

/** Text of the dialog that gives what shows a run on another page. */
export const embed = texts('embed', {
  title: 'Embed this run',
  intro: 'Copy this into your page. It shows the run as it stands; who looks at it can step on and back.',
  as: 'Text for',
  kinds: { iframe: 'An iframe', element: 'The element' },
  iframeHelp: 'An iframe needs nothing but this text. It loads from here.',
  elementHelp: 'The element is one script, which you may copy to your own site. Several runs on a page share it.',
  controls: 'Controls',
  controlNames: { none: 'None', play: 'Play', full: 'All' },
  theme: 'Colours',
  themes: { system: 'Reader’s', light: 'Light', dark: 'Dark' },
  language: 'Language',
  autoplay: 'Plays when it comes into view',
  width: 'Width',
  height: 'Height',
  size: (least: number, most: number) => `Pixels, ${least} to ${most}.`,
  code: 'Text to copy',
  copy: 'Copy',
  copied: 'Copied',
  copyFailed: 'Copying was not allowed: the text is selected.',
  preview: 'Preview',
  lessonTooLarge: 'This lesson is longer than a link may be. Share it as a file instead.',
  failed: (message: string) => `There is no link of this run: ${message}`,
} as const)
