// Browsers of the engines that Playwright does not drive here, behind one face: what the smoke set needs of them.
import { execFileSync, spawn } from 'node:child_process'
import { existsSync, readdirSync } from 'node:fs'
import { createServer } from 'node:net'
import { join } from 'node:path'

const SIZE = { width: 1280, height: 800 }

const onPath = (names) => {
  for (const name of names)
    try {
      return execFileSync('which', [name], { encoding: 'utf8' }).trim()
    } catch {
      // The next one.
    }
  return undefined
}

/** WebKit's browser is not on the path: it lies with its library. */
function miniBrowser() {
  const folders = ['/usr/lib', '/usr/libexec'].flatMap((folder) =>
    existsSync(folder) ? readdirSync(folder).map((one) => join(folder, one)) : [],
  )
  return folders.flatMap((folder) => ['webkit2gtk-4.1', 'webkitgtk-4.1'].map((name) => join(folder, name, 'MiniBrowser'))).find(existsSync)
}

const freePort = () =>
  new Promise((resolve) => {
    const server = createServer()
    server.listen(0, '127.0.0.1', () => {
      const { port } = server.address()
      server.close(() => resolve(port))
    })
  })

/** A screen that nobody sees, and what ends it. */
async function screen() {
  const server = spawn('Xvfb', ['-displayfd', '3', '-screen', '0', `${SIZE.width}x${SIZE.height + 200}x24`], {
    stdio: ['ignore', 'ignore', 'ignore', 'pipe'],
  })
  const number = await new Promise((resolve, reject) => {
    server.once('error', reject)
    server.stdio[3].once('data', (told) => resolve(String(told).trim()))
  })
  return { env: { ...process.env, DISPLAY: `:${number}`, LANG: 'en_US.UTF-8' }, end: () => server.kill() }
}

/** Through puppeteer. Without a graphics card Firefox has WebGL only by force, and on a screen. */
async function firefox() {
  const { env, end } = await screen()
  const { default: puppeteer } = await import('puppeteer-core')
  const browser = await puppeteer.launch({
    browser: 'firefox',
    headless: false,
    defaultViewport: SIZE,
    env,
    executablePath: onPath(['firefox-esr', 'firefox']),
    extraPrefsFirefox: { 'webgl.force-enabled': true },
  })
  const page = await browser.newPage()
  return {
    open: (address) => page.goto(address),
    run: (script, ...given) => page.evaluate(`(${script})(...${JSON.stringify(given)})`),
    async drag(from, to) {
      await page.mouse.move(...from)
      await page.mouse.down()
      await page.mouse.move(...to, { steps: 5 })
      await page.mouse.up()
    },
    press: (key) => page.keyboard.press(key),
    close: () => browser.close().finally(end),
  }
}

/** Playwright drives Chromium, except where all engines do the same. */
export async function chromium() {
  const { default: puppeteer } = await import('puppeteer-core')
  const executablePath = process.env.CHROMIUM ?? onPath(['chromium', 'google-chrome'])
  const browser = await puppeteer.launch({ executablePath, args: ['--no-sandbox'], defaultViewport: SIZE })
  const page = await browser.newPage()
  return {
    open: (address) => page.goto(address),
    run: (script, ...given) => page.evaluate(`(${script})(...${JSON.stringify(given)})`),
    close: () => browser.close(),
  }
}

/** Debian has no browser by itself for WebKit, but one for tests; it is driven by the protocol that all browsers speak. */
async function webkit() {
  const [{ env, end }, port] = [await screen(), await freePort()]
  const driver = spawn('WebKitWebDriver', [`--port=${port}`], { stdio: 'ignore', env })
  const { Builder, Capabilities, Key } = await import('selenium-webdriver')
  const capabilities = new Capabilities({
    browserName: 'MiniBrowser',
    'webkitgtk:browserOptions': { binary: miniBrowser(), args: ['--automation'] },
  })
  let session
  for (let left = 40; !session; left -= 1) {
    try {
      session = await new Builder().usingServer(`http://127.0.0.1:${port}`).withCapabilities(capabilities).build()
    } catch (error) {
      // The driver is not up yet.
      if (left === 0) throw error
      await new Promise((passed) => setTimeout(passed, 250))
    }
  }
  await session
    .manage()
    .window()
    .setRect({ x: 0, y: 0, ...SIZE })
  const point = ([x, y]) => ({ x: Math.round(x), y: Math.round(y) })
  return {
    open: (address) => session.get(address),
    run: (script, ...given) => session.executeScript(`return (${script})(...${JSON.stringify(given)})`),
    drag: (from, to) =>
      session
        .actions()
        .move({ ...point(from), duration: 0 })
        .press()
        .move({ ...point(to), duration: 100 })
        .release()
        .perform(),
    press: (key) =>
      session
        .actions()
        .sendKeys(Key[key.replace(/([a-z])(?=[A-Z])/, '$1_').toUpperCase()] ?? key)
        .perform(),
    async close() {
      await session.quit().catch(() => undefined)
      driver.kill()
      end()
    },
  }
}

/** By their engines' names. */
export const ENGINES = { firefox, webkit }
