import type { Catalogue, ParameterValue, Scene } from 'forage-lab'
import { sameParams, sameScene } from '../scene/equality'

/** A case that was published: a planner on a scene that ships, with the parameters that differ from the defaults. */
export interface Preset {
  /** Its words are in presets.ts, by this name. */
  name: keyof typeof import('../locales/en/presets').presets.cases
  planner: string
  scene: string
  params: Record<string, ParameterValue>
  /** Where another run shows it better than the first. */
  seed?: number
}

export const PRESETS: readonly Preset[] = [
  // Of several shortest ways the ants of this seed find one on which the obstacle comes too near.
  { name: 'moving-ants', planner: 'wolf-ant-drive', scene: 'wolf-ant-20', params: {}, seed: 23 },
  { name: 'moving-a-star', planner: 'a-star-drive', scene: 'wolf-ant-20', params: {} },
  {
    name: 'moving-printed',
    planner: 'a-star-drive',
    scene: 'wolf-ant-20',
    params: { path: 'printed', robot: 'given', robot_radius: 0, margin: 0 },
  },
  { name: 'moving-d-star-lite', planner: 'd-star-lite-drive', scene: 'wolf-ant-20', params: {} },
  { name: 'crossing', planner: 'wolf-ant-drive', scene: 'crossing', params: {} },
  { name: 'patrol', planner: 'a-star-drive', scene: 'patrol', params: {} },
  { name: 'corridor', planner: 'a-star-drive', scene: 'corridor', params: {} },
  { name: 'misled', planner: 'aco-wolf', scene: 'rooms-20', params: { beta: 7, rho: 0.367 } },
  { name: 'direction', planner: 'aco-direction', scene: 'ant-bat-30', params: {} },
  { name: 'arm-guided', planner: 'rrt-guided', scene: 'arm-free', params: {} },
  { name: 'arm-guided-wide', planner: 'rrt-guided', scene: 'arm-free', params: { step_size: 0.05 } },
  { name: 'arm-basic', planner: 'rrt', scene: 'arm-free', params: {} },
  { name: 'arm-cuboid', planner: 'rrt-guided', scene: 'arm-cuboid', params: {} },
  { name: 'arm-cuboid-basic', planner: 'rrt', scene: 'arm-cuboid', params: {} },
  { name: 'arm-star', planner: 'rrt-star', scene: 'arm-cuboid', params: {} },
  { name: 'arm-joints', planner: 'rrt-joint', scene: 'arm-cuboid', params: {} },
  { name: 'arm-puma', planner: 'rrt-joint', scene: 'arm-puma', params: {} },
  { name: 'quantum', planner: 'ltqpso', scene: 'qpso-10m', params: {} },
  { name: 'hens', planner: 'wcpso', scene: 'wcpso-discs', params: {} },
]

/** A case as it is offered: one of the above, or a planner's preset on the scene that goes with it. */
export interface Case extends Omit<Preset, 'name'> {
  name: string
  /** What the catalogue says of it; the words of the above are looked up by their names. */
  texts?: { title: string; help: string }
}

/** Those that can be run here. */
export const offered = ({ planners, scenes }: Catalogue): readonly Case[] => {
  const known = (scene: string): boolean => scenes.some(({ name }) => name === scene)
  return [
    ...PRESETS.filter((preset) => planners.some(({ name }) => name === preset.planner) && known(preset.scene)),
    ...planners.flatMap(({ name: planner, title, presets }) =>
      presets
        .filter(({ scene }) => known(scene))
        .map(({ name, title: preset, help, scene, params }) => ({
          name: `${planner}.${name}`,
          planner,
          scene,
          params,
          // A planner's title is its abbreviation, a colon and what it does.
          texts: { title: `${title.split(':')[0]}: ${preset}`, help },
        })),
    ),
  ]
}

/** The one that is set up just so, if any is. */
export function chosen(
  cases: readonly Case[],
  catalogue: Catalogue,
  setup: { planner: string; scene: Scene | null; params: Record<string, ParameterValue> },
): Case | undefined {
  return cases.find(({ planner, scene, params }) => {
    const shipped = catalogue.scenes.find(({ name }) => name === scene)
    return planner === setup.planner && shipped && sameScene(shipped, setup.scene) && sameParams(params, setup.params)
  })
}
