// Serves the built page for the tests: below a sub-path, as on many static hosts.
import { fileURLToPath } from 'node:url'
import { staticHost } from './static.mjs'

const site = new URL(process.env.SITE ?? 'http://127.0.0.1:4187/')
staticHost(fileURLToPath(new URL('../../dist', import.meta.url)), site.pathname).listen(Number(site.port), site.hostname)
