/** Which layers are drawn: as the planner's entry has it, unless somebody has chosen. */
export class Visible {
  hidden = $state.raw<Record<string, boolean>>({})

  shows = (role: string, standard: boolean): boolean => !(this.hidden[role] ?? !standard)

  show = (role: string, on: boolean): void => {
    this.hidden = { ...this.hidden, [role]: !on }
  }
}
