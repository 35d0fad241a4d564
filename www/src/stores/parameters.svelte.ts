import type { ParameterValue, Scene, UncheckedSetup, Suggestion } from 'forage-lab'
import type { Again } from './scenes.svelte'
import { Transport } from './transport.svelte'

type Values = Record<string, ParameterValue>

/** The planner's parameters. A value is taken over once the core has accepted it; then the run begins again. */
export abstract class Parameters extends Transport {
  /** What differs from the defaults. */
  params = $state.raw<Values>({})
  /** Messages by parameter name. */
  paramErrors = $state.raw<Record<string, string>>({})

  abstract plannerName: string
  /** The whole setup with these values. */
  protected abstract setup(scene: Scene, values: Values): UncheckedSetup
  /** The run begins again; `since`: the number of the request that this follows from. */
  protected abstract override again(where?: Again, since?: number): void

  protected replaceParameters(params: Values): void {
    this.requests.note('parameters')
    this.params = params
  }

  setParameter = async (name: string, value: ParameterValue | string): Promise<void> => {
    const { scene } = this
    if (!scene) return
    const request = this.requests.note()
    const setup = this.setup(scene, { ...this.params, [name]: value as ParameterValue })
    await this.await(
      // A request for sizes checks the whole setup.
      async () => this.api.suggest(setup),
      (answer) => {
        if (this.requests.replaced(request, `parameter ${name}`, 'parameters')) return
        if (!answer.ok && answer.refusal.field === name) {
          if (setup.planner === this.plannerName) this.paramErrors = { ...this.paramErrors, [name]: answer.refusal.message }
          return
        }
        this.forgive(name)
        this.params = { ...this.params, [name]: value as ParameterValue }
        this.again('anew', request)
      },
    )
  }

  resetParameter = (name?: string): void => {
    const { [name ?? '']: _dropped, ...rest } = this.params
    this.requests.note(name === undefined ? 'parameters' : `parameter ${name}`)
    this.params = name === undefined ? {} : rest
    if (name === undefined) this.paramErrors = {}
    else this.forgive(name)
    this.again()
  }

  /** Both sizes at once, and one new run. */
  useSuggestion = ({ population, iterations }: Suggestion): void => {
    this.forgive('population')
    this.forgive('iterations')
    this.requests.note('parameter population', 'parameter iterations')
    this.params = { ...this.params, population, iterations }
    this.again()
  }

  private forgive(name: string): void {
    const { [name]: _gone, ...rest } = this.paramErrors
    this.paramErrors = rest
  }
}
