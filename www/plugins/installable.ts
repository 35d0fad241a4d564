import { createHash } from 'node:crypto'
import { readFile } from 'node:fs/promises'
import sharp from 'sharp'
import { build, type Plugin, type Rolldown, runnerImport } from 'vite'
import { tagsIn } from './languages.ts'

const ICONS = [192, 512]
/** The part of the icon that any shape of a launcher leaves. */
const SAFE = 0.8

/** What a language calls the page. */
interface Worded {
  common: Readonly<Record<'title' | 'name' | 'description', string>>
}

interface Entry {
  url: string
  revision: string | null
}

/** The worker's script, and the licences of what is in it. */
async function scriptOf(worker: string, entries: readonly Entry[]): Promise<{ script: string; licences: string }> {
  const built = await build({
    configFile: false,
    logLevel: 'error',
    publicDir: false,
    define: {
      PRECACHED: JSON.stringify(entries),
      VERSION: JSON.stringify(createHash('sha256').update(JSON.stringify(entries)).digest('hex').slice(0, 16)),
      'process.env.NODE_ENV': '"production"',
    },
    build: {
      write: false,
      license: true,
      rolldownOptions: { checks: { pluginTimings: false }, input: worker, output: { format: 'iife', codeSplitting: false } },
    },
  })
  const { output } = (Array.isArray(built) ? built[0] : built) as Rolldown.RolldownOutput
  const licences = output.find((file) => file.type === 'asset' && file.fileName.endsWith('license.md'))
  if (licences?.type !== 'asset') throw new Error('the worker has no list of licences')
  return { script: output[0].code, licences: String(licences.source) }
}

/**
 * Makes the page one that can be installed and opens without a network: its icons, its manifest, and the worker that keeps its files.
 * @param worker where the worker's script is
 * @param icon where the icon is, as SVG
 * @param palette where each colour is by its name
 * @param english the folder with the page's texts in English
 * @param locales the folder with a folder for each other language
 */
export function installable(worker: string, icon: string, palette: string, english: string, locales: string): Plugin {
  const colorOf = async (name: 'brand' | 'surface'): Promise<string> =>
    (JSON.parse(await readFile(palette, 'utf8')) as Record<'brand' | 'surface', [string, string]>)[name][0]
  return {
    name: 'forage-installable',
    apply: 'build',
    enforce: 'post',
    transformIndexHtml: async () => [
      { tag: 'link', attrs: { rel: 'manifest', href: './manifest.webmanifest' }, injectTo: 'head' as const },
      { tag: 'meta', attrs: { name: 'theme-color', content: await colorOf('brand') }, injectTo: 'head' as const },
    ],
    generateBundle: {
      order: 'post',
      async handler(_, bundle) {
        const drawn = await readFile(icon)
        for (const side of ICONS) {
          this.emitFile({
            type: 'asset',
            fileName: `icon-${side}.png`,
            source: await sharp(drawn, { density: 72 * (side / 32) })
              .resize(side)
              .png()
              .toBuffer(),
          })
        }
        const inner = Math.round(512 * SAFE)
        const inset = await sharp(drawn, { density: 72 * (inner / 32) })
          .resize(inner)
          .png()
          .toBuffer()
        const ground = sharp({ create: { width: 512, height: 512, channels: 4, background: await colorOf('brand') } })
        this.emitFile({
          type: 'asset',
          fileName: 'icon-maskable.png',
          source: await ground
            .composite([{ input: inset }])
            .png()
            .toBuffer(),
        })
        const icons = [
          ...ICONS.map((side) => ({ src: `./icon-${side}.png`, sizes: `${side}x${side}`, type: 'image/png' })),
          { src: './icon-maskable.png', sizes: '512x512', type: 'image/png', purpose: 'maskable' },
          { src: './icon.svg', sizes: 'any', type: 'image/svg+xml' },
        ]
        const shared = {
          id: './',
          start_url: './',
          scope: './',
          display: 'standalone',
          background_color: await colorOf('surface'),
          theme_color: await colorOf('brand'),
          icons,
        }
        const manifest = async (folder: string, lang: string): Promise<string> => {
          const { common } = (await runnerImport<Worded>(`${folder}/common.ts`)).module
          return JSON.stringify({ name: common.title, short_name: common.name, description: common.description, lang, ...shared })
        }
        this.emitFile({ type: 'asset', fileName: 'manifest.webmanifest', source: await manifest(english, 'en') })
        for (const tag of tagsIn(locales)) {
          const source = await manifest(`${locales}/${tag}/page`, tag)
          this.emitFile({ type: 'asset', fileName: `manifest.${tag}.webmanifest`, source })
        }

        const entries: Entry[] = Object.values(bundle)
          .map((file) => ({ name: file.fileName, content: file.type === 'chunk' ? file.code : file.source }))
          .filter(({ name }) => !name.startsWith('.vite/') && !/^icon-|webmanifest$/.test(name))
          // Names of assets have a version in them.
          .map(({ name, content }) => ({
            url: name,
            revision: name.startsWith('assets/') ? null : createHash('sha256').update(content).digest('hex').slice(0, 16),
          }))
        entries.push({ url: 'icon.svg', revision: createHash('sha256').update(drawn).digest('hex').slice(0, 16) })
        entries.sort((a, b) => (a.url < b.url ? -1 : 1))
        const { script, licences } = await scriptOf(worker, entries)
        this.emitFile({ type: 'asset', fileName: 'service-worker.js', source: script })
        this.emitFile({ type: 'asset', fileName: '.vite/service-worker-license.md', source: licences })
      },
    },
  }
}
