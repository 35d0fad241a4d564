import type { Plugin } from 'vite'

/** Has the browser load these files while it still reads scripts: each begins with one of `names` and is asked for by `fetch`. */
export function early(names: readonly string[]): Plugin {
  return {
    name: 'forage-early',
    apply: 'build',
    transformIndexHtml: {
      order: 'post',
      handler(_, { bundle = {} }) {
        return names.map((name) => {
          const file = Object.values(bundle).find(
            ({ type, fileName }) => type === 'asset' && fileName.startsWith(`assets/${name}-`),
          )?.fileName
          if (!file) throw new Error(`the page has no file ${name}`)
          return { tag: 'link', attrs: { rel: 'preload', as: 'fetch', crossorigin: '', href: `./${file}` }, injectTo: 'head' as const }
        })
      },
    },
  }
}
