// RRT: a tree that grows from the start towards random points until it reaches the goal. LaValle 1998.
import { register } from 'forage-lab'

register({
  name: 'my-rrt',
  title: 'Random tree (RRT)',
  summary: 'Grows a tree from the start: the node nearest to a random point is extended towards it by one step.',
  kinds: ['discs', 'grid'],
  parameters: [
    { name: 'step', title: 'Step', default: 0.05, min: 0.005, max: 0.5, help: 'A fraction of the longer side.' },
    { name: 'goal_bias', title: 'Goal bias', default: 0.1, min: 0, max: 1, help: 'The probability that the goal is taken instead of a random point.' },
  ],
  readings: [{ name: 'nodes', title: 'Nodes', value: ({ nodes }) => nodes.length }],
  layers: [
    { name: 'tree', title: 'Tree' },
    { name: 'best', title: 'Path' },
  ],

  // A node: its position and the index of its parent.
  start: ({ scene }) => ({ nodes: [[...scene.start, -1]], path: null, cost: null }),

  advance(state, { scene, box, params, random, isFree, evaluate, finish, math }) {
    const { nodes } = state
    const between = (k) => box.low[k] + (box.high[k] - box.low[k]) * random()
    const target = random() < params.goal_bias ? scene.goal : [between(0), between(1)]
    let nearest = 0
    for (let k = 1; k < nodes.length; k += 1) if (apart(nodes[k], target) < apart(nodes[nearest], target)) nearest = k
    const from = nodes[nearest].slice(0, 2)
    const step = params.step * math.max(box.high[0] - box.low[0], box.high[1] - box.low[1])
    const part = math.min(1, step / math.sqrt(apart(from, target)))
    const node = [0, 1].map((k) => from[k] + part * (target[k] - from[k]))
    if (!(part > 0) || !isFree(from, node)) return
    nodes.push([...node, nearest])
    if (apart(node, scene.goal) > step * step || !isFree(node, scene.goal)) return
    const path = [scene.goal]
    for (let k = nodes.length - 1; k >= 0; k = nodes[k][2]) path.unshift(nodes[k].slice(0, 2))
    if (apart(path.at(-2), scene.goal) === 0) path.splice(-2, 1)
    Object.assign(state, { path, cost: evaluate(path) })
    finish()
  },

  best: ({ path, cost }) => (path ? { path, cost } : null),

  draw({ nodes, path }, pen) {
    pen.segments('tree', nodes.flatMap(([x, y, from]) => (from < 0 ? [] : [nodes[from].slice(0, 2), [x, y]])))
    if (path) pen.line('best', path)
  },
})

/** The squared distance between two points. */
const apart = (a, b) => (a[0] - b[0]) ** 2 + (a[1] - b[1]) ** 2
