/** What requests are about. With its number an answer that comes late finds out whether a newer request has replaced its own. */
export type Subject = 'iteration' | 'playing' | 'scene' | 'setup' | 'seed' | 'inspection' | 'run'
