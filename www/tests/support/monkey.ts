import type { Page } from '@playwright/test'

/** What a monkey did in the page: how often what, and which were the last. */
export interface MonkeyReport {
  counts: Record<string, number>
  last: string[]
}

/** What is used of the browser's interface of this name, which not all TypeScript knows. */
interface Navigation {
  canGoBack: boolean
  canGoForward: boolean
  back(): { committed: Promise<unknown> }
  forward(): { committed: Promise<unknown> }
}

declare global {
  interface Window {
    /** The page's threads that have not been ended, with the names of their scripts. */
    liveThreads?: Set<Worker & { name: string }>
  }
}

/** Keeps a list of the page's threads, for those who end one. */
export const watchThreads = (page: Page): Promise<unknown> =>
  page.addInitScript(() => {
    const threads = new Set<Worker & { name: string }>()
    const { Worker: Real } = window
    window.Worker = class extends Real {
      readonly name: string
      constructor(url: string | URL, options?: WorkerOptions) {
        super(url, options)
        this.name = String(url)
        threads.add(this)
      }
      override terminate(): void {
        threads.delete(this)
        super.terminate()
      }
    }
    window.liveThreads = threads
  })

/**
 * So many random actions by a seed: clicks on what can be clicked, values for what takes one, keys, the pointer and the wheel on the stage,
 * back and forward. Nothing leaves the page: links to other places are not followed.
 */
