import { availableParallelism } from 'node:os'
import { defineConfig } from '@playwright/test'
import { FLAGS } from './tests/support/chromium.mjs'
import { SITE } from './tests/support/site'

export default defineConfig({
  testDir: 'tests',
  testMatch: '**/*.spec.ts',
  outputDir: 'test-results',
  reporter: 'list',
  fullyParallel: true,
  // A page has threads of its own: more pages than cores only wait for each other.
  workers: Math.min(availableParallelism(), 4),
  // A test that fails once has failed.
  retries: 0,
  forbidOnly: Boolean(process.env.CI),
  // For what hangs: with compilers running at the same time the longest test takes 40 seconds.
  timeout: 90_000,
  expect: { timeout: 10_000 },
  use: {
    baseURL: SITE,
    viewport: { width: 1440, height: 900 },
    colorScheme: 'light',
    // It would keep the page for the next visit, and a test has but one: offline.spec.ts lets it.
    serviceWorkers: 'block',
    launchOptions: {
      executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium',
      args: FLAGS,
    },
  },
  // The page is tested as it ships: built (scripts/build-page), below a sub-path, from a server that knows nothing of it.
  webServer: {
    command: 'node tests/support/serve.mjs',
    url: SITE,
    env: { SITE },
    timeout: 120_000,
    reuseExistingServer: false,
  },
})
