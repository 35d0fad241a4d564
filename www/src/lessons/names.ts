import type { Catalogue, Planner } from 'forage-lab'
import { refusals as text } from '../locales/en/refusals'
import type { Lesson, RunPart } from './format'
import { LessonError } from './read'

/** The names that a lesson may use. */
type Known = Pick<Catalogue, 'planners' | 'scenes' | 'layers'>

function one<T extends { name: string }>(all: readonly T[], name: string, field: string): T {
  const found = all.find((candidate) => candidate.name === name)
  if (found) return found
  const names = all.map((candidate) => candidate.name)
  throw new LessonError(field, text.at(field, text.is(`"${name}"`, text.oneOf(names))))
}

/** Refuses planners, parameters, scenes, layers and readings that there are not. */
export function checkNames({ steps }: Lesson, known: Known): void {
  let planner: Planner | undefined
  for (const [at, step] of steps.entries()) {
    const field = `steps[${at}]`
    if (step.run) planner = checkRun(step.run, `${field}.run`, planner, known)
    const { question } = step
    const items = [step.item, question && 'item' in question ? question.item : undefined]
    for (const [number, item] of items.entries())
      if (item) checkRole(item.role, `${field}.${number === 0 ? 'item' : 'question.item'}.role`, known)
    for (const role of Object.keys(step.layers ?? {})) checkRole(role, `${field}.layers.${role}`, known)
    for (const [number, role] of (step.highlight ?? []).entries()) checkRole(role, `${field}.highlight[${number}]`, known)
    if (question?.kind === 'compare')
      for (const [number, { run }] of question.options.entries()) checkRun(run, `${field}.question.options[${number}].run`, planner, known)
  }
}

function checkRun(
  { planner: name, scene, params }: RunPart,
  field: string,
  before: Planner | undefined,
  known: Known,
): Planner | undefined {
  if (typeof scene === 'string') one(known.scenes, scene, `${field}.scene`)
  const planner = name === undefined ? before : one(known.planners, name, `${field}.planner`)
  for (const parameter of Object.keys(params ?? {})) one(planner?.parameters ?? [], parameter, `${field}.params.${parameter}`)
  return planner
}

function checkRole(role: string, field: string, { planners, layers }: Known): void {
  const all = new Set([...planners.flatMap((planner) => planner.layers), ...layers].map((layer) => layer.role as string))
  if (!all.has(role)) throw new LessonError(field, text.at(field, text.is(`"${role}"`, text.oneOf([...all]))))
}
