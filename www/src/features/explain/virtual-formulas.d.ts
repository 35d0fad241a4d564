/** Made by plugins/formulas.ts: TeX of the catalogue → MathML. */
declare module 'virtual:formulas' {
  /** Symbols, for running text. */
  export const inline: Readonly<Record<string, string>>
  /** A planner's formulas, or the `drive`'s; `<mtext>@name@</mtext>` stands where a number of the moment goes. */
  export const display: Readonly<Record<string, () => Promise<Typeset>>>
  interface Typeset {
    default: Readonly<Record<string, string>>
    /** What is in pseudocode. */
    inline: Readonly<Record<string, string>>
  }
}
