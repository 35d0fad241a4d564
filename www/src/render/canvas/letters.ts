const SYSTEM = '"Segoe UI", system-ui, sans-serif'
let family = SYSTEM

/** The page's own letters are there. A canvas that drew text before keeps what it found for a font of the same name: it gets another name. */
export function useLetters(): void {
  family = `Inter, ${SYSTEM}`
}

/** A font of the page: its style, weight and size, as canvases have them. */
export const fontOf = (look: string): string => `${look} ${family}`

/** Of numbers and captions. */
export const small = (): string => fontOf('11px')
