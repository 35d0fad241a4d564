/*
 * The conformance suite for planners in JavaScript: what the Rust suite checks of planners, as far as it can be seen from here.
 * `host` is the package's entry, in Node or in a page.
 */

const SEEDS = [1, 7]
/** At most so many scenes of a kind. */
const MOST_SCENES = 3
const STEPS = 40
/** Costs may differ by rounding where the code computes them itself. */
const NEARLY = 1e-9

/** The kinds of scenes of which each candidate is a result. */
const ALWAYS = ['function', 'tour']

/** Costs that are equal but for rounding. */
const nearly = (a, b) => a === b || Math.abs(a - b) <= NEARLY * Math.max(1, Math.abs(a), Math.abs(b))

const STARTS = 'it starts'

const CHECKS = {
  [STARTS]({ run }) {
    run()
  },
  'the same seed is the same run'({ run, steps }) {
    const [first, second] = [run(), run()]
    if (first.hash() !== second.hash()) return 'two starts with one seed have different states: something else than `random` is used'
    first.step(steps)
    second.step(steps)
    if (first.hash() !== second.hash()) return `after ${first.iteration} iterations two runs with one seed differ`
  },
  'many steps at once are single steps'({ run, steps }) {
    const [whole, single] = [run(), run()]
    whole.step(steps)
    for (let k = 0; k < steps; k += 1) single.step(1)
    if (whole.hash() !== single.hash()) return `${steps} steps at once lead elsewhere than ${steps} single ones`
  },
  'the way back leads to the same states'({ run, steps }) {
    const session = run()
    const hashes = [session.hash()]
    for (let k = 0; k < steps; k += 1) {
      session.step(1)
      hashes.push(session.hash())
    }
    const last = session.iteration
    for (const at of [0, Math.floor(last / 2), last]) {
      session.seek(at)
      if (session.hash() !== hashes[at]) return `back at iteration ${at} the state is another one: something is kept outside of the state`
    }
  },
  'another run at the same time changes nothing'({ run, steps }) {
    const alone = run()
    alone.step(steps)
    const [first, second] = [run(), run()]
    for (let k = 0; k < steps; k += 1) {
      first.step(1)
      second.step(1)
    }
    if (first.hash() !== alone.hash()) return 'with a second run under way a run goes another way: they share something'
  },
  'a link opens the same state'({ run, steps, open }) {
    const session = run()
    session.step(steps)
    const opened = open(session.link())
    opened.seek(session.iteration)
    if (opened.hash() !== session.hash()) return 'a link of the run leads to another state'
  },
  'the best cost never rises'({ run, steps }) {
    const session = run()
    let before = session.outcome().cost ?? Number.POSITIVE_INFINITY
    for (let k = 0; k < steps; k += 1) {
      session.step(1)
      const cost = session.outcome().cost ?? Number.POSITIVE_INFINITY
      if (cost > before) return `in iteration ${session.iteration} the best cost rises from ${before} to ${cost}`
      before = cost
    }
  },
  'a run has a result, and no fault'({ run, steps, scene }) {
    const session = run()
    session.step(steps)
    const { status, trouble, cost } = session.outcome()
    if (status === 'failed') return `the run ends with a fault: ${trouble}`
    // Around obstacles a way may take longer to find.
    const isFound = (cost !== null && cost !== undefined) || !ALWAYS.includes(scene.kind)
    if (!isFound) return `after ${session.iteration} iterations there is no best solution`
  },
  'the cost is that of the solution'({ run, steps, scene }) {
    // On functions the core itself looks, after each step.
    if (scene.kind === 'function') return undefined
    const session = run()
    session.step(steps)
    const { cost, length, feasible } = session.outcome()
    if (feasible && typeof cost === 'number' && !nearly(cost, length)) return `the cost is said to be ${cost}; it is ${length}`
  },
  'looking changes nothing'({ run, steps, described }) {
    const [looked, unseen] = [run(), run()]
    for (let k = 0; k < steps; k += 1) {
      looked.frame()
      looked.readings()
      looked.outcome()
      for (const { role, pickable } of described.layers) if (pickable) looked.inspect({ role, index: 0 })
      looked.step(1)
      unseen.step(1)
    }
    if (looked.hash() !== unseen.hash()) return '`draw`, `best`, `explain` or a reading changes the state'
  },
  'readings are numbers'({ run, steps, described }) {
    const session = run()
    session.step(steps)
    const readings = session.readings()
    const wrong = described.readings.find(({ name }) => typeof readings[name] !== 'number' || Number.isNaN(readings[name]))
    if (wrong) return `the reading \`${wrong.name}\` is no number`
  },
  'parameters run at both ends'({ run, described }) {
    for (const { name, type, min, max, options } of described.parameters) {
      if (name === 'iterations') continue
      const ends = {
        number: [min, max],
        integer: [min, Math.min(max, 1000)],
        flag: [false, true],
        choice: options?.map(({ value }) => value),
      }
      for (const end of ends[type]) {
        const session = run({ [name]: end })
        session.step(3)
        const { status, trouble } = session.outcome()
        if (status === 'failed') return `with ${name} = ${end} the run ends with a fault: ${trouble}`
      }
    }
  },
  'it stops when it should'({ run }) {
    const session = run({ iterations: 5 })
    session.step(1000)
    if (session.iteration > 5) return `with iterations = 5 it takes ${session.iteration}`
  },
}

/** Those with these names, or the first few of each kind. */
function scenesFor(all, kinds, names) {
  if (names) return names.map((name) => all.find((scene) => scene.name === name) ?? { name })
  return kinds.flatMap((kind) => all.filter((scene) => scene.kind === kind).slice(0, MOST_SCENES))
}

export async function conformBy(host, scenes, planner, { steps = STEPS, scenes: names } = {}) {
  const { Session, register, load, partsOf, describedBy } = host
  const described = typeof planner === 'string' ? describedBy(planner) : await register(planner)
  await load('links')
  const violations = []
  for (const scene of scenesFor(scenes, described.kinds, names)) {
    await load(...partsOf({ planner: described.name, scene: scene.name }))
    for (const seed of SEEDS) {
      const where = `${scene.name}, seed ${seed}`
      for (const [check, holds] of Object.entries(CHECKS)) {
        const sessions = []
        const run = (params = {}) => {
          const session = new Session({ planner: described.name, scene: scene.name, seed, params })
          sessions.push(session)
          return session
        }
        let found
        try {
          const open = (link) => {
            const session = Session.fromLink(link)
            sessions.push(session)
            return session
          }
          found = holds({ run, open, steps, scene, described })
        } catch (error) {
          found = error instanceof Error ? error.message : String(error)
        }
        for (const session of sessions) session.free()
        if (found) violations.push({ check, where, found })
        // All others would say the same.
        if (found && check === STARTS) break
      }
    }
  }
  return {
    planner: described.name,
    checks: Object.keys(CHECKS),
    violations,
    toString() {
      if (violations.length === 0) return `${described.name} keeps to all ${Object.keys(CHECKS).length} checks.`
      return violations.map(({ check, where, found }) => `${described.name} on ${where}: not “${check}”: ${found}`).join('\n')
    },
  }
}
