import { fileURLToPath } from 'node:url'
import { svelte } from '@sveltejs/vite-plugin-svelte'
import { defineConfig } from 'vitest/config'
import { glossary } from './plugins/glossary.ts'
import { templates } from './plugins/templates.ts'
import { languages } from './plugins/languages.ts'

const at = (path: string): string => fileURLToPath(new URL(path, import.meta.url))
const core = at('../pkg/node.js')
const test = { setupFiles: ['unit/browser.ts'], restoreMocks: true }

/** `page`: modules by themselves, with no browser and no core. `core`: what they must agree in with the core, which has to be built. */
export default defineConfig({
  plugins: [
    svelte({ compilerOptions: { hmr: false } }),
    glossary(at('../docs/glossary.md'), at('../locales')),
    templates(at('../templates'), at('../locales')),
    languages(at('../locales'), at('../pkg')),
  ],
  resolve: { conditions: ['browser'], alias: [{ find: /^forage-lab\/texts$/, replacement: at('../package/texts.js') }] },
  test: {
    projects: [
      // A thread and its modules serve all files: starting one for each takes longer than the tests.
      { extends: true, test: { ...test, name: 'page', pool: 'threads', isolate: false, include: ['src/**/*.test.ts', 'unit/*.test.ts'] } },
      // Whole runs of the core take their time on a machine that is busy.
      {
        extends: true,
        resolve: { alias: [{ find: /^forage-lab(\/core)?$/, replacement: core }] },
        test: { ...test, name: 'core', testTimeout: 60_000, include: ['unit/core/*.test.ts'] },
      },
    ],
  },
})
