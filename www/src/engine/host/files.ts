import type { Files } from '../host'

/** For `serveBy`: the package's files as responses. */
export const from =
  (files: Files) =>
  (name: string): Promise<Response> =>
    Promise.resolve(files[name] ? new Response(files[name]) : new Response(null, { status: 404, statusText: 'no such file' }))
