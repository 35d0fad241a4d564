/* A planner's code without an interpreter around it. Only for what the user wrote, and only after a question. */
import { type Planner, register } from 'forage-lab'
import { mathematics, powerBy, shown, withPowers } from 'forage-lab/isolate'

type Functions = Record<string, unknown>

/** The line of a code in what a browser tells of an error: scripts from memory have addresses of their own. */
const LINE = /blob:[^\n]*?:(\d+):\d+/

/** They end no run when they throw. */
const SHOWS = ['draw', 'explain']

/** As the interpreter says it. */
function withLine(error: unknown): Error {
  if (!(error instanceof Error)) return new Error(String(error))
  const line = LINE.exec(error.stack ?? '')?.[1]
  return new Error(`${error.name === 'Error' ? '' : `${error.name}: `}${error.message}${line ? ` (line ${line})` : ''}`)
}

/** The same functions, whose errors have their line. */
function withLines(planner: Functions): Functions {
  const entries = Object.entries(planner).map(([name, value]) => [
    name,
    typeof value !== 'function'
      ? value
      : (...given: unknown[]) => {
          try {
            return value.apply(planner, given) as unknown
          } catch (error) {
            const known = withLine(error)
            if (SHOWS.includes(name)) complain(`${name}: ${known.message}`)
            throw known
          }
        },
  ])
  return Object.fromEntries(entries) as Functions
}

/** What only shows something throws with each picture: it is printed once. */
function complain(line: string): void {
  if (line !== complaint) print(line)
  complaint = line
}

let complaint = ''
let print: (line: string) => void = () => undefined
let patched = false

/** What it prints is shown as that of others is. */
function captureConsole(): void {
  if (patched) return
  patched = true
  const { log } = console
  console.log = (...given: unknown[]) => {
    print(given.map(shown).join(' '))
    log(...given)
  }
}

function refuseChance(): never {
  throw new Error('Math.random is another one each time: take `random` from what `start` and `advance` are given')
}

/** The package, where a code imports from it. */
const IMPORTED = /(\bfrom\s*|\bimport\s*)(['"])forage-lab\2/g

const scriptOf = (code: string): string => URL.createObjectURL(new Blob([code], { type: 'text/javascript' }))

/** Registers the planner of a code that was read in the interpreter before. */
export async function registerPlain(code: string, onprint: (line: string) => void): Promise<Planner> {
  let given: Functions | undefined
  captureConsole()
  print = onprint
  complaint = ''
  Object.assign(globalThis, {
    forageMath: { ...mathematics, random: refuseChance },
    power$: powerBy(mathematics.pow),
    register: (planner: Functions) => {
      given = planner
    },
  })
  const library = scriptOf('export const register = globalThis.register')
  // Its lines stay where they are.
  const script = withPowers(code).replace(IMPORTED, (_, before: string) => `${before}'${library}'`)
  const address = scriptOf(`const Math = globalThis.forageMath; ${script}`)
  try {
    await import(/* @vite-ignore */ address)
  } finally {
    for (const one of [address, library]) URL.revokeObjectURL(one)
  }
  if (!given) throw new Error('it registers no planner')
  return register(withLines(given) as unknown as Parameters<typeof register>[0])
}
