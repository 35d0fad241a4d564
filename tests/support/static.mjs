// A plain static file server, and a browser that reads what a page says.
import { createReadStream } from 'node:fs';
import { stat } from 'node:fs/promises';
import { createServer } from 'node:http';
import { createRequire } from 'node:module';
import { extname, join, normalize } from 'node:path';

const TYPES = { '.html': 'text/html; charset=utf-8', '.js': 'text/javascript', '.wasm': 'application/wasm' };
const WAIT = 60_000;

const { chromium } = createRequire(new URL('../../www/package.json', import.meta.url))('playwright-core');

/** Serves a folder below a path of its own, as static hosts do; `types` says otherwise of some endings. */
export async function serve(folder, types = {}) {
  const base = '/somewhere/below/';
  const server = createServer(async (request, response) => {
    const { pathname } = new URL(request.url, 'http://localhost');
    const file = join(folder, normalize(decodeURIComponent(pathname.slice(base.length)) || 'index.html'));
    const found = pathname.startsWith(base) && file.startsWith(folder) && (await stat(file).catch(() => null))?.isFile();
    if (!found) return response.writeHead(404).end();
    response.writeHead(200, { 'content-type': { ...TYPES, ...types }[extname(file)] ?? 'application/octet-stream' });
    createReadStream(file).pipe(response);
  });
  await new Promise((listening) => server.listen(0, '127.0.0.1', listening));
  return { address: `http://127.0.0.1:${server.address().port}${base}`, close: () => new Promise((closed) => server.close(closed)) };
}

/** Opens an address until the page's title begins with “done” or something goes wrong: its text, and what its console said. */
export async function look(address) {
  const browser = await chromium.launch({
    executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
    args: ['--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run', '--disable-background-networking', '--disable-component-update', '--disable-sync'],
  });
  try {
    const page = await browser.newPage();
    const said = [];
    const wrong = new Promise((_, reject) => {
      page.on('pageerror', reject);
      page.on('console', (message) => said.push(`${message.type()}: ${message.text()}`));
      page.on('response', (response) => response.status() >= 400 && reject(new Error(`${response.status()}: ${response.url()}`)));
    });
    await page.goto(address);
    await Promise.race([page.waitForFunction(() => document.title.startsWith('done'), null, { timeout: WAIT }), wrong]);
    return { text: await page.textContent('body'), said };
  } finally {
    await browser.close();
  }
}
