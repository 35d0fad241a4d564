import type { FormulaScene } from 'forage-lab'

/** A function that is known, as a beginning for one's own. */
export interface Example {
  /** As links and files say it. */
  name: string
  title: string
  expression: string
  dimension: number
  bounds: FormulaScene['bounds']
  optimum?: FormulaScene['optimum']
}

/** Functions that textbooks use, with their minima. The first is what an editor begins with. */
export const EXAMPLES: readonly Example[] = [
  {
    name: 'himmelblau',
    title: 'Himmelblau',
    expression: '(x^2 + y - 11)^2 + (x + y^2 - 7)^2',
    dimension: 2,
    bounds: { min: -5, max: 5 },
    optimum: { value: 0, position: [3, 2] },
  },
  {
    name: 'sphere',
    title: 'Sphere',
    expression: 'sum(x[i]^2)',
    dimension: 2,
    bounds: { min: -100, max: 100 },
    optimum: { value: 0, position: [0, 0] },
  },
  {
    name: 'rosenbrock',
    title: 'Rosenbrock',
    expression: 'sum(100*(x[i+1] - x[i]^2)^2 + (1 - x[i])^2, i, 1, n - 1)',
    dimension: 2,
    bounds: { min: -4, max: 4 },
    optimum: { value: 0, position: [1, 1] },
  },
  {
    name: 'ackley',
    title: 'Ackley',
    expression: '-20*exp(-0.2*sqrt(sum(x[i]^2)/n)) - exp(sum(cos(2*pi*x[i]))/n) + 20 + e',
    dimension: 2,
    bounds: { min: -32, max: 32 },
    optimum: { value: 0, position: [0, 0] },
  },
  {
    name: 'rastrigin',
    title: 'Rastrigin',
    expression: 'sum(x[i]^2 - 10*cos(2*pi*x[i]) + 10)',
    dimension: 2,
    bounds: { min: -5.12, max: 5.12 },
    optimum: { value: 0, position: [0, 0] },
  },
  {
    name: 'matyas',
    title: 'Matyas',
    expression: '0.26*(x^2 + y^2) - 0.48*x*y',
    dimension: 2,
    bounds: { min: -10, max: 10 },
    optimum: { value: 0, position: [0, 0] },
  },
  {
    name: 'egg-crate',
    title: 'Egg crate',
    expression: 'x^2 + y^2 + 25*(sin(x)^2 + sin(y)^2)',
    dimension: 2,
    bounds: { min: -2 * Math.PI, max: 2 * Math.PI },
    optimum: { value: 0, position: [0, 0] },
  },
  {
    name: 'six-hump-camel',
    title: 'Six-hump camel',
    expression: '(4 - 2.1*x^2 + x^4/3)*x^2 + x*y + 4*(y^2 - 1)*y^2',
    dimension: 2,
    bounds: { min: [-2, -1.2], max: [2, 1.2] },
    optimum: { value: -1.0316284535, position: [0.08984201, -0.7126564] },
  },
  {
    name: 'branin',
    title: 'Branin',
    expression: '(y - 5.1*x^2/(4*pi^2) + 5*x/pi - 6)^2 + 10*(1 - 1/(8*pi))*cos(x) + 10',
    dimension: 2,
    bounds: { min: [-5, 0], max: [10, 15] },
    optimum: { value: 0.39788735773, position: [Math.PI, 2.275] },
  },
  {
    name: 'easom',
    title: 'Easom: a needle',
    expression: '-cos(x)*cos(y)*exp(-(x - pi)^2 - (y - pi)^2)',
    dimension: 2,
    bounds: { min: -10, max: 10 },
    optimum: { value: -1, position: [Math.PI, Math.PI] },
  },
  {
    name: 'eggholder',
    title: 'Eggholder: the minimum is on the rim',
    expression: '-(y + 47)*sin(sqrt(abs(x/2 + y + 47))) - x*sin(sqrt(abs(x - y - 47)))',
    dimension: 2,
    bounds: { min: -512, max: 512 },
    optimum: { value: -959.64066272, position: [512, 404.231805] },
  },
  {
    name: 'griewank',
    title: 'Griewank',
    expression: 'sum(x[i]^2)/4000 - prod(cos(x[i]/sqrt(i))) + 1',
    dimension: 2,
    bounds: { min: -30, max: 30 },
    optimum: { value: 0, position: [0, 0] },
  },
  {
    name: 'schwefel',
    title: 'Schwefel: far from the middle',
    expression: '418.9828872724338*n - sum(x[i]*sin(sqrt(abs(x[i]))))',
    dimension: 2,
    bounds: { min: -500, max: 500 },
    optimum: { value: 0, position: [420.96874636, 420.96874636] },
  },
  {
    name: 'styblinski-tang',
    title: 'Styblinski–Tang',
    expression: 'sum(x[i]^4 - 16*x[i]^2 + 5*x[i])/2',
    dimension: 2,
    bounds: { min: -5, max: 5 },
    optimum: { value: -78.33233140754, position: [-2.90353403, -2.90353403] },
  },
  {
    name: 'disc-constraint',
    title: 'A bowl with a forbidden disc, by a penalty',
    expression: 'x^2 + y^2 + (hypot(x - 1, y - 1) < 2 ? 100*(2 - hypot(x - 1, y - 1)) : 0)',
    dimension: 2,
    bounds: { min: -5, max: 5 },
    optimum: 0.343145750508,
  },
  {
    name: 'wave',
    title: 'One variable: a wave on a slope',
    expression: 'sin(5*x) + x^2/4',
    dimension: 1,
    bounds: { min: -4, max: 4 },
  },
]
