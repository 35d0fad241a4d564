import type { Files } from '../host'

const typeOf = (name: string): string => (name.endsWith('.wasm') ? 'application/wasm' : 'application/json')

/** For `serveBy`: the package's files as responses. */
export const from =
  (files: Files) =>
  (name: string): Promise<Response> =>
    Promise.resolve(
      files[name]
        ? new Response(files[name], { headers: { 'content-type': typeOf(name) } })
        : new Response(null, { status: 404, statusText: 'no such file' }),
    )
