import type { Generator, ParameterValue, Scene } from 'forage-lab'
import type { Refusal } from '../engine/protocol'
import type { Lab } from './lab.svelte'
import { perLab } from './context.svelte'
import { Latest } from '../engine/latest-request'

type Values = Readonly<Record<string, ParameterValue>>

interface Wish {
  generator: Generator
  values: Values
  seed: number
  /** The parameter that the wish is about. */
  changed: string
}

const without = <T>(of: Readonly<Record<string, T>>, name: string): Record<string, T> => {
  const { [name]: _gone, ...rest } = of
  return rest
}

const known = ({ parameters }: Generator, values: Values): Values =>
  Object.fromEntries(Object.entries(values).filter(([name]) => parameters.some((parameter) => parameter.name === name)))

/** A random scene in the making: what was chosen, and the scene that comes of it. It is kept while the page is open. */
export class GeneratingStore {
  generator = $state.raw<Generator | null>(null)
  values = $state.raw<Values>({})
  seed = $state(1)
  scene = $state.raw<Scene | null>(null)
  /** Values that were refused, by the parameter's name. */
  private refused = $state.raw<Record<string, string>>({})
  /** What is wrong with values that are fine by themselves. */
  private trouble = $state.raw<Refusal | null>(null)
  /** The values with those that are on their way. */
  private wanted: Values = {}

  readonly errors = $derived<Record<string, string>>(
    this.trouble ? { [this.trouble.field]: this.trouble.message, ...this.refused } : this.refused,
  )
  /** What no parameter can show. */
  readonly problem = $derived(
    this.trouble && !this.generator?.parameters.some(({ name }) => name === this.trouble?.field) ? this.trouble.message : '',
  )

  /** It could not be made only because a part of the core was not loaded: that is asked for once more. */
  readonly unloaded = $derived(this.trouble?.unloaded ?? false)

  private readonly latest = new Latest<Wish>((wish) => this.make(wish))

  constructor(private readonly lab: Lab) {}

  begin(generators: readonly Generator[]): void {
    const [first] = generators
    if (first) this.choose(generators.find(({ name }) => name === this.generator?.name) ?? first)
  }

  choose = (generator: Generator): void => {
    this.generator = generator
    this.refused = {}
    this.ask('')
  }

  set = (name: string, value: ParameterValue): void => {
    this.wanted = { ...this.wanted, [name]: value }
    this.ask(name)
  }

  reset = (name?: string): void => {
    this.wanted = name === undefined ? {} : without(this.wanted, name)
    this.refused = name === undefined ? {} : without(this.refused, name)
    this.ask('')
  }

  sow = (seed: number): void => {
    this.seed = seed
    this.ask('')
  }

  retry = (): void => this.ask('')

  private ask(changed: string): void {
    const { generator, wanted, seed } = this
    if (generator) this.latest.want({ generator, values: known(generator, wanted), seed, changed })
  }

  private async make({ generator, values, seed, changed }: Wish): Promise<void> {
    const answer = await this.lab.api.generateScene(generator.name, values, seed)
    if (generator !== this.generator) return
    if (!answer.ok && changed && answer.refusal.field === changed) {
      this.refused = { ...this.refused, [changed]: answer.refusal.message }
      const before = this.values[changed]
      this.wanted = before === undefined ? without(this.wanted, changed) : { ...this.wanted, [changed]: before }
      return
    }
    this.values = { ...this.values, ...values }
    for (const { name } of generator.parameters) if (!(name in values)) this.values = without(this.values, name)
    this.refused = without(this.refused, changed)
    this.trouble = answer.ok ? null : answer.refusal
    this.scene = answer.ok ? answer.value : null
  }
}

export const generatingOf = perLab((lab) => new GeneratingStore(lab))
