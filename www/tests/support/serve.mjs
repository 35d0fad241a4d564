// Serves the built page for the tests: below a sub-path, as on many static hosts. Below that is the one in English with accents.
import { fileURLToPath } from 'node:url'
import { staticHost } from './static.mjs'

const site = new URL(process.env.SITE ?? 'http://127.0.0.1:4187/')
const folder = (name) => fileURLToPath(new URL(`../../${name}`, import.meta.url))
staticHost(folder('dist'), site.pathname, { [`${site.pathname}pseudo/`]: folder('dist-pseudo') }).listen(Number(site.port), site.hostname)
