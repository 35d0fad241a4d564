import { readFile } from 'node:fs/promises'
import type { Plugin } from 'vite'

const ID = 'virtual:palette.css'

/**
 * Provides `virtual:palette.css`: the palette that the core draws by, as tokens for both themes.
 * @param file where each name has its colour by day and by night
 */
export function palette(file: string): Plugin {
  return {
    name: 'forage-palette',
    resolveId: (id) => (id === ID ? ID : undefined),
    async load(id) {
      if (id !== ID) return undefined
      this.addWatchFile(file)
      const colors = Object.entries(JSON.parse(await readFile(file, 'utf8')) as Record<string, [string, string]>)
      const tokens = (theme: 0 | 1): string => colors.map(([name, both]) => `--${name}:${both[theme]};`).join('')
      return `:root{${tokens(0)}}:root[data-theme='dark']{${tokens(1)}}`
    },
  }
}
