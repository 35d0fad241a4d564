import type { ParameterValue, Suggestion } from 'forage-lab'
import type { Refusal } from '../engine/protocol'

type Values = Record<string, ParameterValue>

/** A value that was set and of which it is not known yet whether it is taken. */
interface Pending {
  /** The change of the run that has it first. */
  version: number
  name: string
  value: ParameterValue
  settle(): void
}

const without = <T>(values: Record<string, T>, name: string): Record<string, T> => {
  const { [name]: _gone, ...rest } = values
  return rest
}

/** The planner's parameters. With each value that is set the run begins again; it is taken when it is accepted. */
export class ParametersStore {
  /** What is taken, as far as it differs from the defaults. */
  values = $state.raw<Values>({})
  /** Messages by parameter name. */
  errors = $state.raw<Record<string, string>>({})
  private pending: Pending[] = []

  /** `again`: the run begins again; the number of that change, or 0 if there is nothing to begin. */
  constructor(private readonly again: () => number) {}

  /** The values with those that are to be taken. */
  get wanted(): Values {
    return Object.assign({}, this.values, ...this.pending.map(({ name, value }) => ({ [name]: value })))
  }

  /** Something waits for being accepted. */
  get checks(): boolean {
    return this.pending.length > 0
  }

  replace(values: Values): void {
    this.conclude(() => true)
    this.values = values
    this.errors = {}
  }

  /** Settled when the value is taken, or refused. */
  set = (name: string, value: ParameterValue | string): Promise<void> =>
    new Promise((settle) => {
      const pending = { version: Infinity, name, value: value as ParameterValue, settle }
      this.pending.push(pending)
      pending.version = this.again()
    })

  reset = (name?: string): void => {
    this.drop((other) => name === undefined || other === name)
    this.values = name === undefined ? {} : without(this.values, name)
    this.again()
  }

  /** Both sizes at once, and one new run. */
  useSuggestion = (suggestion: Suggestion): void => {
    this.drop((name) => name in suggestion)
    this.values = { ...this.values, ...suggestion }
    this.again()
  }

  /** What was set of these parameters, and what was said of them, is forgotten. */
  private drop(which: (name: string) => boolean): void {
    this.conclude(({ name }) => which(name))
    this.errors = Object.fromEntries(Object.entries(this.errors).filter(([name]) => !which(name)))
  }

  /** The run that change number `version` wanted is accepted: its values are taken. */
  take(version: number): void {
    const taken = this.pending.filter((pending) => pending.version <= version)
    if (taken.length === 0) return
    for (const { name, value } of taken) {
      this.values = { ...this.values, [name]: value }
      this.errors = without(this.errors, name)
    }
    this.conclude((pending) => pending.version <= version)
  }

  /** A value of this run was refused: it has its message, and is taken back if it has just been set; whether it was. */
  refuse({ field, message }: Refusal, version: number): boolean {
    this.errors = { ...this.errors, [field]: message }
    const refused = this.pending.findLast((pending) => pending.version <= version && pending.name === field)
    // What is refused because of another parameter stays: it may be that one which is changed next.
    if (!refused) this.take(version)
    else this.conclude((pending) => pending === refused)
    return refused !== undefined
  }

  private conclude(which: (pending: Pending) => boolean): void {
    const settled = this.pending.filter(which)
    this.pending = this.pending.filter((pending) => !which(pending))
    for (const { settle } of settled) settle()
  }

  /** Nothing will be known of what is pending. */
  forget(): void {
    this.take(Infinity)
  }
}
