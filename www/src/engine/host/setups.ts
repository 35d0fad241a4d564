import type { Setup } from 'forage-lab'
import type { RunSetup } from '../../catalogue/own'
import type { Answer } from '../protocol'
import { within } from './answers'

/** What is added to links so that they carry the code. */
export type CodeInLinks = Answer<string>

/** A setup as the core takes it. A planner that somebody wrote is made known before. */
export const registered = ({ code, full = false, ...setup }: RunSetup): Promise<Answer<Setup>> =>
  within(async () => {
    if (code !== undefined) await (await import('./own')).loadPlanner(code, full)
    return setup as Setup
  })

/** Refused where the code is too long for a link. */
export const codeInLinks = ({ code }: RunSetup): Promise<CodeInLinks> =>
  within(async () => (code === undefined ? '' : (await import('./own')).withCode('', code)))
