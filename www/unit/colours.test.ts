import { readdirSync, readFileSync } from 'node:fs'
import { join } from 'node:path'
import { describe, expect, it } from 'vitest'

const root = join(import.meta.dirname, '..')
const LITERAL = /#(?:[0-9a-f]{3,4}|[0-9a-f]{6}|[0-9a-f]{8})\b(?!-)|\b(?:rgba?|hsla?|oklch|oklab)\(\s*[\d.]/gi

describe('the colours of the page', () => {
  it('are in the palette and nowhere else', () => {
    const files = ['src', 'plugins'].flatMap((folder) =>
      readdirSync(join(root, folder), { recursive: true, encoding: 'utf8' }).map((file) => join(folder, file)),
    )
    const found = files
      .filter((file) => /\.(ts|svelte|css|html)$/.test(file) && !file.endsWith('.test.ts'))
      .flatMap((file) => [...readFileSync(join(root, file), 'utf8').matchAll(LITERAL)].map(([literal]) => `${file}: ${literal}`))
    expect(found).toEqual([])
  })
})