export const monkey = (page: Page, seed: number, actions: number): Promise<MonkeyReport> =>
  page.evaluate(
    async ([seed, actions]) => {
      let state = seed >>> 0
      const unit = (): number => {
        state = (state + 0x6d2b79f5) >>> 0
        let mixed = Math.imul(state ^ (state >>> 15), state | 1)
        mixed ^= mixed + Math.imul(mixed ^ (mixed >>> 7), mixed | 61)
        return ((mixed ^ (mixed >>> 14)) >>> 0) / 2 ** 32
      }
      const below = (n: number): number => Math.floor(unit() * n)
      const one = <T>(list: readonly T[]): T => list[below(list.length)] as T
      const TEXTS = ['', '1', '12', '-1', '0.5', '1e9', 'x', 'NaN', '9'.repeat(30), 'sphere', '<b>', '…']
      const KEYS = [
        ...['Escape', 'Enter', ' ', 'Tab', 'ArrowLeft', 'ArrowRight', 'ArrowUp', 'ArrowDown', 'Home', 'End', 'PageUp', 'Delete'],
        ...['Backspace', '?', '1', '9', '+', '-', 'f', 'e', 'z', 'h'],
      ]
      const CONTROLS =
        'button, input, select, textarea, summary, a[href^="#"], [role=tab], [role=option], [role=button], [role=slider], [tabindex="0"], canvas'
      // These want a person's click.
      Element.prototype.requestFullscreen = () => Promise.resolve()
      const { click } = HTMLElement.prototype
      HTMLInputElement.prototype.click = function () {
        if (this.type !== 'file') click.call(this)
      }
      const counts: Record<string, number> = {}
      const last: string[] = []
      let travelling = false
      const nameOf = (element: Element): string =>
        (element as HTMLElement).dataset.testid ??
        element.getAttribute('aria-label') ??
        `${element.tagName} ${element.textContent?.slice(0, 30)}`
      const pointer = (type: string, [clientX, clientY]: [number, number], target: Element, more: PointerEventInit = {}): boolean =>
        target.dispatchEvent(
          new PointerEvent(type, {
            bubbles: true,
            cancelable: true,
            composed: true,
            pointerId: 1,
            isPrimary: true,
            clientX,
            clientY,
            ...more,
          }),
        )
      const setter = (element: HTMLElement): ((value: string) => void) => {
        const set = Object.getOwnPropertyDescriptor(Object.getPrototypeOf(element), 'value')?.set
        return (value) => set?.call(element, value)
      }
      const fill = (element: HTMLInputElement | HTMLTextAreaElement, value: string): void => {
        setter(element)(value)
        element.dispatchEvent(new Event('input', { bubbles: true }))
        element.dispatchEvent(new Event('change', { bubbles: true }))
      }
      const onStage = (element: Element): void => {
        const { left, top, width, height } = element.getBoundingClientRect()
        const at = (): [number, number] => [left + unit() * width, top + unit() * height]
        const [from, to] = [at(), at()]
        if (unit() < 0.2) {
          element.dispatchEvent(
            new WheelEvent('wheel', { bubbles: true, cancelable: true, deltaY: 400 * (unit() - 0.5), clientX: from[0], clientY: from[1] }),
          )
          return
        }
        const more = { button: 0, buttons: 1, shiftKey: unit() < 0.1, ctrlKey: unit() < 0.05 }
        pointer('pointerdown', from, element, more)
        if (unit() < 0.6)
          for (const share of [0.3, 0.6, 1])
            pointer('pointermove', [from[0] + share * (to[0] - from[0]), from[1] + share * (to[1] - from[1])], element, more)
        pointer('pointerup', to, element, { ...more, buttons: 0 })
        element.dispatchEvent(new MouseEvent('click', { bubbles: true, cancelable: true, clientX: to[0], clientY: to[1] }))
      }
      const act = (element: HTMLElement): string => {
        if (element instanceof HTMLCanvasElement) onStage(element)
        else if (element instanceof HTMLSelectElement) {
          element.selectedIndex = below(element.options.length)
          element.dispatchEvent(new Event('change', { bubbles: true }))
        } else if (element instanceof HTMLInputElement && element.type === 'range') {
          const [min, max] = [Number(element.min || 0), Number(element.max || 100)]
          fill(element, String(min + Math.round(unit() * (max - min))))
        } else if (element instanceof HTMLInputElement && element.type === 'file') return 'file'
        else if (
          element instanceof HTMLTextAreaElement ||
          (element instanceof HTMLInputElement && !['checkbox', 'radio'].includes(element.type))
        )
          fill(element, one(element.type === 'number' ? TEXTS.filter((text) => !Number.isNaN(Number(text))) : TEXTS))
        else element.click()
        return element.tagName.toLowerCase()
      }
      for (let k = 0; k < actions; k += 1) {
        const which = unit()
        let action = ''
        if (which < 0.04) {
          const step = one(['back', 'forward'] as const)
          action = step
          const { navigation } = window as unknown as { navigation: Navigation }
          // One at a time: two steps back at once could leave the page.
          if (!travelling && (step === 'back' ? navigation.canGoBack : navigation.canGoForward)) {
            travelling = true
            const arrived = (): void => {
              travelling = false
            }
            navigation[step]().committed.then(arrived, arrived)
          }
        } else if (which < 0.14) {
          const key = one(KEYS)
          action = `key ${key}`
          const target = document.activeElement ?? document.body
          for (const type of ['keydown', 'keyup'])
            target.dispatchEvent(
              new KeyboardEvent(type, { key, bubbles: true, cancelable: true, shiftKey: unit() < 0.1, ctrlKey: unit() < 0.05 }),
            )
        } else {
          const open = [...document.querySelectorAll<HTMLDialogElement>('dialog[open]')].at(-1)
          const all = [...(open ?? document).querySelectorAll<HTMLElement>(CONTROLS)].filter(
            (element) => element.checkVisibility() && !(element as HTMLButtonElement).disabled && !element.closest('.cm-editor'),
          )
          const element = all.length > 0 ? one(all) : undefined
          if (element) {
            action = `${act(element)} ${nameOf(element)}`
            element.focus()
          }
        }
        const kind = action.split(' ')[0] ?? ''
        counts[kind] = (counts[kind] ?? 0) + 1
        last.push(action)
        if (last.length > 12) last.shift()
        await new Promise((passed) => setTimeout(passed, unit() < 0.05 ? 120 : 4))
      }
      // What it went back to and what it asked for has come.
      const asked = (): number => performance.getEntriesByType('resource').length
      for (let [before, quiet] = [asked(), 0], looks = 0; quiet < 4 && looks < 50; looks += 1) {
        await new Promise((passed) => setTimeout(passed, 150))
        quiet = asked() === before ? quiet + 1 : 0
        before = asked()
      }
      return { counts, last }
    },
    [seed, actions] as const,
  )
