/** Stands for the package's list of TeX strings in the page, which has them typeset already. */
export const symbols = (): string[] => []
