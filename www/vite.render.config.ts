import { fileURLToPath } from 'node:url'
import { defineConfig } from 'vite'

/* The package's `forage-lab/render`: modules, of which what draws space is loaded when it is needed. */

const at = (path: string): string => fileURLToPath(new URL(path, import.meta.url))

export default defineConfig({
  base: './',
  publicDir: false,
  build: {
    target: 'es2023',
    outDir: 'dist-render',
    license: true,
    modulePreload: false,
    chunkSizeWarningLimit: 1000,
    rolldownOptions: {
      checks: { pluginTimings: false },
      input: at('src/hosts/package/render.ts'),
      external: /^forage-lab/,
      preserveEntrySignatures: 'strict',
      output: {
        format: 'es',
        paths: { 'forage-lab': './catalogue.js' },
        entryFileNames: 'render.js',
        chunkFileNames: 'render/[name].js',
      },
    },
  },
})
