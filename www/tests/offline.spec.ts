import { readFileSync } from 'node:fs'
import { createServer, type Server } from 'node:http'
import type { AddressInfo } from 'node:net'
import { extname, join, normalize } from 'node:path'
import { fileURLToPath } from 'node:url'
import { expect, test as base } from '@playwright/test'
import { linkTo, verified } from './support/core'

/* The page that a browser keeps: without a network, and when there is a newer version. */

const DIST = fileURLToPath(new URL('../dist', import.meta.url))
const TYPES: Readonly<Record<string, string>> = {
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.css': 'text/css',
  '.svg': 'image/svg+xml',
}

interface Site {
  address: string
  /** Files that are other than those of the build. */
  changed: Map<string, string>
  stop(): Promise<void>
}

const test = base.extend<{ site: Site }>({
  serviceWorkers: 'allow',
  site: async ({ page }, use) => {
    void page
    const changed = new Map<string, string>()
    const server: Server = createServer(({ url = '' }, response) => {
      const name = normalize(new URL(url, 'http://x').pathname.replace(/^\/forage\//, '')).replace(/^[./]*$/, 'index.html')
      try {
        // No type for wasm: not all hosts have one.
        response.setHeader('content-type', TYPES[extname(name)] ?? 'application/octet-stream')
        response.end(changed.get(name) ?? readFileSync(join(DIST, name)))
      } catch {
        response.writeHead(404).end()
      }
    })
    await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve))
    const stop = (): Promise<void> =>
      new Promise((resolve) => {
        server.closeAllConnections()
        server.close(() => resolve())
      })
    await use({ address: `http://127.0.0.1:${(server.address() as AddressInfo).port}/forage/`, changed, stop })
    await stop().catch(() => undefined)
  },
})

const SWARM = linkTo({ seed: 3 }, 20)
const ARM = linkTo({ planner: 'rrt-guided', scene: 'arm-cuboid', seed: 1 }, 60)

test('once kept, the page opens without a network: any run, any room, an embed', { tag: '@smoke' }, async ({ page, site }) => {
  await page.goto(site.address)
  await expect
    .poll(() => page.evaluate(async () => (await navigator.serviceWorker.getRegistration())?.active?.state), { timeout: 30_000 })
    .toBe('activated')
  await site.stop()
  await page.goto(`${site.address}${ARM}`)
  await page.reload()
  const app = page.getByTestId('app')
  await expect(app).toHaveAttribute('data-hash', verified(ARM).hash ?? '')
  await expect(page.getByTestId('space-words')).not.toBeEmpty()
  await page.getByTestId('view-papers').click()
  await expect(page.getByRole('heading', { level: 2 }).first()).toBeVisible()
  await page.goto(`${site.address}?embed&controls=none${SWARM}`)
  await expect(app).toHaveAttribute('data-hash', verified(SWARM).hash ?? '')
  await page.goto(`${site.address}#lesson=pso&step=best`)
  await page.reload()
  await expect(page.getByTestId('lesson')).toHaveAttribute('data-step', 'best')
  await expect(page.getByTestId('app')).toHaveAttribute('data-iteration', '2')
})

test('once it is installed, the page in one file is saved without a network', async ({ page, site }) => {
  // A browser without a window of its own for apps says so by the query only.
  await page.addInitScript(() => {
    const asked = matchMedia.bind(window)
    window.matchMedia = (query) => asked(query === '(display-mode: standalone)' ? 'all' : query)
  })
  await page.goto(`${site.address}${SWARM}`)
  const kept = () => page.evaluate(async () => Boolean(await caches.match(new URL('single-file.html', location.href).href)))
  await expect.poll(kept, { timeout: 30_000 }).toBe(true)
  await site.stop()
  await page.reload()
  await page.getByTestId('export').click()
  const [saved] = await Promise.all([page.waitForEvent('download'), page.getByTestId('export-file').click()])
  expect(readFileSync(await saved.path(), 'utf8')).toContain('seed=3')
})

test('a newer version is offered, and comes only when it is asked for', async ({ page, site }) => {
  await page.goto(`${site.address}${SWARM}`)
  const app = page.getByTestId('app')
  await expect
    .poll(() => page.evaluate(async () => (await navigator.serviceWorker.getRegistration())?.active?.state), { timeout: 30_000 })
    .toBe('activated')
  site.changed.set('index.html', readFileSync(join(DIST, 'index.html'), 'utf8').replace('<title>', '<title>Newer '))
  site.changed.set(
    'service-worker.js',
    readFileSync(join(DIST, 'service-worker.js'), 'utf8').replace(/(url:`index\.html`,revision:`)[^`]*/, '$1newer'),
  )
  await page.reload()
  await expect(page.getByTestId('update')).toBeVisible({ timeout: 30_000 })
  await expect(page).not.toHaveTitle(/Newer/)
  await page.getByTestId('step-forward').click()
  await expect(app).toHaveAttribute('data-hash', verified(linkTo({ seed: 3 }, 21)).hash ?? '')
  await page.waitForTimeout(500)
  await page.getByTestId('update-now').click()
  await expect(page).toHaveTitle(/Newer/)
  await expect(app).toHaveAttribute('data-hash', verified(linkTo({ seed: 3 }, 21)).hash ?? '')
})

test('it can be installed: a manifest with icons of the sizes that browsers ask for', async ({ page, site }) => {
  await page.goto(site.address)
  const found = await page.evaluate(async () => {
    const link = document.querySelector<HTMLLinkElement>('link[rel="manifest"]')
    const manifest = await (await fetch(link?.href ?? '')).json()
    const sizes = await Promise.all(
      manifest.icons.map(async ({ src }: { src: string }) => {
        const bitmap = src.endsWith('png') && (await createImageBitmap(await (await fetch(new URL(src, link?.href))).blob()))
        return bitmap ? bitmap.width : 0
      }),
    )
    return { sizes, start: new URL(manifest.start_url, link?.href).href, display: manifest.display }
  })
  expect(found).toEqual({ sizes: [192, 512, 512, 0], start: site.address, display: 'standalone' })
})
