/** What brings the rest of the core, and words: the first picture needs neither. */
export const rest = (): Promise<typeof import('forage-lab')> => import('forage-lab')
