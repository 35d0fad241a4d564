import base from '../../www/vitest.config.ts'

const [page, core] = base.test.projects

/** The engine's own tests, as one project: a change would reach the tests of one project only. */
export default {
  ...base,
  resolve: { ...base.resolve, alias: [...base.resolve.alias, ...core.resolve.alias] },
  test: {
    ...page.test,
    name: undefined,
    isolate: true,
    testTimeout: core.test.testTimeout,
    include: ['src/engine/**/*.test.ts', 'unit/core/run-{host,loop,reports}.test.ts'],
  },
}
