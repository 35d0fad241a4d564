import { mkdirSync, mkdtempSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { dirname, join } from 'node:path'
import { describe, expect, it } from 'vitest'
import { circles, graphOf, ORDER, upward } from './imports'

const graph = graphOf(join(import.meta.dirname, '../src'))

describe('the imports of the page', () => {
  it('lie in folders that have a place in the order', () => {
    const elsewhere = [...graph.keys()].filter((file) => !ORDER.some((folder) => file.startsWith(`${folder}/`)))
    expect(elsewhere).toEqual([])
  })

  it('lead down', () => {
    expect(upward(graph)).toEqual([])
  })

  it('form no circle', () => {
    expect(circles(graph)).toEqual([])
  })
})

describe('the graph', () => {
  it('finds types, dynamic imports, workers and markup', () => {
    const root = mkdtempSync(join(tmpdir(), 'imports-'))
    const write = (file: string, text: string): void => {
      mkdirSync(dirname(join(root, file)), { recursive: true })
      writeFileSync(join(root, file), text)
    }
    write('text/a.ts', "import type { B } from '../ui/b'\nexport const worker = new Worker(new URL('./w.worker.ts', import.meta.url))")
    write('text/w.worker.ts', "export type A = typeof import('./a')")
    write('ui/b.ts', 'export interface B {}')
    write('ui/C.svelte', "<script lang=\"ts\">\n  import './c.css'\n</script>\n{#await import('../text/a') then module}{module}{/await}")
    write('ui/c.css', '')
    const found = graphOf(root)
    rmSync(root, { recursive: true })
    expect(found.get('ui/C.svelte')).toEqual(new Set(['ui/c.css', 'text/a.ts']))
    expect(upward(found)).toEqual(['text/a.ts → ui/b.ts'])
    expect(circles(found)).toEqual([['text/a.ts', 'text/w.worker.ts']])
  })
})
