/** Lines are told apart by dashes too, not by colour alone. */
export const DASHES: readonly (number[] | undefined)[] = [undefined, [7, 3], [2, 3], [9, 3, 2, 3], [4, 2], [12, 4], [2, 2, 6, 2], [1, 4]]

export const tokenOf = (slot: number): string => `--series-${slot + 1}`
