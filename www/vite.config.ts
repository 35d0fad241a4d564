import { createHash } from 'node:crypto'
import { readdirSync, readFileSync } from 'node:fs'
import { fileURLToPath } from 'node:url'
import { svelte } from '@sveltejs/vite-plugin-svelte'
import { defineConfig } from 'vite'
import { contract } from './plugins/contract.ts'
import { early } from './plugins/early.ts'
import { formulas } from './plugins/formulas.ts'
import { glossary } from './plugins/glossary.ts'
import { templates } from './plugins/templates.ts'
import { languages } from './plugins/languages.ts'
import { lessons } from './plugins/lessons.ts'
import { installable } from './plugins/installable.ts'
import { palette } from './plugins/palette.ts'
import { settled } from './plugins/settled.ts'
import { policy } from './plugins/policy.ts'
import { recordings } from './plugins/recordings.ts'
import { reproduction } from './plugins/reproduction.ts'

const root = fileURLToPath(new URL('..', import.meta.url))
/** Another build has another package, and other languages. */
const { PKG: core = `${root}/pkg`, LOCALES: locales = `${root}/locales`, OUT: outDir = 'dist' } = process.env

/** The first view need not know what scripts each later one is made of: they ask for each other. Styles must be there before what they style. */
const styles = (_: string, files: string[], { hostType }: { hostType: 'html' | 'js' }): string[] =>
  hostType === 'html' ? files : files.filter((file) => file.endsWith('.css'))

/** Changes with any part of the core. */
const version = createHash('sha256')
for (const file of readdirSync(core).filter((name) => name.endsWith('.wasm'))) version.update(readFileSync(`${core}/${file}`))

export default defineConfig({
  define: { CORE_VERSION: JSON.stringify(version.digest('hex').slice(0, 16)) },
  base: './',
  plugins: [
    svelte(),
    settled(),
    early(['forage_bg', 'catalogue']),
    formulas(core, `${root}/lessons`),
    palette(`${root}/src/describe/palette.json`),
    glossary(`${root}/docs/glossary.md`, locales),
    templates(`${root}/templates`, locales),
    languages(locales, core),
    lessons(`${root}/lessons`, locales, `${root}/REPRODUCTION.claims.json`),
    recordings(core),
    reproduction(root),
    contract(`${core}/planner.d.ts`),
    policy(),
    installable(
      fileURLToPath(new URL('src/hosts/page/service-worker.ts', import.meta.url)),
      fileURLToPath(new URL('public/icon.svg', import.meta.url)),
      `${root}/src/describe/palette.json`,
      fileURLToPath(new URL('src/locales/en', import.meta.url)),
      locales,
    ),
  ],
  resolve: {
    alias: [
      { find: /^forage-lab$/, replacement: `${core}/page.js` },
      { find: /^forage-lab\//, replacement: `${core}/` },
    ],
  },
  worker: {
    format: 'es',
    // What a thread is made of is a file of its own: others import it, and none its worker's script.
    rolldownOptions: {
      checks: { pluginTimings: false },
      output: {
        codeSplitting: { groups: ['run', 'trial', 'render'].map((kind) => ({ name: `${kind}-thread`, test: `${kind}-thread.ts` })) },
      },
    },
  },
  server: { fs: { allow: ['..'] } },
  // What draws in space is one library, and comes with the first scene that needs it.
  build: {
    outDir,
    emptyOutDir: true,
    license: true,
    target: 'es2023',
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false, resolveDependencies: styles },
    chunkSizeWarningLimit: 800,
    // What the first view and later ones share is one file: small ones compress badly.
    rolldownOptions: {
      checks: { pluginTimings: false },
      output: {
        codeSplitting: {
          groups: [
            {
              name: 'shared',
              test: new RegExp(
                [
                  '/node_modules/(?:svelte|esm-env|clsx)/',
                  'vite/preload-helper',
                  'virtual:languages$',
                  '/describe/palette\\.json$',
                  '/src/(?:locales/(?:en/common|language\\.svelte)|render/(?:asking|frame|heights|looks|palette|view)|scene/(?:cells|stops)|stores/(?:context\\.svelte|storage)|text/number)\\.ts$',
                  '/src/(?:engine/host\\.ts|ui/(?:Fold|Icon|Tabs)\\.svelte)',
                ].join('|'),
              ),
            },
          ],
        },
      },
    },
  },
})
