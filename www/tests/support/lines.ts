import type { Page } from '@playwright/test'

/** Lines that begin with a mark that closes something, or end with one that opens something: no language breaks its lines there. */
export const misbroken = (page: Page): Promise<string[]> =>
  page.evaluate(() => {
    const CLOSING = /^[)\]}）】」』》〉、。，：；！？”’…—～·%,.:;!?]/
    const OPENING = /[([{（【「『《〈“‘]$/
    const found: string[] = []
    const visible = (node: Node): boolean => {
      const element = node.parentElement
      return !!element?.checkVisibility() && !element.closest('svg, canvas, .cm-editor, option, pre, .katex, .visually-hidden')
    }
    /** Boxes of a line; others are lines of their own. */
    const INLINE = /^(?:inline|contents)/
    const blockOf = (node: Node): Element | null => {
      let at = node.parentElement
      while (at && INLINE.test(getComputedStyle(at).display)) at = at.parentElement
      return at
    }
    const rectOf = (node: Node, from: number, to: number): DOMRect | undefined => {
      const range = document.createRange()
      range.setStart(node, from)
      range.setEnd(node, to)
      return [...range.getClientRects()].at(-1)
    }
    const texts = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT, (node) =>
      node.textContent && visible(node) ? NodeFilter.FILTER_ACCEPT : NodeFilter.FILTER_SKIP,
    )
    let before: Node | null = null
    for (let node = texts.nextNode(); node; before = node, node = texts.nextNode()) {
      const [text, left] = [node.textContent ?? '', before?.textContent ?? '']
      if (!before || !left || blockOf(node) !== blockOf(before) || !(CLOSING.test(text) || OPENING.test(left))) continue
      const [last, first] = [rectOf(before, left.length - 1, left.length), rectOf(node, 0, 1)]
      // In the next line.
      if (last && first && first.width > 0 && first.top >= last.bottom - 2 && first.left < last.left)
        found.push(`${left.slice(-20)}|${text.slice(0, 20)}`)
    }
    return found
  })

/** Words that a line's end breaks where no hyphen says so. */
export const brokenWords = (page: Page): Promise<string[]> =>
  page.evaluate(() => {
    const found: string[] = []
    const texts = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT)
    const range = document.createRange()
    const lines = (): number => new Set([...range.getClientRects()].filter(({ width }) => width > 0).map(({ top }) => Math.round(top))).size
    for (let node = texts.nextNode(); node; node = texts.nextNode()) {
      const text = node.textContent ?? ''
      const element = node.parentElement
      if (!element?.checkVisibility() || element.closest('svg, canvas, .cm-editor, option, pre, code, .katex, .visually-hidden')) continue
      range.selectNodeContents(node)
      if (lines() < 2 || getComputedStyle(element).hyphens === 'auto') continue
      for (const { 0: word, index } of text.matchAll(/\p{Script=Latin}{2,}/gu)) {
        range.setStart(node, index)
        range.setEnd(node, index + word.length)
        if (lines() > 1) found.push(`${word} of ${text.slice(Math.max(index - 20, 0), index + 40)}`)
      }
    }
    return found
  })
