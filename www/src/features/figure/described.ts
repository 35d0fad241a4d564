/** What goes with a figure. */
export interface Described {
  /** Of its file, without an ending. */
  name: string
  /** Line by line; the first one is the title. */
  caption: string[]
  /** The address of what it shows. */
  link: string
}
