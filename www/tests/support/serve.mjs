// A static host without any manners: files below a sub-path, 404 for everything else.
import { createReadStream } from 'node:fs'
import { stat } from 'node:fs/promises'
import { createServer } from 'node:http'
import { extname, join, normalize } from 'node:path'
import { fileURLToPath } from 'node:url'

const dist = fileURLToPath(new URL('../../dist', import.meta.url))
const site = new URL(process.env.SITE ?? 'http://127.0.0.1:4187/')
const TYPES = {
  '.html': 'text/html; charset=utf-8',
  '.js': 'text/javascript',
  '.css': 'text/css',
  '.wasm': 'application/wasm',
  '.svg': 'image/svg+xml',
  '.json': 'application/json',
  '.woff2': 'font/woff2',
}

createServer(async (request, response) => {
  const path = decodeURIComponent(new URL(request.url ?? '/', site).pathname)
  const file = join(dist, normalize(path.slice(site.pathname.length) || 'index.html'))
  const found = path.startsWith(site.pathname) && file.startsWith(dist) && (await stat(file).catch(() => null))?.isFile()
  if (!found) {
    response.writeHead(404).end()
    return
  }
  response.writeHead(200, { 'content-type': TYPES[extname(file)] ?? 'application/octet-stream' })
  createReadStream(file).pipe(response)
}).listen(Number(site.port), site.hostname)
