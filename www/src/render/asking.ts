/** What is asked for by the names of its functions. */
export const asking = <T extends object>(ask: (name: keyof T & string, given: unknown[]) => Promise<unknown>): T =>
  new Proxy({} as T, {
    get:
      (_, name) =>
      (...given: unknown[]) =>
        ask(name as keyof T & string, given),
  })
