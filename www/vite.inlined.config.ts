import { createHash } from 'node:crypto'
import { gzipSync } from 'node:zlib'
import { readdirSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { svelte } from '@sveltejs/vite-plugin-svelte'
import { defineConfig, type Plugin } from 'vite'
import { formulas } from './plugins/formulas.ts'
import { inlined, unaddressed } from './plugins/inlined.ts'
import { glossary } from './plugins/glossary.ts'
import { templates } from './plugins/templates.ts'
import { languages } from './plugins/languages.ts'
import { lessons } from './plugins/lessons.ts'
import { palette } from './plugins/palette.ts'
import { settled } from './plugins/settled.ts'

/* The element (`--mode element`) and the page in one file (`--mode file`): one script each, with all that it needs. */

const at = (path: string): string => fileURLToPath(new URL(path, import.meta.url))
const core = at('../pkg')

const tags = readdirSync(`${core}/locales`, { withFileTypes: true }).flatMap((entry) => (entry.isDirectory() ? [entry.name] : []))
const files = [
  ...readdirSync(core).filter((file) => file.endsWith('.wasm')),
  ...tags
    .flatMap((tag) => readdirSync(`${core}/locales/${tag}`).map((file) => `locales/${tag}/${file}`))
    .filter((file) => !file.endsWith('catalogue.json')),
  ...readdirSync(`${core}/scenes`).map((file) => `scenes/${file}`),
  'catalogue.json',
]

const shared = {
  base: './',
  resolve: {
    alias: [
      { find: /^forage-lab$/, replacement: `${core}/page.js` },
      { find: /^forage-lab\//, replacement: `${core}/` },
    ],
  },
  build: { target: 'es2023', chunkSizeWarningLimit: 4000 },
}

const threads = {
  run: at('src/engine/host/run.worker.ts'),
  trial: at('src/engine/host/trial.worker.ts'),
  render: at('src/render/render.worker.ts'),
}

/** The styles, in the element's script. In its shadow the root is the element, and faces of type are the page's. */
const withStyles = (): Plugin => ({
  name: 'forage-element-styles',
  enforce: 'post',
  generateBundle(_, bundle) {
    let styles = ''
    for (const [name, file] of Object.entries(bundle)) {
      if (file.type !== 'asset' || !name.endsWith('.css')) continue
      styles += String(file.source)
      delete bundle[name]
    }
    styles = styles
      .replace(/@font-face\s*\{[^}]*\}/g, '')
      .replace(/:root\[data-theme=['"]?dark['"]?\]/g, ':host([data-theme=dark])')
      .replace(/:root|(?<=[},]|^)(?:html|body)(?=[{,])/g, ':host')
    for (const file of Object.values(bundle)) {
      if (file.type !== 'chunk') continue
      const parts = file.code.split('ELEMENT_STYLES')
      if (parts.length !== 2) throw new Error('the script has not one place for its styles')
      file.code = parts.join(JSON.stringify(styles))
    }
  },
})

/** Unpacks the page's script and runs it. */
const LOADER = `(async () => {
  const packed = Uint8Array.from(atob(document.getElementById('code').textContent), (letter) => letter.charCodeAt(0))
  const bytes = await new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'))).arrayBuffer()
  const address = URL.createObjectURL(new Blob([bytes], { type: 'text/javascript' }))
  const policy = globalThis.trustedTypes?.createPolicy('forage-file', { createScriptURL: (known) => known })
  const script = document.createElement('script')
  script.src = policy ? policy.createScriptURL(address) : address
  document.head.append(script)
})()`

/** What the page in one file may do: run its own script and threads, and nothing over the network. */
const policyOf = (script: string, styles: string): string => {
  const hash = (text: string): string => `'sha256-${createHash('sha256').update(text).digest('base64')}'`
  return [
    `default-src 'none'`,
    `script-src ${hash(script)} 'wasm-unsafe-eval' blob:`,
    `worker-src blob:`,
    `style-src ${hash(styles)}`,
    `img-src data: blob:`,
    `font-src data:`,
    `base-uri 'none'`,
    `form-action 'none'`,
    `require-trusted-types-for 'script'`,
    `trusted-types svelte-trusted-html forage forage-file`,
  ].join('; ')
}

/** The page in one file, from its script and styles. */
const withPage = (): Plugin => ({
  name: 'forage-file',
  enforce: 'post',
  generateBundle(_, bundle) {
    let [script, styles] = ['', '']
    for (const [name, file] of Object.entries(bundle)) {
      if (file.type === 'chunk') script += file.code
      else if (name.endsWith('.css')) styles += String(file.source)
      delete bundle[name]
    }
    const source = `<!doctype html>
<html lang="en" data-link="">
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<meta name="color-scheme" content="light dark">
<meta http-equiv="Content-Security-Policy" content="${policyOf(LOADER, styles)}">
<title>Forage</title>
<style>${styles}</style>
<div id="app"></div>
<noscript>Forage computes in your browser and needs JavaScript.</noscript>
<script id="code" type="text/plain">${gzipSync(script, { level: 9 }).toString('base64')}</script>
<script>${LOADER}</script>
</html>
`
    this.emitFile({ type: 'asset', fileName: 'forage.html', source })
  },
})

export default defineConfig(({ mode }) => ({
  ...shared,
  publicDir: false,
  plugins: [
    unaddressed(core),
    svelte(),
    settled(),
    formulas(core, at('../lessons')),
    glossary(at('../docs/glossary.md'), at('../locales')),
    templates(at('../templates'), at('../locales')),
    languages(at('../locales'), core),
    lessons(at('../lessons'), at('../locales'), at('../REPRODUCTION.claims.json')),
    palette(at('../src/describe/palette.json')),
    inlined(core, files, threads, { ...shared, plugins: [unaddressed(core)] }),
    mode === 'element' ? withStyles() : withPage(),
  ],
  build: {
    ...shared.build,
    outDir: mode === 'element' ? 'dist-element' : 'dist-single',
    license: true,
    assetsInlineLimit: Number.MAX_SAFE_INTEGER,
    cssCodeSplit: false,
    rolldownOptions: {
      checks: { pluginTimings: false },
      transform: { define: { 'import.meta': '{}' } },
      input: at(mode === 'element' ? 'src/hosts/element/element.ts' : 'src/hosts/file/main.ts'),
      output: { format: 'iife', codeSplitting: false, entryFileNames: `${mode === 'element' ? 'element' : 'forage'}.js` },
    },
  },
}))
