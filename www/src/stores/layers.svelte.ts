/** Which layers are drawn: as the planner's entry has it, unless somebody has chosen. */
export class Visible {
  chosen = $state.raw<Readonly<Record<string, boolean>>>({})

  shows = (role: string, standard: boolean): boolean => this.chosen[role] ?? standard

  show = (role: string, on: boolean): void => {
    this.chosen = { ...this.chosen, [role]: on }
  }
}
