import { texts } from '../texts'

/** What is said of planners in JavaScript by what runs and checks them: in English, whatever the language of the page. */
export const code = texts('code', {
  /** An error, or what a check has found. */
  said: (message: string) => message,
  /** What is said around an error where a planner could not start. */
  starts: /^planner: .* must be one whose code starts: (.+)$/s,
  /** The name of a check. */
  check: (name: string) => name,
} as const)
