import { svelte } from '@sveltejs/vite-plugin-svelte'
import { defineConfig } from 'vitest/config'

// Modules that need no page and no core. What is told of a page is in unit/browser.ts.
export default defineConfig({
  plugins: [svelte({ compilerOptions: { hmr: false } })],
  resolve: { conditions: ['browser'] },
  test: { include: ['src/**/*.test.ts', 'unit/**/*.test.ts'], setupFiles: ['unit/browser.ts'], restoreMocks: true },
})
