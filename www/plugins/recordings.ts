import { resolve } from 'node:path'
import { pathToFileURL } from 'node:url'
import type { Plugin } from 'vite'
import type { Scene } from '../../pkg/node.js'
import { FAMILIES, type Family } from '../src/catalogue/families.ts'
import { pack } from '../src/engine/host/pack.ts'
import type { Header } from '../src/render/recording.ts'

const ID = 'virtual:recordings'
/** Vertices that a layer may have: a card is small. */
const BUDGET = 500
/** Steps of a coordinate between its smallest and its largest value: less than a pixel of a card. */
const STEPS = 4095
/** Runs that are recorded to their end are no longer than this. */
const LONGEST = 5000

type Core = typeof import('../../pkg/node.js')

/**
 * Provides `virtual:recordings`: for each family the address of a file with some pictures of a run.
 * @param core the folder that the wasm package was built into
 */
export function recordings(core: string): Plugin {
  let served = false
  return {
    name: 'forage-recordings',
    configResolved: ({ command }) => {
      served = command === 'serve'
    },
    resolveId: (id) => (id === ID ? `\0${ID}` : undefined),
    async load(id) {
      if (id !== `\0${ID}`) return undefined
      const lab = (await import(pathToFileURL(resolve(core, 'node.js')).href)) as Core
      const entries = FAMILIES.map((family) => {
        const source = record(lab, family)
        const name = JSON.stringify(family.name)
        if (served) return `${name}: ${JSON.stringify(`data:application/octet-stream;base64,${Buffer.from(source).toString('base64')}`)}`
        const file = this.emitFile({ type: 'asset', name: `${family.name}.frames`, source })
        return `${name}: import.meta.ROLLUP_FILE_URL_${file}`
      })
      return `export default { ${entries.join(', ')} }`
    },
  }
}

/** The posture in which an arm waits. */
const homeOf = ({ arm }: Extract<Scene, { kind: 'arm' }>): number[] => arm.joints.map(({ home }) => home)

interface Picture {
  iteration: number
  points: Float32Array
  spans: Uint32Array
}

/** A length, a header as JSON, and the pictures: per picture the coordinates column by column, as differences, and the span table. */
function record({ armPose, Session, shapes }: Core, { planner, scene, params, seed, until, pictures }: Family): Uint8Array {
  const session = new Session({ planner, scene, params, seed } as ConstructorParameters<Core['Session']>[0])
  const last = until || endOf(session)
  const taken = Array.from({ length: pictures }, (_, at): Picture => {
    session.seek(Math.round((last * at) / (pictures - 1)))
    const { vertices, spans } = session.frame(BUDGET)
    const packed = pack(vertices, spans, shapes.indexOf('field'), (bytes) => new ArrayBuffer(bytes))
    return {
      iteration: session.iteration,
      points: new Float32Array(packed.buffer, 0, packed.vertices),
      spans: new Uint32Array(packed.buffer, packed.vertices * 4, packed.spans),
    }
  })
  const [exact, { scene: own }] = [session.exact(), session]
  session.free()
  const skeleton = own.kind === 'arm' ? armPose(own, homeOf(own)).skeleton : []
  const ranges = [0, 1, 2, 3].map((column): [number, number] => {
    const values = taken.flatMap(({ points }) => [...points].filter((_, at) => at % 4 === column))
    return [Math.min(0, ...values), Math.max(0, ...values)]
  })
  const header: Header = {
    ranges,
    steps: STEPS,
    pictures: taken.map(({ iteration, points, spans }) => ({ iteration, vertices: points.length, spans: spans.length })),
    skeleton,
    exact: (exact?.tip_path ?? exact?.path ?? null) as Header['exact'],
  }
  const body = taken.flatMap(({ points, spans }) => [...columns(points, ranges), ...spans])
  const head = Buffer.from(JSON.stringify(header))
  // Numbers are read where they are a multiple of two.
  const padded = Buffer.concat([head, Buffer.alloc(head.length % 2, ' ')])
  const length = Buffer.alloc(4)
  length.writeUInt32LE(padded.length)
  return Buffer.concat([length, padded, Buffer.from(Uint16Array.from(body).buffer)])
}

function endOf(session: InstanceType<Core['Session']>): number {
  session.step(LONGEST)
  return session.iteration
}

function columns(points: Float32Array, ranges: readonly [number, number][]): number[] {
  return ranges.flatMap(([low, high], column) => {
    let before = 0
    return Array.from({ length: points.length / 4 }, (_, at) => {
      const value = Math.round((STEPS * ((points[4 * at + column] ?? 0) - low)) / (high - low || 1))
      const difference = value - before
      before = value
      return difference & 0xffff
    })
  })
}
