import type { Plugin } from 'vite'

interface Wanted {
  /** Asked for by `fetch`. */
  fetched: readonly string[]
  /** What threads are made of. */
  modules: readonly string[]
}

/** Has the browser load these files while it still reads scripts: the name of each begins with one of these. */
export function early({ fetched, modules }: Wanted): Plugin {
  return {
    name: 'forage-early',
    apply: 'build',
    transformIndexHtml: {
      order: 'post',
      handler(_, { bundle = {} }) {
        const tag = (name: string, attrs: Record<string, string>) => {
          const file = Object.keys(bundle).find((path) => path.startsWith(`assets/${name}-`))
          if (!file) throw new Error(`the page has no file ${name}`)
          return { tag: 'link', attrs: { ...attrs, crossorigin: '', href: `./${file}` }, injectTo: 'head' as const }
        }
        return [
          ...fetched.map((name) => tag(name, { rel: 'preload', as: 'fetch' })),
          ...modules.map((name) => tag(name, { rel: 'modulepreload' })),
        ]
      },
    },
  }
}
