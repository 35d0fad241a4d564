// docs/scene.schema.json says what the scene reader says: the shipped scenes are valid, edge cases are accepted by both,
// and broken variants are rejected by both, the reader naming the field.
import assert from 'node:assert/strict'
import { spawnSync } from 'node:child_process'
import { existsSync, mkdtempSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { createRequire } from 'node:module'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { after, before, test } from 'node:test'
import { fileURLToPath } from 'node:url'

const root = fileURLToPath(new URL('..', import.meta.url))
const program = process.env.FORAGE ?? join(root, 'target/debug', process.platform === 'win32' ? 'forage.exe' : 'forage')
const { default: Ajv } = createRequire(join(root, 'www/package.json'))('ajv/dist/2020.js')
const read = (path) => JSON.parse(readFileSync(join(root, path), 'utf8'))
const valid = new Ajv({ allErrors: true, strictTypes: false, strictRequired: false, strictTuples: false }).compile(
  read('docs/scene.schema.json'),
)

let folder
before(() => {
  assert.ok(existsSync(program), `${program} is missing: cargo build, or set FORAGE`)
  folder = mkdtempSync(join(tmpdir(), 'forage-schema-'))
})
after(() => rmSync(folder, { recursive: true, force: true }))

/** Exit code and message of the reader. Only code 2 means that the scene was rejected. */
function inProgram(text) {
  const file = join(folder, 'scene.json')
  writeFileSync(file, text)
  const { status, stderr } = spawnSync(program, ['exact', '--scene', file], { encoding: 'utf8' })
  return { rejected: status === 2, status, stderr }
}

const head = (kind) => ({ format: 'forage-scene', version: 1, kind, name: 'a', title: 'A' })
const BASES = {
  function: { ...head('function'), function: 'sphere', dimension: 3 },
  formula: { ...head('function'), expression: 'sum(x[i]^2)', dimension: 3, bounds: { min: -5, max: [5, 6, 7] }, optimum: 0 },
  suite: { ...head('function'), function: 'bbob-15', instance: 3, dimension: 5 },
  discs: { ...head('discs'), bounds: { min: [0, 0], max: [8, 8] }, start: [0, 0], goal: [8, 8], discs: [{ center: [4, 4], radius: 1 }] },
  grid: {
    ...head('grid'),
    cell: 1,
    rows: ['...', '.#.', '...'],
    start: [0.5, 0.5],
    goal: [2.5, 2.5],
    robot: { length: 0.2, width: 0.1, speed: 1 },
    moving: [
      { center: [1, 2], radius: 0.25, velocity: [0.5, 0] },
      {
        center: [2, 1],
        radius: 0.25,
        waypoints: [
          [1, 2, 2],
          [2.5, 0, 2],
        ],
      },
    ],
  },
  stops: {
    ...head('grid'),
    cell: 1,
    rows: ['...', '.#.', '...'],
    stops: [
      [0.5, 0.5],
      [2.5, 2.5],
      [2.5, 0.5],
    ],
  },
  tour: {
    ...head('tour'),
    points: [
      [0, 0],
      [1, 0],
      [1, 1],
      [0, 1],
    ],
    exact: { length: 4, order: [0, 1, 2, 3] },
  },
  matrix: {
    ...head('tour'),
    matrix: [
      [0, 1, 2],
      [1, 0, 3],
      [2, 3, 0],
    ],
  },
  arm: read('scenes/arm-cuboid.json'),
}

/** A base scene after a change. */
function changed(base, change) {
  const scene = structuredClone(BASES[base])
  change(scene)
  return scene
}

test('every shipped scene is valid', () => {
  for (const file of readdirSync(join(root, 'scenes')).filter((name) => name.endsWith('.json'))) {
    assert.ok(valid(read(`scenes/${file}`)), `${file}: ${JSON.stringify(valid.errors)}`)
  }
})

const ACCEPTED = [
  ...Object.keys(BASES).map((base) => [base, () => {}]),
  ['function', (s) => Object.assign(s, { note: null, source: 'a book', units: null, exact: 'unknown', published: [1, 2] })],
  ['function', (s) => Object.assign(s, { title: '', function: 'rosenbrock', dimension: 2 })],
  ['function', (s) => Object.assign(s, { function: 'matyas', dimension: 2 })],
  ['formula', (s) => delete s.optimum],
  ['suite', (s) => delete s.instance],
  ['suite', (s) => Object.assign(s, { function: 'bbob-24', instance: 200000, dimension: 40 })],
  ['formula', (s) => (s.optimum = { value: 0, position: [0, 0, 0] })],
  ['discs', (s) => (s.discs = [])],
  ['grid', (s) => Object.assign(s, { y_axis: 'up', corner_cutting: null, robot: null, moving: [], stops: [] })],
  ['grid', (s) => Object.assign(s, { corner_cutting: true, robot: { turn_time: 0, margin: 0, sensor: 3, radius: 0.5, look_ahead: 4 } })],
  ['grid', (s) => (s.robot = { speed: 1e9, turn_time: 1e6, margin: 1e9, sensor: 0, radius: 0, look_ahead: 0 })],
  ['stops', (s) => (s.start = [0.5, 0.5])],
  ['tour', (s) => Object.assign(s, { metric: 'att', closed: false, exact: { length: null, order: null } })],
  ['tour', (s) => Object.assign(s, { closed: null, exact: 7 })],
  ['matrix', (s) => (s.points = [])],
  [
    'matrix',
    (s) =>
      (s.points = [
        [0, 0],
        [0, 1],
        [2, 0],
      ]),
  ],
  ['arm', (s) => delete s.cuboids],
  [
    'arm',
    (s) => {
      delete s.arm.base.yaw
      delete s.arm.base.column_radius
      s.arm.joints[5].speed = 90
    },
  ],
]

for (const [k, [base, change]] of ACCEPTED.entries()) {
  test(`accepted by schema and reader: ${base}, variant ${k}`, () => {
    const scene = changed(base, change)
    const { rejected, stderr } = inProgram(JSON.stringify(scene))
    assert.ok(valid(scene), JSON.stringify(valid.errors))
    assert.ok(!rejected, stderr)
  })
}

/** Base, what is wrong, the field that the reader names, the change. */
const REJECTED = [
  ['function', 'another format', 'format', (s) => (s.format = 'scene')],
  ['function', 'another version', 'version', (s) => (s.version = 2)],
  ['function', 'a version as text', 'version', (s) => (s.version = '1')],
  ['function', 'an unknown kind', 'kind', (s) => (s.kind = 'maze')],
  ['function', 'no kind', 'kind', (s) => delete s.kind],
  ['function', 'no title', 'title', (s) => delete s.title],
  ['function', 'an empty name', 'name', (s) => (s.name = '')],
  ['function', 'a name of 101 characters', 'name', (s) => (s.name = 'a'.repeat(101))],
  ['function', 'a note that is no text', 'note', (s) => (s.note = 3)],
  ['function', 'an unknown field', 'colour', (s) => (s.colour = 'red')],
  ['function', 'a `$schema` field', '$schema', (s) => (s.$schema = './scene.schema.json')],
  ['function', 'a field of another kind', 'rows', (s) => (s.rows = ['...'])],
  ['function', 'an unknown function', 'function', (s) => (s.function = 'schwefel')],
  ['function', 'no dimension', 'dimension', (s) => delete s.dimension],
  ['function', 'a dimension of 2.5', 'dimension', (s) => (s.dimension = 2.5)],
  ['function', 'a dimension of 101', 'dimension', (s) => (s.dimension = 101)],
  ['function', 'matyas in three variables', 'dimension', (s) => (s.function = 'matyas')],
  ['function', 'rosenbrock in one variable', 'dimension', (s) => Object.assign(s, { function: 'rosenbrock', dimension: 1 })],
  ['suite', 'a function that the suite does not have', 'function', (s) => (s.function = 'bbob-25')],
  ['suite', 'a number with a zero before it', 'function', (s) => (s.function = 'bbob-01')],
  ['suite', 'instance 0', 'instance', (s) => (s.instance = 0)],
  ['suite', 'half an instance', 'instance', (s) => (s.instance = 1.5)],
  ['suite', 'one variable', 'dimension', (s) => (s.dimension = 1)],
  ['suite', 'a shift', 'shift', (s) => (s.shift = [0, 0, 0, 0, 0])],
  ['formula', 'a formula that is a number', 'expression', (s) => (s.expression = 3)],
  ['formula', 'an empty formula', 'expression', (s) => (s.expression = '')],
  ['formula', 'a formula of 4097 bytes', 'expression', (s) => (s.expression = 'x'.repeat(4097))],
  ['formula', 'a function as well', 'function', (s) => (s.function = 'sphere')],
  ['formula', 'a dimension of 101', 'dimension', (s) => (s.dimension = 101)],
  ['formula', 'no bounds', 'bounds', (s) => delete s.bounds],
  ['formula', 'bounds without max', 'bounds.max', (s) => delete s.bounds.max],
  ['formula', 'a side that is a text', 'bounds.min', (s) => (s.bounds.min = '0')],
  ['formula', 'a side beyond 1e15', 'bounds.min[0]', (s) => (s.bounds.min = -1e16)],
  ['formula', 'an optimum without a value', 'optimum.value', (s) => (s.optimum = { position: [0, 0, 0] })],
  ['formula', 'an unknown field of the bounds', 'bounds.mid', (s) => (s.bounds.mid = 0)],
  ['discs', 'no start', 'start', (s) => delete s.start],
  ['discs', 'a start that is null', 'start', (s) => (s.start = null)],
  ['discs', 'a goal with one coordinate', 'goal', (s) => (s.goal = [8])],
  ['discs', 'a goal with three coordinates', 'goal', (s) => (s.goal = [8, 8, 0])],
  ['discs', 'a coordinate "NaN"', 'goal', (s) => (s.goal = ['NaN', 8])],
  ['discs', 'a radius "Infinity"', 'radius', (s) => (s.discs[0].radius = 'Infinity')],
  ['discs', 'a radius of 0', 'radius', (s) => (s.discs[0].radius = 0)],
  ['discs', 'a coordinate beyond a million', 'center', (s) => (s.discs[0].center = [2e6, 0])],
  ['discs', 'an unknown field of a disc', 'r', (s) => (s.discs[0].r = 1)],
  ['discs', 'bounds without max', 'max', (s) => delete s.bounds.max],
  ['discs', '201 discs', 'discs', (s) => (s.discs = Array(201).fill({ center: [4, 4], radius: 0.1 }))],
  ['discs', 'no list of discs', 'discs', (s) => delete s.discs],
  ['grid', 'another character in a row', 'rows', (s) => (s.rows[1] = '.x.')],
  ['grid', 'no rows', 'rows', (s) => (s.rows = [])],
  ['grid', 'an empty row', 'rows', (s) => (s.rows = [''])],
  ['grid', 'a cell of 0', 'cell', (s) => (s.cell = 0)],
  ['grid', 'a goal without a start', 'start', (s) => delete s.start],
  ['grid', 'a start without a goal', 'goal', (s) => delete s.goal],
  ['grid', 'a start left of the grid', 'start', (s) => (s.start = [-0.5, 0.5])],
  ['grid', 'an unknown direction of y', 'y_axis', (s) => (s.y_axis = 'left')],
  ['grid', 'a robot with a length alone', 'width', (s) => delete s.robot.width],
  ['grid', 'a robot with an unknown field', 'mass', (s) => (s.robot.mass = 2.3)],
  ['grid', 'a speed of 0', 'speed', (s) => (s.robot.speed = 0)],
  ['grid', 'a negative turn time', 'turn_time', (s) => (s.robot.turn_time = -1)],
  ['grid', 'a negative sensor range', 'sensor', (s) => (s.robot.sensor = -1)],
  ['grid', 'a moving obstacle that does not move', 'velocity', (s) => delete s.moving[0].velocity],
  ['grid', 'velocity and waypoints', 'velocity', (s) => (s.moving[1].velocity = [1, 0])],
  ['grid', 'an empty list of waypoints', 'waypoints', (s) => (s.moving[1].waypoints = [])],
  ['grid', 'a waypoint at time 0', 'waypoints', (s) => (s.moving[1].waypoints[0][0] = 0)],
  ['grid', 'a waypoint without a time', 'waypoints', (s) => s.moving[1].waypoints[1].shift()],
  ['stops', 'no stops and no ends', 'start', (s) => (s.stops = [])],
  ['stops', '201 stops', 'stops', (s) => (s.stops = Array(201).fill([0.5, 0.5]))],
  ['tour', 'one stop', 'points', (s) => (s.points.length = 1)],
  ['tour', 'no stops', 'points', (s) => delete s.points],
  ['tour', 'an unknown metric', 'metric', (s) => (s.metric = 'manhattan')],
  ['tour', 'a flag as text', 'closed', (s) => (s.closed = 'yes')],
  ['tour', 'a negative stored length', 'length', (s) => (s.exact.length = -4)],
  ['tour', 'a stored order that visits a stop twice', 'order', (s) => (s.exact.order = [0, 1, 1, 3])],
  ['matrix', 'a metric besides the matrix', 'metric', (s) => (s.metric = 'euc-2d')],
  ['matrix', 'a negative distance', 'matrix', (s) => (s.matrix[0][1] = s.matrix[1][0] = -1)],
  ['matrix', 'a distance that is null', 'matrix', (s) => (s.matrix[0][1] = null)],
  ['arm', 'five joints', 'joints', (s) => s.arm.joints.pop()],
  ['arm', 'alpha of 45 degrees', 'alpha', (s) => (s.arm.joints[3].alpha = 45)],
  ['arm', 'an offset in the wrist', 'joints', (s) => (s.arm.joints[4].d = 0.1)],
  ['arm', 'no upper arm', 'joints', (s) => (s.arm.joints[2].a = 0)],
  ['arm', 'no forearm', 'joints', (s) => Object.assign(s.arm.joints[3], { a: 0, d: 0 })],
  ['arm', 'no limits', 'min', (s) => delete s.arm.joints[0].min],
  ['arm', 'a tool along no axis', 'axis', (s) => (s.arm.tool.axis = 'w')],
  ['arm', 'a start in the plane', 'start', (s) => s.start.pop()],
  ['arm', 'an unknown field of the base', 'height', (s) => (s.arm.base.height = 1)],
  ['arm', 'no workspace', 'workspace', (s) => delete s.workspace],
]

for (const [base, what, field, change] of REJECTED) {
  test(`rejected by schema and reader: ${what} (${base})`, () => {
    const scene = changed(base, change)
    const { rejected, status, stderr } = inProgram(JSON.stringify(scene))
    assert.ok(!valid(scene), 'the schema accepts it')
    assert.ok(rejected, `the reader accepts it: exit code ${status}`)
    assert.ok(stderr.includes(field), stderr)
  })
}
