/** The canvas, for those who want to save what it shows. */
export const picture: { canvas: HTMLCanvasElement | null } = { canvas: null }
