import type { ParameterValue, Scene, Suggestion, UncheckedSetup } from 'forage-lab'
import type { Refusal } from '../engine/protocol'
import type { Again } from './scenes.svelte'
import { Transport } from './transport.svelte'

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
export abstract class Parameters extends Transport {
  /** What is taken, as far as it differs from the defaults. */
  params = $state.raw<Values>({})
  /** Messages by parameter name. */
  paramErrors = $state.raw<Record<string, string>>({})
  private pending: Pending[] = []

  abstract plannerName: string
  /** The whole setup with these values. */
  protected abstract setup(scene: Scene, values: Values): UncheckedSetup
  /** The run begins again; the number of that change, or 0 if there is nothing to begin. */
  protected abstract override again(where?: Again): number

  /** The values with those that are to be taken. */
  protected get wantedParameters(): Values {
    return Object.assign({}, this.params, ...this.pending.map(({ name, value }) => ({ [name]: value })))
  }

  protected override get checks(): boolean {
    return this.pending.length > 0
  }

  protected replaceParameters(params: Values): void {
    this.conclude(() => true)
    this.params = params
    this.paramErrors = {}
  }

  /** Settled when the value is taken, or refused. */
  setParameter = (name: string, value: ParameterValue | string): Promise<void> =>
    new Promise((settle) => {
      const pending = { version: Infinity, name, value: value as ParameterValue, settle }
      this.pending.push(pending)
      pending.version = this.again()
    })

  resetParameter = (name?: string): void => {
    this.drop((other) => name === undefined || other === name)
    this.params = name === undefined ? {} : without(this.params, name)
    this.again()
  }

  /** Both sizes at once, and one new run. */
  useSuggestion = ({ population, iterations }: Suggestion): void => {
    this.drop((name) => name === 'population' || name === 'iterations')
    this.params = { ...this.params, population, iterations }
    this.again()
  }

  /** What was set of these parameters, and what was said of them, is forgotten. */
  private drop(which: (name: string) => boolean): void {
    this.conclude(({ name }) => which(name))
    this.paramErrors = Object.fromEntries(Object.entries(this.paramErrors).filter(([name]) => !which(name)))
  }

  /** The run that change number `version` wanted is accepted: its values are taken. */
  protected takeParameters(version: number): void {
    const taken = this.pending.filter((pending) => pending.version <= version)
    if (taken.length === 0) return
    for (const { name, value } of taken) {
      this.params = { ...this.params, [name]: value }
      this.paramErrors = without(this.paramErrors, name)
    }
    this.conclude((pending) => pending.version <= version)
  }

  /** A value of this run was refused: it has its message, and is taken back if it has just been set; whether it was. */
  protected refuseParameter({ field, message }: Refusal, version: number): boolean {
    this.paramErrors = { ...this.paramErrors, [field]: message }
    const refused = this.pending.findLast((pending) => pending.version <= version && pending.name === field)
    // What is refused because of another parameter stays: it may be that one which is changed next.
    if (!refused) this.takeParameters(version)
    else this.conclude((pending) => pending === refused)
    return refused !== undefined
  }

  private conclude(which: (pending: Pending) => boolean): void {
    const settled = this.pending.filter(which)
    this.pending = this.pending.filter((pending) => !which(pending))
    for (const { settle } of settled) settle()
  }

  /** Nothing will be known of what is pending. */
  protected override forget(): void {
    this.takeParameters(Infinity)
    super.forget()
  }
}
