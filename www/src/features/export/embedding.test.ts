import { expect, test } from 'vitest'
import { addressOf, type Embedding, elementOf, iframeOf, withLink } from './embedding'

const usual: Embedding = { controls: 'play', theme: 'system', language: '', autoplay: false, width: 480, height: 320 }
const elsewhere = { page: 'https://example.org/forage/', element: 'https://example.org/forage/element.js' }
const LINK = '#v=1&planner=pso&scene=sphere&seed=1&at=5'

test('an address says only what differs from what is usual', () => {
  expect(addressOf(elsewhere, usual, LINK)).toBe(`https://example.org/forage/?embed${LINK}`)
  expect(addressOf(elsewhere, { ...usual, controls: 'none', theme: 'dark', language: 'zh-CN', autoplay: true }, LINK)).toBe(
    `https://example.org/forage/?embed&controls=none&theme=dark&lang=zh-CN&autoplay${LINK}`,
  )
})

test('nothing in a text to copy ends its attribute', () => {
  const hostile = '#v=1"><img src=x onerror=alert(1)>&seed=1'
  for (const text of [iframeOf(elsewhere, usual, hostile, 'A "run" <b>'), elementOf(elsewhere, usual, hostile)]) {
    const element = /^(?:<script src="[^"<>]*" async><\/script>\n)?<(iframe|forage-run)(?: [a-z]+(?:="[^"<>]*")?)*><\/\1>$/
    expect(text).toMatch(element)
    expect(text).toContain('&quot;&gt;&lt;img')
  }
})

test('the page in one file begins with its run', () => {
  expect(withLink('<html lang="en" data-link=""><p data-link="">', LINK)).toBe(
    `<html lang="en" data-link="${LINK.replaceAll('&', '&amp;')}"><p data-link="">`,
  )
  expect(() => withLink('<html>', LINK)).toThrow('no place')
})
