/** A lesson, and a step of it. */
export interface Place {
  name: string
  step?: string | undefined
}

/** The name of the lesson that is written in this browser. */
export const DRAFT = 'draft'

/** Before the name of one whose file was opened: this browser keeps it. */
export const OPENED = '@'

/** The lesson in an address or its keys: `#lesson=pso`, `&lesson=pso&step=bowl`; null: there is none. */
export function lessonIn(address: string): Place | null {
  const read = (key: string): string | undefined => new RegExp(`[#&]${key}=([^&]*)`).exec(address)?.[1]
  const name = read('lesson')
  return name ? { name, step: read('step') } : null
}
